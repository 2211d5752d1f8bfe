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
          did_you_mean(name, known,
                       what == "method" ? "correct the name, or name the library that has the method: --load LIBRARY"
                                        : fmt::format("define the {}, or correct the name", what))};
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

bool matches(std::string_view pattern, std::string_view name) {
  // Greedy: on a mismatch the last star matches one more character.
  std::size_t p = 0, n = 0, star = std::string_view::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<std::int32_t> find_names(const Section& section, std::string_view key, std::size_t item,
                                     std::string_view what, const std::vector<std::string>& known) {
  const std::string name = section.texts(key)[item];
  if (name.find('*') == std::string::npos || index_of(name, known) >= 0)
    return {find_name(section, key, item, what, known)};
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (matches(name, known[i])) found.push_back(static_cast<std::int32_t>(i));
  if (found.empty())
    throw section.error(key, item, fmt::format("no {} fits the pattern", what), listed(known),
                        "* stands for any characters, all others for themselves");
  return found;
}

}  // namespace scree::io
