#include "coupling/contact/table/contact_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "coupling/contact/law/joint_strength.h"
#include "coupling/contact/table/contact_finder_rules.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// Square of the distance from a point to a segment.
inline double squared_distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double along = (p - a).dot(d), whole = d.squaredNorm();
  const double s = along <= 0.0 ? 0.0 : (along >= whole ? 1.0 : along / whole);  // most points lie beyond an end
  return (p - a - s * d).squaredNorm();
}

constexpr std::size_t kAhead = 12;       // pairs: edges on the other side are prefetched so far ahead
constexpr double kClearly = 1.0 - 1e-6;  // of a depth: at equal ones a corner does not alternate
constexpr double kBoundMargin = 0.1;     // of a point's largest share, so that the step bound covers small changes

}  // namespace

ContactFinder::ContactFinder(const Setup& setup, double detection)
    : setup_(&setup),
      detection_(detection),
      touching_(1e-3 * detection),
      springs_(setup),
      pairs_(setup, springs_, 2.0 * detection),
      quiet_(setup.outlines()),
      known_(setup.outlines()),
      x_(setup.outlines().nodes.size()),
      frames_(setup.outlines().segments.size()) {
  const Outlines& o = setup.outlines();
  const std::size_t expected = 2 * o.vertices.size();  // so that steps need not allocate
  moving_.reserve(expected);
  kind_.reserve(expected);
  for (auto* points : {&first_, &gone_, &fresh_, &corners_, &paired_}) points->reserve(expected);
  constexpr std::size_t kFew = 1000, kFewOfVertex = 16;
  splice_.reserve(std::min(expected, kFew));
  first_by_chunk_.resize(expected / kChunk + 1);
  for (std::vector<std::int32_t>& list : first_by_chunk_)
    list.reserve(std::min(expected, static_cast<std::size_t>(kChunk)));
  kept_.resize((o.vertices.size() + kContactChunk - 1) / kContactChunk);
  for (Kept& kept : kept_) {
    kept.changed.reserve(std::min(expected, kFewOfVertex));
    kept.of_vertex.reserve(std::min(expected, kFewOfVertex));
  }
  made_.points.reserve(std::min(expected, kFew));
  made_.memory.reserve(std::min(expected, kFew));
  made_.briefs.reserve(std::min(expected, kFew));
  for (const OutlineNode i : o.nodes.indices()) {
    const Body& b = setup.body(o.node_body[i]);
    largest_weights_ =
        std::max(largest_weights_, std::abs(o.nodes[i].w[0]) + std::abs(o.nodes[i].w[1]) + std::abs(o.nodes[i].w[2]));
    compliance_.push_back(b.driven && !b.ghost ? 0.0
                                               : setup.pool_of(b).compliance(b.index, setup.local(b, o.nodes[i])));
  }
}

ContactKey ContactFinder::key_of(VertexIndex vertex, EdgeIndex edge) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Segment& s = o.segments[leaving(vertex)];
  const Outlines::Edge &own = o.edges[s.edge], &e = o.edges[edge];
  const auto block = [&](BodyIndex body) { return setup_->body(body).block.value; };
  return {block(own.body), own.ring, own.edge, s.part, block(e.body), e.ring, e.edge};
}

void ContactFinder::restore(std::span<const ContactMemory> memory, ContactList& out) const {
  const Outlines& o = setup_->outlines();
  out.points.clear();
  out.memory.clear();
  out.briefs.clear();
  for (const ContactMemory& m : memory) {
    const EdgeIndex of = setup_->edge_of(m.key.block_p, m.key.ring_p, m.key.vertex);
    ContactPoint p;
    p.key = m.key;
    p.edge = setup_->edge_of(m.key.block_e, m.key.ring_e, m.key.edge);
    if (!of.valid() || !p.edge.valid()) continue;  // the face of a crack that this stage does not cut
    const Outlines::Edge& own = o.edges[of];
    if (m.key.part >= own.segments) continue;  // a mesh vertex that no longer exists
    p.vertex = own.first_vertex() + m.key.part;
    out.points.push_back(p);
    out.memory.push_back(m);
    out.briefs.push_back({p.vertex, p.edge});
  }
}

ContactGeometry ContactFinder::geometry(VertexIndex vertex, SegmentIndex segment) const {
  const Outlines& o = setup_->outlines();
  return contact_geometry(x_[o.vertices[vertex].node], frames_[segment]);
}

void ContactFinder::place_nodes(std::span<const double> q) {
  const Outlines& o = setup_->outlines();
  const auto place = [&](std::span<const IndexRange<OutlineNode>> nodes,
                         std::span<const IndexRange<SegmentIndex>> segments) {
    for (const IndexRange<OutlineNode> r : nodes)
      parallel_for(r, [&](OutlineNode i) { x_[i] = position(o.nodes[i], q); });
    for (const IndexRange<SegmentIndex> r : segments)
      parallel_for(r, [&](SegmentIndex i) { frames_[i] = segment_frame(x_[o.segments[i].a], x_[o.segments[i].b]); });
  };
  if (std::exchange(placed_, true)) {
    place(o.moving_nodes, o.moving_segments);
  } else {
    place(std::array{x_.indices()}, std::array{frames_.indices()});
  }
}

ContactFinder::Under ContactFinder::segment_under(const Vec2& x, EdgeIndex edge, std::int32_t guess) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& e = o.edges[edge];
  const auto squared = [&](const Outlines::Segment& s) { return squared_distance(x, x_[s.a], x_[s.b]); };
  if (e.segments == 1) return {e.first_segment, std::sqrt(squared(o.segments[e.first_segment]))};
  const Vec2& along = pairs_.direction(edge);
  const double at = along.dot(x);
  const auto begin = o.segments.begin() + e.first_segment.value, end = begin + e.segments;
  const auto starts_ahead = [&](const Outlines::Segment& s) { return at < along.dot(x_[s.a]); };
  auto next = begin + 1;  // the first segment that starts ahead of the point
  if (guess >= 0 && guess < e.segments) {
    next += guess;
    while (next != end && !starts_ahead(*next)) ++next;
    while (next != begin + 1 && starts_ahead(*(next - 1))) --next;
  } else {
    next = std::partition_point(next, end, [&](const Outlines::Segment& s) { return !starts_ahead(s); });
  }
  // Bent edges: a neighbour may be nearer than the segment that the straight line would give.
  const auto first = std::max(begin, next - 2), last = std::min(end, next + 1);
  auto best = first;
  double nearest = squared(*first), second = std::numeric_limits<double>::infinity();
  for (auto s = first + 1; s < last; ++s) {
    const double d = squared(*s);
    // Of segments at one distance, to the last bit, the first one.
    if (d >= nearest || std::sqrt(d) >= std::sqrt(nearest)) {
      second = std::min(second, d);
      continue;
    }
    second = nearest;
    nearest = d;
    best = s;
  }
  Under out{e.first_segment + static_cast<std::int32_t>(best - begin), std::sqrt(nearest)};
  // Each distance changes by what the point and the segment move, and the place along the edge by that and by what the
  // edge turns, at most four times the way over its length.
  out.room = 0.25 * (std::sqrt(second) - out.distance);
  const double length = (x_[(end - 1)->b] - x_[begin->a]).norm();
  const auto stays_beyond = [&](const Outlines::Segment& s) {
    const double margin = std::abs(at - along.dot(x_[s.a])), farthest = (x - x_[s.a]).norm() + margin;
    out.room = std::min(out.room, margin / (2.0 + 4.0 * farthest / length));
  };
  if (next != end) stays_beyond(*next);
  if (next != begin + 1) stays_beyond(*(next - 1));
  return out;
}

void ContactFinder::set_range(ContactPoint& p, bool closed) const {
  if (p.edge_edge) {  // it ends with the overlap of its edges, not where its foot leaves the segment
    p.s_low = -detection_;
    p.s_high = p.at.length + detection_;
    p.beyond = false;
    return;
  }
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& edge = o.edges[p.edge];
  const std::int32_t part = o.segments[p.segment].part;
  // Beyond a re-entrant corner the solid continues; beyond a convex one there is nothing, and beyond a straight one the
  // next edge carries. But a closed contact is kept a little further, so that corners which meet exactly do not lose
  // and regain their contact, and another edge can take it over.
  const auto beyond = [&](bool convex, EdgeIndex next) {
    const bool ends = convex || pairs_.in_line(next, p.edge);
    return !ends ? detection_ : (closed ? 0.25 * detection_ : 1e-9 * p.at.length);
  };
  const Outlines::Vertex &first = o.vertices[edge.first_vertex()], &last = o.vertices[edge.end_vertex];
  p.s_low = part == 0 ? -beyond(edge.convex_start, first.edge_in) : -detection_;
  p.s_high = p.at.length + (part == edge.segments - 1 ? beyond(edge.convex_end, last.edge_out) : detection_);
  const double foot = p.at.xi * p.at.length;
  p.beyond = foot < p.s_low || foot > p.s_high;
}

bool ContactFinder::admissible(const ContactPoint& p) const {
  // Both sides of a corner of nearly 180 degrees may be within the tolerance though its rock lies on the inner side of
  // the edge: then neither side faces the edge, and the corner does not touch it.
  if (pairs_.direction(pairs_.opposing_edge(p.vertex, p.edge)).dot(pairs_.direction(p.edge)) >= 0.0) return false;
  const Outlines& o = setup_->outlines();
  const Outlines::Vertex& v = o.vertices[p.vertex];
  const Vec2& at = x_[v.node];
  const Vec2 forward = (x_[o.segments[leaving(p.vertex)].b] - at).normalized();
  const Vec2 backward = (x_[o.segments[v.segment_in].a] - at).normalized();
  return p.at.n.dot(forward) >= -kWedgeTolerance && p.at.n.dot(backward) >= -kWedgeTolerance;
}

double ContactFinder::compliance(const ContactPoint& p) const {
  const auto of = [&](OutlineNode node) { return compliance_[node]; };
  // Of the foot: an upper bound. Where two vertices meet either may be the corner, with the same damping.
  const double xi = std::clamp(p.at.xi, 0.0, 1.0);
  return of(p.node[0]) + (1.0 - xi) * of(p.node[1]) + xi * of(p.node[2]);
}

void ContactFinder::begin_impact(const ContactPoint& p, double speed, ContactMemory& m) const {
  constexpr double kPeriods = 4.0, kSwings = 10.0;
  Springs springs{m.tributary, m.kn, m.kt};
  if (p.edge_edge) {
    const EdgeIndex own = pairs_.opposing_edge(p.vertex, p.edge);
    const JointId law{m.joint};
    const double length = std::min(springs_.corner_length(law, own, p.edge), p.full_tributary);
    const Springs corner = springs_.springs(law, own, p.edge, length);
    if (m.kn < corner.kn) springs = corner;
  }
  const double rate = std::sqrt(springs.kn * compliance(p));
  if (speed < touching_ * rate || speed * rate < kSwings * setup_->model().gravity.norm()) return;
  const std::int32_t beside = neighbour(p, false);
  if (beside >= 0 && known_.impact(static_cast<std::size_t>(beside)) == 0.0) return;
  m.tributary = springs.tributary;
  m.kn = springs.kn;
  m.kt = springs.kt;
  m.impact = kPeriods * 2.0 * std::numbers::pi / rate;
}

void ContactFinder::set_damping(ContactPoint& p, const ContactMemory& m) const {
  const double fraction = setup_->model().joints[static_cast<std::size_t>(m.joint)].damping;
  if (fraction == 0.0) return;
  const double mu = compliance(p);
  // In proportion to the share, as the springs: in proportion to sqrt(k) it is unbounded per length of a small overlap.
  const double part =
      p.full_tributary > 0.0 && m.edge_edge != 0 ? std::sqrt(std::min(1.0, m.tributary / p.full_tributary)) : 1.0;
  const double cn = 2.0 * fraction * part * std::sqrt(m.kn / mu),
               ct = m.kt == m.kn ? cn : 2.0 * fraction * part * std::sqrt(m.kt / mu);
  p.cn = cn;  // both in one instruction: soon after, both are read by one, which otherwise waits for all earlier writes
  p.ct = ct;
}

bool ContactFinder::goes_over(const ContactPoint& from, const ContactPoint& to) const {
  if ((to.edge_edge && !in_impact(from)) || to.beyond) return false;
  const Outlines& o = setup_->outlines();
  const Outlines::Edge &a = o.edges[from.edge], &b = o.edges[to.edge];
  // A corner passes over a convex corner where both gaps are equal.
  if ((a.end_vertex == b.first_vertex() && a.convex_end) || (b.end_vertex == a.first_vertex() && b.convex_end)) {
    return !reentrant(from) && from.at.gap < 0.0 && to.at.gap < 0.0 && to.at.gap > kClearly * from.at.gap;
  }
  // Along a joint, or a straight side, it passes with its foot, unless the next edge stands up like a step.
  const auto off = [](const ContactPoint& p) { return p.at.xi < 0.0 || p.at.xi > 1.0; };
  return pairs_.in_line(from.edge, to.edge) && off(from) && !off(to) &&
         from.at.gap - to.at.gap <= kInLine * std::max(0.0, -from.at.gap);
}

bool ContactFinder::in_impact(const ContactPoint& p) const {
  return p.from >= 0 && known_.impact(static_cast<std::size_t>(p.from)) > 0.0;
}

bool ContactFinder::was_closed(const ContactPoint& p) const {
  return p.from >= 0 && known_.closed(static_cast<std::size_t>(p.from));
}

ContactPoint* ContactFinder::successor(const ContactPoint& from, std::span<ContactPoint> points) const {
  if ((from.edge_edge && !in_impact(from)) || !was_closed(from) ||
      known_.list().memory[static_cast<std::size_t>(from.from)].bonded != 0)
    return nullptr;
  const auto to = std::find_if(points.begin(), points.end(), [&](const ContactPoint& p) {
    return &p != &from && !was_closed(p) && goes_over(from, p);
  });
  return to == points.end() ? nullptr : &*to;
}

void ContactFinder::pass_corners(std::span<ContactPoint> points) const {
  for (ContactPoint& from : points) {
    ContactPoint* to = successor(from, points);
    if (to == nullptr) continue;
    std::swap(from.from, to->from);
    if (in_impact(*to)) from.from = -1;  // the depth at which it was found does not belong to this edge
    set_range(from, false);
    set_range(*to, true);
  }
}

bool ContactFinder::goes_over_tip(const ContactPoint& from, std::span<const ContactPoint> of_corner,
                                  const ContactPoint& to, std::span<const ContactPoint> of_tip) const {
  const Outlines::Vertex& corner = setup_->outlines().vertices[from.vertex];
  if ((to.edge != corner.edge_in && to.edge != corner.edge_out) || to.beyond || was_closed(to)) return false;
  if (to.edge_edge && -pairs_.direction(from.edge).dot(pairs_.direction(to.edge)) > kStillFaces) return false;
  if (to.at.gap >= 0.0 || to.at.gap <= kClearly * from.at.gap) return false;
  const auto goes_on = [this](const ContactPoint& p, std::span<const ContactPoint> of_vertex) {
    return std::any_of(of_vertex.begin(), of_vertex.end(), [&](const ContactPoint& other) {
      return other.edge != p.edge && pairs_.in_line(other.edge, p.edge);
    });
  };
  return !goes_on(from, of_corner) && !goes_on(to, of_tip);
}

VertexIndex ContactFinder::tip_beside(const ContactPoint& from) const {
  const Outlines& o = setup_->outlines();
  const double depth = -from.at.gap, s = from.at.xi * from.at.length;
  if (from.edge_edge || depth <= 0.0 || !in_impact(from)) return {};
  const Outlines::Edge& edge = o.edges[from.edge];
  const std::int32_t part = o.segments[from.segment].part;
  // The gaps are equal at depth tan(a/2) from the end, a < 90 degrees between the edges.
  if (edge.convex_start && part == 0 && s < depth) return edge.first_vertex();
  const bool at_last = edge.convex_end && part == edge.segments - 1 && from.at.length - s < depth;
  return at_last ? edge.end_vertex : VertexIndex{};
}

void ContactFinder::pass_tips(bool at_start, ContactList& out) const {
  const auto of_vertex = [&out](VertexIndex vertex) {
    const auto before = [](const ContactPoint& p, VertexIndex wanted) { return p.vertex < wanted; };
    const auto begin = std::lower_bound(out.points.begin(), out.points.end(), vertex, before),
               end = std::lower_bound(begin, out.points.end(), vertex + 1, before);
    return std::span(begin, end);
  };
  for (ContactPoint& from : out.points) {
    if (from.suppressed) continue;
    const VertexIndex tip = tip_beside(from);
    if (!tip.valid()) continue;
    const auto of_corner = of_vertex(from.vertex), of_tip = of_vertex(tip);
    for (ContactPoint& to : of_tip) {
      if (!goes_over_tip(from, of_corner, to, of_tip)) continue;
      to.from = std::exchange(from.from, -1);
      to.suppressed = false;
      for (ContactPoint* p : {&from, &to}) {
        set_range(*p, p == &to);
        const auto index = static_cast<std::size_t>(p - out.points.data());
        out.memory[index] = {};
        remember(index, at_start, out);
      }
      break;
    }
  }
}

void ContactFinder::pass_energy_on(bool at_start, ContactList& out) {
  const Outlines& o = setup_->outlines();
  const auto bodies = [&](VertexIndex vertex, EdgeIndex edge) {
    return std::pair(std::minmax({o.vertices[vertex].body, o.edges[edge].body}));
  };
  for (std::size_t g = 0; g < known_.size(); ++g) {
    if (gone_[g] == 0 || !known_.closed(g)) continue;
    const ContactMemory& was = known_.list().memory[g];
    if (was.impact == 0.0 || was.gap >= 0.0) continue;
    const auto pair = bodies(known_.vertex(g), known_.edge(g));
    const Vec2& at = x_[o.vertices[known_.vertex(g)].node];
    ContactPoint* successor = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (ContactPoint& p : out.points) {
      if (p.at.gap >= 0.0 || p.beyond || (was_closed(p) && (p.suppressed || !in_impact(p))) ||
          bodies(p.vertex, p.edge) != pair)
        continue;
      const double d = (x_[p.node[0]] - at).norm();
      if (d > nearest || (d == nearest && p.at.gap < successor->at.gap)) continue;
      nearest = d;
      successor = &p;
    }
    if (successor == nullptr) continue;
    const auto index = static_cast<std::size_t>(successor - out.points.data());
    ContactMemory& m = out.memory[index];
    if (was_closed(*successor)) {
      const double held = std::min(m.gap, 0.0);
      m.gap = -std::sqrt(held * held + was.kn / m.kn * was.gap * was.gap);
      merged_ += 0.5 * was.kn * was.gap * was.gap;
    } else {
      successor->from = static_cast<std::int32_t>(g);
      successor->suppressed = false;
      gone_[g] = 0;
      set_range(*successor, true);
      m = {};
      remember(index, at_start, out);
      m.gap = was.gap;  // see ExplicitContact::transfer_impact_energy()
    }
    m.gap0 = successor->at.gap - m.gap;
  }
}

void ContactFinder::settle_vertex(std::size_t first, bool at_start, ContactList& out) {
  const auto points = std::span(out.points).subspan(first);
  if (points.size() > 1) {
    pass_corners(points);
    pair_edges(first, out);
  }
  out.memory.resize(out.points.size());
  for (std::size_t i = first; i < out.points.size(); ++i) {
    const ContactPoint& p = out.points[i];
    const auto index = static_cast<std::int32_t>(i);
    if (p.from >= 0) {
      gone_[static_cast<std::size_t>(p.from)] = 0;
      if (!known_.divided()) remember(i, at_start, out);
    } else {
      fresh_.push_back(index);
    }
    if (!p.edge_edge && !was_closed(p)) corners_.push_back(index);
    if (std::max(p.partner[0], p.partner[1]) >= 0) paired_.push_back(index);
  }
}

bool ContactFinder::touches(const VertexEdge& pair, const ContactMemory* was, bool closed, ContactPoint& p) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Vertex& v = o.vertices[pair.vertex];
  const Outlines::Segment& s = o.segments[p.segment];
  p.vertex = pair.vertex;
  p.edge = pair.edge;
  p.node = {v.node, s.a, s.b};
  p.at = contact_geometry(x_[v.node], frames_[p.segment]);
  // A corner that is first found more than half way through a body has entered over another edge.
  if (!closed && p.at.gap < -0.5 * springs_.width(p.edge) && (was == nullptr || was->gap + was->gap0 < 0.0))
    return false;
  p.edge_edge = pair.tributary > 0.0;
  p.behind = pair.behind;
  p.ahead = pair.ahead;
  set_range(p, closed);
  if (p.beyond && closed) return false;
  return closed || p.edge_edge || admissible(p);
}

void ContactFinder::set_springs(const VertexEdge& pair, JointId law, ContactPoint& p) const {
  p.joint = law.value;
  p.springs = springs_.springs(law, pair.own, pair.edge,
                               p.edge_edge ? pair.tributary : springs_.corner_length(law, pair.own, pair.edge));
  p.first_gap0 = std::min(p.at.gap, 0.0);
  if (!p.edge_edge || !springs_.per_area(law)) return;
  const Outlines::Vertex& v = setup_->outlines().vertices[p.vertex];
  const auto length = [this](SegmentIndex of) { return frames_[of].length; };
  const double before = 0.5 * length(v.segment_in), after = 0.5 * length(leaving(p.vertex));
  p.largest_tributary = before + after;
  p.full_tributary =
      std::min(0.5 * p.at.length, (v.edge_in == pair.own ? before : 0.0) + (v.edge_out == pair.own ? after : 0.0));
  p.margin = kBoundMargin * p.largest_tributary / p.springs.tributary * std::max(p.springs.kn, p.springs.kt);
}

void ContactFinder::describe(const VertexEdge& pair, const ContactMemory* was, bool closed, ContactPoint& p) const {
  set_springs(pair, springs_.law_of(pair.own, pair.edge), p);
  if (was == nullptr || (!closed && was->gap < 0.0)) {
    p.beside = neighbour(p, false);
    // In an impact the earlier points keep their memory, and a new one has none yet.
    if (p.beside >= 0 && known_.impact(static_cast<std::size_t>(p.beside)) > 0.0) p.beside = -1;
    if (p.beside >= 0) p.first_gap0 = known_.gap0(static_cast<std::size_t>(p.beside));
  }
}

void ContactFinder::find(std::span<const double> q, const ContactList& known, bool at_start, ContactList& out) {
  place_nodes(q);
  known_.index(known);
  list_points(pairs_.update(x_, known_), at_start, out);
}

void ContactFinder::find_of_ghosts(std::span<const double> q, ContactList& out) {
  place_nodes(q);
  list_points(pairs_.update(x_, known_, ContactPairs::Of::ghosts), false, out);
}

void ContactFinder::follow(std::span<const double> q, ContactList& list) {
  place_nodes(q);
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    ContactPoint& p = list.points[i];
    const double before = p.at.gap;
    p.at = geometry(p.vertex, p.segment);
    list.memory[i].gap += p.at.gap - before;
  }
}

void ContactFinder::find_again(const ContactList& known, ContactList& out) {
  known_.index(known);
  list_points(pairs_.pairs(), false, out);
}

void ContactFinder::list_vertex(std::span<const VertexEdge> pairs, std::size_t old, bool at_start, ContactList& out) {
  const Outlines& o = setup_->outlines();
  const std::size_t first = out.points.size();
  for (const VertexEdge& pair : pairs) {
    const Vec2& xP = x_[o.vertices[pair.vertex].node];
    const std::pair here(pair.vertex, pair.edge);
    while (old < known_.size() && std::pair(known_.vertex(old), known_.edge(old)) < here) ++old;
    const bool has_memory = old < known_.size() && std::pair(known_.vertex(old), known_.edge(old)) == here;
    const bool closed = has_memory && known_.closed(old);
    const Outlines::Edge& edge = o.edges[pair.edge];
    const Under under = closed && edge.segments == 1
                            ? Under{edge.first_segment, 0.0}
                            : segment_under(xP, pair.edge, has_memory ? known_.segment(old) : -1);
    if (!closed && under.distance > detection_) continue;
    // Constructed in place: copying what has just been written waits for all pending writes to memory.
    ContactPoint& p = out.points.emplace_back();
    p.segment = under.segment;
    if (has_memory) p.from = static_cast<std::int32_t>(old);
    const ContactMemory* was = has_memory ? &known_.list().memory[old] : nullptr;
    if (!touches(pair, was, closed, p)) {
      out.points.pop_back();
      continue;
    }
    describe(pair, was, closed, p);
    out.briefs.push_back({pair.vertex, pair.edge});
  }
  settle_vertex(first, at_start, out);
}

void ContactFinder::list_points(std::span<const VertexEdge> pairs, bool at_start, ContactList& out) {
  const Outlines& o = setup_->outlines();
  merged_ = 0.0;
  gone_.assign(known_.size(), 1);
  listed_anew_ = true;
  fresh_.clear();
  corners_.clear();
  paired_.clear();
  out.points.clear();
  out.memory.clear();
  out.briefs.clear();
  out.reserve(known_.size() + known_.size() / 16);  // doubling a long list would leave half of it unused
  for (std::size_t k = 0, old = 0; k < pairs.size();) {
    const std::size_t first = k;
    while (k < pairs.size() && pairs[k].vertex == pairs[first].vertex) ++k;
    if (k + kAhead < pairs.size()) __builtin_prefetch(&o.edges[pairs[k + kAhead].edge]);
    while (old < known_.size() && known_.vertex(old) < pairs[first].vertex) ++old;
    list_vertex(pairs.subspan(first, k - first), old, at_start, out);
  }
  cover_corners(out);
  inherit(out);
  index_divided(out);
  if (known_.divided())
    for (std::size_t i = 0; i < out.points.size(); ++i) remember(i, at_start, out);
  else
    for (const std::int32_t i : fresh_) remember(static_cast<std::size_t>(i), at_start, out);
  interpolate(out);
  pass_tips(at_start, out);
  pass_energy_on(at_start, out);
  suppress_second_edges(at_start, out);
  if (setup_->model().waters.empty()) return;
  for (std::size_t i = 0; i < out.points.size(); ++i) fill_with_water(out.points[i], out.memory[i]);
}

void ContactFinder::fill_with_water(const ContactPoint& p, ContactMemory& m) const {
  m.water = 0.0;
  const JointWater* water = setup_->water_in(JointId{m.joint});
  if (water == nullptr || !p.edge_edge || p.suppressed) return;
  // The water acts on the straight pieces beside the vertex, in the middle of the gap: the side of the vertex does not
  // matter. Each end of a piece carries its part of a linear pressure.
  const Vec2 at = x_[p.node[0]] - 0.5 * p.at.gap * p.at.n;
  for (const double piece : {-p.behind, p.ahead})
    if (piece != 0.0) m.water += water_force(*water, at, piece * p.at.t);
}

}  // namespace scree::coupling
