#include "coupling/transfer/contact_forces.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {
namespace {

/// A contact's vertex and the two edges it lies between, in the outlines before the change.
struct Place {
  VertexIndex vertex;
  EdgeIndex edge;
};

Place place_of(const Setup& from, const ContactKey& key) {
  const EdgeIndex own = from.edge_of(key.block_p, key.ring_p, key.vertex);
  return {from.outlines().edges[own].first_vertex() + key.part, from.edge_of(key.block_e, key.ring_e, key.edge)};
}

/// Part of a force between two points that the second one takes; a missing point (-1) takes nothing.
double part_of_second(const std::int32_t (&side)[2], const double (&distance)[2]) {
  if (side[0] < 0) return 1.0;
  if (side[1] < 0) return 0.0;
  const double whole = distance[0] + distance[1];
  return whole > 0.0 ? distance[0] / whole : 0.5;
}

}  // namespace

void hand_contacts_over(const Setup& from, const std::vector<char>& changed, State& state) {
  const Outlines& o = from.outlines();
  const auto node = [&](VertexIndex vertex) { return position(o.nodes[o.vertices[vertex].node], state.q); };
  const auto on_edge = [&](VertexIndex vertex, EdgeIndex edge) {
    const Outlines::Vertex& v = o.vertices[vertex];
    return v.edge_in == edge || v.edge_out == edge;
  };
  const auto goes = [&](const ContactMemory& m) {
    return m.key.part > 0 && changed[static_cast<std::size_t>(m.key.block_p)] != 0;
  };
  std::vector<Place> places;
  for (const ContactMemory& m : state.contacts) places.push_back(place_of(from, m.key));
  for (std::size_t i = 0; i < places.size(); ++i) {
    ContactMemory& gone = state.contacts[i];
    if (!goes(gone) || gone.status == ContactStatus::open) continue;
    const EdgeIndex own = o.vertices[places[i].vertex].edge_out, edge = places[i].edge;
    const Outlines::Edge& e = o.edges[edge];
    const Vec2 along = (node(e.end_vertex) - node(e.first_vertex())).normalized();
    std::int32_t side[2] = {-1, -1};  // nearest closed points that remain, before and behind
    double distance[2] = {0.0, 0.0};
    for (std::size_t k = 0; k < places.size(); ++k) {
      const ContactMemory& m = state.contacts[k];
      if (goes(m) || m.status == ContactStatus::open) continue;
      const bool same_side = places[k].edge == edge && on_edge(places[k].vertex, own);
      if (!same_side && !(places[k].edge == own && on_edge(places[k].vertex, edge))) continue;
      const double s = along.dot(node(places[k].vertex) - node(places[i].vertex));
      const std::size_t at = s < 0.0 ? 0 : 1;
      if (side[at] >= 0 && std::abs(s) >= distance[at]) continue;
      side[at] = static_cast<std::int32_t>(k);
      distance[at] = std::abs(s);
    }
    if (side[0] < 0 && side[1] < 0) continue;  // nothing remains between the two edges
    const double to_second = part_of_second(side, distance);
    for (const auto& [to, part] : {std::pair(side[0], 1.0 - to_second), std::pair(side[1], to_second)}) {
      if (to < 0) continue;
      ContactMemory& m = state.contacts[static_cast<std::size_t>(to)];
      m.fn += part * (gone.fn - gone.fd);
      m.ft += part * (gone.ft - gone.fdt);
      m.tributary += part * gone.tributary;  // length on which the force acts: a new mesh derives the traction from it
    }
  }
  std::erase_if(state.contacts.memory, goes);
  for (ContactMemory& m : state.contacts)
    if (changed[static_cast<std::size_t>(m.key.block_e)] != 0 || changed[static_cast<std::size_t>(m.key.block_p)] != 0)
      m.segment = -1;
}

}  // namespace scree::coupling
