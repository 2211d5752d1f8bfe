// The one idea that joins the methods: the position of a boundary node is linear in its body's nodes,
//   x = sum_k w_k q[node_k],
// three weights, constant until the body is discretised anew. Contact, supports, transfer, output and streaming see
// bodies only through this page and never ask which method a body uses.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
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

/// A body without stress, in material coordinates about its centre of mass: what a discretisation is made from.
struct ReferenceShape {
  Polygon outline;             // stress-free shape, centre of mass at the origin [m]
  Polygon origin;              // the same vertices where the model first had them [m]
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

/// What one body is, and how it is represented now. Rebuilds the discretisation bit for bit.
struct BodyRecord {
  BlockId block;
  std::string method;  // name of the pool it lives in
  ReferenceShape shape;
  Formulation form;
};

/// In-situ stress of a block in its reference shape: the axes there are those that turn with the rock.
class InSituStress {
 public:
  InSituStress(const Model& model, const BodyRecord& record);
  [[nodiscard]] bool none() const { return stress_ == nullptr; }
  /// At a point of the reference shape; of a stress that is linear, at the centroid of a piece its mean [Pa].
  [[nodiscard]] Mat2 at(const Vec2& X) const;
  /// Mean over the outline [Pa].
  [[nodiscard]] Mat2 mean() const { return at(centroid_); }

 private:
  const InitialStress* stress_ = nullptr;
  Vec2 centroid_{0.0, 0.0};  // of the outline: not the centre of mass where a deformed body left it behind
  AffineMotion origin_;      // from the reference shape to where the model first had the block
  Mat2 turn_ = Mat2::Identity();
};

/// What a body leaves behind when it changes method: its affine part exactly, the rest as energy and fields.
/// @source coupling.md 1
struct Release {
  ReferenceShape shape;  // reference of the affine body that goes on
  AffineMotion motion;
  Mat2 initial = Mat2::Zero();  // mean in-situ stress of the body that is left, co-rotated [Pa]
  double kinetic_rest = 0.0;    // 1/2 w^T M w, w = v - affine [J]
  double elastic_rest = 0.0;    // 1/2 sum A_e (s_e - s):D:(s_e - s) [J]
  double elastic_cross = 0.0;   // sum A_e s:(e_e - e): zero to first order, booked [J]
  double spin_squared = 0.0;    // sum J_e w_e^2 / sum J_e over its cells [1/s2]
  // Two numbers a node, empty where the affine part is all: F^-1 (x - c), of which the deformation beside the affine
  // one follows, and w in the co-rotated frame.
  std::vector<double> position, velocity_rest;
};

/// Momenta and energies of one body, from the operators that its method really uses.
struct BodyTotals {
  double mass = 0.0;
  Vec2 centre{0.0, 0.0};
  Vec2 momentum{0.0, 0.0};
  double angular_momentum = 0.0;  // about the origin [kg m2/s]
  double kinetic = 0.0, elastic = 0.0;
};

/// Cells for output: polygons of points, each point a Row.
struct MeshPart {
  std::vector<Row> points;            // nodes counted within the pool
  std::vector<Vec2> origin;           // where the model first had each point [m]
  std::vector<std::int32_t> offsets;  // cells + 1
  std::vector<std::int32_t> connectivity;
  std::vector<std::int32_t> body;   // a cell: body index in the pool
  std::vector<char> explicit_half;  // a cell: 1 in the explicit half of a divided body; empty: no body is divided
};

/// A row expressed in the unknowns d of an implicit step, counted from the body's first: dx = T d. At most three nodes
/// that each follow three others, with two unknowns.
struct ChartRow {
  static constexpr int kMax = 18;
  int n = 0;
  std::array<std::int32_t, kMax> dof{};  // each once
  std::array<double, kMax> tx{}, ty{};
};

/// The unknowns of the element matrices that a body's system is the sum of, counted from the body's first. Values come
/// as lower triangles, element after element, each column after column: n (n + 1)/2 numbers for n unknowns.
struct ElementDofs {
  std::vector<std::int32_t> start{0};  // into dof; elements + 1
  std::vector<std::int32_t> dof;
  [[nodiscard]] std::size_t size() const { return start.size() - 1; }
  /// Numbers that all lower triangles have together.
  [[nodiscard]] std::size_t values() const {
    std::size_t sum = 0;
    for (std::size_t e = 0; e + 1 < start.size(); ++e) {
      const auto n = static_cast<std::size_t>(start[e + 1] - start[e]);
      sum += n * (n + 1) / 2;
    }
    return sum;
  }
};

/// Which stiffness an implicit step asks for.
enum class Stiffness {
  exact,     // second derivative of the elastic energy: Newton's method converges quadratically
  definite,  // its nearest positive semi-definite neighbour, element by element
  material   // without the part of the stress that turns with the rock: rigid motion has no force, always definite
};

/// A body that its unknowns leave without a meaning.
struct Fault {
  int body = -1;      // in the pool; -1: none
  std::string where;  // what is wrong and where in it, e.g. "element 12 near (0.5, 2) is turned inside out"
};

/// All bodies of one method in contiguous arrays. Spans q, v, f hold two numbers (x, y) a node of this pool.
class Pool {
 public:
  Pool() = default;
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  virtual ~Pool() = default;

  // --- what it is made of ---
  [[nodiscard]] virtual std::string_view method() const = 0;
  /// Appends a body made from the record; its nodes follow those of the bodies before it.
  virtual void add(const Model& model, const BodyRecord& record) = 0;
  /// Called once after the last body was added.
  virtual void finish() {}
  [[nodiscard]] virtual int bodies() const = 0;
  /// First node of a body; first_node(bodies()) is the number of nodes.
  [[nodiscard]] virtual std::int32_t first_node(int body) const = 0;
  [[nodiscard]] virtual const Boundary& boundary(int body) const = 0;
  /// Row of any material point of the body (supports, monitors).
  [[nodiscard]] virtual Row row_at(int body, const Vec2& X) const = 0;
  /// Nodes of the two halves of a divided body that are one place of one continuum.
  struct Seam {
    std::int32_t explicit_node, implicit_node;  // in the pool
  };
  [[nodiscard]] virtual std::span<const Seam> seams(int body) const;
  /// A node of a divided body: its number, counted from the body's first, where the body is made undivided; empty: it
  /// is not divided.
  [[nodiscard]] virtual std::span<const std::int32_t> undivided(int body) const;
  /// Puts nodes that follow others to where these are.
  virtual void settle(int body, std::span<double> q, std::span<double> v) const;
  /// True for a node of the half of a divided body that does not act here: another mover moves it.
  [[nodiscard]] virtual bool idle(std::int32_t node) const;
  /// Weights t with: a translation by a adds t_k a to node k of the body.
  [[nodiscard]] virtual std::span<const double> translation(int body) const = 0;

  // --- state ---
  /// True if place() takes any affine motion; false for a method whose bodies cannot strain.
  [[nodiscard]] virtual bool strains() const { return true; }
  /// Sets the body's nodes to an affine motion, or to the rigid one nearest to it.
  virtual void place(int body, const AffineMotion& motion, std::span<double> q, std::span<double> v) const = 0;
  /// Affine part, and what is left over.
  [[nodiscard]] virtual Release release(int body, std::span<const double> q, std::span<const double> v) const = 0;
  [[nodiscard]] virtual BodyTotals totals(int body, std::span<const double> q, std::span<const double> v) const = 0;

  // --- explicit dynamics ---
  /// The first body that cannot be as q says: not finite, or turned inside out.
  [[nodiscard]] virtual Fault find_fault(std::span<const double> q) const;
  /// f += internal force; returns the elastic energy of every body summed in a fixed order [J]. Not a number where a
  /// body cannot be as q says (turned inside out); find_fault() then tells which.
  virtual double internal_force(std::span<const double> q, std::span<double> f) const = 0;
  /// f += body force of a uniform acceleration.
  virtual void body_force(const Vec2& acceleration, std::span<double> f) const = 0;
  /// Passes forces on nodes that follow others on to those, so that each is the unbalanced force of a free node; the
  /// motion is the same.
  virtual void fold_forces(std::span<double> f) const { (void)f; }
  /// a = M^-1 f (f is not changed); the acceleration is compatible with the method's constraints.
  virtual void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const = 0;
  /// p = M v on the nodes of one body; zero on nodes that follow others.   @param p  [kg m/s], other bodies' stay
  virtual void mass_apply(int body, std::span<const double> q, std::span<const double> v,
                          std::span<double> p) const = 0;
  /// 1/2 v^T M v, bodies in `counted` only (one flag a body).
  [[nodiscard]] virtual double kinetic_energy(std::span<const double> q, std::span<const double> v,
                                              std::span<const char> counted) const = 0;
  /// Corrects moved = q + h v, and carries velocities along, where the method's nodes turn. The default leaves both.
  virtual void turn(double h, std::span<const double> q, std::span<double> v, std::span<double> moved) const;
  /// w *= factor, then f = -rate M w and a -= rate w; w = v minus its affine part: mass-proportional damping that
  /// spares rigid motion and sliding. Methods whose bodies are affine have no w, and f = 0.
  /// @param rate [1/s], w taken after the scaling
  /// @return f.along, summed in a fixed order
  virtual double damp(double factor, double rate, std::span<const double> along, std::span<double> v,
                      std::span<double> f, std::span<double> a) const;
  /// f -= rate times the tangent stiffness of the bodies applied to v: Rayleigh damping proportional to stiffness.
  /// Rigid motion has none.   @param rate [s]
  virtual void stiffness_damping(std::span<const double> q, std::span<const double> v, double rate,
                                 std::span<double> f) const;
  /// Largest eigenvalue of D^-1 K of a body's own stiffness, D the method's diagonal mass: a certified bound [1/s2].
  [[nodiscard]] virtual double frequency_bound(int body) const = 0;
  /// What sets frequency_bound(): an element and its place, for messages. Empty: the body as a whole.
  [[nodiscard]] virtual std::string binding(int body) const;
  /// theta: D <= theta M. Squared frequencies in M are at most theta times those in D.
  [[nodiscard]] virtual double mass_ratio(int body) const = 0;
  /// J D^-1 J^T of a row: the acceleration of the point per unit force on it [1/kg].
  [[nodiscard]] virtual double compliance(int body, const Row& row) const = 0;
  /// Groups of unknowns that a row touches (covers; or the whole body): contacts that share a group add up in the
  /// bound.
  virtual void bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const = 0;

  // --- implicit steps; a method without them has no dofs. Spans of dofs count from the body's first ---
  /// Unknowns a body; 0: explicit only.
  [[nodiscard]] virtual int dofs(int body) const;
  /// True where the internal force is not linear in the unknowns of a step: Newton's method goes on at new iterates.
  [[nodiscard]] virtual bool nonlinear(int body) const;
  /// True where the chart is a constant matrix, so that accelerations are those of the nodes.
  [[nodiscard]] virtual bool constant_chart(int body) const;
  /// Why the body cannot take implicit steps although its method can; empty: it can.
  [[nodiscard]] virtual std::string implicit_obstacle(int body) const;
  /// Unknowns of the body's elements; the same during a stage.
  [[nodiscard]] virtual ElementDofs element_dofs(int body) const;
  [[nodiscard]] virtual ChartRow chart_row(int body, const Row& row, std::span<const double> q) const;
  /// Mass of the elements at q, lower triangles in the order of element_dofs().
  virtual void element_masses(int body, std::span<const double> q, std::span<double> mass) const;
  /// Velocity in the unknowns.
  virtual void rates(int body, std::span<const double> q, std::span<const double> v, std::span<double> rate) const;
  /// Tangent stiffness of the elements at q and internal force -dU/dd of the body.
  /// @param stiffness  lower triangles; empty: only the force is wanted
  /// @return elastic energy [J]
  virtual double linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                           std::span<double> force) const;
  /// q, v of a body from the step's unknowns d and the new rates.
  virtual void retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
                       std::span<double> v) const;

  // --- output ---
  virtual void topology(MeshPart& mesh) const = 0;
  /// Cauchy stress (xx, yy, xy) a cell, in the order of topology().
  virtual void stress(std::span<const double> q, std::span<double> cells) const = 0;
  /// Recovered Cauchy stress: three numbers (xx, yy, xy) a node, so that sum_k w_k s[node_k] of a row is the stress of
  /// that point, smoothed over the cells around it [Pa].
  virtual void recovered_stress(std::span<const double> q, std::span<double> nodes) const;
};

}  // namespace scree
