// Chooses the factors of the next runs in the search for a factor of safety: they bracket it, then narrow the bracket.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// Result of a run at a factor.
enum class Verdict {
  stable,     // the forces balance
  failed,     // a block keeps accelerating (criteria: trial_verdict.h)
  undecided,  // neither of these within the time of the run
};
[[nodiscard]] std::string_view name(Verdict verdict);

struct Trial {
  Verdict verdict = Verdict::undecided;
  double acceleration = 0.0;  // of the fastest block, in a run that failed [m/s2]
};

/// A search over factors above 0: the slope stands at small factors and fails at large ones.
class FosSearch {
 public:
  struct Range {
    double least = 0.1, most = 10.0;  // range of factors
    double tolerance = 0.01;          // width of the bracket
  };
  enum class State {
    searching,
    found,      // the bracket is as narrow as the tolerance
    undecided,  // the bracket cannot be narrowed further, since runs inside it have no verdict
    at_most     // stable at the largest factor
  };

  /// @param start  a factor at which the slope stands   @pre 0 < least <= start <= most, tolerance > 0
  FosSearch(const Range& range, double start);

  /// Factors of the next runs, two at most; none once the search is over. The factors depend on the results so far, not
  /// on the order in which these arrived. Two failed runs give an estimate of the factor of safety: the acceleration of
  /// the moving blocks is linear in 1/F, and is zero at the factor of safety.
  [[nodiscard]] std::vector<double> next() const;
  /// Adds the results of all factors of next().   @throws std::invalid_argument if one is missing
  void take(const std::map<double, Trial>& results);

  [[nodiscard]] State state() const;
  /// The ends of the bracket. fails() is the smallest factor at which the slope failed, infinite if it failed at none;
  /// stands() is the largest factor below fails() at which it stands.
  [[nodiscard]] double stands() const;
  [[nodiscard]] double fails() const;
  [[nodiscard]] const std::map<double, Trial>& trials() const { return trials_; }
  /// True if the slope stood at a factor above one at which it failed. There is then more than one bracket, and the
  /// lowest is used.
  [[nodiscard]] bool inconsistent() const;

 private:
  [[nodiscard]] std::optional<double> guess() const;
  /// Factors without a verdict between the ends of the bracket.
  [[nodiscard]] std::vector<double> gap() const;

  Range range_;
  std::map<double, Trial> trials_;
  int rounds_ = 0;  // rounds of runs that used an estimate
};

/// The factor at which the acceleration is zero, by a line through two points of the acceleration over 1/F.
/// @return empty if the acceleration does not grow with F, or the line has no zero at a positive factor
[[nodiscard]] std::optional<double> zero_of(double factor_1, double acceleration_1, double factor_2,
                                            double acceleration_2);

}  // namespace scree::app
