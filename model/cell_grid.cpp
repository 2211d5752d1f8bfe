#include "model/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scree {

CellGrid::CellGrid(const Box& extent, std::size_t items) : extent_(extent) {
  constexpr double kMostCells = 1 << 18;
  const Vec2 span = (extent.hi - extent.lo).cwiseMax(1e-300);
  const double cells = std::clamp(static_cast<double>(items), 1.0, kMostCells);
  // A long and narrow extent still gets at most twice the cells: one of its sides has a single cell.
  size_ = std::max(std::sqrt(span.x() * span.y() / cells), span.maxCoeff() / cells);
  columns_ = static_cast<std::int32_t>(std::floor(span.x() / size_)) + 1;
  rows_ = static_cast<std::int32_t>(std::floor(span.y() / size_)) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

std::int32_t CellGrid::column(double x) const {
  return static_cast<std::int32_t>(std::clamp(std::floor((x - extent_.lo.x()) / size_), 0.0, columns_ - 1.0));
}
std::int32_t CellGrid::row(double y) const {
  return static_cast<std::int32_t>(std::clamp(std::floor((y - extent_.lo.y()) / size_), 0.0, rows_ - 1.0));
}

void CellGrid::insert(const Box& box, std::int32_t item) {
  for (std::int32_t r = row(box.lo.y()), last = row(box.hi.y()); r <= last; ++r)
    for (std::int32_t c = column(box.lo.x()), end = column(box.hi.x()); c <= end; ++c) {
      std::vector<std::int32_t>& items = cells_[cell(c, r)];
      if (items.empty() || items.back() != item) items.push_back(item);
    }
}

void CellGrid::insert(const Vec2& a, const Vec2& b, double reach, std::int32_t item) {
  // The segment is cut at the four lines of the extent's sides: each part lies within the extent or on one side of it.
  const Vec2 d = b - a;
  std::array<double, 6> cuts{0.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(2 * k + 1);
    if (d[k] == 0.0) continue;
    cuts[i] = std::clamp((extent_.lo[k] - a[k]) / d[k], 0.0, 1.0);
    cuts[i + 1] = std::clamp((extent_.hi[k] - a[k]) / d[k], 0.0, 1.0);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] == cuts[i]) continue;
    const Vec2 p = a + cuts[i] * d, q = a + cuts[i + 1] * d, middle = 0.5 * (p + q);
    const bool within = (middle.array() >= extent_.lo.array()).all() && (middle.array() <= extent_.hi.array()).all();
    insert_pieces(p, q, within ? static_cast<std::int64_t>(std::ceil((q - p).norm() / size_)) + 1 : 1, reach, item);
  }
}

void CellGrid::insert_pieces(const Vec2& a, const Vec2& b, std::int64_t pieces, double reach, std::int32_t item) {
  const Vec2 margin(reach, reach);
  for (std::int64_t i = 0; i < pieces; ++i) {
    const Vec2 p = a + (b - a) * (static_cast<double>(i) / static_cast<double>(pieces));
    const Vec2 q = a + (b - a) * (static_cast<double>(i + 1) / static_cast<double>(pieces));
    insert({p.cwiseMin(q) - margin, p.cwiseMax(q) + margin}, item);
  }
}

std::span<const std::int32_t> CellGrid::at(const Vec2& point) const {
  return cells_[cell(column(point.x()), row(point.y()))];
}

void CellGrid::near(const Box& box, std::vector<std::int32_t>& items) const {
  items.clear();
  for (std::int32_t r = row(box.lo.y()), last = row(box.hi.y()); r <= last; ++r)
    for (std::int32_t c = column(box.lo.x()), end = column(box.hi.x()); c <= end; ++c) {
      const std::vector<std::int32_t>& here = cells_[cell(c, r)];
      items.insert(items.end(), here.begin(), here.end());
    }
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace scree
