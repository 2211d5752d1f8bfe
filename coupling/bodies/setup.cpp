#include "coupling/bodies/setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace scree::coupling {

ReferenceShape reference_shape(const Model& model, BlockId block) {
  const Block& b = model.blocks[block.index()];
  const double density = model.material_of(block).density;
  const Moments m = moments(b.polygon);
  ReferenceShape shape;
  shape.origin = b.polygon;
  shape.outline = transformed(b.polygon, -m.centroid, Mat2::Identity());
  shape.mass = density * m.area;
  shape.area = m.area;
  shape.second = density * m.second;
  return shape;
}

namespace {

bool flagged(const std::vector<char>& flags, std::size_t i) { return !flags.empty() && flags[i] != 0; }

/// Decides the pool of a body: its method, whether its forces are not evaluated (it is held, so that it keeps its
/// shape) or belong to another integrator, whether it is slow.
using PoolKey = std::tuple<std::string, bool, bool>;
PoolKey key_of(const Model& model, const BodyRecord& record, const Ghosts& ghosts, std::size_t i) {
  const bool held = record.absent || flagged(ghosts.asleep, i) || model.support_of(record.block) != nullptr;
  return {record.method, held || flagged(ghosts.ghost, i), flagged(ghosts.slow, i)};
}

/// Appends [begin, end) to ranges, extending the last one if it ends there.
template <class Index>
void extend(std::vector<IndexRange<Index>>& ranges, Index begin, Index end) {
  if (ranges.empty() || ranges.back().end_index() != begin) ranges.push_back({begin, begin});
  ranges.back() = {ranges.back().first(), end};
}

/// Body i without its places in pools and arrays.
Body describe(const Model& model, const BodyRecord& record, const Ghosts& ghosts, std::size_t i) {
  Body b;
  b.block = record.block;
  b.slow = flagged(ghosts.slow, i);
  b.driven = b.absent = record.absent;
  if (const BlockSupport* s = model.support_of(record.block); s != nullptr && !b.absent) {
    b.driven = true;
    b.motion = s->motion;
  }
  b.ghost = !b.driven && flagged(ghosts.ghost, i);
  b.asleep = !b.driven && flagged(ghosts.asleep, i);
  b.driven = b.driven || b.ghost || b.asleep;
  b.resting = b.driven && !b.ghost && !b.motion.valid();
  b.touched = ghosts.shared ? b.ghost || !b.driven : !b.driven;
  if (b.absent || b.asleep || (ghosts.shared && !ghosts.touch)) b.touched = false;
  b.divided = record.form.division.divides() && record.form.division.acts != Division::Acts::both;
  b.centre = moments(model.blocks[record.block.index()].polygon).centroid;
  return b;
}

}  // namespace

Setup::Setup(const Model& model, const Methods& methods, const std::vector<BodyRecord>& records, const Ghosts& ghosts,
             Clocks clocks, const Setup* earlier)
    : model_(&model), ghosts_touch_(ghosts.touch), clocks_(std::move(clocks)), laws_(model.joints) {
  for (const JointWater& w : model.waters) waters_.push_back(w.in_stage(clocks_.stage));
  std::map<PoolKey, std::int32_t> pool_of_key;
  for (std::size_t i = 0; i < records.size(); ++i) pool_of_key.emplace(key_of(model, records[i], ghosts, i), 0);
  for (auto& [key, index] : pool_of_key) {
    const auto& [method, is_foreign, is_slow] = key;
    index = static_cast<std::int32_t>(pools_.size());
    const auto factory = methods.find(method);
    if (factory == methods.end()) throw std::invalid_argument("unknown method '" + method + "'");
    if (!is_foreign) own_pools_.push_back(pools_.size());
    if (!is_foreign) (is_slow ? slow_pools_ : fast_pools_).push_back(pools_.size());
    pools_.push_back(factory->second());
    counted_.emplace_back();
  }
  bodies_.reserve(records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    Body b = describe(model, records[i], ghosts, i);
    b.pool = pool_of_key[key_of(model, records[i], ghosts, i)];
    Pool& pool = *pools_[static_cast<std::size_t>(b.pool)];
    b.index = pool.bodies();
    if (earlier != nullptr)
      pool.add_again(model, records[i], earlier->pool_of(earlier->bodies()[i]), earlier->bodies()[i].index);
    else
      pool.add(model, records[i]);
    counted_[static_cast<std::size_t>(b.pool)].push_back(b.driven ? 0 : 1);
    bodies_.push_back(b);
  }
  pool_first_.assign(1, 0);
  for (auto& pool : pools_) {
    pool->finish();
    pool_first_.push_back(pool_first_.back() + pool->first_node(pool->bodies()));
  }
  kind_.assign(static_cast<std::size_t>(nodes()), NodeKind::free);
  reserve_outlines();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& b = bodies_[i];
    const Pool& pool = pool_of(b);
    b.first_node = pool_first_[static_cast<std::size_t>(b.pool)] + pool.first_node(b.index);
    b.nodes = pool.first_node(b.index + 1) - pool.first_node(b.index);
    if (b.driven)
      std::fill_n(kind_.begin() + b.first_node, b.nodes,
                  b.ghost     ? NodeKind::ghost
                  : b.resting ? NodeKind::resting
                              : NodeKind::driven);
    for (std::int32_t k = 0; b.divided && k < b.nodes; ++k)
      if (pool.idle(pool.first_node(b.index) + k))
        kind_[static_cast<std::size_t>(b.first_node) + static_cast<std::size_t>(k)] = NodeKind::ghost;
    add_outline(BodyIndex::of(i));
  }
  for (Outlines::Edge& e : outlines_.edges) {
    const Body& b = body(e.body);
    if (b.absent || b.asleep || (!ghosts.touch && (b.ghost || b.divided))) e.touches = false;
  }
}

const JointWater* Setup::water_in(JointId joint) const {
  for (const JointWater& w : waters_)
    if (w.fills(joint)) return &w;
  return nullptr;
}

bool Setup::applies(std::span<const Row> rows) const {
  bool ghosts = false, own = false;
  for (const Row& row : rows)
    for (std::size_t k = 0; k < 3; ++k)
      if (row.w[k] != 0.0) (kind(row.node[k]) == NodeKind::ghost ? ghosts : own) = true;
  return ghosts_touch_ ? own : own && !ghosts;
}

Row Setup::global(const Body& b, Row row) const {
  for (std::int32_t& n : row.node) n += pool_first_[static_cast<std::size_t>(b.pool)];
  return row;
}

Row Setup::local(const Body& b, Row row) const {
  for (std::int32_t& n : row.node) n -= pool_first_[static_cast<std::size_t>(b.pool)];
  return row;
}

void Setup::reserve_outlines() {
  std::size_t nodes = 0, segments = 0, corners = 0;
  for (const Body& b : bodies_) {
    const Boundary& boundary = pool_of(b).boundary(b.index);
    nodes += boundary.nodes.size();
    segments += boundary.segments.size();
    corners += boundary.corners.size();
  }
  outlines_.nodes.reserve(nodes);
  outlines_.node_body.reserve(nodes);
  outlines_.segments.reserve(segments);
  outlines_.vertices.reserve(segments);
  outlines_.edges.reserve(corners);
}

void Setup::add_outline(BodyIndex index) {
  const Body& b = body(index);
  const Boundary& boundary = pool_of(b).boundary(b.index);
  Outlines& out = outlines_;
  const OutlineNode node0 = out.nodes.next();
  const SegmentIndex segment0 = out.segments.next();
  const EdgeIndex edge0 = out.edges.next();
  for (const Row& row : boundary.nodes) {
    out.nodes.push_back(global(b, row));
    out.node_body.push_back(index);
  }
  std::size_t corner = 0;
  EdgeIndex ring_edge;  // the first of the ring
  VertexIndex ring_vertex;
  for (std::size_t s = 0; s < boundary.segments.size(); ++s) {
    const Boundary::Segment& segment = boundary.segments[s];
    const bool new_ring = s == 0 || boundary.segments[s - 1].edge.ring != segment.edge.ring;
    const bool new_edge = new_ring || boundary.segments[s - 1].edge != segment.edge;
    const SegmentIndex at = out.segments.next();
    if (new_ring) {
      ring_edge = out.edges.next();
      ring_vertex = start_of(at);
    }
    if (new_edge) {
      // Corners come in the order of edges: edge i leaves vertex i. Convex by less than 1e-6 counts as straight.
      const bool convex = boundary.corners[corner++].angle < std::numbers::pi - 1e-6;
      if (!new_ring) {
        out.edges.back().end_vertex = start_of(at);
        out.edges.back().convex_end = convex;
      }
      Outlines::Edge edge{};
      edge.body = index;
      edge.ring = segment.edge.ring;
      edge.edge = segment.edge.edge;
      edge.first_segment = at;
      edge.convex_start = convex;
      const Ring& ring = model_->blocks[b.block.index()].polygon.ring(static_cast<std::size_t>(edge.ring));
      const auto k = static_cast<std::size_t>(edge.edge);
      edge.along = (ring[(k + 1) % ring.size()] - ring[k]).normalized();
      edge.joint = model_->joint_of(b.block, static_cast<std::size_t>(edge.ring), static_cast<std::size_t>(edge.edge));
      out.edges.push_back(edge);
    }
    const EdgeIndex of = out.edges.last();
    Outlines::Edge& edge = out.edges.back();
    out.segments.push_back({node0 + segment.a, node0 + segment.b, of, edge.segments});
    out.vertices.push_back(
        {node0 + segment.a, index, at - 1, new_edge ? of - 1 : of, of, edge.segments == 0 && edge.convex_start});
    ++edge.segments;
    const bool closes = s + 1 == boundary.segments.size() || boundary.segments[s + 1].edge.ring != segment.edge.ring;
    if (!closes) continue;
    edge.end_vertex = ring_vertex;
    edge.convex_end = out.edges[ring_edge].convex_start;
    out.vertices[ring_vertex].segment_in = at;
    out.vertices[ring_vertex].edge_in = of;
  }
  add_cracks(index, boundary, node0);
  if (b.resting) return;
  extend(out.moving_nodes, node0, out.nodes.next());
  extend(out.moving_segments, segment0, out.segments.next());
  extend(out.moving_edges, edge0, out.edges.next());
}

void Setup::add_cracks(BodyIndex index, const Boundary& boundary, OutlineNode first_node) {
  const Body& b = body(index);
  std::vector<const Crack*> of_block;
  for (const Crack& c : model_->cracks)
    if (c.block == b.block) of_block.push_back(&c);
  Outlines& out = outlines_;
  std::int32_t stretch = 0;
  for (std::size_t i = 0; i < boundary.cracks.size(); ++i) {
    const Boundary::Crack& faces = boundary.cracks[i];
    stretch = i > 0 && boundary.cracks[i - 1].crack == faces.crack ? stretch + 1 : 0;
    const Crack& crack = *of_block[static_cast<std::size_t>(faces.crack)];
    const EdgeIndex first_edge = out.edges.next();
    const VertexIndex first_vertex = out.vertices.next();
    const std::vector<std::int32_t>&left = faces.left, back(faces.right.rbegin(), faces.right.rend());
    const Vec2 along = (crack.to - crack.from).normalized();
    const auto add = [&](std::span<const std::int32_t> nodes, const Vec2& direction, bool touches) {
      Outlines::Edge edge;
      const EdgeIndex of = out.edges.next();
      edge.body = index;
      edge.ring = static_cast<std::int32_t>(model_->blocks[b.block.index()].polygon.rings()) + faces.crack;
      edge.edge = 4 * stretch + (of - first_edge);
      edge.first_segment = out.segments.next();
      edge.segments = static_cast<std::int32_t>(nodes.size()) - 1;
      edge.end_vertex = edge.first_vertex() + edge.segments;
      edge.joint = crack.joint;
      edge.along = direction;
      edge.touches = touches;
      if (touches) edge.opposite = first_edge + (of == first_edge ? 2 : 0);
      for (std::int32_t k = 0; k < edge.segments; ++k) {
        const SegmentIndex segment = out.segments.next();
        const auto at = static_cast<std::size_t>(k);
        out.segments.push_back({first_node + nodes[at], first_node + nodes[at + 1], of, k});
        out.vertices.push_back({first_node + nodes[at], index, segment - 1, k == 0 ? of - 1 : of, of, false});
      }
      out.edges.push_back(edge);
    };
    add(left, along, true);
    add(std::array{left.back(), back.front()}, along, false);
    add(back, -along, true);
    add(std::array{back.back(), left.front()}, -along, false);
    out.edges.back().end_vertex = first_vertex;
    out.vertices[first_vertex].segment_in = out.segments.last();
    out.vertices[first_vertex].edge_in = out.edges.last();
  }
}

EdgeIndex Setup::edge_of(std::int32_t block, std::int32_t ring, std::int32_t edge) const {
  const auto key = [&](const Outlines::Edge& e) { return std::tuple(body(e.body).block.value, e.ring, e.edge); };
  const auto at = std::lower_bound(outlines_.edges.begin(), outlines_.edges.end(), std::tuple(block, ring, edge),
                                   [&](const Outlines::Edge& e, const auto& wanted) { return key(e) < wanted; });
  if (at == outlines_.edges.end() || key(*at) != std::tuple(block, ring, edge)) return {};
  return EdgeIndex{static_cast<std::int32_t>(at - outlines_.edges.begin())};
}

Vec2 Setup::driven_displacement(const Body& b, double time) const {
  if (!b.motion.valid()) return {0.0, 0.0};
  return model_->motions[b.motion.index()].displacement(motion_time(b.motion, time));
}

void Setup::prescribe(double time, std::span<double> q, std::span<double> v) const {
  for (const Body& b : bodies_) {
    if (!b.resting || b.asleep) continue;
    AffineMotion m;
    m.c = b.centre;
    const auto p = static_cast<std::size_t>(b.pool);
    pool_of(b).place(b.index, m, part(q, p), part(v, p));
  }
  prescribe_motions(time, q, v);
}

void Setup::prescribe_motions(double time, std::span<double> q, std::span<double> v) const {
  for (const Body& b : bodies_) {
    if (!b.driven || b.ghost || b.resting) continue;
    AffineMotion m;
    m.c = b.centre + driven_displacement(b, time);
    m.vc = model_->motions[b.motion.index()].velocity(motion_time(b.motion, time));
    const auto p = static_cast<std::size_t>(b.pool);
    pool_of(b).place(b.index, m, part(q, p), part(v, p));
  }
}

}  // namespace scree::coupling
