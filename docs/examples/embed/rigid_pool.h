// A third method in 150 lines: rigid blocks, three degrees of freedom, explicit and implicit. It shows that contact,
// hand-over, results and streaming require nothing of a method beyond model/pool.h.
#pragma once

#include <Eigen/LU>
#include <cmath>

#include "model/outline.h"
#include "model/planar.h"

namespace scree::rigid {

/// Nodes (c, R e1, R e2): x = c + X1 (R e1) + X2 (R e2). R stays a rotation.
class RigidPool : public Pool {
 public:
  /// @param inertia_factor  factor of the moments of inertia
  explicit RigidPool(double inertia_factor = 1.0) : inertia_factor_(inertia_factor) {}
  [[nodiscard]] std::string_view method() const override { return "rigid"; }
  void add(const Model&, const BodyRecord& record) override {
    const int b = bodies();
    shapes_.push_back(record.shape);
    boundaries_.push_back(affine_boundary(record.shape.outline, b, [b](const Vec2& X) { return row(b, X); }));
  }
  [[nodiscard]] int bodies() const override { return static_cast<int>(shapes_.size()); }
  [[nodiscard]] std::int32_t first_node(int body) const override { return 3 * body; }
  [[nodiscard]] const Boundary& boundary(int body) const override {
    return boundaries_[static_cast<std::size_t>(body)];
  }
  [[nodiscard]] Row row_at(int body, const Vec2& X) const override { return row(body, X); }
  [[nodiscard]] std::span<const double> translation(int) const override {
    static constexpr std::array<double, 3> kOnce{1.0, 0.0, 0.0};
    return kOnce;
  }

  [[nodiscard]] bool strains() const override { return false; }
  void place(int body, const AffineMotion& m, std::span<double> q, std::span<double> v) const override {
    const Mat2 R = polar_rotation(m.F), B = m.Fdot * m.F.inverse();
    store(body, m.c, R, q);
    store(body, m.vc, 0.5 * (B(1, 0) - B(0, 1)) * quarter_turn() * R, v);
  }
  [[nodiscard]] Release release(int body, std::span<const double> q, std::span<const double> v) const override {
    Release out;
    out.shape = shape(body);
    out.motion = {centre(body, q), gradient(body, q), centre(body, v), gradient(body, v)};
    return out;
  }
  [[nodiscard]] BodyTotals totals(int body, std::span<const double> q, std::span<const double> v) const override {
    BodyTotals t;
    t.mass = shape(body).mass;
    t.centre = centre(body, q);
    t.momentum = t.mass * centre(body, v);
    t.angular_momentum = cross(t.centre, t.momentum) + inertia(body) * spin(body, q, v);
    t.kinetic = 0.5 * t.mass * centre(body, v).squaredNorm() + 0.5 * inertia(body) * std::pow(spin(body, q, v), 2);
    return t;
  }

  double internal_force(std::span<const double>, std::span<double>) const override { return 0.0; }
  void body_force(const Vec2& a, std::span<double> f) const override {
    for (int b = 0; b < bodies(); ++b) {
      f[6 * static_cast<std::size_t>(b)] += shape(b).mass * a.x();
      f[6 * static_cast<std::size_t>(b) + 1] += shape(b).mass * a.y();
    }
  }
  void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const override {
    for (int b = 0; b < bodies(); ++b) {
      const Mat2 WR = quarter_turn() * gradient(b, q);
      const double alpha = WR.cwiseProduct(gradient(b, f)).sum() / inertia(b);
      store(b, centre(b, f) / shape(b).mass, alpha * WR, a);
    }
  }
  void mass_apply(int b, std::span<const double>, std::span<const double> v, std::span<double> p) const override {
    store(b, shape(b).mass * centre(b, v), 0.5 * inertia(b) * gradient(b, v), p);
  }
  [[nodiscard]] double kinetic_energy(std::span<const double> q, std::span<const double> v,
                                      std::span<const char> counted) const override {
    double sum = 0.0;
    for (int b = 0; b < bodies(); ++b)
      if (counted[static_cast<std::size_t>(b)] != 0) sum += totals(b, q, v).kinetic;
    return sum;
  }
  void turn(double h, std::span<const double> q, std::span<double> v, std::span<double> moved) const override {
    for (int b = 0; b < bodies(); ++b) {
      const double w = spin(b, q, v);
      const Mat2 R = rotation(h * w) * gradient(b, q);
      store(b, centre(b, q) + h * centre(b, v), R, moved);
      store(b, centre(b, v), w * quarter_turn() * R, v);
    }
  }
  [[nodiscard]] double frequency_bound(int) const override { return 0.0; }
  [[nodiscard]] double mass_ratio(int) const override { return 1.0; }
  [[nodiscard]] double compliance(int body, const Row& r) const override {
    return 1.0 / shape(body).mass + (r.w[1] * r.w[1] + r.w[2] * r.w[2]) / inertia(body);
  }
  void bound_groups(int body, const Row&, std::vector<std::int32_t>& groups) const override {
    groups.assign(1, 3 * body);
  }

  [[nodiscard]] int dofs(int) const override { return 3; }
  [[nodiscard]] ChartRow chart_row(int body, const Row& r, std::span<const double> q) const override {
    std::array<double, 3> w{};
    for (std::size_t k = 0; k < 3; ++k) w[static_cast<std::size_t>(r.node[k] - 3 * body)] += r.w[k];
    const Vec2 lever = quarter_turn() * (gradient(body, q) * Vec2(w[1], w[2]));
    return {3, {0, 1, 2}, {w[0], 0.0, lever.x()}, {0.0, w[0], lever.y()}};
  }
  [[nodiscard]] ElementDofs element_dofs(int) const override { return {{0, 3}, {0, 1, 2}}; }
  void element_masses(int body, std::span<const double>, std::span<double> mass) const override {
    const std::array lower{shape(body).mass, 0.0, 0.0, shape(body).mass, 0.0, inertia(body)};
    std::copy(lower.begin(), lower.end(), mass.begin());
  }
  void rates(int body, std::span<const double> q, std::span<const double> v, std::span<double> rate) const override {
    Eigen::Map<Eigen::Vector3d>(rate.data()) << centre(body, v), spin(body, q, v);
  }
  double linearise(int, std::span<const double>, Stiffness, std::span<double> K, std::span<double> f) const override {
    std::fill(K.begin(), K.end(), 0.0);
    std::fill(f.begin(), f.end(), 0.0);
    return 0.0;
  }
  void retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
               std::span<double> v) const override {
    const Mat2 R = rotation(d[2]) * gradient(body, q);
    store(body, centre(body, q) + Vec2(d[0], d[1]), R, q);
    store(body, {rate[0], rate[1]}, rate[2] * quarter_turn() * R, v);
  }

  void topology(MeshPart& mesh) const override {
    mesh.offsets.assign(1, 0);
    for (int b = 0; b < bodies(); ++b) {
      const AffineMotion origin = affine_fit(shape(b).outline, shape(b).origin);
      for (const Vec2& X : shape(b).outline.outer) {
        mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.points.size()));
        mesh.points.push_back(row(b, X));
        mesh.origin.push_back(origin.c + origin.F * X);
      }
      mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
      mesh.body.push_back(b);
    }
  }
  void stress(std::span<const double>, std::span<double> cells) const override {
    for (std::size_t i = 0; i < 3 * shapes_.size(); ++i) cells[i] = 0.0;
  }

 private:
  static Row row(int b, const Vec2& X) { return {{3 * b, 3 * b + 1, 3 * b + 2}, {1.0, X.x(), X.y()}}; }
  static Vec2 centre(int b, std::span<const double> q) {
    return {q[6 * static_cast<std::size_t>(b)], q[6 * static_cast<std::size_t>(b) + 1]};
  }
  static Mat2 gradient(int b, std::span<const double> q) {
    return Eigen::Map<const Mat2>(q.data() + 6 * static_cast<std::size_t>(b) + 2);
  }
  static void store(int b, const Vec2& c, const Mat2& F, std::span<double> q) {
    Eigen::Map<Vec2>(q.data() + 6 * static_cast<std::size_t>(b)) = c;
    Eigen::Map<Mat2>(q.data() + 6 * static_cast<std::size_t>(b) + 2) = F;
  }
  [[nodiscard]] static double spin(int b, std::span<const double> q, std::span<const double> v) {
    const Mat2 B = gradient(b, v) * gradient(b, q).inverse();
    return 0.5 * (B(1, 0) - B(0, 1));
  }
  [[nodiscard]] const ReferenceShape& shape(int b) const { return shapes_[static_cast<std::size_t>(b)]; }
  [[nodiscard]] double inertia(int b) const { return inertia_factor_ * shape(b).second.trace(); }
  double inertia_factor_;
  std::vector<ReferenceShape> shapes_;
  std::vector<Boundary> boundaries_;
};

}  // namespace scree::rigid
