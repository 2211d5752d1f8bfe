#include "nmm/nmm_pool.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "model/parallel.h"
#include "model/planar.h"
#include "nmm/step_bound.h"

namespace scree::nmm {
namespace {

Vec2 node(std::span<const double> q, std::int32_t k) {
  const auto i = 2 * static_cast<std::size_t>(k);
  return {q[i], q[i + 1]};
}

}  // namespace

void NmmPool::add(const Model& model, const BodyRecord& record) {
  auto body = std::make_unique<Body>();
  body->shape = record.shape;
  body->mesh = make_cover_mesh(record.shape.outline, record.form.cover_size);
  const std::int32_t first = first_.back();
  if (!body->mass.make(body->mesh, record.shape, first)) {
    body->mesh = make_onefold(record.shape.outline);
    if (!body->mass.make(body->mesh, record.shape, first))
      throw std::runtime_error("block '" + model.blocks[record.block.index()].name + "': no positive lumped mass");
  }
  body->first_element = static_cast<std::int32_t>(area_.size());
  const Elasticity law = model.elasticity_of(record.block);
  // The rock keeps its area, mass over density, also where an outline fitted to a deformed body holds a little less.
  double drawn = 0.0;
  for (const Element& e : body->mesh.elements) drawn += e.area;
  const double scale = record.shape.area / drawn;
  body->frequency = scale * frequency_bound_of(body->mesh, body->mass, law);
  for (const Element& e : body->mesh.elements) {
    cover_.push_back({e.cover[0] + first, e.cover[1] + first, e.cover[2] + first});
    gradient_.push_back(e.gradients());
    area_.push_back(scale * e.area);
    law_.push_back(law);
    linear_.push_back(record.form.kinematics == Kinematics::linear ? 1 : 0);
    drawn_.push_back(static_cast<std::int32_t>(drawing_cells(e.piece).size()));
  }
  body->form = record.form;
  body->consistent_mass = record.form.mass == MassKind::consistent;
  if (record.form.mass != MassKind::affine_exact) make_implicit(*body, first);
  for (Row& row : body->mesh.boundary.nodes)
    for (std::int32_t& n : row.node) n += first;
  for (Boundary::Segment& s : body->mesh.boundary.segments) s.cell += body->first_element;
  first_.push_back(first + static_cast<std::int32_t>(body->mesh.star.size()));
  bodies_.push_back(std::move(body));
}

void NmmPool::make_implicit(Body& body, std::int32_t first) {
  const CoverMesh& mesh = body.mesh;
  std::vector<std::array<std::int32_t, 3>> covers;
  std::vector<MassElement> elements;
  for (const Element& e : mesh.elements) {
    covers.push_back(e.cover);
    elements.push_back({e.cover, e.weights(e.centroid), e.gradients(), moments(e.piece)});
  }
  FoldedElements folded;
  folded.make(static_cast<std::int32_t>(mesh.star.size()), covers, mesh.ties);
  body.consistent.make(folded, elements, mesh.star, body.shape, first);
  std::vector<Mat3> masses;
  for (std::size_t e = 0; e < elements.size(); ++e) masses.push_back(body.consistent.element(e));
  body.implicit.make(std::move(folded), std::move(masses), body.form.mass == MassKind::lumped, first);
}

void NmmPool::gather(std::span<double> f) const {
  for (int b = 0; b < bodies(); ++b)
    for (const Tie& t : of(b).mesh.ties) {
      const std::size_t from = 2 * static_cast<std::size_t>(first_node(b) + t.cover);
      for (std::size_t d = 0; d < 2; ++d) {
        for (std::size_t k = 0; k < 3; ++k)
          f[2 * static_cast<std::size_t>(first_node(b) + t.root[k]) + d] += t.w[k] * f[from + d];
        f[from + d] = 0.0;
      }
    }
}

std::string NmmPool::implicit_obstacle(int body) const {
  if (of(body).form.mass != MassKind::affine_exact) return {};
  return "its mass is affine-exact, which couples all covers of a block; implicit steps take mass = \"consistent\" or "
         "\"lumped\"";
}

ChartRow NmmPool::chart_row(int body, const Row& row, std::span<const double>) const {
  return of(body).implicit.chart_row(row);
}

void NmmPool::element_masses(int body, std::span<const double>, std::span<double> mass) const {
  of(body).implicit.element_masses(mass);
}

void NmmPool::rates(int body, std::span<const double>, std::span<const double> v, std::span<double> rate) const {
  of(body).implicit.rates(v, rate);
}

double NmmPool::linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                          std::span<double> force) const {
  const auto first = static_cast<std::size_t>(of(body).first_element), count = of(body).mesh.elements.size();
  return of(body).implicit.linearise(
      std::span(cover_).subspan(first, count), q, kind, stiffness, force, [&](std::size_t e) {
        return StiffElement{gradient_[first + e], area_[first + e], law_[first + e], of(body).form.kinematics};
      });
}

void NmmPool::retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
                      std::span<double> v) const {
  of(body).implicit.retract(d, rate, q, v);
}

void NmmPool::finish() {
  gather_start_.assign(static_cast<std::size_t>(first_.back()) + 1, 0);
  for (const auto& covers : cover_)
    for (std::int32_t c : covers) ++gather_start_[static_cast<std::size_t>(c) + 1];
  for (std::size_t k = 1; k < gather_start_.size(); ++k) gather_start_[k] += gather_start_[k - 1];
  gather_.resize(3 * cover_.size());
  std::vector<std::int32_t> next(gather_start_.begin(), gather_start_.end() - 1);
  for (std::size_t e = 0; e < cover_.size(); ++e)
    for (std::size_t k = 0; k < 3; ++k)
      gather_[static_cast<std::size_t>(next[static_cast<std::size_t>(cover_[e][k])]++)] =
          static_cast<std::int32_t>(3 * e + k);
  corner_force_.resize(3 * cover_.size());
  ones_.assign(static_cast<std::size_t>(first_.back()), 1.0);
}

Row NmmPool::row_at(int body, const Vec2& X) const {
  const Body& b = of(body);
  Row row = b.mesh.row(b.mesh.locate(X), X);
  for (std::int32_t& n : row.node) n += first_node(body);
  return row;
}

std::span<const double> NmmPool::translation(int body) const {
  const auto first = static_cast<std::size_t>(first_node(body)), last = static_cast<std::size_t>(first_node(body + 1));
  return std::span(ones_).subspan(first, last - first);
}

void NmmPool::place(int body, const AffineMotion& m, std::span<double> q, std::span<double> v) const {
  const Body& b = of(body);
  for (std::size_t k = 0; k < b.mesh.star.size(); ++k) {
    const std::size_t i = 2 * (static_cast<std::size_t>(first_node(body)) + k);
    const Vec2 x = m.c + m.F * b.mesh.star[k], u = m.vc + m.Fdot * b.mesh.star[k];
    q[i] = x.x();
    q[i + 1] = x.y();
    v[i] = u.x();
    v[i + 1] = u.y();
  }
}

ElasticResponse NmmPool::respond(std::size_t e, const Mat2& F) const {
  return linear_[e] != 0 ? linear_response(law_[e], F, Mat2::Zero()) : elastic_response(law_[e], F, Mat2::Zero());
}

Mat2 NmmPool::gradient(std::size_t e, std::span<const double> q) const {
  const auto& c = cover_[e];
  const auto& g = gradient_[e];
  return node(q, c[0]) * g.col(0).transpose() + node(q, c[1]) * g.col(1).transpose() +
         node(q, c[2]) * g.col(2).transpose();
}

double NmmPool::internal_force(std::span<const double> q, std::span<double> f) const {
  const auto count = static_cast<std::int64_t>(area_.size());
  const double energy = parallel_sum(count, partial_, [&](std::int64_t begin, std::int64_t end) {
    double sum = 0.0;
    for (auto e = static_cast<std::size_t>(begin); e < static_cast<std::size_t>(end); ++e) {
      const ElasticResponse r = respond(e, gradient(e, q));
      const Mat2 AP = area_[e] * r.P;
      for (int k = 0; k < 3; ++k) corner_force_[3 * e + static_cast<std::size_t>(k)] = AP * gradient_[e].col(k);
      sum += area_[e] * r.energy;
    }
    return sum;
  });
  parallel_for(first_.back(), [&](std::int64_t c) {
    const auto k = static_cast<std::size_t>(c);
    Vec2 sum = Vec2::Zero();
    for (std::int32_t s = gather_start_[k]; s < gather_start_[k + 1]; ++s)
      sum += corner_force_[static_cast<std::size_t>(gather_[static_cast<std::size_t>(s)])];
    f[2 * k] -= sum.x();
    f[2 * k + 1] -= sum.y();
  });
  return energy;
}

void NmmPool::body_force(const Vec2& acceleration, std::span<double> f) const {
  for (const auto& b : bodies_)
    b->consistent_mass ? b->consistent.add_weight(acceleration, f) : b->mass.add_weight(acceleration, f);
}

void NmmPool::mass_solve(std::span<const double>, std::span<const double> f, std::span<double> a) const {
  for (const auto& b : bodies_) b->consistent_mass ? b->consistent.solve(f, a) : b->mass.solve(f, a);
}

double NmmPool::kinetic_of(const Body& b, std::span<const double> v) {
  return b.consistent_mass ? b.consistent.kinetic_energy(v) : b.mass.kinetic_energy(v);
}

void NmmPool::apply(const Body& b, std::span<const double> v, std::span<double> p) {
  b.consistent_mass ? b.consistent.apply(v, p) : b.mass.apply(v, p);
}

double NmmPool::kinetic_energy(std::span<const double>, std::span<const double> v,
                               std::span<const char> counted) const {
  double sum = 0.0;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (counted[b] != 0) sum += kinetic_of(*bodies_[b], v);
  return sum;
}

void NmmPool::damp(double factor, double rate, std::span<double> v, std::span<double> f, std::span<double> a) const {
  for (const auto& b : bodies_)
    b->consistent_mass ? b->consistent.damp(factor, rate, v, f, a) : b->mass.damp(factor, rate, v, f, a);
}

double NmmPool::compliance(int body, const Row& row) const {
  std::vector<std::pair<std::int32_t, double>> folded;
  of(body).mass.fold(row, folded);
  double sum = 0.0;
  for (const auto& [cover, w] : folded) sum += w * w / of(body).mass.lumped()[static_cast<std::size_t>(cover)];
  return sum;
}

void NmmPool::bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const {
  std::vector<std::pair<std::int32_t, double>> folded;
  of(body).mass.fold(row, folded);
  groups.clear();
  for (const auto& [cover, w] : folded)
    if (std::abs(w) > 1e-12) groups.push_back(first_node(body) + cover);
}

BodyTotals NmmPool::totals(int body, std::span<const double> q, std::span<const double> v) const {
  const Body& b = of(body);
  std::vector<double> p(q.size(), 0.0), weight(q.size(), 0.0);
  apply(b, v, p);
  b.consistent_mass ? b.consistent.add_weight({1.0, 1.0}, weight) : b.mass.add_weight({1.0, 1.0}, weight);
  BodyTotals t;
  for (std::int32_t k = first_node(body); k < first_node(body + 1); ++k) {
    const double m = weight[2 * static_cast<std::size_t>(k)];
    t.mass += m;
    t.centre += m * node(q, k);
    t.momentum += node(p, k);
    t.angular_momentum += cross(node(q, k), node(p, k));
  }
  t.centre /= t.mass;
  t.kinetic = kinetic_of(b, v);
  for (std::size_t e = 0; e < b.mesh.elements.size(); ++e) {
    const std::size_t i = static_cast<std::size_t>(b.first_element) + e;
    t.elastic += area_[i] * respond(i, gradient(i, q)).energy;
  }
  return t;
}

Release NmmPool::release(int body, std::span<const double> q, std::span<const double> v) const {
  const Body& b = of(body);
  Release out;
  const std::int32_t begin = first_node(body), end = first_node(body + 1);
  const auto local = [&](std::int32_t k) { return static_cast<std::size_t>(k - begin); };

  // Affine part in the operator really used: c, S, v_c, B, and the fit of x to X.
  std::vector<double> weight(q.size(), 0.0), p(q.size(), 0.0), r(q.size(), 0.0), Mr(q.size(), 0.0);
  b.consistent_mass ? b.consistent.add_weight({1.0, 1.0}, weight) : b.mass.add_weight({1.0, 1.0}, weight);
  apply(b, v, p);
  Vec2 c = Vec2::Zero(), momentum = Vec2::Zero();
  double mass = 0.0;
  for (std::int32_t k = begin; k < end; ++k) {
    mass += weight[2 * static_cast<std::size_t>(k)];
    c += weight[2 * static_cast<std::size_t>(k)] * node(q, k);
    momentum += node(p, k);
  }
  c /= mass;
  const Vec2 vc = momentum / mass;
  for (std::int32_t k = begin; k < end; ++k)
    for (int d = 0; d < 2; ++d) r[2 * static_cast<std::size_t>(k) + static_cast<std::size_t>(d)] = node(q, k)[d] - c[d];
  apply(b, r, Mr);
  Mat2 S = Mat2::Zero(), B = Mat2::Zero(), fit = Mat2::Zero();
  for (std::int32_t k = begin; k < end; ++k) {
    S += node(Mr, k) * node(r, k).transpose();
    B += node(p, k) * node(r, k).transpose();
    fit += node(Mr, k) * b.mesh.star[local(k)].transpose();
  }
  S = 0.5 * (S + S.transpose()).eval();
  const Mat2 G = B * S.inverse();

  // The stress that keeps the affine part of the internal force, and the stretch that carries it.
  const Mat2 R = polar_rotation(fit);
  const auto first = static_cast<std::size_t>(b.first_element);
  Mat2 virial = Mat2::Zero();
  double area = 0.0;
  for (std::size_t e = first; e < first + b.mesh.elements.size(); ++e) {
    const Mat2 F = gradient(e, q);
    virial += area_[e] * elastic_response(law_[e], F, Mat2::Zero()).P * F.transpose();
    area += area_[e];
  }
  const Mat2 local_virial = R.transpose() * virial * R;
  const Elasticity law = law_[first];
  const Mat2 strain = strain_of_kirchhoff(law, 0.5 * (local_virial + local_virial.transpose()) / area);
  const Mat2 F = R * (Mat2::Identity() + strain), F_inverse = F.inverse();
  out.motion = {c, F, vc, G * F};

  out.shape.mass = b.shape.mass;
  out.shape.area = area;
  out.shape.second = F_inverse * S * F_inverse.transpose();
  out.shape.origin = b.shape.origin;
  out.shape.outline = b.shape.outline;
  for (const Boundary::Corner& corner : b.mesh.boundary.corners) {
    const Row& row = b.mesh.boundary.nodes[static_cast<std::size_t>(corner.node)];
    Vec2 x = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) x += row.w[k] * node(q, row.node[k]);
    out.shape.outline.ring(static_cast<std::size_t>(corner.ring))[static_cast<std::size_t>(corner.vertex)] =
        F_inverse * (x - c);
  }

  // What is left over: velocities M-orthogonal to affine fields, stresses about their mean.
  std::vector<double> w(q.size(), 0.0);
  for (std::int32_t k = begin; k < end; ++k) {
    const Vec2 rest = node(v, k) - vc - G * node(r, k), turned = R.transpose() * rest;
    w[2 * static_cast<std::size_t>(k)] = rest.x();
    w[2 * static_cast<std::size_t>(k) + 1] = rest.y();
    out.velocity_rest.insert(out.velocity_rest.end(), {turned.x(), turned.y()});
  }
  out.kinetic_rest = kinetic_of(b, w);
  const Mat2 mean = law.stress(strain);
  for (std::size_t e = first; e < first + b.mesh.elements.size(); ++e) {
    const Mat2 F_e = gradient(e, q);
    const Mat2 U = polar_rotation(F_e).transpose() * F_e;
    const Mat2 difference = 0.5 * (U + U.transpose()) - Mat2::Identity() - strain;
    const Mat2 ds = law.stress(difference);
    out.elastic_rest += 0.5 * area_[e] * ds.cwiseProduct(difference).sum();
    out.elastic_cross += area_[e] * mean.cwiseProduct(difference).sum();
    out.stress_rest.insert(out.stress_rest.end(), {ds(0, 0), ds(1, 1), ds(0, 1)});
  }
  return out;
}

void NmmPool::topology(MeshPart& mesh) const {
  mesh.offsets.assign(1, 0);
  for (int b = 0; b < bodies(); ++b) {
    const Body& body = of(b);
    // The affine map from the reference shape to where the model first had the block.
    const AffineMotion origin = affine_fit(body.shape.outline, body.shape.origin);
    const Box box = bounds(body.shape.outline);
    const double grid = 1e-8 * (box.hi - box.lo).maxCoeff();
    std::map<std::pair<std::int64_t, std::int64_t>, std::int32_t> known;  // points shared by neighbouring cells
    for (std::size_t e = 0; e < body.mesh.elements.size(); ++e)
      for (const Ring& ring : drawing_cells(body.mesh.elements[e].piece)) {
        for (const Vec2& X : ring) {
          const std::pair key(std::llround(X.x() / grid), std::llround(X.y() / grid));
          const auto [it, fresh] = known.emplace(key, static_cast<std::int32_t>(mesh.points.size()));
          mesh.connectivity.push_back(it->second);
          if (!fresh) continue;
          Row row = body.mesh.row(static_cast<std::int32_t>(e), X);
          for (std::int32_t& n : row.node) n += first_node(b);
          mesh.points.push_back(row);
          mesh.origin.push_back(origin.c + origin.F * X);
        }
        mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
        mesh.body.push_back(b);
      }
  }
}

void NmmPool::stress(std::span<const double> q, std::span<double> cells) const {
  std::size_t cell = 0;
  for (std::size_t e = 0; e < area_.size(); ++e) {
    const Mat2 F = gradient(e, q);
    const Mat2 cauchy = elastic_response(law_[e], F, Mat2::Zero()).P * F.transpose() / F.determinant();
    for (std::int32_t k = 0; k < drawn_[e]; ++k, ++cell) {
      cells[3 * cell] = cauchy(0, 0);
      cells[3 * cell + 1] = cauchy(1, 1);
      cells[3 * cell + 2] = 0.5 * (cauchy(0, 1) + cauchy(1, 0));
    }
  }
}

}  // namespace scree::nmm
