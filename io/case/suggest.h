// "Did you mean": the known name that is nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

/// The known name with the fewest edits (insert, delete, replace, swap neighbours; letter case is ignored), if their
/// number is at most a third of the length of the name (one edit is always allowed); else the shortest known name whose
/// parts begin with the parts of the name (fric_deg: friction_deg). Empty: there is no such name.
[[nodiscard]] std::string nearest(std::string_view name, const std::vector<std::string>& known);

/// "did you mean "density"?", or the text `otherwise` if there is no near name.
[[nodiscard]] std::string did_you_mean(std::string_view name, const std::vector<std::string>& known,
                                       std::string_view otherwise);

/// The names, quoted and separated by commas; only the first forty if there are more.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace scree::io
