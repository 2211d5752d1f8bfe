// Contact points updated to the next instant in place: the same list, the same memories, to the bits of find().
#include <algorithm>
#include <limits>
#include <utility>

#include "coupling/contact/table/contact_finder.h"
#include "coupling/contact/table/contact_finder_rules.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

constexpr std::size_t kFewPairs = 1024;  // fewer pairs of vertex and edge are not worth waking threads

bool has_partner(const ContactPoint& p) { return std::max(p.partner[0], p.partner[1]) >= 0; }

}  // namespace

void ContactFinder::index(const ContactList& list, bool in_turn) {
  known_.index(list);
  if (!in_turn) pairs_.forget();
  kind_.resize(list.points.size());
  parallel_for(std::ssize(kind_), [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    kind_[i] = {has_partner(list.points[i]), !list.points[i].edge_edge};
  });
}

void ContactFinder::take_noted(const ContactList& list) {
  known_.take_noted();
  if (!splice_.empty()) known_.replace(splice_, list.briefs);
}

bool ContactFinder::stays(const VertexEdge& pair, std::int32_t row, const ContactList& list, QuietPoints::Quiet& quiet,
                          bool& anew) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& edge = o.edges[pair.edge];
  const bool listed = row >= 0, closed = listed && known_.closed(static_cast<std::size_t>(row)),
             faces = pair.tributary > 0.0, several = edge.segments > 1;
  quiet.segment = edge.first_segment;
  if (closed && faces && !several) return true;
  const Vec2& at = x_[o.vertices[pair.vertex].node];
  const Under under = closed && !several
                          ? Under{quiet.segment, 0.0}
                          : segment_under(at, pair.edge, listed ? known_.segment(static_cast<std::size_t>(row)) : -1);
  quiet.segment = under.segment;
  if (!closed && under.distance > detection_) {
    // The distance to a segment changes by what both move.
    if (several && !listed) quiet.room = std::min(under.room, 0.5 * (under.distance - detection_));
    return !listed;
  }
  if (closed && faces) {
    quiet.room = under.room;
    return true;
  }
  ContactPoint p;
  p.segment = under.segment;
  p.from = row;
  const ContactMemory* was = listed ? &list.memory[static_cast<std::size_t>(row)] : nullptr;
  if (touches(pair, was, closed, p) != listed) return false;
  // Open, and near: such a point ends with the overlap, or where it is no longer near.
  if (several && listed && !closed && p.edge_edge && springs_.width(pair.edge) > 2.0 * detection_)
    quiet.room = std::min(under.room, 0.5 * (detection_ - under.distance));
  if (several && !listed && !faces) {
    const Outlines::Vertex& v = o.vertices[pair.vertex];
    const auto side = [&](OutlineNode next) { return averted_room(x_[next] - at, p.at); };
    const double room = std::max(side(o.segments[leaving(pair.vertex)].b), side(o.segments[v.segment_in].a));
    quiet = {QuietPoints::Kind::averted, under.segment, std::min(under.room, room)};
  }
  anew = anew || (closed && tip_beside(p).valid());
  return true;
}

bool ContactFinder::passes_on(std::size_t first, std::size_t last, const ContactList& list,
                              std::vector<ContactPoint>& of_vertex) const {
  const std::span<const VertexEdge> pairs = pairs_.pairs();
  const auto pair_of = [&](std::size_t i) -> const VertexEdge& {
    return pairs[static_cast<std::size_t>(moving_[i].pair)];
  };
  bool open = false, passing = false;
  for (std::size_t i = first; i < last; ++i) {
    const auto was = static_cast<std::size_t>(moving_[i].from);
    if (known_.closed(was))
      passing = passing || !(pair_of(i).tributary > 0.0) || known_.impact(was) > 0.0;
    else
      open = true;
  }
  if (!open || !passing) return false;
  of_vertex.clear();
  for (std::size_t i = first; i < last; ++i) {
    ContactPoint& p = of_vertex.emplace_back();
    p.segment = moving_[i].segment;
    p.from = moving_[i].from;
    const auto was = static_cast<std::size_t>(p.from);
    (void)touches(pair_of(i), &list.memory[was], known_.closed(was), p);
  }
  return std::any_of(of_vertex.begin(), of_vertex.end(),
                     [&](const ContactPoint& p) { return successor(p, of_vertex) != nullptr; });
}

bool ContactFinder::stay(VertexIndex vertex, const ContactList& list, Kept& kept) {
  const std::span<const VertexEdge> pairs = pairs_.pairs();
  const std::size_t first = known_.first_point(vertex), end = known_.first_point(vertex + 1);
  std::size_t row = first;
  for (std::size_t k = pairs_.first_pair(vertex); k < pairs_.first_pair(vertex + 1); ++k) {
    const bool listed = row < end && known_.edge(row) == pairs[k].edge;
    using As = QuietPoints::Kind;
    const As kind = !listed ? As::far : (known_.closed(row) ? As::closed : As::open);
    const bool faces = pairs[k].tributary > 0.0,
               quiet = listed ? faces && quiet_.quiet(k, kind)
                              : quiet_.quiet(k, kind) || (!faces && quiet_.quiet(k, As::averted));
    QuietPoints::Quiet as{kind};
    if (quiet) {
      as.segment = quiet_.segment(k);
    } else {
      const std::int32_t known = listed ? static_cast<std::int32_t>(row) : -1;
      if (!stays(pairs[k], known, list, as, kept.anew)) return false;
      if (as.room > 0.0) quiet_.set(k, as);
    }
    if (!listed) continue;
    moving_[row] = {static_cast<std::int32_t>(k), static_cast<std::int32_t>(row), as.segment};
    ++row;
  }
  return row == end && !(end - first > 1 && passes_on(first, end, list, kept.of_vertex));
}

bool ContactFinder::keeps(std::span<const double> q, const ContactList& list) {
  place_nodes(q);
  (void)pairs_.update(x_, known_, ContactPairs::Of::all_in_turn);
  quiet_.begin(pairs_);
  if (known_.divided()) return false;
  const std::size_t size = known_.size(), vertices = setup_->outlines().vertices.size();
  moving_.resize(size);
  forget_gone(size);
  splice_.begin(size);
  const auto of_vertices = [&](std::int64_t begin, std::int64_t end) {
    Kept& kept = kept_[static_cast<std::size_t>(begin / kContactChunk)];
    kept.anew = false;
    kept.changed.clear();
    const VertexIndex first{static_cast<std::int32_t>(begin)}, last{static_cast<std::int32_t>(end)};
    const bool none =
        pairs_.first_pair(first) == pairs_.first_pair(last) && known_.first_point(first) == known_.first_point(last);
    if (none) return;  // most vertices of a long outline have no contact near
    for (const VertexIndex v : IndexRange(first, last))
      if (!stay(v, list, kept)) kept.changed.push_back(v);
  };
  // Most vertices of a large base have nothing near: the number of pairs decides about threads.
  const auto count = static_cast<std::int64_t>(vertices);
  parallel_for_chunks(count, of_vertices, pairs_.pairs().size() < kFewPairs ? count + 1 : 0, kContactChunk);
  if (std::any_of(kept_.begin(), kept_.end(), [](const Kept& kept) { return kept.anew; })) return false;
  if (std::all_of(kept_.begin(), kept_.end(), [](const Kept& kept) { return kept.changed.empty(); })) return true;
  make_changed();
  return complete_made(list);
}

void ContactFinder::forget_gone(std::size_t size) {
  if (std::exchange(listed_anew_, false))
    gone_.clear();
  else
    for (const Changed& c : changed()) std::fill(gone_.begin() + c.begin, gone_.begin() + c.end, 0);
  gone_.resize(size);
}

void ContactFinder::make_changed() {
  made_.points.clear();
  made_.memory.clear();
  made_.briefs.clear();
  fresh_.clear();
  for (const Kept& kept : kept_)
    for (const VertexIndex vertex : kept.changed) {
      const std::size_t begin = known_.first_point(vertex), end = known_.first_point(vertex + 1),
                        pair = pairs_.first_pair(vertex), first = made_.points.size();
      std::fill(gone_.begin() + static_cast<std::ptrdiff_t>(begin), gone_.begin() + static_cast<std::ptrdiff_t>(end),
                1);
      list_vertex(pairs_.pairs().subspan(pair, pairs_.first_pair(vertex + 1) - pair), begin, false, made_);
      splice_.replace({vertex, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end),
                       static_cast<std::int32_t>(first), static_cast<std::int32_t>(made_.points.size() - first)});
    }
}

bool ContactFinder::complete_made(const ContactList& list) {
  inherit(made_);
  for (const std::int32_t i : fresh_) remember(static_cast<std::size_t>(i), false, made_);
  for (const Changed& c : changed())
    for (std::int32_t k = c.begin; k < c.end; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (gone_[i] != 0 && known_.closed(i) && known_.impact(i) != 0.0 && list.memory[i].gap < 0.0) return false;
    }
  return std::none_of(made_.points.begin(), made_.points.end(),
                      [this](const ContactPoint& p) { return tip_beside(p).valid(); });
}

void ContactFinder::splice(ContactList& list) {
  splice_.move(list.points);
  splice_.move(list.memory);
  splice_.move(list.briefs);
  splice_.move(moving_);
  splice_.move(kind_);
  const auto shift_partners = [](ContactPoint& p, std::int32_t by) {
    for (std::int32_t& partner : p.partner)
      if (partner >= 0) partner += by;
  };
  splice_.for_moved([&](std::size_t i, std::int32_t by) {
    if (kind_[i].partnered) shift_partners(list.points[i], by);
  });
  splice_.for_new([&](std::size_t to, std::size_t from) {
    list.points[to] = made_.points[from];
    list.memory[to] = made_.memory[from];
    list.briefs[to] = made_.briefs[from];
    shift_partners(list.points[to], static_cast<std::int32_t>(to) - static_cast<std::int32_t>(from));
    moving_[to] = {-1, -1, {}, true};
    kind_[to] = {has_partner(list.points[to]), !list.points[to].edge_edge};
  });
  known_.expect(splice_.size());
}

bool ContactFinder::move_along(const VertexEdge& pair, const Moving& moving, ContactPoint& p, ContactMemory& m) const {
  const bool alike = m.status != ContactStatus::open && m.edge_edge != 0 && m.impact == 0.0 && p.edge_edge &&
                     pair.tributary > 0.0 && p.segment == moving.segment;
  const JointId law = springs_.law_of(pair.own, pair.edge);
  if (!alike || law.value != p.joint) return false;
  p.from = moving.from;
  p.beside = -1;
  p.behind = pair.behind;
  p.ahead = pair.ahead;
  p.suppressed = false;
  p.at = contact_geometry(x_[p.node[0]], frames_[p.segment]);
  p.s_high = p.at.length + detection_;
  set_springs(pair, law, p);
  m.tributary = p.springs.tributary;
  m.kn = p.springs.kn;
  m.kt = p.springs.kt;
  set_damping(p, m);
  m.gap = p.at.gap - m.gap0;
  m.stretch = (p.at.xi - m.anchor) * p.at.length;
  return true;
}

void ContactFinder::move(std::size_t i, ContactList& list) {
  ContactPoint& p = list.points[i];
  ContactMemory& m = list.memory[i];
  const Moving& moving = moving_[i];
  const VertexEdge& pair = pairs_.pairs()[static_cast<std::size_t>(moving.pair)];
  if (move_along(pair, moving, p, m)) {
    if (!kind_[i].partnered && !setup_->model().waters.empty()) fill_with_water(p, m);
    return;
  }
  const bool closed = m.status != ContactStatus::open;
  const std::array partner{p.partner[0], p.partner[1]};
  p = ContactPoint{};
  p.key = m.key;
  p.partner[0] = partner[0];
  p.partner[1] = partner[1];
  p.segment = moving.segment;
  p.from = moving.from;
  (void)touches(pair, &m, closed, p);
  describe(pair, &m, closed, p);
  fill(&m, false, false, p, m);
  kind_[i].corner = !p.edge_edge;
  const bool waits = kind_[i].partnered || !p.edge_edge;  // for settle()
  if (!waits && !setup_->model().waters.empty()) fill_with_water(p, m);
}

void ContactFinder::find_first() {
  const auto take = [this](std::int64_t at, std::vector<std::int32_t>& out) {
    const auto i = static_cast<std::size_t>(at);
    if (moving_[i].made || kind_[i].partnered || kind_[i].corner ||
        !(pairs_.pairs()[static_cast<std::size_t>(moving_[i].pair)].tributary > 0.0))
      out.push_back(static_cast<std::int32_t>(i));
  };
  parallel_list(std::ssize(moving_), first_by_chunk_, first_, take);
}

void ContactFinder::settle(ContactList& list) {
  merged_ = 0.0;
  corners_.clear();
  paired_.clear();
  for (const std::int32_t k : first_) {
    const auto i = static_cast<std::size_t>(k);
    if (!list.points[i].edge_edge && !was_closed(list.points[i])) corners_.push_back(k);
    if (kind_[i].partnered) paired_.push_back(k);
  }
  cover_corners(list);
  suppress_second_edges(false, list);
  if (setup_->model().waters.empty()) return;
  for (const std::int32_t i : first_)
    fill_with_water(list.points[static_cast<std::size_t>(i)], list.memory[static_cast<std::size_t>(i)]);
}

}  // namespace scree::coupling
