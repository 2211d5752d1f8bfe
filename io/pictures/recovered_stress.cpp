#include "io/pictures/recovered_stress.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "io/pictures/frame_field.h"

namespace scree::io {
namespace {

constexpr std::size_t kEnough = 5;  // cells for a plane
constexpr double kFlat = 1e-3;      // of its extent: patches as thin as this have no plane
constexpr std::size_t kComponents = 3;

constexpr std::size_t kAlone = static_cast<std::size_t>(-1);

/// Cells that are a block each, as in DDA: their stress is not recovered, whatever their number.
std::vector<char> alone_in(const StoredFrame& f) {
  std::vector<std::int32_t> cells(1, 0);
  for (const std::int32_t block : f.block) {
    const auto b = static_cast<std::size_t>(block);
    if (b >= cells.size()) cells.resize(b + 1, 0);
    ++cells[b];
  }
  std::vector<char> alone;
  alone.reserve(f.cells());
  for (const std::int32_t block : f.block) alone.push_back(cells[static_cast<std::size_t>(block)] == 1 ? 1 : 0);
  return alone;
}

/// Node of each corner: corners of a block at one place both in the model and now are one; kAlone where a block has
/// one cell.
std::vector<std::size_t> nodes_of(const StoredFrame& f, std::size_t& count) {
  const std::vector<char> alone = alone_in(f);
  double extent = 0.0;
  for (const double x : f.position) extent = std::isfinite(x) ? std::max(extent, std::abs(x)) : extent;
  const double grid = std::max(1e-8 * extent, 1e-300);
  const auto spot = [grid](double x) { return std::isfinite(x) ? std::llround(x / grid) : 0LL; };
  std::map<std::tuple<std::int32_t, long long, long long, long long, long long>, std::size_t> known;
  std::vector<std::size_t> node(f.connectivity.size(), kAlone);
  for (std::size_t c = 0; c < f.cells(); ++c)
    for (auto i = static_cast<std::size_t>(f.offsets[c]);
         alone[c] == 0 && i < static_cast<std::size_t>(f.offsets[c + 1]); ++i) {
      const auto p = static_cast<std::size_t>(f.connectivity[i]);
      const double x = f.position[2 * p], y = f.position[2 * p + 1];
      const auto key = std::tuple(f.block[c], spot(x - f.displacement[2 * p]), spot(y - f.displacement[2 * p + 1]),
                                  spot(x), spot(y));
      node[i] = known.emplace(key, known.size()).first->second;
    }
  count = known.size();
  return node;
}

class Recovery {
 public:
  explicit Recovery(const StoredFrame& frame) : f_(&frame), node_(nodes_of(frame, nodes_)), cells_(nodes_) {
    for (std::size_t c = 0; c < f_->cells(); ++c) {
      middle_.push_back(cell_middle(*f_, c));
      area_.push_back(std::abs(cell_area(*f_, c)));
      for (const std::size_t n : corners(c))
        if (n != kAlone) cells_[n].push_back(c);
    }
    for (std::vector<std::size_t>& around : cells_)
      around.erase(std::unique(around.begin(), around.end()), around.end());
  }

  [[nodiscard]] std::vector<double> corners() const {
    std::vector<Vec2> place(nodes_, Vec2::Zero());
    for (std::size_t i = 0; i < node_.size(); ++i) {
      if (node_[i] == kAlone) continue;
      const auto p = static_cast<std::size_t>(f_->connectivity[i]);
      place[node_[i]] = Vec2(f_->position[2 * p], f_->position[2 * p + 1]);
    }
    std::vector<std::array<double, kComponents>> at(nodes_);
    for (std::size_t n = 0; n < nodes_; ++n) at[n] = value(n, place[n]);
    std::vector<double> out;
    out.reserve(kComponents * node_.size());
    for (std::size_t c = 0; c < f_->cells(); ++c)
      for (auto i = static_cast<std::size_t>(f_->offsets[c]); i < static_cast<std::size_t>(f_->offsets[c + 1]); ++i)
        for (std::size_t k = 0; k < kComponents; ++k)
          out.push_back(node_[i] == kAlone ? stress(c, k) : at[node_[i]][k]);
    return out;
  }

 private:
  [[nodiscard]] std::vector<std::size_t> corners(std::size_t c) const {
    return {node_.begin() + f_->offsets[c], node_.begin() + f_->offsets[c + 1]};
  }

  /// Cells around a node, with those of the next ring where they are few.
  [[nodiscard]] std::vector<std::size_t> patch(std::size_t n) const {
    std::vector<std::size_t> cells = cells_[n];
    if (cells.size() >= kEnough) return cells;
    for (const std::size_t c : cells_[n])
      for (const std::size_t other : corners(c)) cells.insert(cells.end(), cells_[other].begin(), cells_[other].end());
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
  }

  [[nodiscard]] double stress(std::size_t cell, std::size_t k) const { return f_->stress[kComponents * cell + k]; }

  [[nodiscard]] std::array<double, kComponents> value(std::size_t n, const Vec2& at) const {
    const std::vector<std::size_t> cells = patch(n);
    double weight = 0.0;
    Vec2 centre = Vec2::Zero();
    for (const std::size_t c : cells) {
      weight += area_[c];
      centre += area_[c] * middle_[c];
    }
    centre /= weight;
    Mat2 spread = Mat2::Zero();
    for (const std::size_t c : cells)
      spread += area_[c] / weight * (middle_[c] - centre) * (middle_[c] - centre).transpose();
    // Eigenvalues of the spread: half of its trace, more or less the radius.
    const double mean = 0.5 * spread.trace(), radius = std::hypot(0.5 * (spread(0, 0) - spread(1, 1)), spread(0, 1));
    const bool plane = cells.size() >= kEnough && mean - radius > kFlat * kFlat * (mean + radius);
    const Vec2 lever = plane ? Vec2(spread.inverse() * (at - centre)) : Vec2(Vec2::Zero());
    std::array<double, kComponents> out{};
    for (std::size_t k = 0; k < kComponents; ++k) {
      double low = stress(cells.front(), k), high = low, sum = 0.0;
      for (const std::size_t c : cells) {
        low = std::min(low, stress(c, k)), high = std::max(high, stress(c, k));
        // mean + gradient . (at - centre), gradient = spread^-1 sum w (x - centre) s
        sum += area_[c] / weight * (1.0 + lever.dot(middle_[c] - centre)) * stress(c, k);
      }
      out[k] = std::clamp(sum, low, high);
    }
    return out;
  }

  const StoredFrame* f_;
  std::size_t nodes_ = 0;
  std::vector<std::size_t> node_;                // a corner of a cell
  std::vector<std::vector<std::size_t>> cells_;  // around a node
  std::vector<Vec2> middle_;                     // per cell
  std::vector<double> area_;
};

}  // namespace

std::vector<double> recovered_stress(const StoredFrame& frame) { return Recovery(frame).corners(); }

}  // namespace scree::io
