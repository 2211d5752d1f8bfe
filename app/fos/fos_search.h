// Where to look next for a factor of safety: brackets it and closes the bracket by runs at chosen factors.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// What a run at a factor came to.
enum class Verdict {
  stable,     // at rest
  failed,     // some of it accelerates and has moved far
  undecided,  // neither within the time of the run
};
[[nodiscard]] std::string_view name(Verdict verdict);

struct Trial {
  Verdict verdict = Verdict::undecided;
  double acceleration = 0.0;  // of the block that is fastest, of a run that failed [m/s2]
};

/// A search over factors above 0: stands at small ones, fails at large ones.
class FosSearch {
 public:
  struct Range {
    double least = 0.1, most = 10.0;  // factors tried at all
    double tolerance = 0.01;          // width of the bracket
  };
  enum class State {
    searching,
    found,      // bracket() is narrow enough
    undecided,  // as narrow as runs without a verdict let it be
    at_most     // stable at the largest factor
  };

  /// @param start  a factor at which it stands   @pre 0 < least <= start <= most, tolerance > 0
  FosSearch(const Range& range, double start);

  /// Factors to run next, two at most; none once the search is over. The same results give the same factors, in
  /// whatever order they came. Two failed runs give a guess: the acceleration of what moves is straight over 1/F, and
  /// zero at the factor of safety.
  [[nodiscard]] std::vector<double> next() const;
  /// Takes the results of all factors of next().   @throws std::invalid_argument where one is missing
  void take(const std::map<double, Trial>& results);

  [[nodiscard]] State state() const;
  /// The largest factor that stands below every one that fails, and the smallest one that fails; infinite: none has.
  [[nodiscard]] double stands() const;
  [[nodiscard]] double fails() const;
  [[nodiscard]] const std::map<double, Trial>& trials() const { return trials_; }
  /// A factor below a failed one stood, or the other way round: where more than one bracket is possible the lowest
  /// counts.
  [[nodiscard]] bool inconsistent() const;

 private:
  [[nodiscard]] std::optional<double> guess() const;
  /// Factors without a verdict between the ends of the bracket.
  [[nodiscard]] std::vector<double> gap() const;

  Range range_;
  std::map<double, Trial> trials_;
  int rounds_ = 0;  // with a guess
};

/// Where a straight line through two points is zero: an acceleration that grows with -1/F.
/// @return nothing where the line does not fall to zero above 0
[[nodiscard]] std::optional<double> zero_of(double factor_1, double acceleration_1, double factor_2,
                                            double acceleration_2);

}  // namespace scree::app
