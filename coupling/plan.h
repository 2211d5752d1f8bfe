// Plan of a run: stages, output and streaming.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/formulation.h"
#include "model/geometry.h"
#include "model/ids.h"

namespace scree::coupling {

enum class Integrator { explicit_, implicit, partitioned };
/// beta = 1/2, gamma = 1 ([Qu2013] 3.3.2), or beta = 1/4, gamma = 1/2 for convergence studies without contacts.
enum class NewmarkScheme { damped, trapezoidal };

/// What becomes of the velocity beside the affine one of a block that changes method
/// (docs/theory/transfer.md, "Modes").
enum class TransferMode { reservoir, strain_rate, rotational };

/// Settings of the open-close iteration and of step control ([Qu2013] 3.2.2, 4.5).
struct StepControl {
  // Open-close passes that do not halve the number of switches before the step is cut ([Qu2013]: 6).
  int max_passes = 12;
  double max_displacement = 0.0;  // largest displacement per step [m]; 0: a hundredth of the smallest block's width
  double cut_factor = 1.0 / 3.0;  // a step that fails is repeated with this fraction of its length
  int max_cuts = 12;              // consecutive cuts before the run gives up
};

/// Method and mesh of named blocks in a stage.
struct MethodRule {
  std::vector<BlockId> blocks;
  std::string method;
  double cover_size = 0.0;      // NMM mesh; 0: that of the block or the stage [m]
  bool onefold = false;         // NMM: one cover around the whole block
  bool model_triangle = false;  // of onefold: one triangle, common to the whole model
};

/// Which blocks of a partitioned stage take explicit steps; the others take implicit ones. The lists have precedence,
/// then the region, at the initial position of the blocks (of a block across its border: the elements inside), then the
/// area. Moving blocks may change sides from step to step: explicit above `up`, implicit again below `down`.
/// @source docs/theory/explicit-implicit-coupling.md, "Sides"; [Qu2013] ch. 7
struct Partition {
  struct Band {
    double up = 0.0, down = 0.0;  // 0, 0: no such rule
    [[nodiscard]] bool used() const { return up > 0.0; }
  };
  std::vector<BlockId> explicit_blocks, implicit_blocks;
  Ring explicit_region;  // blocks inside are explicit, those across its border are divided; empty: no such rule [m]
  double explicit_area = 0.0;  // smaller blocks are explicit [m2]; 0: no such rule
  Band speed;                  // of the fastest corner [m/s]
  Band strain_rate;            // largest principal one of the affine part [1/s]
  std::int32_t substeps = 0;   // explicit steps per implicit one; 0: as the certified bound requires
  // All contacts explicit; false: those between implicit blocks by the open-close iteration ([Qu2013] figure 7.6).
  bool shared_contacts = false;
  // The other blocks take explicit steps too, of the same length; their internal force is evaluated once per dt.
  bool slow_explicit = false;
  [[nodiscard]] bool changes() const { return speed.used() || strain_rate.used(); }
};

/// Conditions that end a stage before its duration is over: the first that is met. 0: no such rule.
/// @source docs/theory/time-integration.md, "Rest and statics"
struct EndRules {
  double kinetic_below = 0.0;  // kinetic energy: a fraction of its maximum in the stage so far
  double force_below = 0.0;    // the largest unbalanced force: a fraction of the largest single one
  Tick hold = 0;               // the two above must hold without interruption for this time
  double slip = 0.0;           // largest slip between two blocks since the stage began [m]
  double displacement = 0.0;   // of a block's centre of mass since the stage began [m]
  [[nodiscard]] bool used() const {
    return kinetic_below > 0.0 || force_below > 0.0 || slip > 0.0 || displacement > 0.0;
  }
};

/// Blocks change between the NMM and the DDA during a stage: a block whose motion has been almost affine for long
/// enough changes to the DDA, a block that is hit or strained changes to the NMM. A bound of 0: no such rule.
/// @source docs/theory/transfer.md, "Switching rules"
struct SwitchRules {
  bool used = false;
  std::vector<BlockId> blocks;  // empty: all that can
  double kinetic = 0.0;         // dT/(T + |U|) below this,
  double elastic = 0.0;         // dU/(T + |U|),
  double inhomogeneity = 0.0;   // and sqrt(dU/|U|)
  Tick hold = 0;                // for this time: to the DDA
  struct Back {                 // above any of these bounds: to the NMM
    double strain_rate = 0.0;   // largest principal one of the affine part [1/s]
    double stress = 0.0;        // largest principal one of the affine part, of either sign [Pa]
    double acceleration = 0.0;  // resultant of the contact forces over the mass [m/s2]
    [[nodiscard]] bool used() const { return strain_rate > 0.0 || stress > 0.0 || acceleration > 0.0; }
  };
  Back back;
};

/// Strengths of joint laws that a stage divides by a factor (coupling/bodies/joint_laws.h).
struct StrengthPlan {
  enum class Part { all, friction, cohesion };  // friction: tan phi, tan psi; cohesion: cohesion and tensile strength
  std::vector<JointId> joints;                  // empty: none
  Part part = Part::all;
  double from = 1.0, to = 1.0;  // factor at the beginning of the stage, and when its duration is over
  [[nodiscard]] bool used() const { return !joints.empty(); }
};

/// Construction at the beginning of a stage. Blocks that are absent in this stage and were present in the previous one
/// are removed; those that were absent and are present now are added.
/// @source docs/theory/construction.md, "Release"
struct Construction {
  std::vector<BlockId> absent;    // blocks absent in this stage, in ascending order
  std::optional<double> release;  // part of the removed forces released in this stage, 0 to 1; empty: none
  Tick release_time = 0;          // duration of the linear release; 0: at once, as the stage begins
  [[nodiscard]] std::vector<char> flags(std::size_t blocks) const {
    std::vector<char> out(blocks, 0);
    for (const BlockId b : absent) out[b.index()] = 1;
    return out;
  }
};

struct Stage {
  std::string name;
  std::string method;  // of blocks that no rule names
  std::vector<MethodRule> rules;
  Integrator integrator = Integrator::explicit_;
  std::optional<double> dt;  // [s]; empty: auto, explicit only
  bool force_dt = false;     // an explicit dt above the certified bound is used nevertheless
  double safety = 0.8;       // fraction of the certified explicit bound that auto takes
  Tick duration = 0;
  double cover_size = 0.0;  // NMM mesh [m]
  Kinematics kinematics = Kinematics::corotational;
  BlockRotation rotation = BlockRotation::exact;  // DDA, implicit
  std::optional<MassKind> mass;                   // empty: affine-exact in explicit stages, consistent in implicit ones
  bool cracks = true;                             // NMM: blocks are cut along their cracks
  double damping = 0.0;                           // mass-proportional [1/s]
  bool damp_rigid_motion = false;  // `damping` acts on the whole velocity, not only on its non-affine part
  double stiffness_damping = 0.0;  // Rayleigh damping proportional to stiffness [s]
  double local_damping = 0.0;      // fraction of the unbalanced force, against the velocity; explicit, 0 to 1
  double sliding_damping = 1.0;    // damping of the deformation of sliding blocks, fraction of critical
  NewmarkScheme newmark = NewmarkScheme::damped;
  TransferMode transfer = TransferMode::reservoir;  // of blocks that change method as the stage begins
  double transfer_cap = 1.1;                        // strain_rate: largest factor of the strain rates
  double dynamics = 1.0;    // fraction of the velocity that an implicit step hands to the next, 0 to 1
  bool rest = false;        // velocities are set to 0: explicit at peaks of kinetic energy, implicit after each step
  double rest_force = 0.0;  // a rest stage ends once unbalanced forces are below this fraction of the largest; 0: no
  std::int64_t rest_steps = 0;  // and fails if it has not ended after so many steps; 0: after its duration
  // Islands of blocks at rest take no steps until something acts on them: bound of their motion relative to their
  // elastic compression (coupling/stages/sleep_rules.h); 0: all blocks take all steps.
  double sleep = 0.0;
  Partition partition;
  EndRules end;
  SwitchRules change;
  StrengthPlan strength;
  Construction construction;
  StepControl control;
  /// Steps of two sizes, all of them explicit.
  [[nodiscard]] bool subcycled() const { return integrator == Integrator::partitioned && partition.slow_explicit; }
  /// Some blocks take implicit steps.
  [[nodiscard]] bool has_implicit_steps() const { return integrator != Integrator::explicit_ && !subcycled(); }
};

struct OutputPlan {
  Tick every = 0;                     // a frame every so many ticks
  Tick history_every = 0;             // monitors and ledger
  bool contacts = false;              // frames show the contact points
  double checkpoint_every = 60.0;     // a checkpoint every so many seconds of wall time; 0: not by the clock
  std::int64_t checkpoint_steps = 0;  // and every so many steps; 0: not by steps
};

struct LivePlan {
  bool enabled = false;
  std::string url = "udpm://239.255.76.67:7667?ttl=0";
  double rate = 30.0;  // largest number of frames per second of wall time
};

struct Plan {
  std::vector<Stage> stages;
  double detection = 0.0;  // contact detection distance [m]; 0: auto
  OutputPlan output;
  LivePlan live;
  std::map<std::string, std::vector<double>> constants;  // of methods with keys of their own, by name of the method
  int threads = 0;                                       // 0: as many as the machine has
  double max_closure = 0.0;  // a run ends once its ledger is open by more than this part of the energy moved; 0: never
  double max_passed_closure = 1e-3;  // the same bound relative to the energy passed (Ledger::passed)
  double max_gain = 1.0;             // a run ends once Ledger::gain() exceeds this part of the energy passed; 0: never
  // A partitioned stage ends once its effort exceeds this multiple of the effort of implicit steps; 0: never (pace.h)
  double max_slowdown = 20.0;
  bool audit = false;  // every step is checked, and a run ends at the first wrong one
};

}  // namespace scree::coupling
