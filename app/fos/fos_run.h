// The search for a factor of safety: the runs to rest, the runs at a factor, and the result.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/fos/fos_folder.h"
#include "app/fos/fos_search.h"
#include "app/fos/trial_verdict.h"
#include "io/results/rock_use.h"

namespace scree::app {

/// How a search is carried out. None of these settings changes the result.
struct FosSettings {
  std::size_t jobs = 1;                          // runs at a time
  int threads = 1;                               // per run
  std::function<void(const std::string&)> note;  // receives each line of progress to be printed; empty: none
  std::function<bool()> stop;                    // returns true to interrupt the search
};

struct FosAnswer {
  enum class Status {
    found,           // the factor of safety lies between stands and fails
    undecided,       // runs between the two have no verdict
    fails_at_least,  // the slope does not come to rest even with the largest strength: strength does not govern
    stable_at_most,  // the slope stands even with the smallest strength
    interrupted
  };
  Status status = Status::interrupted;
  double stands = 0.0, fails = 0.0;    // ends of the bracket; fails is infinite if no run failed
  std::map<double, TrialResult> runs;  // by factor, without the run to rest
  double start = 1.0;                  // factor of the run to rest
  bool explicit_rest = false;          // the run to rest used explicit steps, since implicit ones found no balance
  bool inconsistent = false;           // the slope stood at a factor above one at which it failed
  /// If the slope fails at the least factor: the horizontal acceleration with which it stands, and the nearest one with
  /// which it fails, in g, positive along x; empty if none was searched for, or if none up to 1.6 g was found.
  std::optional<double> k_h, k_h_fails;
  std::string why;                      // reason for which the run to rest failed
  std::optional<TrialResult> at_least;  // failure at the least factor
  /// Stress compared with the strength of the rock: at rest, and in the run that stands at the largest factor; empty if
  /// no material has a strength.
  std::vector<io::RockUse> rock_at_rest, rock_at_limit;
  double cpu = 0.0;  // of all processes [s]

  [[nodiscard]] double factor() const { return 0.5 * (stands + fails); }
  /// The run that failed at the smallest factor, or the run to rest that failed at the least factor; null if none did.
  [[nodiscard]] const TrialResult* failure() const;
};
[[nodiscard]] std::string_view name(FosAnswer::Status status);

/// Carries out the search of a folder, or continues it.
/// @param limit    displacement limit of the verdict [m]   @param gravity [m/s2]
/// @param implicit_rest  true if the stages to rest use implicit steps. If these find no balance although no block
///                       moves as far as the limit, the run to rest is repeated with explicit steps before a smaller
///                       factor is tried
/// @throws FileError
[[nodiscard]] FosAnswer search_factor(const FosFolder& folder, const FosRecord& record, double limit,
                                      const Vec2& gravity, bool implicit_rest, const FosSettings& settings);

}  // namespace scree::app
