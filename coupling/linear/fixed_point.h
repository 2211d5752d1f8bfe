// Fixed-point iteration sped up by the differences of earlier iterates.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace scree::coupling {

/// Anderson's method for x = T(x): the next iterate is the answer T to that combination of earlier iterates whose
/// residual T(x) - x is least. On linear maps it takes as many iterations as GMRES, without a derivative of T.
/// Differences of an iteration that was accepted serve later ones of a similar map; newer differences come first, and
/// what is nearly a combination of newer ones is left out. An iteration that takes long goes on without them.
/// @source [Anderson1965]; as interface quasi-Newton least squares, with differences of earlier steps: [Degroote2009]
class FixedPoint {
 public:
  /// Iterates that are found with differences of accepted iterations; then these are forgotten.
  static constexpr int kPatience = 12;
  /// Differences of accepted iterations, the newest last.
  struct Kept {
    std::int32_t count = 0;
    std::vector<double> answers, residuals;  // `count` columns; residuals divided by their units
    /// As State::visit().
    template <class Visitor>
    void visit(Visitor&& see) const {
      see("kept.count", count);
      see("kept.answers", answers);
      see("kept.residuals", residuals);
    }
  };

  /// Begins an iteration.
  /// @param unit      residuals are measured divided by it; must outlive the iteration
  /// @param use_kept  the map is similar to those of the accepted iterations
  void begin(std::span<const double> unit, bool use_kept);
  /// T has changed by a constant: differences stay, and the last iterate is forgotten.
  void restart() { last_answer_.clear(); }
  /// @param answer  T(x)   @param x  the iterate x; becomes the next
  void next(std::span<const double> answer, std::span<double> x);
  /// Accepts the iteration: its differences are kept.
  void accept();
  void forget() { kept_ = {}; }
  [[nodiscard]] Kept& kept() { return kept_; }

 private:
  static constexpr Eigen::Index kMost = 24;          // differences used
  static constexpr std::size_t kMostKept = 1 << 20;  // numbers kept of either kind
  void take_difference(std::span<const double> answer);
  /// Orthogonalises a difference to newer ones, and applies it to the residual that is left and to the iterate.
  /// @param least  part of it that must be left for this, else nothing happens
  void apply(const double* answer, const double* residual, double least, Eigen::Map<Eigen::VectorXd> iterate);

  std::span<const double> unit_;
  bool uses_kept_ = false;
  int iterates_ = 0;  // of this iteration
  Kept kept_;
  std::vector<double> last_answer_, last_residual_;
  Eigen::VectorXd residual_, left_;      // of the iterate; after the differences applied so far
  Eigen::MatrixXd answers_, residuals_;  // of this iteration: one column per difference, the newest last
  Eigen::Index count_ = 0;
  Eigen::MatrixXd base_,
      step_;  // orthonormal residuals of the differences applied, and the answers that belong to them
  Eigen::Index rank_ = 0;
};

}  // namespace scree::coupling
