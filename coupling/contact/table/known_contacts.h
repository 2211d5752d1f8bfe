// Contacts of the instant before, by their vertices.
#pragma once

#include <utility>
#include <vector>

#include "coupling/contact/table/contact_point.h"

namespace scree::coupling {

/// Points and memories in the order of their keys, one memory a point.
struct ContactList {
  /// What the next search asks of a point, apart from the rest: reading it there is a cache miss a point.
  struct Brief {
    std::int32_t vertex, edge;
  };
  std::vector<ContactPoint> points;
  std::vector<ContactMemory> memory;
  std::vector<Brief> briefs;

  /// A list as it was, from what find() left in it.
  void restore(const std::vector<ContactPoint>& all, const std::vector<ContactMemory>& of_all) {
    points = all;
    memory = of_all;
    briefs.clear();
    for (const ContactPoint& p : points) briefs.push_back({p.vertex, p.edge});
  }
};

/// Finds points of a list by vertex and edge. Refers to the list.
class KnownContacts {
 public:
  explicit KnownContacts(const Outlines& outlines)
      : outlines_(&outlines), first_(outlines.vertices.size() + 1), against_first_(outlines.edges.size() + 2) {
    points_.reserve(2 * outlines.vertices.size());  // so that steps need not allocate
    against_.reserve(points_.capacity());
  }

  void index(const ContactList& list) {
    list_ = &list;
    points_.resize(list.briefs.size());
    divided_ = closed_divided_ = false;
    first_.assign(first_.size(), 0);
    // Points in the order of their edges: counted one further on, so that filling leaves the first ones.
    against_first_.assign(against_first_.size(), 0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const ContactList::Brief& p = list.briefs[i];
      const ContactMemory& m = list.memory[i];
      points_[i] = {p.vertex, p.edge, m.status != ContactStatus::open, m.edge_edge != 0, m.gap + m.gap0};
      divided_ = divided_ || m.segment < 0;
      closed_divided_ = closed_divided_ || (m.segment < 0 && points_[i].closed);
      ++first_[static_cast<std::size_t>(p.vertex) + 1];
      ++against_first_[static_cast<std::size_t>(p.edge) + 2];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    for (std::size_t e = 2; e < against_first_.size(); ++e) against_first_[e] += against_first_[e - 1];
    against_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      std::int32_t& next = against_first_[static_cast<std::size_t>(points_[i].edge) + 1];
      against_[static_cast<std::size_t>(next++)] = static_cast<std::int32_t>(i);
    }
  }
  /// True if a body was made anew since: a contact does not know the segment it was on; and a closed one.
  [[nodiscard]] bool divided() const { return divided_; }
  [[nodiscard]] bool closed_divided() const { return closed_divided_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] std::int32_t vertex(std::size_t i) const { return points_[i].vertex; }
  [[nodiscard]] std::int32_t edge(std::size_t i) const { return points_[i].edge; }
  [[nodiscard]] bool closed(std::size_t i) const { return points_[i].closed; }
  [[nodiscard]] bool edge_edge(std::size_t i) const { return points_[i].edge_edge; }
  /// Gap between the bodies, whatever counts as closed [m].
  [[nodiscard]] double whole_gap(std::size_t i) const { return points_[i].whole_gap; }
  /// True if the vertex is closed against any edge.
  [[nodiscard]] bool closed_vertex(std::int32_t vertex) const {
    bool found = false;
    for_vertex(
        vertex, [](std::int32_t) { return true; }, [&](std::size_t i) { found = found || points_[i].closed; });
    return found;
  }
  /// True if the vertex is closed against the edge.
  [[nodiscard]] bool closed(std::int32_t vertex, std::int32_t edge) const {
    bool found = false;
    for_vertex(
        vertex, [edge](std::int32_t other) { return other == edge; },
        [&](std::size_t i) { found = found || points_[i].closed; });
    return found;
  }
  [[nodiscard]] const ContactList& list() const { return *list_; }
  /// Calls see(i) for the points of a vertex against the edges that take() accepts.
  template <class Take, class See>
  void for_vertex(std::int32_t vertex, Take&& take, See&& see) const {
    const auto v = static_cast<std::size_t>(vertex);
    for (auto i = static_cast<std::size_t>(first_[v]); i < static_cast<std::size_t>(first_[v + 1]); ++i)
      if (take(points_[i].edge)) see(i);
  }
  /// Calls see(i) for the points of an edge's vertices against the edges that take() accepts.
  template <class Take, class See>
  void for_vertices(std::int32_t edge, Take&& take, See&& see) const {
    const Outlines::Edge& e = outlines_->edges[static_cast<std::size_t>(edge)];
    for (std::int32_t k = 0; k <= e.segments; ++k)
      for_vertex(k < e.segments ? e.first_segment + k : e.end_vertex, take, see);
  }
  /// Calls see(i) for the points against an edge, of whatever vertices.
  template <class See>
  void for_against(std::int32_t edge, See&& see) const {
    const auto e = static_cast<std::size_t>(edge);
    for (auto i = against_first_[e]; i < against_first_[e + 1]; ++i)
      see(static_cast<std::size_t>(against_[static_cast<std::size_t>(i)]));
  }
  /// Calls see(i) for the points between two edges.
  template <class See>
  void for_pair(std::int32_t a, std::int32_t b, See&& see) const {
    for (const auto& [of, against] : {std::pair(a, b), std::pair(b, a)})
      for_vertices(
          of, [other = against](std::int32_t edge) { return edge == other; }, see);
  }

 private:
  /// What searches look at, close together.
  struct Brief {
    std::int32_t vertex, edge;
    bool closed, edge_edge;
    double whole_gap;
  };
  const Outlines* outlines_;
  const ContactList* list_ = nullptr;
  std::vector<Brief> points_;
  bool divided_ = false, closed_divided_ = false;
  std::vector<std::int32_t> first_;          // per vertex: its first point, and the end
  std::vector<std::int32_t> against_first_;  // an edge: the first in against_, and the end
  std::vector<std::int32_t> against_;        // points by edge
};

}  // namespace scree::coupling
