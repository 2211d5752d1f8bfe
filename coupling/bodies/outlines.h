// The outlines of all bodies of a stage, which may touch.
#pragma once

#include <vector>

#include "coupling/outline_index.h"
#include "model/body.h"
#include "model/indexed.h"

namespace scree::coupling {

/// The segment that leaves a vertex, and the vertex at which a segment starts: they have the same number.
[[nodiscard]] constexpr SegmentIndex leaving(VertexIndex v) { return SegmentIndex{v.value}; }
[[nodiscard]] constexpr VertexIndex start_of(SegmentIndex s) { return VertexIndex{s.value}; }

/// Outlines of all bodies, with rows in the state's nodes. Faces of cracks follow a block's rings: crack c is ring
/// (rings + c). Each cut stretch of it has four edges: the left face from its first to its last end, the edge to the
/// right face, the right face backwards, and the edge back to the left face.
struct Outlines {
  struct Segment {
    OutlineNode a, b;
    EdgeIndex edge;
    std::int32_t part = 0;  // counted along the edge
  };
  struct Edge {
    BodyIndex body;
    std::int32_t ring = 0, edge = 0;
    SegmentIndex first_segment{0};
    std::int32_t segments = 0;
    VertexIndex end_vertex;                         // the vertex after its last segment
    bool convex_start = false, convex_end = false;  // interior angle at its ends below pi
    JointId joint;                                  // its own law; may be invalid
    Vec2 along{0.0, 0.0};                           // its direction in the model
    EdgeIndex opposite;                             // of a face of a crack: the other face, the only edge it may touch
    bool touches = true;                            // false: joins the faces of a crack at their ends; or not there

    [[nodiscard]] VertexIndex first_vertex() const { return start_of(first_segment); }
    /// Vertex k of the edge, 0 to `segments`.
    [[nodiscard]] VertexIndex vertex(std::int32_t k) const { return k == segments ? end_vertex : first_vertex() + k; }
  };
  /// Start of a segment: a corner of the outline (part 0), or a node where a mesh divides an edge.
  struct Vertex {
    OutlineNode node;
    BodyIndex body;
    SegmentIndex segment_in;  // the segment that ends here
    EdgeIndex edge_in, edge_out;
    bool convex = false;  // a corner with an interior angle below pi
  };
  IndexedVector<OutlineNode, Row> nodes;
  IndexedVector<OutlineNode, BodyIndex> node_body;
  // Ranges of bodies that do not rest.
  std::vector<IndexRange<OutlineNode>> moving_nodes;
  std::vector<IndexRange<SegmentIndex>> moving_segments;
  std::vector<IndexRange<EdgeIndex>> moving_edges;
  IndexedVector<SegmentIndex, Segment> segments;
  IndexedVector<EdgeIndex, Edge> edges;
  IndexedVector<VertexIndex, Vertex> vertices;  // by block, ring, edge, part
};

/// Positions [m] and velocities [m/s] of the outline nodes at some time.
using OutlinePositions = IndexedSpan<OutlineNode, const Vec2>;
using OutlineVelocities = IndexedSpan<OutlineNode, const Vec2>;

}  // namespace scree::coupling
