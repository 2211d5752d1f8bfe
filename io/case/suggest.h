// "Did you mean": the known name that is nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

/// The known name with the fewest edits (insert, delete, replace, swap neighbours; letter case is free), if they are
/// few for the length of the name: at most a third of it, one at least; else the shortest one whose parts begin with
/// the parts of the name (fric_deg: friction_deg). Empty: none is near.
[[nodiscard]] std::string nearest(std::string_view name, const std::vector<std::string>& known);

/// "did you mean "density"?", or the other text where no name is near.
[[nodiscard]] std::string did_you_mean(std::string_view name, const std::vector<std::string>& known,
                                       std::string_view otherwise);

/// The names, quoted and separated by commas; the first forty where there are more.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace scree::io
