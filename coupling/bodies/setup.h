// The bodies of one stage, discretised: pools, their places in the state's arrays, and the outlines that may touch.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "coupling/bodies/clocks.h"
#include "coupling/bodies/joint_laws.h"
#include "coupling/bodies/methods.h"
#include "coupling/bodies/outlines.h"
#include "coupling/state.h"
#include "model/pool.h"

namespace scree::coupling {

/// One body and its places in pools and arrays.
struct Body {
  BlockId block;
  std::int32_t pool = 0, index = 0;        // pool, and body within it
  std::int32_t first_node = 0, nodes = 0;  // in the state's arrays
  bool driven = false;                     // held or moved as a whole, or a ghost; has no unknowns
  bool absent = false;                     // not in the stage; driven too, at rest at its place in the model, untouched
  bool ghost = false;                      // another integrator moves it (see Ghosts)
  bool resting = false;                    // driven, and stays at its place: in the model, or where it fell asleep
  bool asleep = false;                     // driven too, stays where it is, untouched (see Ghosts)
  bool divided = false;                    // another integrator moves one half of it
  bool slow = false;                       // its internal force is evaluated at long steps only (see Ghosts)
  bool touched = true;                     // contact forces on it matter to some integrator of this setup
  MotionId motion;                         // of a driven body; invalid: at rest
  Vec2 centre{0.0, 0.0};                   // centroid in the model [m]
};

/// Ghost bodies, which the owner of a setup includes and does not move: those of the other side of a partitioned stage.
/// They are driven, but along paths that their integrator determines, and have pools of their own. The half of a
/// divided body that does not act here is a ghost, in the pool of the other half; its contacts all belong to the
/// explicit side.
struct Ghosts {
  std::vector<char> ghost;  // per body: 1 for a ghost; empty: none
  bool touch = true;        // false: no contacts with them, and driven bodies belong to the other side as well
  bool shared = false;      // all contacts belong to the explicit side, those between two ghosts too
  // Per body: 1 where a Subcycled integrator evaluates its internal force at long steps only; pools of their own.
  // Empty: none.
  std::vector<char> slow;
  // Per body: 1 where it takes no steps and has no contacts, but keeps its stress. Empty: none.
  std::vector<char> asleep;
};

/// Constant during a stage.
class Setup {
 public:
  /// Builds the pools from records (ordered by block). Throws what a pool throws on a body it cannot make.
  /// @param earlier  another setup of the blocks: what bodies have in common with it need not be made again
  Setup(const Model& model, const Methods& methods, const std::vector<BodyRecord>& records, const Ghosts& ghosts = {},
        Clocks clocks = {}, const Setup* earlier = nullptr);

  [[nodiscard]] const Model& model() const { return *model_; }
  /// The joint laws with their present strengths.
  [[nodiscard]] const JointLaws& laws() const { return laws_; }
  /// Between two steps only: all later uses of a strength have the new one.
  void divide_strength(const StrengthPlan& plan, double factor) { laws_.divide(plan, factor); }
  [[nodiscard]] std::size_t pools() const { return pools_.size(); }
  [[nodiscard]] const Pool& pool(std::size_t p) const { return *pools_[p]; }
  /// Pools of free bodies, whose forces and energies are this setup's. Driven bodies, ghosts among them, have pools of
  /// their own: they keep their shape, or another integrator evaluates their forces, and steps skip them.
  [[nodiscard]] const std::vector<std::size_t>& own_pools() const { return own_pools_; }
  /// The same in two groups: those whose internal force is evaluated at every step, and those of slow bodies.
  [[nodiscard]] const std::vector<std::size_t>& fast_pools() const { return fast_pools_; }
  [[nodiscard]] const std::vector<std::size_t>& slow_pools() const { return slow_pools_; }
  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  [[nodiscard]] const Body& body(BodyIndex i) const { return bodies_[i.index()]; }
  /// The body of a block.
  [[nodiscard]] const Body& body(BlockId block) const { return bodies_[block.index()]; }
  [[nodiscard]] const Outlines& outlines() const { return outlines_; }
  [[nodiscard]] std::int32_t nodes() const { return pool_first_.back(); }
  /// First node of a pool in the state's arrays.
  [[nodiscard]] std::int32_t pool_first(std::size_t p) const { return pool_first_[p]; }
  [[nodiscard]] const Pool& pool_of(const Body& b) const { return *pools_[static_cast<std::size_t>(b.pool)]; }
  /// Part of an array (x, y per node) that belongs to a pool.
  template <class T>
  [[nodiscard]] std::span<T> part(std::span<T> all, std::size_t p) const {
    const auto first = static_cast<std::size_t>(pool_first_[p]), last = static_cast<std::size_t>(pool_first_[p + 1]);
    return all.subspan(2 * first, 2 * (last - first));
  }
  /// False for two bodies that contact forces do not move, and for ghosts without contacts.
  [[nodiscard]] bool can_touch(std::size_t a, std::size_t b) const {
    const Body &x = bodies_[a], &y = bodies_[b];
    return !x.absent && !y.absent && !x.asleep && !y.asleep && (x.touched || y.touched) &&
           (ghosts_touch_ || !(x.ghost || y.ghost || x.divided || y.divided));
  }
  /// Row of a pool with its nodes counted in the state's arrays, and back.
  [[nodiscard]] Row global(const Body& b, Row row) const;
  [[nodiscard]] Row local(const Body& b, Row row) const;
  enum class NodeKind : char { free, driven, resting, ghost };
  [[nodiscard]] NodeKind kind(std::int32_t node) const { return kind_[static_cast<std::size_t>(node)]; }
  /// True for a row on a node that another integrator moves.
  [[nodiscard]] bool on_ghost(const Row& row) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (row.w[k] != 0.0 && kind(row.node[k]) == NodeKind::ghost) return true;
    return false;
  }
  /// True if this setup, not the other side, applies a force on rows of one body: on a divided body the explicit side
  /// applies it as soon as one node is explicit.
  [[nodiscard]] bool applies(std::span<const Row> rows) const;
  /// One flag per body of a pool: 1 if it is free.
  [[nodiscard]] std::span<const char> counted(std::size_t p) const { return counted_[p]; }

  /// Moves the anchors of a body that holds its edges, see BodyTransfer::shift_edges().
  void shift_edges(const Body& b, std::span<const double> shift) {
    pools_[static_cast<std::size_t>(b.pool)]->shift_edges(b.index, shift);
  }
  /// Sets positions and velocities of driven bodies at a time; ghosts stay.
  void prescribe(double time, std::span<double> q, std::span<double> v) const;
  /// The same without bodies at rest, which are in place already.
  void prescribe_motions(double time, std::span<double> q, std::span<double> v) const;
  /// Index of an outline edge; not valid if there is none (a crack that the stage does not cut).
  [[nodiscard]] EdgeIndex edge_of(std::int32_t block, std::int32_t ring, std::int32_t edge) const;
  /// Displacement of a driven body at a time since the start.
  [[nodiscard]] Vec2 driven_displacement(const Body& b, double time) const;
  /// Velocity of a ground motion at a time since the start.
  [[nodiscard]] Vec2 ground_velocity(MotionId m, double time) const {
    return model_->motions[m.index()].velocity(motion_time(m, time));
  }
  /// Value of a load's function at a time, by the function's clock; 1 where it has none.
  [[nodiscard]] double factor(FunctionId f, double time) const {
    return model_->factor(f, f.valid() && !clocks_.function.empty() ? time - clocks_.function[f.index()] : time);
  }
  [[nodiscard]] const Clocks& clocks() const { return clocks_; }
  /// The model's waters in the stage.
  [[nodiscard]] const std::vector<JointWater>& waters() const { return waters_; }
  /// The water in joints of a law; nullptr: they are dry.
  [[nodiscard]] const JointWater* water_in(JointId joint) const;

 private:
  [[nodiscard]] double motion_time(MotionId m, double time) const {
    return clocks_.motion.empty() ? time : time - clocks_.motion[m.index()];
  }
  /// Reserves room for all outlines, which would take up to twice the memory if they grew one by one.
  void reserve_outlines();
  void add_outline(BodyIndex index);
  void add_cracks(BodyIndex index, const Boundary& boundary, OutlineNode first_node);

  const Model* model_;
  std::vector<std::unique_ptr<Pool>> pools_;
  std::vector<std::size_t> own_pools_, fast_pools_, slow_pools_;
  std::vector<std::int32_t> pool_first_;
  std::vector<Body> bodies_;
  std::vector<NodeKind> kind_;
  std::vector<std::vector<char>> counted_;
  bool ghosts_touch_;
  Clocks clocks_;
  JointLaws laws_;
  std::vector<JointWater> waters_;
  Outlines outlines_;
};

/// Position of a row.
[[nodiscard]] inline Vec2 position(const Row& row, std::span<const double> q) {
  Vec2 x = Vec2::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = 2 * static_cast<std::size_t>(row.node[k]);
    x += row.w[k] * Vec2(q[i], q[i + 1]);
  }
  return x;
}

/// f += J^T force.
inline void add_force(const Row& row, const Vec2& force, std::span<double> f) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = 2 * static_cast<std::size_t>(row.node[k]);
    f[i] += row.w[k] * force.x();
    f[i + 1] += row.w[k] * force.y();
  }
}

/// Shape of a block in the model, at rest and free of stress.
[[nodiscard]] ReferenceShape reference_shape(const Model& model, BlockId block);

}  // namespace scree::coupling
