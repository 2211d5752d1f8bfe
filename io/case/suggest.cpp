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
  return best;
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
