#include "io/drawing/chains.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace scree::io {
namespace {

struct End {
  std::size_t line;
  bool last;
};

/// Ends of lines, sorted by position into a grid with cells of the joining distance.
class Ends {
 public:
  Ends(const std::vector<const DrawnLine*>& lines, double distance)
      : lines_(&lines), cell_(std::max(distance, 1e-300)) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!lines[i]->closed)
        for (const bool last : {false, true}) grid_[key(at({i, last}))].push_back({i, last});
  }
  [[nodiscard]] const Vec2& at(const End& e) const {
    const auto& points = (*lines_)[e.line]->points;
    return e.last ? points.back() : points.front();
  }
  /// Other ends within the joining distance of an end.
  [[nodiscard]] std::vector<End> meeting(const End& e) const {
    std::vector<End> out;
    const auto [i, j] = key(at(e));
    for (std::int64_t a = i - 1; a <= i + 1; ++a)
      for (std::int64_t b = j - 1; b <= j + 1; ++b)
        if (const auto cell = grid_.find({a, b}); cell != grid_.end())
          for (const End& o : cell->second)
            if (!(o.line == e.line && o.last == e.last) && (at(o) - at(e)).norm() <= cell_) out.push_back(o);
    return out;
  }

 private:
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> key(const Vec2& x) const {
    const auto whole = [this](double v) {
      return static_cast<std::int64_t>(std::clamp(std::floor(v / cell_), -9e18, 9e18));
    };
    return {whole(x.x()), whole(x.y())};
  }
  const std::vector<const DrawnLine*>* lines_;
  double cell_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<End>> grid_;
};

}  // namespace

std::vector<Chain> chained(const std::vector<const DrawnLine*>& lines, double distance) {
  const Ends ends(lines, distance);
  std::vector<char> used(lines.size(), 0);
  std::vector<Chain> out;
  /// The one end that meets another end and continues the chain; nothing at a free end.
  const auto next = [&](const End& e) -> std::optional<End> {
    const std::vector<End> meeting = ends.meeting(e);
    if (meeting.size() > 1)
      throw DrawingError(
          lines[e.line]->row,
          fmt::format("{} lines meet at ({:.10g}, {:.10g}) m", meeting.size() + 1, ends.at(e).x(), ends.at(e).y()),
          "two lines where an outline or a line of water goes on", "put other lines on another layer");
    if (meeting.empty() || used[meeting[0].line] != 0) return {};
    return meeting[0];
  };
  const auto append = [&](Chain& chain, std::size_t line, bool backwards) {
    std::vector<Vec2> points = lines[line]->points;
    if (backwards) std::reverse(points.begin(), points.end());
    chain.points.insert(chain.points.end(), points.begin() + (chain.points.empty() ? 0 : 1), points.end());
    used[line] = 1;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i] != 0) continue;
    Chain chain;
    chain.row = lines[i]->row;
    append(chain, i, false);
    if (lines[i]->closed) {
      chain.closed = true;
      out.push_back(std::move(chain));
      continue;
    }
    for (int side = 0; side < 2; ++side) {
      End tip{i, side == 0};
      while (const std::optional<End> e = next(tip)) {
        append(chain, e->line, e->last);
        tip = {e->line, !e->last};
      }
      std::reverse(chain.points.begin(), chain.points.end());  // continue at the other end, then restore the order
    }
    if (chain.points.size() > 3 && (chain.points.front() - chain.points.back()).norm() <= distance) {
      chain.points.pop_back();
      chain.closed = true;
    }
    out.push_back(std::move(chain));
  }
  return out;
}

}  // namespace scree::io
