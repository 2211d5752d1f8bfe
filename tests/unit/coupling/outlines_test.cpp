#include "coupling/bodies/outlines.h"

#include <gtest/gtest.h>

#include "coupling/bodies/setup.h"
#include "tests/support/by_hand.h"
#include "tests/support/scene.h"

namespace scree::test::outlines_test {
namespace {

using namespace coupling;

/// A held base, a block with a hole, and one with a crack that a mesh cuts.
Scene scene() {
  Scene out(1e9, 0.2, 2500.0);
  out.add("base", rectangle(-1, -1, 5, 0), true);
  out.add("ring", {rectangle(0, 0, 2, 2).outer, {{{0.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}}}});
  const BlockId cracked = out.add("cracked", rectangle(2, 0, 4, 2));
  Crack crack;
  crack.block = cracked;
  crack.from = Vec2(2.3, 1.0);  // within the block: where a crack begins at an edge the outline has two nodes
  crack.to = Vec2(3.5, 1.1);
  crack.joint = out.model.default_joint;
  out.model.cracks.push_back(crack);
  out.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.4);
  return out;
}

TEST(Outlines, edges_vertices_and_segments_name_each_other) {
  const Scene s = scene();
  const ByHand hand(s.model, s.plan.stages[0]);
  const Outlines& o = hand.setup->outlines();
  ASSERT_EQ(o.vertices.size(), o.segments.size());
  for (const EdgeIndex e : o.edges.indices()) {
    const Outlines::Edge& edge = o.edges[e];
    ASSERT_GT(edge.segments, 0);
    EXPECT_EQ(edge.vertex(0), edge.first_vertex());
    EXPECT_EQ(edge.vertex(edge.segments), edge.end_vertex);
    for (std::int32_t k = 0; k < edge.segments; ++k) {
      const SegmentIndex at = edge.first_segment + k;
      const VertexIndex start = start_of(at);
      EXPECT_EQ(leaving(start), at);
      EXPECT_EQ(edge.vertex(k), start);
      EXPECT_EQ(o.segments[at].edge, e);
      EXPECT_EQ(o.segments[at].part, k);
      EXPECT_EQ(o.vertices[start].node, o.segments[at].a);
      EXPECT_EQ(o.vertices[start].edge_out, e);
      EXPECT_EQ(o.vertices[start].edge_in == e, k > 0);
      EXPECT_EQ(o.vertices[edge.vertex(k + 1)].node, o.segments[at].b);
      EXPECT_EQ(o.vertices[edge.vertex(k + 1)].segment_in, at);
    }
    EXPECT_EQ(o.vertices[edge.end_vertex].edge_in, e);
    EXPECT_EQ(o.node_body[o.vertices[edge.end_vertex].node], edge.body);
    if (edge.opposite.valid()) {
      EXPECT_EQ(o.edges[edge.opposite].opposite, e);
    }
  }
}

TEST(Outlines, edges_are_found_by_block_ring_and_number) {
  const Scene s = scene();
  const ByHand hand(s.model, s.plan.stages[0]);
  const Outlines& o = hand.setup->outlines();
  std::size_t faces = 0;
  for (const EdgeIndex e : o.edges.indices()) {
    const Outlines::Edge& edge = o.edges[e];
    EXPECT_EQ(hand.setup->edge_of(hand.setup->body(edge.body).block.value, edge.ring, edge.edge), e);
    faces += edge.opposite.valid() ? 1U : 0U;
  }
  EXPECT_EQ(faces, 2U);  // of the crack
  EXPECT_FALSE(hand.setup->edge_of(1, 2, 0).valid());
  EXPECT_FALSE(hand.setup->edge_of(3, 0, 0).valid());
}

TEST(Outlines, what_moves_is_all_but_the_parts_of_bodies_that_rest) {
  const Scene s = scene();
  const ByHand hand(s.model, s.plan.stages[0]);
  const Outlines& o = hand.setup->outlines();
  std::int32_t nodes = 0, segments = 0, edges = 0;
  for (const IndexRange<OutlineNode> r : o.moving_nodes)
    for (const OutlineNode n : r) nodes += o.node_body[n] == BodyIndex{0} ? 1000000 : 1;
  for (const IndexRange<SegmentIndex> r : o.moving_segments)
    for (const SegmentIndex i : r) segments += o.vertices[start_of(i)].body == BodyIndex{0} ? 1000000 : 1;
  for (const IndexRange<EdgeIndex> r : o.moving_edges)
    for (const EdgeIndex e : r) edges += o.edges[e].body == BodyIndex{0} ? 1000000 : 1;
  std::int32_t of_base[3] = {};
  for (const BodyIndex b : o.node_body) of_base[0] += b == BodyIndex{0} ? 1 : 0;
  for (const Outlines::Vertex& v : o.vertices) of_base[1] += v.body == BodyIndex{0} ? 1 : 0;
  for (const Outlines::Edge& e : o.edges) of_base[2] += e.body == BodyIndex{0} ? 1 : 0;
  EXPECT_EQ(nodes + of_base[0], o.nodes.indices().size());
  EXPECT_EQ(segments + of_base[1], o.segments.indices().size());
  EXPECT_EQ(edges + of_base[2], o.edges.indices().size());
}

}  // namespace
}  // namespace scree::test::outlines_test
