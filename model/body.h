// Per body: its boundary as rows on its nodes, its stress-free shape, its representation and its motion.
// The one idea that joins the methods: the position of a boundary node is linear in its body's nodes,
//   x = sum_k w_k q[node_k],
// three weights, constant until the body is discretised anew. Contact, supports, transfer, output and streaming use
// bodies only through these rows and do not depend on the method of a body.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/formulation.h"
#include "model/model.h"

namespace scree {

/// x = sum_k w[k] q[node[k]]; nodes count within the pool. An unused place has weight 0 and repeats a node.
struct Row {
  std::array<std::int32_t, 3> node{0, 0, 0};
  std::array<double, 3> w{0.0, 0.0, 0.0};
};

/// The outline of a body as its unknowns carry it.
struct Boundary {
  struct Segment {
    std::int32_t a = 0, b = 0;  // indices into nodes; the solid lies to the left of a -> b
    OutlineEdge edge;           // the outline edge it is part of
    double s0 = 0.0, s1 = 1.0;  // its range of the edge, 0 to 1
    std::int32_t cell = 0;      // the element it bounds, counted within the pool
  };
  struct Corner {
    std::int32_t node;          // index into nodes
    std::int32_t ring, vertex;  // outline vertex; edge `vertex` leaves it
    double angle;               // interior angle in the reference shape [rad]
  };
  /// The two faces of a stretch of crack that the body is cut along.
  struct Crack {
    std::int32_t crack = 0;                 // counted among the cracks of the block
    std::vector<std::int32_t> left, right;  // indices into nodes, both from its first to its last end
  };
  std::vector<Row> nodes;
  std::vector<Crack> cracks;      // by crack, then along it
  std::vector<Segment> segments;  // by ring, edge, then along the edge
  std::vector<Corner> corners;    // by ring and vertex
};

/// A body without stress, in material coordinates about its centre of mass: the basis of a discretisation.
struct ReferenceShape {
  Polygon outline;             // stress-free shape, centre of mass at the origin [m]
  Polygon origin;              // initial positions of the same vertices in the model [m]
  double mass = 0.0;           // [kg] for unit thickness
  double area = 0.0;           // mass / density [m2]
  Mat2 second = Mat2::Zero();  // int rho X X^T dA [kg m2]
};

/// x = c + F X, velocity vc + Fdot X.
struct AffineMotion {
  Vec2 c{0.0, 0.0};
  Mat2 F = Mat2::Identity();
  Vec2 vc{0.0, 0.0};
  Mat2 Fdot = Mat2::Zero();
};

/// Least-squares affine map of the vertices of `from` to those of `to` (same rings and counts); velocities zero.
[[nodiscard]] AffineMotion affine_fit(const Polygon& from, const Polygon& to);

/// Identity and current representation of one body. The discretisation can be rebuilt from it bit for bit.
struct BodyRecord {
  BlockId block;
  std::string method;  // name of the pool it lives in
  ReferenceShape shape;
  Formulation form;
  // Displacement of the anchors of the block's edge supports by transfers: x, y at both ends of each; empty: none.
  std::vector<double> edge_shift{};
  bool absent = false;  // not placed yet, or excavated. The body keeps its place in lists, and nothing acts on it
  bool placed = false;  // placed by a stage: it does not have its material's in-situ stress
};

/// In-situ stress of a block in its reference shape, whose axes rotate with the rock.
class InSituStress {
 public:
  InSituStress(const Model& model, const BodyRecord& record);
  [[nodiscard]] bool none() const { return stress_ == nullptr; }
  /// Stress at a point of the reference shape [Pa]. The mean of a linear stress over a piece is that at its centroid.
  [[nodiscard]] Mat2 at(const Vec2& X) const;
  /// Mean over the outline [Pa].
  [[nodiscard]] Mat2 mean() const { return at(centroid_); }

 private:
  const InitialStress* stress_ = nullptr;
  Vec2 centroid_{0.0, 0.0};  // of the outline; not the centre of mass if a deformed body left this shape behind
  AffineMotion origin_;      // from the reference shape to the block's initial position in the model
  Mat2 turn_ = Mat2::Identity();
};

/// Momenta and energies of one body, from the operators that its method actually uses.
struct BodyTotals {
  double mass = 0.0;
  Vec2 centre{0.0, 0.0};
  Vec2 momentum{0.0, 0.0};
  double angular_momentum = 0.0;  // about the origin [kg m2/s]
  double kinetic = 0.0, elastic = 0.0;
};

}  // namespace scree
