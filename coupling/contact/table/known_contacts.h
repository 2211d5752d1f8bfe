// Contacts of the instant before, by their vertices.
#pragma once

#include <utility>
#include <vector>

#include "coupling/contact/table/splice.h"
#include "model/buckets.h"

namespace scree::coupling {

/// Finds points of a list by vertex and edge. Refers to the list.
class KnownContacts {
 public:
  explicit KnownContacts(const Outlines& outlines)
      : outlines_(&outlines), first_(outlines.vertices.size() + 1), against_first_(outlines.edges.size() + 1) {
    places_.reserve(2 * outlines.vertices.size());  // so that steps need not allocate
    points_.reserve(places_.capacity());
    next_.reserve(places_.capacity());
    against_.reserve(places_.capacity());
  }

  void index(const ContactList& list) {
    list_ = &list;
    places_.resize(list.briefs.size());
    points_.resize(list.briefs.size());
    next_.resize(list.briefs.size());
    const double divided = parallel_largest(std::ssize(points_), [&](std::int64_t at) {
      const auto i = static_cast<std::size_t>(at);
      const ContactList::Brief& p = list.briefs[i];
      const ContactMemory& m = list.memory[i];
      places_[i] = {p.vertex, p.edge};
      points_[i] = brief(m);
      return m.segment >= 0 ? 0.0 : (points_[i].closed ? 2.0 : 1.0);
    });
    divided_ = divided > 0.0;
    closed_divided_ = divided > 1.0;
    list_places();
  }
  /// Notes the memory of a point of the list at the next instant; nothing changes before take_noted().
  void note(std::size_t i, const ContactMemory& m) { next_[i] = brief(m); }
  /// In place of index(), when all points have been noted and the list has changed in its memory alone.
  void take_noted() { points_.swap(next_); }
  /// Called before note() if the list of the next instant is another one.
  void expect(std::size_t size) { next_.resize(size); }
  /// After take_noted(): the list of the next instant is another one.
  /// @param briefs  of the new list   @pre segments are known
  void replace(const Splice& splice, const std::vector<ContactList::Brief>& briefs);
  /// True if a body was made anew since, so that a contact has no valid segment; and the same for a closed contact.
  [[nodiscard]] bool divided() const { return divided_; }
  [[nodiscard]] bool closed_divided() const { return closed_divided_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  /// Index of a vertex's first point; its points end where those of the next vertex begin.
  /// @param vertex  any, or one beyond the last
  [[nodiscard]] std::size_t first_point(VertexIndex vertex) const { return static_cast<std::size_t>(first_[vertex]); }
  [[nodiscard]] VertexIndex vertex(std::size_t i) const { return places_[i].vertex; }
  [[nodiscard]] EdgeIndex edge(std::size_t i) const { return places_[i].edge; }
  [[nodiscard]] bool closed(std::size_t i) const { return points_[i].closed; }
  [[nodiscard]] bool edge_edge(std::size_t i) const { return points_[i].edge_edge; }
  /// Segment of the edge, counted within it, and ContactMemory::impact and gap0. A list that is changed point by point
  /// contains those of the next instant already.
  [[nodiscard]] std::int32_t segment(std::size_t i) const { return points_[i].segment; }
  [[nodiscard]] double impact(std::size_t i) const { return points_[i].impact; }
  [[nodiscard]] double gap0(std::size_t i) const { return points_[i].gap0; }
  /// Gap between the bodies, gap0 included [m].
  [[nodiscard]] double whole_gap(std::size_t i) const { return points_[i].whole_gap; }
  /// True if the vertex is closed against any edge.
  [[nodiscard]] bool closed_vertex(VertexIndex vertex) const {
    bool found = false;
    for_vertex(
        vertex, [](EdgeIndex) { return true; }, [&](std::size_t i) { found = found || points_[i].closed; });
    return found;
  }
  /// True if the vertex is closed against the edge.
  [[nodiscard]] bool closed(VertexIndex vertex, EdgeIndex edge) const {
    bool found = false;
    for_vertex(
        vertex, [edge](EdgeIndex other) { return other == edge; },
        [&](std::size_t i) { found = found || points_[i].closed; });
    return found;
  }
  [[nodiscard]] const ContactList& list() const { return *list_; }
  /// Calls see(i) for the points of a vertex against the edges that take() accepts.
  template <class Take, class See>
  void for_vertex(VertexIndex vertex, Take&& take, See&& see) const {
    for (std::size_t i = first_point(vertex), end = first_point(vertex + 1); i < end; ++i)
      if (take(places_[i].edge)) see(i);
  }
  /// Calls see(i) for the points of an edge's vertices against the edges that take() accepts.
  template <class Take, class See>
  void for_vertices(EdgeIndex edge, Take&& take, See&& see) const {
    const Outlines::Edge& e = outlines_->edges[edge];
    const VertexIndex first = e.first_vertex(), last = e.end_vertex;
    // The points of all vertices but the last are contiguous: vertices without a point cost nothing.
    for (std::size_t i = first_point(first), end = first_point(first + e.segments); i < end; ++i)
      if (take(places_[i].edge)) see(i);
    for_vertex(last, take, see);
  }
  /// Calls see(i) for the points against an edge, of whatever vertices.
  template <class See>
  void for_against(EdgeIndex edge, See&& see) const {
    for (auto i = against_first_[edge]; i < against_first_[edge + 1]; ++i)
      see(static_cast<std::size_t>(against_[static_cast<std::size_t>(i)]));
  }
  /// Calls see(i) for the points between two edges.
  template <class See>
  void for_pair(EdgeIndex a, EdgeIndex b, See&& see) const {
    for (const auto& [of, against] : {std::pair(a, b), std::pair(b, a)})
      for_vertices(
          of, [other = against](EdgeIndex edge) { return edge == other; }, see);
  }

 private:
  struct Place {
    VertexIndex vertex;
    EdgeIndex edge;
  };
  /// Indexes points by vertex and by edge.
  void list_places() {
    first_.assign(first_.size(), 0);
    std::vector<std::int32_t>& of_vertex = first_.values();
    for (const Place& p : places_) ++first_[p.vertex + 1];
    for (std::size_t v = 1; v < of_vertex.size(); ++v) of_vertex[v] += of_vertex[v - 1];
    list_edges();
  }
  void list_edges();
  /// Data that searches read, contiguous in memory.
  struct Brief {
    double whole_gap, gap0, impact;
    std::int32_t segment;
    bool closed, edge_edge;
  };
  static Brief brief(const ContactMemory& m) {
    return {m.gap + m.gap0, m.gap0, m.impact, m.segment, m.status != ContactStatus::open, m.edge_edge != 0};
  }
  const Outlines* outlines_;
  const ContactList* list_ = nullptr;
  std::vector<Place> places_;
  std::vector<Brief> points_, next_;
  bool divided_ = false, closed_divided_ = false;
  IndexedVector<VertexIndex, std::int32_t> first_;        // its first point, and the end
  IndexedVector<EdgeIndex, std::int32_t> against_first_;  // the first in against_, and the end
  std::vector<std::int32_t> against_;                     // points in the order of their edges
  std::vector<Reach> reach_;                              // of every chunk of points, on edges
  Buckets by_edge_;
};

inline void KnownContacts::list_edges() {
  const auto size = std::ssize(places_);
  against_.resize(places_.size());
  reach_.resize(static_cast<std::size_t>((size + kChunk - 1) / kChunk));
  parallel_for_chunks(size, [&](std::int64_t begin, std::int64_t end) {
    Reach reach;
    for (std::int64_t i = begin; i < end; ++i) reach.take(places_[static_cast<std::size_t>(i)].edge.value);
    reach_[static_cast<std::size_t>(begin / kChunk)] = reach;
  });
  const auto for_points = [&](std::int32_t begin, std::int32_t end, auto&& see) {
    for (std::size_t c = 0; c < reach_.size(); ++c) {
      if (!reach_[c].meets(begin, end)) continue;
      const auto first = static_cast<std::int32_t>(kChunk * static_cast<std::int64_t>(c)),
                 last = static_cast<std::int32_t>(std::min(size, first + kChunk));
      for (std::int32_t i = first; i < last; ++i)
        if (const std::int32_t e = places_[static_cast<std::size_t>(i)].edge.value; e >= begin && e < end) see(e, i);
    }
  };
  by_edge_.sort(against_first_.values(), size >= kSerialBelow, for_points,
                [&](std::int32_t place, std::int32_t i) { against_[static_cast<std::size_t>(place)] = i; });
}

inline void KnownContacts::replace(const Splice& splice, const std::vector<ContactList::Brief>& briefs) {
  next_.resize(briefs.size());
  splice.move(places_);
  splice.for_new([&](std::size_t i, std::size_t) { places_[i] = {briefs[i].vertex, briefs[i].edge}; });
  for (std::size_t c = 0; c < splice.changed().size(); ++c) {
    const bool last = c + 1 == splice.changed().size();
    const VertexIndex begin = splice.changed()[c].vertex + 1,
                      end = last ? first_.next() : splice.changed()[c + 1].vertex + 1;
    if (const std::int32_t by = splice.shift_after(c); by != 0)
      for (const VertexIndex v : IndexRange(begin, end)) first_[v] += by;
  }
  list_edges();
}

}  // namespace scree::coupling
