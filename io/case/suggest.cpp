#include "io/case/suggest.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/case/case_error.h"

namespace scree::io {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Optimal string alignment distance.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    std::swap(last, row);
  }
  return last[b.size()];
}

std::vector<std::string_view> parts_of(std::string_view name) {
  std::vector<std::string_view> parts;
  while (!name.empty()) {
    const std::size_t end = name.find_first_of("_-. ");
    if (end != 0) parts.push_back(name.substr(0, end));
    if (end == std::string_view::npos) break;
    name.remove_prefix(end + 1);
  }
  return parts;
}

/// True if the parts of a name are beginnings of parts of the known name, in the same order: fric_deg, friction_deg.
bool abbreviates(std::string_view name, std::string_view known) {
  constexpr std::size_t kShortest = 3;  // of the first part: shorter parts fit too many names
  const std::vector<std::string_view> given = parts_of(name), full = parts_of(known);
  if (given.empty() || given.front().size() < kShortest) return false;
  std::size_t at = 0;
  for (const std::string_view part : given) {
    const auto begins = [&](std::string_view word) {
      return word.size() >= part.size() &&
             std::equal(part.begin(), part.end(), word.begin(), [](char a, char b) { return lower(a) == lower(b); });
    };
    while (at < full.size() && !begins(full[at])) ++at;
    if (at == full.size()) return false;
    ++at;
  }
  return true;
}

/// The shortest known name that a name abbreviates; empty if there is none, or if two have that length.
std::string abbreviated(std::string_view name, const std::vector<std::string>& known) {
  std::string best;
  bool two = false;
  for (const std::string& k : known) {
    if (k.size() > 100 || !abbreviates(name, k)) continue;
    if (best.empty() || k.size() < best.size()) {
      best = k;
      two = false;
    } else if (k.size() == best.size() && k != best) {
      two = true;
    }
  }
  return two ? std::string() : best;
}

}  // namespace

std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 100;  // longer names are not typed by hand, and the search is quadratic
  std::string best;
  std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
  if (name.empty() || name.size() > kLongest) return best;
  for (const std::string& k : known) {
    if (k.empty() || k.size() > kLongest) continue;
    if (const std::size_t d = edits(name, k); d < least) {
      least = d;
      best = k;
    }
  }
  return best.empty() ? abbreviated(name, known) : best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known, std::string_view otherwise) {
  const std::string near = nearest(name, known);
  return near.empty() ? std::string(otherwise) : fmt::format("did you mean {}?", in_quotes(near));
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 40;
  std::string out;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i) out += (i == 0 ? "" : ", ") + in_quotes(names[i]);
  if (names.size() > kMost) out += fmt::format(", and {} more", names.size() - kMost);
  return out;
}

}  // namespace scree::io
