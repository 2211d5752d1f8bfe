#include "coupling/contact/table/contact_pairs.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "model/parallel.h"

namespace scree::coupling {
namespace {

constexpr double kFaces = 0.9962;             // cosine of 5 degrees: edges this nearly anti-parallel face each other
constexpr std::int64_t kFewEdgePairs = 1024;  // fewer pairs are not worth waking threads
constexpr double kRounding = 1e-9;            // pairs excluded here must fail the exact tests of ContactFinder too
constexpr double kLeast = -kWedgeTolerance - kRounding;

/// Distance of two boxes along the axis along which they are farthest apart; negative where they overlap [m].
double distance(const Box& a, const Box& b) { return (a.lo - b.hi).cwiseMax(b.lo - a.hi).maxCoeff(); }

/// Distance of two points from a straight edge's line, both on one side; <= 0: not on one side [m]. Boxes of long
/// inclined edges overlap those of all others.
double beside(const std::array<Vec2, 2>& edge, const Vec2& direction, const Vec2& x, const Vec2& y) {
  const Vec2 n(direction.y(), -direction.x());
  const double sx = n.dot(x - edge[0]), sy = n.dot(y - edge[0]);
  return std::max(std::min(sx, sy), -std::max(sx, sy));
}

/// How far every node may move while points stay more than `far` beside an edge's line; <= 0: they are not [m]. With a
/// displacement d of the nodes n' . (x' - e') - n . (x - e) = n' . ((x' - e') - (x - e)) + (n' - n) . (x - e) is at
/// most 2 d + 4 d |x - e|/L, by the bound of turn_by().
double room_beside(const std::array<Vec2, 2>& edge, const Vec2& direction, const Vec2& x, const Vec2& y, double far) {
  const double lever =
      std::sqrt(std::max((x - edge[0]).squaredNorm(), (y - edge[0]).squaredNorm()) / (edge[1] - edge[0]).squaredNorm());
  return (beside(edge, direction, x, y) - far) / (2.0 + 4.0 * lever);
}

/// Order of the pairs of one vertex.
bool comes_before(const VertexEdge& p, const VertexEdge& q) {
  return p.edge != q.edge ? p.edge < q.edge : p.own < q.own;
}

}  // namespace

ContactPairs::ContactPairs(const Setup& setup, const JointSprings& springs, double reach)
    : setup_(&setup),
      springs_(&springs),
      reach_(reach),
      search_(setup, reach),
      direction_(setup.outlines().edges.size()),
      ends_(direction_.size()),
      box_(direction_.size()) {
  for (const Outlines::Edge& e : setup.outlines().edges) ghost_.push_back(setup.body(e.body).ghost ? 1 : 0);
  // So that steps need not allocate.
  const std::size_t expected = 2 * setup.outlines().vertices.size();
  deep_.reserve(expected);
  const bool ghost = std::any_of(ghost_.begin(), ghost_.end(), [](char g) { return g != 0; });
  for (Lists* lists : {&lists_, &other_}) {
    lists->first.resize(setup.outlines().vertices.size() + 1);
    if (lists == &other_ && !ghost) break;
    lists->pairs.reserve(expected);
    lists->found.resize(2);
    for (Found& f : lists->found) f.pairs.reserve(std::min(expected, 2 * static_cast<std::size_t>(kContactChunk)));
    lists->place.reserve(expected);
  }
  origin_.reserve(expected);
}

bool ContactPairs::edge_edge(EdgeIndex a, EdgeIndex b, const KnownContacts& known) const {
  const double against = -direction(a).dot(direction(b));
  if (against < kStillFaces || against > kFaces) return against > kFaces;
  bool closed = false;
  known.for_pair(a, b, [&](std::size_t i) { closed = closed || (known.closed(i) && known.edge_edge(i)); });
  return closed;
}

bool ContactPairs::in_line(EdgeIndex a, EdgeIndex b) const {
  const Vec2& t = direction(b);
  if (direction(a).dot(t) <= kStillFaces) return false;
  const auto &ea = ends_[a], &eb = ends_[b];
  const double a0 = t.dot(ea[0] - eb[0]), a1 = t.dot(ea[1] - eb[0]), length = t.dot(eb[1] - eb[0]);
  return std::min(a1, length) - std::max(a0, 0.0) < 0.5 * std::min(a1 - a0, length);
}

EdgeIndex ContactPairs::opposing_edge(VertexIndex vertex, EdgeIndex edge) const {
  const Outlines::Vertex& v = setup_->outlines().vertices[vertex];
  const Vec2& t = direction(edge);
  return direction(v.edge_out).dot(t) < direction(v.edge_in).dot(t) ? v.edge_out : v.edge_in;
}

bool ContactPairs::too_far(const Box& a, const Box& b) const { return distance(a, b) > far(); }

double ContactPairs::far() const { return 0.5 * reach_ * (1.0 + kRounding); }

double ContactPairs::corner_room(VertexIndex vertex, EdgeIndex edge) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Vertex& v = o.vertices[vertex];
  if (!v.convex) return std::numeric_limits<double>::infinity();
  const Vec2& at = ends_[v.edge_out][0];
  const double apart = 0.5 * (distance({at, at}, box_[edge]) - far());
  const auto bent = [&](EdgeIndex e) { return o.edges[e].segments > 1; };
  const Vec2& t = direction(edge);
  const Vec2 n(t.y(), -t.x());
  const double faces = -direction(v.edge_in).dot(t);
  double turned = faces - kFaces;  // the side before it faces the edge, and is listed with it
  // Up to kStillFaces it depends on the closed contacts whether that side faces the edge.
  if (turned <= 0.0 && !bent(edge) && !bent(v.edge_in) && !bent(v.edge_out))
    turned = std::min(kStillFaces - faces,
                      std::max(kLeast - n.dot(direction(v.edge_out)), kLeast + n.dot(direction(v.edge_in))));
  return std::max(apart, turned / turn_by({edge, v.edge_in, v.edge_out}));
}

double ContactPairs::room(EdgeIndex a, EdgeIndex b) const {
  const auto& edges = setup_->outlines().edges;
  const double apart = 0.5 * (distance(box_[a], box_[b]) - far());
  if (apart > 0.0) return apart;
  const auto &ea = ends_[a], &eb = ends_[b];
  if (edges[a].segments == 1 && edges[b].segments == 1) {
    const double parted = std::max(room_beside(ea, direction(a), eb[0], eb[1], far()),
                                   room_beside(eb, direction(b), ea[0], ea[1], far()));
    if (parted > 0.0) return parted;
  }
  // A neighbour that closes makes edges face each other from kStillFaces on.
  const double faces = (kStillFaces + direction(a).dot(direction(b))) / turn_by({a, b});
  return std::min({faces, corner_room(edges[a].first_vertex(), b), corner_room(edges[b].first_vertex(), a)});
}

double ContactPairs::turn_by(std::initializer_list<EdgeIndex> edges) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const EdgeIndex e : edges) {
    const auto& [begin, end] = ends_[e];
    shortest = std::min(shortest, (end - begin).squaredNorm());
  }
  // |u - u'| <= 2 |d - d'|/|d| for the unit vectors u of d, where |d - d'| is at most twice the displacement of a node.
  return 8.0 / std::sqrt(shortest);
}

bool ContactPairs::leans_in(const Outlines::Vertex& v, EdgeIndex edge) const {
  const Outlines& o = setup_->outlines();
  const auto bent = [&](EdgeIndex e) { return o.edges[e].segments > 1; };
  if (bent(edge) || bent(v.edge_in) || bent(v.edge_out)) return false;
  const Vec2& t = direction(edge);
  const Vec2 n(t.y(), -t.x());
  return n.dot(direction(v.edge_out)) < kLeast || -n.dot(direction(v.edge_in)) < kLeast;
}

inline void ContactPairs::Found::list(const VertexEdge& pair) {
  if (count == pairs.size()) pairs.emplace_back();
  VertexEdge& p = pairs[count++];
  same = same && p.vertex == pair.vertex && p.edge == pair.edge && p.own == pair.own;
  p = pair;
}

void ContactPairs::Found::end() {
  if (count == pairs.size()) return;
  pairs.resize(count);
  same = false;
}

void ContactPairs::try_corner(VertexIndex vertex, EdgeIndex edge, const KnownContacts& known, Found& out) const {
  const Outlines::Vertex& v = setup_->outlines().vertices[vertex];
  if (!v.convex) return;
  const Vec2& at = ends_[v.edge_out][0];
  const bool straight = setup_->outlines().edges[edge].segments == 1;
  if ((leans_in(v, edge) || too_far({at, at}, box_[edge]) ||
       (straight && beside(ends_[edge], direction(edge), at, at) > far())) &&
      !known.closed(vertex, edge))
    return;
  if (edge_edge(v.edge_in, edge, known)) return;
  out.list({vertex, edge, opposing_edge(vertex, edge), 0.0, 0.0, 0.0});
}

void ContactPairs::try_edges(OutlinePositions x, EdgeIndex a, EdgeIndex b, const KnownContacts& known,
                             Found& out) const {
  const Outlines& o = setup_->outlines();
  const auto &ea = ends_[a], &eb = ends_[b];
  const bool straight = o.edges[a].segments == 1 && o.edges[b].segments == 1;
  const bool parted =
      straight && std::max(beside(ea, direction(a), eb[0], eb[1]), beside(eb, direction(b), ea[0], ea[1])) > far();
  if (parted || too_far(box_[a], box_[b])) {
    bool closed = false;
    known.for_pair(a, b, [&](std::size_t i) { closed = closed || known.closed(i); });
    if (!closed) return;
  }
  if (edge_edge(a, b, known)) {
    const Vec2 along = (direction(a) - direction(b)).normalized();
    const auto bent = [&](EdgeIndex e) { return o.edges[e].segments > 1; };
    const bool middle = (bent(a) || bent(b)) && springs_->per_area(springs_->law_of(a, b));
    for (const OverlapPoint& p : out.overlap.divide(o, x, a, b, along, middle))
      if (p.edge == a)
        out.list({p.vertex, p.edge, b, p.tributary, p.behind, p.ahead});
      else  // b runs against the direction
        out.list({p.vertex, p.edge, a, p.tributary, p.ahead, p.behind});
  } else {
    try_corner(o.edges[a].first_vertex(), b, known, out);
    try_corner(o.edges[b].first_vertex(), a, known, out);
  }
}

void ContactPairs::sort() {
  std::vector<VertexEdge>& pairs = lists_.pairs;
  std::vector<Found>& found = lists_.found;
  std::int32_t count = 0;
  for (Found& f : found) {
    f.first = count;
    count += static_cast<std::int32_t>(f.pairs.size());
  }
  pairs.resize(static_cast<std::size_t>(count));
  origin_.resize(pairs.size());
  lists_.place.resize(pairs.size());
  // In the order of vertices; origin_ holds the number of each pair in the order in which they were found.
  const bool on_threads = count >= kFewEdgePairs && omp_get_max_threads() > 1;
  const auto find_reach = [&](std::int64_t c) {
    Found& f = found[static_cast<std::size_t>(c)];
    f.reach = {};
    for (const VertexEdge& p : f.pairs) f.reach.take(p.vertex.value);
  };
  if (on_threads) parallel_for(std::ssize(found), find_reach, 0);
  const auto for_found = [&](std::int32_t begin, std::int32_t end, auto&& see) {
    for (const Found& f : found)
      for (std::size_t k = 0; k < f.pairs.size() && (!on_threads || f.reach.meets(begin, end)); ++k)
        if (const std::int32_t v = f.pairs[k].vertex.value; v >= begin && v < end)
          see(v, std::pair(&f.pairs[k], f.first + static_cast<std::int32_t>(k)));
  };
  const auto put = [&](std::int32_t place, const std::pair<const VertexEdge*, std::int32_t>& item) {
    pairs[static_cast<std::size_t>(place)] = *item.first;
    origin_[static_cast<std::size_t>(place)] = item.second;
  };
  by_vertex_.sort(lists_.first.values(), on_threads, for_found, put);
  const auto merges = [&](std::int64_t v) { return sort_of_vertex(VertexIndex::of(v)) ? 1.0 : 0.0; };
  const auto vertices = std::ssize(lists_.first.values()) - 1;
  lists_.merged = parallel_largest(vertices, merges, on_threads ? 0 : vertices + 1) > 0.0;
  if (lists_.merged) merge();
}

bool ContactPairs::sort_of_vertex(VertexIndex vertex) {
  std::vector<VertexEdge>& pairs = lists_.pairs;
  const std::size_t begin = first_pair(vertex), end = first_pair(vertex + 1);
  bool merges = false;
  for (std::size_t i = begin + 1; i < end; ++i)  // they are few
    for (std::size_t j = i; j > begin && comes_before(pairs[j], pairs[j - 1]); --j) {
      std::swap(pairs[j], pairs[j - 1]);
      std::swap(origin_[j], origin_[j - 1]);
    }
  for (std::size_t i = begin; i < end; ++i) {
    lists_.place[static_cast<std::size_t>(origin_[i])] = {static_cast<std::int32_t>(i), false};
    merges = merges || (i > begin && pairs[i].edge == pairs[i - 1].edge);
  }
  return merges;
}

void ContactPairs::merge() {
  std::vector<VertexEdge>& pairs = lists_.pairs;
  std::vector<Place>& place = lists_.place;
  std::vector<std::int32_t>& first_of = lists_.first.values();
  std::size_t kept = 0, begin = 0;
  for (std::size_t v = 0; v + 1 < first_of.size(); ++v) {
    const auto end = static_cast<std::size_t>(first_of[v + 1]);
    first_of[v] = static_cast<std::int32_t>(kept);
    for (std::size_t i = begin; i < end; ++i) {
      const std::int32_t from = origin_[i];
      if (i > begin && pairs[kept - 1].edge == pairs[i].edge) {
        // A vertex between two edges in line may face one edge with both. In refresh() the pair found first sets
        // the lengths, and the other adds its own.
        VertexEdge& same = pairs[kept - 1];
        same.tributary += pairs[i].tributary;
        same.behind += pairs[i].behind;
        same.ahead += pairs[i].ahead;
        const std::int32_t first = std::min(from, origin_[kept - 1]), second = std::max(from, origin_[kept - 1]);
        place[static_cast<std::size_t>(first)] = {static_cast<std::int32_t>(kept - 1), false};
        place[static_cast<std::size_t>(second)] = {static_cast<std::int32_t>(kept - 1), true};
        origin_[kept - 1] = first;
        continue;
      }
      if (kept != i) {
        pairs[kept] = pairs[i];
        origin_[kept] = from;
      }
      place[static_cast<std::size_t>(from)] = {static_cast<std::int32_t>(kept), false};
      ++kept;
    }
    begin = end;
  }
  first_of.back() = static_cast<std::int32_t>(kept);
  pairs.resize(kept);
}

void ContactPairs::refresh() {
  const auto update = [this](const Found& f, bool adding) {
    auto place = lists_.place.begin() + f.first;
    for (const VertexEdge& from : f.pairs) {
      VertexEdge& to = lists_.pairs[static_cast<std::size_t>(place->pair)];
      if (const bool adds = (place++)->adds; adds != adding) continue;
      to.tributary = (adding ? to.tributary : 0.0) + from.tributary;
      to.behind = (adding ? to.behind : 0.0) + from.behind;
      to.ahead = (adding ? to.ahead : 0.0) + from.ahead;
    }
  };
  // To at most one other: the sum of two does not depend on their order.
  const auto chunks = std::ssize(lists_.found);
  parallel_for(
      chunks, [&](std::int64_t c) { update(lists_.found[static_cast<std::size_t>(c)], false); },
      std::ssize(lists_.pairs) < kFewEdgePairs ? chunks + 1 : 2);
  if (!lists_.merged) return;
  for (const Found& f : lists_.found) update(f, true);
}

void ContactPairs::place_edges(OutlinePositions x, IndexRange<EdgeIndex> range) {
  const Outlines& o = setup_->outlines();
  const auto at = [&](VertexIndex v) { return x[o.vertices[v].node]; };
  parallel_for(range, [&](EdgeIndex e) {
    const Outlines::Edge& edge = o.edges[e];
    ends_[e] = {at(edge.first_vertex()), at(edge.end_vertex)};
    direction_[e] = (ends_[e][1] - ends_[e][0]).normalized();
    Box& box = box_[e] = {ends_[e][0].cwiseMin(ends_[e][1]), ends_[e][0].cwiseMax(ends_[e][1])};
    for (std::int32_t k = 1; k < edge.segments; ++k) {  // may be bent
      const Vec2 middle = at(edge.vertex(k));
      box.lo = box.lo.cwiseMin(middle);
      box.hi = box.hi.cwiseMax(middle);
    }
  });
}

void ContactPairs::find_deep(const KnownContacts& known) {
  const Outlines& o = setup_->outlines();
  deep_.clear();
  const auto depth = [&](std::int64_t i) {
    const auto k = static_cast<std::size_t>(i);
    return known.closed(k) ? -known.whole_gap(k) : 0.0;
  };
  const double deep = 0.25 * reach_;
  if (parallel_largest(static_cast<std::int64_t>(known.size()), depth) < deep) return;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!known.closed(i)) continue;
    if (known.whole_gap(i) > -deep) continue;
    const VertexIndex vertex = known.vertex(i);
    const EdgeIndex edge = known.edge(i);
    // Corners are tried with the edge that begins at them.
    const EdgeIndex own = known.edge_edge(i) ? opposing_edge(vertex, edge) : o.vertices[vertex].edge_out;
    deep_.push_back({std::min(own, edge), std::max(own, edge)});
  }
  std::sort(deep_.begin(), deep_.end());
  deep_.erase(std::unique(deep_.begin(), deep_.end()), deep_.end());
}

std::span<const VertexEdge> ContactPairs::update(OutlinePositions x, const KnownContacts& known, Of of) {
  if ((of == Of::ghosts) != ghosts_) {
    std::swap(lists_, other_);
    ghosts_ = !ghosts_;
  }
  const auto wanted = [&](EdgeIndex a, EdgeIndex b) { return of != Of::ghosts || ghost_[a] != 0 || ghost_[b] != 0; };
  if (std::exchange(placed_, true)) {
    for (const IndexRange<EdgeIndex> r : setup_->outlines().moving_edges) place_edges(x, r);
  } else {
    place_edges(x, box_.indices());
  }
  const std::span<const EdgePair> near = search_.update(x);
  const bool in_turn = of == Of::all_in_turn;
  if (in_turn)
    quiet_.begin(x, setup_->outlines().moving_nodes, near, search_.times_listed() != times_listed_);
  else if (of == Of::all)
    quiet_.forget();
  if (of != Of::ghosts) times_listed_ = search_.times_listed();
  const auto size = static_cast<std::int64_t>(near.size());
  const auto chunks = static_cast<std::size_t>((size + kContactChunk - 1) / kContactChunk);
  std::vector<Found>& found = lists_.found;
  bool same = found.size() == chunks + 1;
  found.resize(chunks + 1);
  parallel_for_chunks(
      size,
      [&](std::int64_t begin, std::int64_t end) {
        Found& out = found[static_cast<std::size_t>(begin / kContactChunk)];
        out.begin();
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
          const EdgePair& pair = near[k];
          if ((in_turn && quiet_.quiet(k)) || !wanted(pair.a, pair.b)) continue;
          const std::size_t before = out.count;
          try_edges(x, pair.a, pair.b, known, out);
          if (in_turn && out.count == before) quiet_.set(k, room(pair.a, pair.b));
        }
        out.end();
      },
      kFewEdgePairs, kContactChunk);
  // A corner that was pressed deeper than the search reaches, as through a thin plate, is still kept.
  find_deep(known);
  Found& deep = found.back();
  deep.begin();
  for (const EdgePair& pair : deep_)
    if (wanted(pair.a, pair.b) && !std::binary_search(near.begin(), near.end(), pair))
      try_edges(x, pair.a, pair.b, known, deep);
  deep.end();
  for (const Found& f : found) same = same && f.same;
  if (same) {
    refresh();
  } else {
    sort();
    lists_.number = ++numbers_;
  }
  return lists_.pairs;
}

}  // namespace scree::coupling
