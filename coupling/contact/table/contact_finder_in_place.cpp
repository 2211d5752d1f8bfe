// Contact points brought to the next instant where they are: the same list, the same memories, to the bits of find().
#include <algorithm>

#include "coupling/contact/table/contact_finder.h"

namespace scree::coupling {

void ContactFinder::index(const ContactList& list) {
  known_.index(list);
  moving_.resize(list.points.size());
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    const ContactPoint& p = list.points[i];
    moving_[i].partnered = std::max(p.partner[0], p.partner[1]) >= 0;
    moving_[i].corner = !p.edge_edge;
  }
}

bool ContactFinder::stays(const VertexEdge& pair, std::int32_t row, const ContactList& list) {
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& edge = o.edges[static_cast<std::size_t>(pair.edge)];
  const bool listed = row >= 0, closed = listed && known_.closed(static_cast<std::size_t>(row));
  if (closed && pair.tributary > 0.0 && edge.segments == 1) {
    moving_[static_cast<std::size_t>(row)].segment = edge.first_segment;
    return true;
  }
  const Vec2& at = x_[static_cast<std::size_t>(o.vertices[static_cast<std::size_t>(pair.vertex)].node)];
  const Under under = closed && edge.segments == 1 ? Under{edge.first_segment, 0.0} : segment_under(at, pair.edge);
  if (!closed && under.distance > detection_) return !listed;
  if (listed) moving_[static_cast<std::size_t>(row)].segment = under.segment;
  if (closed && pair.tributary > 0.0) return true;
  // A corner in an impact may pass to a tip, and gives its energy away where it ends: find() knows how.
  if (closed && known_.impact(static_cast<std::size_t>(row)) > 0.0) return false;
  ContactPoint p;
  p.segment = under.segment;
  p.from = row;
  return touches(pair, listed ? &list.memory[static_cast<std::size_t>(row)] : nullptr, closed, p) == listed;
}

bool ContactFinder::passes_on(std::size_t first, std::size_t last, const ContactList& list) {
  const std::span<const VertexEdge> pairs = pairs_.pairs();
  bool open = false, passing = false;
  for (std::size_t i = first; i < last; ++i) {
    const bool corner = !(pairs[static_cast<std::size_t>(moving_[i].pair)].tributary > 0.0);
    if (!known_.closed(i))
      open = true;
    else
      passing = passing || corner || known_.impact(i) > 0.0;
  }
  if (!open || !passing) return false;
  of_vertex_.clear();
  for (std::size_t i = first; i < last; ++i) {
    ContactPoint& p = of_vertex_.emplace_back();
    p.segment = moving_[i].segment;
    p.from = static_cast<std::int32_t>(i);
    (void)touches(pairs[static_cast<std::size_t>(moving_[i].pair)], &list.memory[i], known_.closed(i), p);
  }
  return std::any_of(of_vertex_.begin(), of_vertex_.end(),
                     [this](const ContactPoint& p) { return successor(p, of_vertex_) != nullptr; });
}

bool ContactFinder::keeps(std::span<const double> q, const ContactList& list) {
  place_nodes(q);
  const std::span<const VertexEdge> pairs = pairs_.update(x_, known_, ContactPairs::Of::all);
  if (known_.divided()) return false;
  const std::size_t size = known_.size();
  first_.clear();
  std::size_t row = 0, first_of_vertex = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const VertexEdge& pair = pairs[k];
    const bool listed = row < size && known_.vertex(row) == pair.vertex && known_.edge(row) == pair.edge;
    if (!stays(pair, listed ? static_cast<std::int32_t>(row) : -1, list)) return false;
    if (!listed) continue;
    moving_[row].pair = static_cast<std::int32_t>(k);
    if (moving_[row].partnered || moving_[row].corner || !(pair.tributary > 0.0))
      first_.push_back(static_cast<std::int32_t>(row));
    if (known_.vertex(first_of_vertex) != pair.vertex) {
      if (row - first_of_vertex > 1 && passes_on(first_of_vertex, row, list)) return false;
      first_of_vertex = row;
    }
    ++row;
  }
  if (row < size) return false;
  return !(row - first_of_vertex > 1 && passes_on(first_of_vertex, row, list));
}

void ContactFinder::move(std::size_t i, ContactList& list) {
  ContactPoint& p = list.points[i];
  ContactMemory& m = list.memory[i];
  const VertexEdge& pair = pairs_.pairs()[static_cast<std::size_t>(moving_[i].pair)];
  const bool closed = m.status != ContactStatus::open;
  const std::array partner{p.partner[0], p.partner[1]};
  p = ContactPoint{};
  p.key = m.key;
  p.partner[0] = partner[0];
  p.partner[1] = partner[1];
  p.segment = moving_[i].segment;
  p.from = static_cast<std::int32_t>(i);
  (void)touches(pair, &m, closed, p);
  describe(pair, &m, closed, p);
  fill(&m, false, false, p, m);
  moving_[i].corner = !p.edge_edge;
  const bool waits = moving_[i].partnered || !p.edge_edge;  // for settle()
  if (!waits && !setup_->model().waters.empty()) fill_with_water(p, m);
}

void ContactFinder::settle(ContactList& list) {
  merged_ = 0.0;
  corners_.clear();
  paired_.clear();
  for (const std::int32_t k : first_) {
    const auto i = static_cast<std::size_t>(k);
    if (!known_.closed(i) && !list.points[i].edge_edge) corners_.push_back(k);
    if (moving_[i].partnered) paired_.push_back(k);
  }
  cover_corners(list);
  suppress_second_edges(false, list);
  if (setup_->model().waters.empty()) return;
  for (const std::int32_t i : first_)
    fill_with_water(list.points[static_cast<std::size_t>(i)], list.memory[static_cast<std::size_t>(i)]);
}

}  // namespace scree::coupling
