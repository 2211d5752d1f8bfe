// The reference for speed: a plain scalar loop over constant-strain triangles, co-rotational, gather and scatter,
// without the other parts of a simulator (no damping, no ledger, no exact inertia, no contacts).
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree::bench {

class PlainLoop {
 public:
  /// n x n cells of two right triangles each, cells of length 1, Lame constants 1, density 1.
  explicit PlainLoop(int n) : elements_(2 * n * n) {
    const int nodes = (n + 1) * (n + 1);
    node_.reserve(3 * static_cast<std::size_t>(elements_));
    u_.assign(2 * static_cast<std::size_t>(nodes), 0.0);
    v_ = f_ = u_;
    mass_.assign(static_cast<std::size_t>(nodes), 0.0);
    std::vector<double> X(u_.size());
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const auto k = 2 * static_cast<std::size_t>(j * (n + 1) + i);
        X[k] = i;
        X[k + 1] = j;
        u_[k] = 1e-4 * std::sin(0.1 * i);
        u_[k + 1] = 1e-4 * std::cos(0.1 * j);
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = j * (n + 1) + i, b = a + n + 1;
        node_.insert(node_.end(), {a, a + 1, b + 1, a, b + 1, b});
      }
    for (int e = 0; e < elements_; ++e) {
      const int* k = &node_[3 * static_cast<std::size_t>(e)];
      const auto x = [&](int c, int d) { return X[2 * static_cast<std::size_t>(k[c]) + static_cast<std::size_t>(d)]; };
      const double twice = (x(1, 0) - x(0, 0)) * (x(2, 1) - x(0, 1)) - (x(2, 0) - x(0, 0)) * (x(1, 1) - x(0, 1));
      area_.push_back(0.5 * twice);
      for (int c = 0; c < 3; ++c) {
        const int p = (c + 1) % 3, q = (c + 2) % 3;
        gradient_.push_back((x(p, 1) - x(q, 1)) / twice);
        gradient_.push_back((x(q, 0) - x(p, 0)) / twice);
        mass_[static_cast<std::size_t>(k[c])] += twice / 6.0;
      }
    }
  }

  [[nodiscard]] int elements() const { return elements_; }

  void step(double dt) {
    std::fill(f_.begin(), f_.end(), 0.0);
    for (int e = 0; e < elements_; ++e) {
      const int* k = &node_[3 * static_cast<std::size_t>(e)];
      const double* g = &gradient_[6 * static_cast<std::size_t>(e)];
      double F00 = 1.0, F01 = 0.0, F10 = 0.0, F11 = 1.0;
      for (int c = 0; c < 3; ++c) {
        const double x = u_[2 * static_cast<std::size_t>(k[c])], y = u_[2 * static_cast<std::size_t>(k[c]) + 1];
        F00 += x * g[2 * c];
        F01 += x * g[2 * c + 1];
        F10 += y * g[2 * c];
        F11 += y * g[2 * c + 1];
      }
      const double a = F00 + F11, b = F10 - F01, r = 1.0 / std::sqrt(a * a + b * b), cs = a * r, sn = b * r;
      const double e00 = cs * F00 + sn * F10 - 1.0, U01 = cs * F01 + sn * F11, U10 = cs * F10 - sn * F00,
                   e11 = cs * F11 - sn * F01 - 1.0, trace = e00 + e11;
      const double s00 = trace + 2.0 * e00, s11 = trace + 2.0 * e11, s01 = U01 + U10;
      const double A = area_[static_cast<std::size_t>(e)];
      const double P00 = A * (cs * s00 - sn * s01), P01 = A * (cs * s01 - sn * s11), P10 = A * (sn * s00 + cs * s01),
                   P11 = A * (sn * s01 + cs * s11);
      for (int c = 0; c < 3; ++c) {
        f_[2 * static_cast<std::size_t>(k[c])] -= P00 * g[2 * c] + P01 * g[2 * c + 1];
        f_[2 * static_cast<std::size_t>(k[c]) + 1] -= P10 * g[2 * c] + P11 * g[2 * c + 1];
      }
    }
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      const double kick = dt / mass_[i];
      v_[2 * i] += kick * f_[2 * i];
      v_[2 * i + 1] += kick * f_[2 * i + 1];
      u_[2 * i] += dt * v_[2 * i];
      u_[2 * i + 1] += dt * v_[2 * i + 1];
    }
  }
  /// Sum of the results, so that the compiler does not optimise the loop away.
  [[nodiscard]] double sum() const {
    double s = 0.0;
    for (const double x : u_) s += x;
    return s;
  }

 private:
  int elements_;
  std::vector<int> node_;
  std::vector<double> u_, v_, f_, mass_, gradient_, area_;
};

}  // namespace scree::bench
