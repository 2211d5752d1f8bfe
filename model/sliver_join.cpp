#include "model/sliver_join.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace scree {
namespace {

/// A face, or several that were joined.
struct Group {
  double area = 0.0, perimeter = 0.0;
  std::map<std::int32_t, double> shared;  // length of the common edge with each neighbour
};

double length_of(const LineGraph& graph, std::int32_t a, std::int32_t b) {
  return (graph.vertices[static_cast<std::size_t>(b)] - graph.vertices[static_cast<std::size_t>(a)]).norm();
}

/// Calls see(a, b) for each directed edge of a face; the face is to the left.
template <class See>
void each_edge(const Face& face, See&& see) {
  for (const std::vector<std::int32_t>& ring : face.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) see(ring[i], ring[(i + 1) % ring.size()]);
}

std::vector<Group> groups_of(const LineGraph& graph, const std::vector<Face>& faces) {
  std::vector<Group> groups(faces.size());
  std::vector<std::tuple<std::int32_t, std::int32_t, std::int32_t>> sides;  // vertices a < b, face
  for (std::size_t f = 0; f < faces.size(); ++f) {
    groups[f].area = area_of(graph, faces[f]);
    each_edge(faces[f], [&](std::int32_t a, std::int32_t b) {
      groups[f].perimeter += length_of(graph, a, b);
      sides.emplace_back(std::min(a, b), std::max(a, b), static_cast<std::int32_t>(f));
    });
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const auto [a, b, f] = sides[i];
    const auto [c, d, g] = sides[i + 1];
    if (a != c || b != d || f == g) continue;
    const double length = length_of(graph, a, b);
    groups[static_cast<std::size_t>(f)].shared[g] += length;
    groups[static_cast<std::size_t>(g)].shared[f] += length;
  }
  return groups;
}

}  // namespace

double area_of(const LineGraph& graph, const Face& face) {
  const Vec2 origin = graph.vertices[static_cast<std::size_t>(face.rings[0][0])];
  double twice = 0.0;
  each_edge(face, [&](std::int32_t a, std::int32_t b) {
    twice += cross(graph.vertices[static_cast<std::size_t>(a)] - origin,
                   graph.vertices[static_cast<std::size_t>(b)] - origin);
  });
  return 0.5 * twice;
}

SliverJoin join_slivers(const LineGraph& graph, const std::vector<Face>& faces, const std::vector<std::int32_t>& region,
                        const SliverLimits& limits) {
  std::vector<Group> groups = groups_of(graph, faces);
  SliverJoin out;
  for (std::size_t f = 0; f < faces.size(); ++f) out.group.push_back(static_cast<std::int32_t>(f));
  const auto is_sliver = [&](const Group& g) {
    return g.area < limits.least_area || 2.0 * g.area < limits.least_width * g.perimeter;
  };
  std::set<std::pair<double, std::int32_t>> slivers;  // smallest first
  for (std::size_t f = 0; f < groups.size(); ++f)
    if (is_sliver(groups[f])) slivers.emplace(groups[f].area, static_cast<std::int32_t>(f));

  while (!slivers.empty()) {
    const std::int32_t f = slivers.begin()->second;
    slivers.erase(slivers.begin());
    Group& sliver = groups[static_cast<std::size_t>(f)];
    std::int32_t best = -1;
    std::pair<bool, double> best_key{false, 0.0};  // same region, length
    for (const auto& [g, length] : sliver.shared) {
      const std::pair key{region[static_cast<std::size_t>(g)] == region[static_cast<std::size_t>(f)], length};
      if (best < 0 || key > best_key) best = g, best_key = key;
    }
    if (best < 0) {
      ++out.left;
      continue;
    }
    ++out.joined;
    Group& host = groups[static_cast<std::size_t>(best)];
    slivers.erase({host.area, best});
    out.group[static_cast<std::size_t>(f)] = best;
    host.area += sliver.area;
    host.perimeter += sliver.perimeter - 2.0 * best_key.second;
    host.shared.erase(f);
    for (const auto& [g, length] : sliver.shared) {
      if (g == best) continue;
      host.shared[g] += length;
      std::map<std::int32_t, double>& other = groups[static_cast<std::size_t>(g)].shared;
      other.erase(f);
      other[best] += length;
    }
    if (is_sliver(host)) slivers.emplace(host.area, best);
  }
  for (std::int32_t& g : out.group)
    while (out.group[static_cast<std::size_t>(g)] != g) g = out.group[static_cast<std::size_t>(g)];
  return out;
}

}  // namespace scree
