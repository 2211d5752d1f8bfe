#include <fmt/format.h>

#include <algorithm>

#include "io/case/read_parts.h"
#include "io/case/suggest.h"

namespace scree::io {
namespace {

struct Unknown {
  std::string problem, allowed, hint;
};

std::int32_t index_of(const std::string& name, const std::vector<std::string>& known) {
  const auto at = std::find(known.begin(), known.end(), name);
  return at == known.end() ? -1 : static_cast<std::int32_t>(at - known.begin());
}

Unknown unknown(std::string_view what, const std::string& name, const std::vector<std::string>& known) {
  return {fmt::format("there is no {} of that name", what),
          known.empty() ? fmt::format("nothing: the case has no {}", what) : listed(known),
          did_you_mean(name, known, fmt::format("define the {}, or correct the name", what))};
}

}  // namespace

std::int32_t find_name(const Section& section, std::string_view key, std::string_view what,
                       const std::vector<std::string>& known) {
  const std::string& name = section.text(key);
  const std::int32_t index = index_of(name, known);
  if (index >= 0) return index;
  Unknown u = unknown(what, name, known);
  throw section.error(key, std::move(u.problem), std::move(u.allowed), std::move(u.hint));
}

std::int32_t find_name(const Section& section, std::string_view key, std::size_t item, std::string_view what,
                       const std::vector<std::string>& known) {
  const std::string name = section.texts(key)[item];
  const std::int32_t index = index_of(name, known);
  if (index >= 0) return index;
  Unknown u = unknown(what, name, known);
  throw section.error(key, item, std::move(u.problem), std::move(u.allowed), std::move(u.hint));
}

}  // namespace scree::io
