// Gaps and stretches of an implicit step's contact points as rows of its unknowns.
#include <algorithm>
#include <atomic>

#include "coupling/integrate/open_close.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

constexpr std::int64_t kFewRows = 4096;  // fewer points or nodes are handled on one thread

}  // namespace

void OpenClose::add_rows(std::span<const double> q, std::span<const Vec2> driven_move) {
  std::fill(chart_of_node_.begin(), chart_of_node_.end(), -1);
  if (system_->affine() && add_affine_rows(q, driven_move)) return;
  charts_.clear();
  std::fill(chart_of_node_.begin(), chart_of_node_.end(), -1);
  for (std::size_t i = 0; i < list_->points.size(); ++i) add_rows(list_->points[i], list_->memory[i], q, driven_move);
}

const ChartRow& OpenClose::chart(OutlineNode node, std::span<const double> q) {
  const Outlines& o = setup_->outlines();
  std::int32_t& chart = chart_of_node_[node];
  if (chart < 0) {
    chart = static_cast<std::int32_t>(charts_.size());
    charts_.push_back(system_->chart(o.node_body[node], o.nodes[node], q));
  }
  return charts_[static_cast<std::size_t>(chart)];
}

void OpenClose::add_rows(const ContactPoint& p, const ContactMemory& m, std::span<const double> q,
                         std::span<const Vec2> driven_move) {
  const Outlines& o = setup_->outlines();
  for (const ContactRow& row : {gap_row(p.at), stretch_row(p.at, m.anchor)}) {
    rows_.begin_row();
    for (std::size_t i = 0; i < 3; ++i) {
      const BodyIndex body = o.node_body[p.node[i]];
      if (setup_->body(body).driven)
        rows_.add_known(row[i].dot(driven_move[body.index()]));
      else
        ImplicitSystem::add_point(chart(p.node[i], q), row[i], rows_);
    }
  }
}

bool OpenClose::find_affine_charts(std::span<const double> q) {
  const Outlines& o = setup_->outlines();
  constexpr std::int32_t kUsed = -2;
  row_size_.resize(2 * list_->points.size());
  const auto mark = [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    const ContactPoint& p = list_->points[i];
    const BodyIndex corner = o.node_body[p.node[0]], edge = o.node_body[p.node[1]];
    const bool corner_moves = !setup_->body(corner).driven, edge_moves = !setup_->body(edge).driven;
    const int bodies = (corner_moves ? 1 : 0) + (edge_moves && edge != corner ? 1 : 0);
    row_size_[2 * i] = row_size_[2 * i + 1] = bodies * kBlockSide;
    for (std::size_t k = 0; k < 3; ++k)
      if (k == 0 ? corner_moves : edge_moves)
        std::atomic_ref(chart_of_node_[p.node[k]]).store(kUsed, std::memory_order_relaxed);
  };
  parallel_for(std::ssize(list_->points), mark, kFewRows);
  charted_.clear();
  for (const OutlineNode node : o.nodes.indices()) {
    if (chart_of_node_[node] != kUsed) continue;
    chart_of_node_[node] = static_cast<std::int32_t>(charted_.size());
    charted_.push_back(node);
  }
  if (charted_.size() > affine_charts_.capacity()) {  // resize() would double it
    affine_charts_.clear();
    affine_charts_.reserve(charted_.size() + charted_.size() / 16);
  }
  affine_charts_.resize(charted_.size());
  parallel_for(
      std::ssize(charted_),
      [&](std::int64_t at) {
        const OutlineNode node = charted_[static_cast<std::size_t>(at)];
        AffineChart& out = affine_charts_[static_cast<std::size_t>(at)];
        const ChartRow row = system_->chart(o.node_body[node], o.nodes[node], q);
        bool run = static_cast<std::size_t>(row.n) == out.tx.size();
        for (std::size_t k = 1; run && k < out.tx.size(); ++k) run = row.dof[k] == row.dof[k - 1] + 1;
        out.first = run ? row.dof[0] : -1;
        std::copy_n(row.tx.begin(), out.tx.size(), out.tx.begin());
        std::copy_n(row.ty.begin(), out.ty.size(), out.ty.begin());
      },
      kFewRows);
  return std::all_of(affine_charts_.begin(), affine_charts_.end(), [](const AffineChart& c) { return c.first >= 0; });
}

bool OpenClose::add_affine_rows(std::span<const double> q, std::span<const Vec2> driven_move) {
  if (!find_affine_charts(q)) return false;
  rows_.extend(row_size_);
  parallel_for(
      std::ssize(list_->points), [&](std::int64_t i) { fill_affine_rows(static_cast<std::size_t>(i), driven_move); },
      kFewRows);
  return true;
}

void OpenClose::fill_affine_rows(std::size_t point, std::span<const Vec2> driven_move) {
  const Outlines& o = setup_->outlines();
  const ContactPoint& p = list_->points[point];
  constexpr std::size_t kUnknowns = std::tuple_size_v<decltype(AffineChart::tx)>;
  std::array<const AffineChart*, 3> chart{};
  for (std::size_t i = 0; i < 3; ++i)
    if (const std::int32_t at = chart_of_node_[p.node[i]]; at >= 0)
      chart[i] = &affine_charts_[static_cast<std::size_t>(at)];
  const bool both = chart[0] != nullptr && chart[1] != nullptr && chart[0]->first != chart[1]->first;
  const std::size_t row = springs_->size() + 2 * point;
  for (std::size_t r = 0; r < 2; ++r) {
    const ContactRow along = r == 0 ? gap_row(p.at) : stretch_row(p.at, list_->memory[point].anchor);
    const DofRows::Filled out = rows_.fill(row + r);
    double known = 0.0;
    bool begun[2] = {};
    for (std::size_t i = 0; i < 3; ++i) {
      if (chart[i] == nullptr) {
        known += along[i].dot(driven_move[o.node_body[p.node[i]].index()]);
        continue;
      }
      // Unknowns are in ascending order: those of the other body are first, or last.
      const std::size_t place = both && chart[i]->first > std::min(chart[0]->first, chart[1]->first) ? 1 : 0;
      const std::size_t first = kUnknowns * place;
      const DoubleColumn tx(chart[i]->tx.data()), ty(chart[i]->ty.data());
      DoubleColumn h;
      h.set(along[i].x(), tx, along[i].y(), ty);
      if (begun[place]) {
        DoubleColumn sum(&out.h[first]);
        sum.add(1.0, h);
        sum.store(&out.h[first]);
        continue;
      }
      h.store(&out.h[first]);
      for (std::size_t k = 0; k < kUnknowns; ++k) out.dof[first + k] = chart[i]->first + static_cast<std::int32_t>(k);
      begun[place] = true;
    }
    *out.known = known;
  }
}

}  // namespace scree::coupling
