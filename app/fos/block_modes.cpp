#include "app/fos/block_modes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "io/results/file_error.h"

namespace scree::app {
namespace {

constexpr double kMoves = 0.1;                   // least displacement of a moving block over the largest of all blocks
constexpr double kTopples = 0.6, kSlides = 0.2;  // bounds on the displacement by rotation over that of the centroid
constexpr double kSlips = 0.05;                  // bound on the slip at contacts over the displacement of the centroid
constexpr double kFreeFall = 0.75;               // least downward acceleration of a falling block over g

/// Indices of the points of each block, sorted and without duplicates.
std::vector<std::vector<std::size_t>> points_of(const io::StoredFrame& frame, std::size_t blocks) {
  std::vector<std::vector<std::size_t>> out(blocks);
  for (std::size_t c = 0; c < frame.cells(); ++c)
    for (auto i = frame.offsets[c]; i < frame.offsets[c + 1]; ++i)
      out[static_cast<std::size_t>(frame.block[c])].push_back(
          static_cast<std::size_t>(frame.connectivity[static_cast<std::size_t>(i)]));
  for (auto& list : out) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return out;
}

Vec2 at(const std::vector<double>& xy, std::size_t i) { return {xy[2 * i], xy[2 * i + 1]}; }

Vec2 mean(const std::vector<double>& xy, const std::vector<std::size_t>& points) {
  Vec2 sum = Vec2::Zero();
  for (const std::size_t i : points) sum += at(xy, i);
  return sum / static_cast<double>(points.size());
}

/// Rotation of the rigid motion that fits the displacements of the given points best, by least squares [rad].
double rotation(const std::vector<double>& before, const std::vector<double>& after,
                const std::vector<std::size_t>& points) {
  const Vec2 from = mean(before, points), to = mean(after, points);
  double cross = 0.0, dot = 0.0;
  for (const std::size_t i : points) {
    const Vec2 x = at(before, i) - from, y = at(after, i) - to;
    cross += x.x() * y.y() - x.y() * y.x();
    dot += x.dot(y);
  }
  return std::atan2(cross, dot);
}

/// Largest slip and opening at the contacts of every pair of blocks, and the blocks that have a closed contact.
struct Joints {
  std::map<std::pair<std::int32_t, std::int32_t>, double> slip, gap;
  std::map<std::int32_t, bool> closed;
};

Joints joints_of(const io::StoredContacts& c) {
  Joints out;
  for (std::size_t i = 0; i < c.state.size(); ++i) {
    const std::pair pair = std::minmax(c.corner_block[i], c.edge_block[i]);
    const std::pair<std::int32_t, std::int32_t> key{pair.first, pair.second};
    out.slip[key] = std::max(out.slip[key], c.slip[i]);
    out.gap[key] = std::max(out.gap[key], c.gap[i]);
    if (c.state[i] == 0) continue;
    out.closed[key.first] = true;
    out.closed[key.second] = true;
  }
  return out;
}

}  // namespace

std::string_view name(Mode mode) {
  switch (mode) {
    case Mode::stands:
      return "stands";
    case Mode::slides:
      return "slides";
    case Mode::topples:
      return "topples";
    case Mode::slides_and_topples:
      return "slides and topples";
    case Mode::falls:
      return "falls";
  }
  return "unknown";
}

std::vector<BlockMotion> block_motions(const io::RunReader& run, std::size_t from, std::size_t to) {
  const io::StoredFrame before = run.frame(from), after = run.frame(to);
  if (before.position.size() != after.position.size())
    throw io::FileError("run.vtkhdf", "two frames that are to be compared have different meshes");
  const std::vector<io::StoredBlock>& blocks = run.blocks();
  const auto points = points_of(after, blocks.size());
  Joints first, last;
  if (run.has_contacts()) {
    first = joints_of(run.contacts(from));
    last = joints_of(run.contacts(to));
  }
  std::vector<BlockMotion> out;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].held || points[b].empty()) continue;
    BlockMotion m;
    m.name = blocks[b].name;
    const Vec2 centre = mean(before.position, points[b]);
    m.displacement = mean(after.position, points[b]) - centre;
    m.rotation = rotation(before.position, after.position, points[b]);
    m.speed = mean(after.velocity, points[b]).norm();
    m.first_speed = mean(before.velocity, points[b]).norm();
    m.area = moments(blocks[b].polygon).area;
    for (const std::size_t i : points[b]) m.radius = std::max(m.radius, (at(before.position, i) - centre).norm());
    const auto id = static_cast<std::int32_t>(b);
    for (const auto& [pair, slip] : last.slip) {
      if (pair.first != id && pair.second != id) continue;
      m.slip = std::max(m.slip, slip - first.slip[pair]);
      m.gap = std::max(m.gap, last.gap[pair] - first.gap[pair]);
    }
    m.touches = !run.has_contacts() || last.closed[id];
    out.push_back(std::move(m));
  }
  return out;
}

void name_modes(std::vector<BlockMotion>& motions, double seconds, const Vec2& gravity) {
  const auto way = [](const BlockMotion& m) {
    return std::max(m.displacement.norm(), std::abs(m.rotation) * m.radius);
  };
  double farthest = 0.0;
  for (const BlockMotion& m : motions) farthest = std::max(farthest, way(m));
  for (BlockMotion& m : motions) {
    if (!(way(m) > kMoves * farthest)) {
      m.mode = Mode::stands;
      continue;
    }
    const double shift = m.displacement.norm(), turn = std::abs(m.rotation) * m.radius;
    const double down = gravity.norm() > 0.0 ? m.displacement.dot(gravity) / gravity.norm() : 0.0;
    if (!m.touches || (seconds > 0.0 && down > kFreeFall * 0.5 * gravity.norm() * seconds * seconds))
      m.mode = Mode::falls;
    else if (turn > kTopples * shift || (turn > kSlides * shift && m.slip < kSlips * shift))
      m.mode = Mode::topples;
    else
      m.mode = turn > kSlides * shift ? Mode::slides_and_topples : Mode::slides;
  }
}

Mode leading_mode(const std::vector<BlockMotion>& motions) {
  std::array<double, 5> sum{};
  for (const BlockMotion& m : motions)
    if (m.mode != Mode::stands)
      sum[static_cast<std::size_t>(m.mode)] +=
          m.area * std::max(m.displacement.norm(), std::abs(m.rotation) * m.radius);
  const auto best = std::max_element(sum.begin(), sum.end());
  return *best > 0.0 ? static_cast<Mode>(best - sum.begin()) : Mode::stands;
}

}  // namespace scree::app
