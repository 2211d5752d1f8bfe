// Which of the contacts of a corner carry: those with two edges that meet, and those at the end of an edge.
#include <algorithm>
#include <limits>
#include <utility>

#include "coupling/contact/table/contact_finder.h"
#include "coupling/contact/table/contact_finder_rules.h"

namespace scree::coupling {
namespace {

/// True if the corner is outside the body, above the edge `over`, and only behind the line of the edge `behind`, which
/// ends at the same corner.
bool passes_over(const ContactPoint& over, const ContactPoint& behind) {
  if (over.at.gap < 0.0 || behind.at.gap >= 0.0) return false;
  // Where both pairs are of faces, those of `behind` do not overlap. A corner that stands on the end of an edge is
  // kept.
  return (over.edge_edge && behind.edge_edge) || over.at.gap < -behind.at.gap;
}

/// Suppresses one of two contacts of a corner where it is clear which of the edges the corner stands on, or passes
/// over.
/// @return false: it is not clear, and nothing has changed
bool suppress_by_place(bool at_start, ContactPoint& a, const ContactMemory& ma, ContactPoint& b,
                       const ContactMemory& mb) {
  if (const bool first_is_open = ma.status == ContactStatus::open;
      at_start && ma.status != mb.status && (first_is_open ? ma : mb).gap < 0.0) {
    // The corner stands on one edge, beside the end of the other, and its depth behind that is the distance to its end.
    (first_is_open ? a : b).suppressed = true;
    return true;
  }
  const bool over_a = passes_over(a, b);
  if (!over_a && !passes_over(b, a)) return false;
  if ((over_a ? mb : ma).bonded == 0) (over_a ? b : a).suppressed = true;
  return true;
}

}  // namespace

std::int32_t ContactFinder::neighbour(const ContactPoint& p, bool next_only) const {
  if (!p.edge_edge || p.largest_tributary == 0.0) return -1;
  const Outlines& o = setup_->outlines();
  const EdgeIndex own = pairs_.opposing_edge(p.vertex, p.edge);
  const Vec2& at = x_[p.node[0]];
  double nearest = std::numeric_limits<double>::infinity();
  std::int32_t found = -1;
  const auto distance = [&](VertexIndex vertex) { return (x_[o.vertices[vertex].node] - at).norm(); };
  const auto fits = [&](std::size_t i) {
    return (known_.closed(i) || (!next_only && p.from < 0)) && known_.edge_edge(i) &&
           (known_.vertex(i) != p.vertex || known_.edge(i) != p.edge);
  };
  const auto take = [&](std::size_t i, double d) {
    nearest = d;
    found = static_cast<std::int32_t>(i);
  };
  if (!next_only)
    known_.for_pair(own, p.edge, [&](std::size_t i) {
      if (!fits(i)) return;
      const double d = distance(known_.vertex(i));
      if (!(d >= nearest)) take(i, d);
    });
  if (found >= 0) return found;
  // Points of either edge with edges in line with the other, of any body. The distance is the cheapest condition that
  // few points meet; of a long edge only those are seen that may meet it.
  for (const auto& [of, against] : {std::pair(own, p.edge), std::pair(p.edge, own)}) {
    const auto see = [&, other = against](std::size_t i, auto&& next) {
      if (!fits(i)) return;
      const double d = distance(known_.vertex(i));
      if (d > detection_ || d >= nearest) return;
      if (const EdgeIndex edge = next(); edge != other && pairs_.in_line(edge, other)) take(i, d);
    };
    // A point within `detection_` of this one is over a segment within twice that.
    const Outlines::Edge& edge = o.edges[of];
    const std::int32_t part = of == p.edge ? o.segments[p.segment].part : part_of(o, p.vertex, of);
    const std::pair near = part_near(o, x_, edge, pairs_.direction(of), part, at, 2.0 * detection_);
    const auto far = [&](std::int32_t segment) {
      return segment >= 0 && (segment < near.first || segment > near.second);
    };
    for (std::int32_t k = near.first; k <= near.second; ++k)
      known_.for_vertex(
          edge.vertex(k), [](EdgeIndex) { return true; },
          [&](std::size_t i) { see(i, [&] { return known_.edge(i); }); });
    // Where vertices meet exactly, either may stand for both.
    known_.for_against(of, [&](std::size_t i) {
      if (!far(known_.segment(i))) see(i, [&] { return pairs_.opposing_edge(known_.vertex(i), known_.edge(i)); });
    });
  }
  return found;
}

double ContactFinder::entry_depth(const ContactPoint& p) const {
  const std::int32_t i = neighbour(p, true);
  if (i < 0) return -p.at.gap;
  const auto beside = static_cast<std::size_t>(i);
  const std::int32_t part = std::max(0, known_.segment(beside));
  const Outlines::Edge& edge = setup_->outlines().edges[known_.edge(beside)];
  return std::max(0.0, geometry(known_.vertex(beside), edge.first_segment + part).gap - p.at.gap);
}

bool ContactFinder::reentrant(const ContactPoint& p) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Vertex& v = o.vertices[p.vertex];
  return v.edge_in != v.edge_out && !o.edges[v.edge_in].convex_end;
}

void ContactFinder::cover_corners(ContactList& out) const {
  // A corner whose side continues in line on another block cannot be struck by an edge: an end of that edge that is
  // pressed into the joint carries the contact, unless the corner stands up from it like a step.
  const Outlines& o = setup_->outlines();
  for (const std::int32_t c : corners_) {
    ContactPoint& p = out.points[static_cast<std::size_t>(c)];
    const Outlines::Vertex& v = o.vertices[p.vertex];
    const Outlines::Edge& edge = o.edges[p.edge];
    const auto goes_on = [&](EdgeIndex e) {
      return e == v.edge_in || e == v.edge_out || pairs_.in_line(e, v.edge_in) || pairs_.in_line(e, v.edge_out);
    };
    for (const VertexIndex tip : {edge.first_vertex(), edge.end_vertex}) {
      if (!known_.closed_vertex(tip)) continue;
      const auto begin =
          std::lower_bound(out.points.begin(), out.points.end(), tip,
                           [](const ContactPoint& other, VertexIndex wanted) { return other.vertex < wanted; });
      for (auto t = begin; t != out.points.end() && t->vertex == tip; ++t) {
        if (t->edge_edge || !was_closed(*t) || !goes_on(t->edge)) continue;
        const double step = t->at.n.dot(x_[p.node[0]] - x_[t->node[1]]);
        if (step <= kInLine * std::max(0.0, -t->at.gap)) p.suppressed = true;
      }
    }
  }
}

void ContactFinder::pair_edges(std::size_t first, ContactList& list) const {
  const Outlines& o = setup_->outlines();
  for (std::size_t i = first; i < list.points.size(); ++i)
    for (std::size_t j = i + 1; j < list.points.size(); ++j) {
      const Outlines::Edge &a = o.edges[list.points[i].edge], &b = o.edges[list.points[j].edge];
      const bool follows = a.end_vertex == b.first_vertex() && a.convex_end;
      const bool closes_ring = b.end_vertex == a.first_vertex() && b.convex_end;
      if (!follows && !closes_ring) continue;
      const auto [ends, begins] = follows ? std::pair(i, j) : std::pair(j, i);  // at the common corner
      list.points[ends].partner[1] = static_cast<std::int32_t>(begins);
      list.points[begins].partner[0] = static_cast<std::int32_t>(ends);
    }
}

void ContactFinder::suppress_second_edges(bool at_start, ContactList& list) const {
  // A corner inside another body near one of that body's convex corners penetrates both edges; it leaves by the nearer
  // one (shortest path, [Qu2013] 2.4.3), and the choice is kept until the other is clearly nearer. Where it entered
  // along a joint that continues on the next block, its depth there is the same as before, and it does not strike the
  // side. A convex corner in a reentrant one touches both of its sides, and each carries.
  for (const std::int32_t index : paired_)
    for (const std::int32_t other : list.points[static_cast<std::size_t>(index)].partner) {
      if (other <= index) continue;
      const auto i = static_cast<std::size_t>(index);
      const auto j = static_cast<std::size_t>(other);
      if (list.points[i].beyond || list.points[j].beyond || reentrant(list.points[i])) continue;
      if (list.memory[i].bonded != 0 && list.memory[j].bonded != 0) continue;  // the corner is bonded to both
      suppress_one(at_start, i, j, list);
    }
}

void ContactFinder::suppress_one(bool at_start, std::size_t i, std::size_t j, ContactList& list) const {
  const ContactMemory &ma = list.memory[i], &mb = list.memory[j];
  ContactPoint &a = list.points[i], &b = list.points[j];
  if (suppress_by_place(at_start, a, ma, b, mb)) return;
  const bool inside = a.at.gap < 0.0 && b.at.gap < 0.0, loaded = ma.gap < 0.0 && mb.gap < 0.0;
  if (!inside && !loaded) return;
  if (ma.impact > 0.0 || mb.impact > 0.0) {  // the corner passes where both gaps are equal (pass_corners())
    if (loaded && mb.impact == 0.0) b.suppressed = true;
    if (loaded && ma.impact == 0.0) a.suppressed = true;
    return;
  }
  const bool bonded = ma.bonded != 0 || mb.bonded != 0;
  if (bonded && !loaded) return;
  const double depth_a = entry_depth(a);
  const bool in_line = !bonded && depth_a < -kInLine * a.at.gap;
  if (!in_line && !loaded) return;
  const double depth_b = entry_depth(b);
  // Where joints continue in line in both directions four blocks meet in a corner, and diagonal ones do not touch.
  if (in_line && depth_b < -kInLine * b.at.gap) {
    a.suppressed = b.suppressed = true;
    return;
  }
  if (!loaded) return;
  const double keep_a = ma.status != ContactStatus::open ? 0.5 : 1.0,
               keep_b = mb.status != ContactStatus::open ? 0.5 : 1.0;
  const bool a_ends = a.partner[1] == static_cast<std::int32_t>(j),
             a_wins = ma.bonded != mb.bonded ? ma.bonded != 0 : leaves_by(depth_a * keep_a, depth_b * keep_b, a_ends);
  (a_wins ? b : a).suppressed = true;
}

}  // namespace scree::coupling
