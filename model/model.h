// The physical description given by the user, validated and constant during a run. No solver, no file format.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/bolt.h"
#include "model/discontinuity.h"
#include "model/elasticity.h"
#include "model/friction_law.h"
#include "model/geometry.h"
#include "model/ground_motion.h"
#include "model/ids.h"
#include "model/joint_water.h"
#include "model/loads.h"
#include "model/rock_strength.h"
#include "model/time_function.h"

namespace scree {

struct Material {
  std::string name;
  double density = 0.0;  // [kg/m3], > 0
  double young = 0.0;    // [Pa], > 0
  double poisson = 0.0;  // 0 <= nu < 0.5
  std::optional<InitialStress> initial_stress{};
  std::optional<RockStrength> rock_strength{};  // its stress is compared with this; blocks stay elastic
};

/// Coulomb law of a joint with springs at each contact point, and its loss of strength by failure or slip.
/// Stiffness is either per area (a point carries its share of the overlap) or, as a penalty, the same for every point;
/// neither given: auto, per area.
struct JointLaw {
  std::string name;
  double friction = 0.0;           // friction angle [rad], 0 <= phi < pi/2
  double cohesion = 0.0;           // [Pa], until the first failure
  double residual_cohesion = 0.0;  // [Pa], after the first failure
  double tensile_strength = 0.0;   // [Pa], of contacts closed at t = 0, until failure; infinite: they never fail
  std::optional<double> residual_friction;  // [rad], 0 <= . <= friction; empty: friction does not weaken
  double weakening_slip = 0.0;              // [m] over which friction falls to the residual; 0: at the first failure
  double dilation = 0.0;                    // dilation angle [rad], 0 <= psi <= phi: slip opens the joint by tan psi
  std::optional<double> dilation_slip;      // [m] of slip after which dilation ends; empty: it never ends
  double contact_length = 0.0;  // [m] tributary length of a corner; 0: a tenth of the smaller block's root area
  std::optional<double> normal_stiffness;     // [Pa/m]
  std::optional<double> shear_stiffness;      // [Pa/m]; empty: as the normal one
  std::optional<double> penalty;              // normal stiffness of a contact point [N/m]
  std::optional<double> shear_penalty;        // tangential stiffness of a contact point [N/m]; empty: as the normal one
  double damping = 0.5;                       // of closed contacts, a fraction of the corner's critical damping
  const FrictionLaw* friction_law = nullptr;  // how friction changes with motion; null: as above. Not with a residual
  std::vector<double> friction_constants;     // of that law, in the order of its keys
};

/// Per block: its polygon, material and joints.
struct Block {
  std::string name;
  Polygon polygon;  // oriented
  MaterialId material;
  JointId joint;                            // law of its edges; invalid: the model's default
  std::vector<std::vector<JointId>> edges;  // law per edge, by ring and edge (edge i runs from vertex i to i+1)
  double cover_size = 0.0;                  // of the NMM in this block; 0: the stage's value [m]
};

/// A block supported as a whole: fixed in space, or moving with a ground motion.
struct BlockSupport {
  BlockId block;
  MotionId motion;  // invalid: at rest
};

/// A point of a block tied to its position at the start by a spring.
struct PointSupport {
  BlockId block;
  Vec2 point{0.0, 0.0};  // [m], model coordinates, on the block's outline or inside
  bool fix_x = true, fix_y = true;
  std::optional<double> stiffness;  // [N/m]; empty: auto, 10 (K + 4G/3)
};

/// A point whose history is written.
struct Monitor {
  std::string name;
  BlockId block;
  Vec2 point{0.0, 0.0};  // [m], model coordinates
};

struct InitialVelocity {
  BlockId block;
  Vec2 velocity{0.0, 0.0};  // of the centroid [m/s]
  double spin = 0.0;        // [rad/s]
};

struct Model {
  std::string title;
  Plane plane = Plane::strain;
  Vec2 gravity{0.0, -9.81};  // [m/s2]
  // Origin of all positions below [m]: (0, 0) unless move_to_local_origin() moved a model that lies far away. Without
  // that call such a model can be run, with the round-off of its distance: forces of contacts 1e6 m away have errors
  // of 1e-5 to 1e-4 of a weight.
  Vec2 origin{0.0, 0.0};
  std::vector<Material> materials;
  std::vector<JointLaw> joints;
  JointId default_joint;  // valid in a checked model
  std::vector<Block> blocks;
  std::vector<BlockSupport> block_supports;
  std::vector<PointSupport> point_supports;
  std::vector<EdgeSupport> edge_supports;
  std::vector<Monitor> monitors;
  std::vector<GroundMotion> motions;
  std::vector<InitialVelocity> initial_velocities;
  std::vector<TimeFunction> functions;
  std::vector<PointLoad> point_loads;
  std::vector<EdgeTraction> tractions;
  std::vector<BodyAcceleration> body_accelerations;
  std::vector<ViscousEdge> viscous_edges;
  std::vector<Bolt> bolts;         // laid out (lay_out)
  std::vector<JointWater> waters;  // a joint law is in one of them at most
  // If a domain was cut: the lines drawn, their dead ends inside blocks, and the statistics.
  std::vector<JointLine> joint_lines;
  std::vector<Crack> cracks;
  std::vector<SetStatistics> joint_sets;
  std::optional<CuttingReport> cutting;

  [[nodiscard]] const Material& material_of(BlockId b) const { return materials[blocks[b.index()].material.index()]; }
  [[nodiscard]] Elasticity elasticity_of(BlockId b) const {
    const Material& m = material_of(b);
    return Elasticity::from(m.young, m.poisson, plane);
  }
  [[nodiscard]] const BlockSupport* support_of(BlockId b) const;
  /// Value of a load's time function at a time of its clock; 1 if the load has none.
  [[nodiscard]] double factor(FunctionId f, double t) const { return f.valid() ? functions[f.index()].value(t) : 1.0; }
  /// The water in joints of a law; nullptr: they are dry.
  [[nodiscard]] const JointWater* water_in(JointId joint) const;
  /// Law of an edge of a block: the edge's own, else the block's, else invalid.
  [[nodiscard]] JointId joint_of(BlockId b, std::size_t ring, std::size_t edge) const;
};

/// One error in the geometry of a model; io locates it in the case file.
struct GeometryFault {
  BlockId block;     // the block at fault
  BlockId other;     // a second block (overlap), else invalid
  std::string what;  // what is wrong, with coordinates
  std::string hint;  // what to change
};

/// Checks the polygons: at least three vertices, finite, no repeated or crossing edges, holes inside, area > 0, no two
/// blocks overlapping by more than a sliver of width 1e-9 of the extent.
[[nodiscard]] std::vector<GeometryFault> check_geometry(const Model& model);

}  // namespace scree
