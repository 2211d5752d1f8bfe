// Choice of the next factors in the search for a factor of safety: brackets it and narrows the bracket by runs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// Result of a run at a factor.
enum class Verdict {
  stable,     // at rest
  failed,     // some block accelerates and has moved far
  undecided,  // neither within the time of the run
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
    found,      // bracket() is narrow enough
    undecided,  // as narrow as runs without a verdict allow
    at_most     // stable at the largest factor
  };

  /// @param start  a factor at which the slope stands   @pre 0 < least <= start <= most, tolerance > 0
  FosSearch(const Range& range, double start);

  /// Factors to run next, two at most; none once the search is over. The same results give the same factors,
  /// independent of their order of arrival. Two failed runs give a guess: the acceleration of the moving blocks is
  /// linear in 1/F, and zero at the factor of safety.
  [[nodiscard]] std::vector<double> next() const;
  /// Takes the results of all factors of next().   @throws std::invalid_argument where one is missing
  void take(const std::map<double, Trial>& results);

  [[nodiscard]] State state() const;
  /// stands(): the largest factor at which the slope stands, below fails(): the smallest factor at which it fails;
  /// infinite: it failed at none.
  [[nodiscard]] double stands() const;
  [[nodiscard]] double fails() const;
  [[nodiscard]] const std::map<double, Trial>& trials() const { return trials_; }
  /// True if a factor above a failed one was stable. Then more than one bracket is possible, and the lowest counts.
  [[nodiscard]] bool inconsistent() const;

 private:
  [[nodiscard]] std::optional<double> guess() const;
  /// Factors without a verdict between the ends of the bracket.
  [[nodiscard]] std::vector<double> gap() const;

  Range range_;
  std::map<double, Trial> trials_;
  int rounds_ = 0;  // with a guess
};

/// The factor at which the line through two points is zero, for an acceleration that grows linearly with -1/F.
/// @return nothing where the line does not fall to zero above 0
[[nodiscard]] std::optional<double> zero_of(double factor_1, double acceleration_1, double factor_2,
                                            double acceleration_2);

}  // namespace scree::app
