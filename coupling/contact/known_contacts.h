// Contacts of the instant before, by their vertices.
#pragma once

#include <utility>
#include <vector>

#include "coupling/contact/contact_point.h"

namespace scree::coupling {

/// Points and memories in the order of their keys, one memory a point.
struct ContactList {
  std::vector<ContactPoint> points;
  std::vector<ContactMemory> memory;
};

/// Finds points of a list by vertex and edge. Refers to the list.
class KnownContacts {
 public:
  explicit KnownContacts(const Outlines& outlines)
      : outlines_(&outlines), first_(outlines.vertices.size() + 1), against_first_(outlines.edges.size() + 2) {
    against_.reserve(2 * outlines.vertices.size());  // so that steps need not allocate
  }

  void index(const ContactList& list) {
    list_ = &list;
    first_.assign(first_.size(), 0);
    for (const ContactPoint& p : list.points) ++first_[static_cast<std::size_t>(p.vertex) + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    // Points in the order of their edges: counted one further on, so that filling leaves the first ones.
    against_first_.assign(against_first_.size(), 0);
    for (const ContactPoint& p : list.points) ++against_first_[static_cast<std::size_t>(p.edge) + 2];
    for (std::size_t e = 2; e < against_first_.size(); ++e) against_first_[e] += against_first_[e - 1];
    against_.resize(list.points.size());
    for (std::size_t i = 0; i < list.points.size(); ++i) {
      std::int32_t& next = against_first_[static_cast<std::size_t>(list.points[i].edge) + 1];
      against_[static_cast<std::size_t>(next++)] = static_cast<std::int32_t>(i);
    }
  }
  [[nodiscard]] const ContactList& list() const { return *list_; }
  /// Calls see(i) for the points of a vertex against the edges that take() accepts.
  template <class Take, class See>
  void for_vertex(std::int32_t vertex, Take&& take, See&& see) const {
    const auto v = static_cast<std::size_t>(vertex);
    for (auto i = static_cast<std::size_t>(first_[v]); i < static_cast<std::size_t>(first_[v + 1]); ++i)
      if (take(list_->points[i].edge)) see(i);
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
  const Outlines* outlines_;
  const ContactList* list_ = nullptr;
  std::vector<std::int32_t> first_;          // a vertex: its first point, and the end
  std::vector<std::int32_t> against_first_;  // an edge: the first in against_, and the end
  std::vector<std::int32_t> against_;        // points by edge
};

}  // namespace scree::coupling
