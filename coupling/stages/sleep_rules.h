// Which blocks fall asleep, and which wake.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/stages/force_balance.h"

namespace scree::coupling {

class BoxTree;

/// A block is at rest if its unbalanced force is below `tolerance` times the largest single force on it, and its
/// kinetic energy below tolerance^2 times the elastic energy of it and its contacts: then it moves by no more than
/// about that fraction of its elastic compression. Islands are blocks that are within reach of each other, or joined by
/// bolts; held and driven blocks join nothing. An island of blocks that were at rest for kChecks checks, kEvery steps
/// apart, falls asleep; a small one (less than kShare of the blocks that are awake) waits until kPatience steps have
/// passed since others did, since each change makes the bodies that are awake anew. It wakes before a step in which
///   - a block that is awake, or a driven one that moves, comes within reach of it (twice the detection distance,
///     between boxes around edges),
///   - a load's time function changes, the ground of a viscous edge moves, or a driven block that a bolt joins to it,
///     where one of its blocks is concerned.
/// Changes of supports, water, bolts, strengths and methods are stages, at whose beginning all blocks are awake; while
/// a stage releases forces or changes strengths no block falls asleep.
/// @source docs/theory/time-integration.md, "Sleep"
class SleepRules {
 public:
  static constexpr std::int64_t kEvery = 32;  // steps
  static constexpr std::int32_t kChecks = 8;
  static constexpr double kShare = 0.05;
  static constexpr std::int64_t kPatience = 1024;  // steps

  struct Change {
    std::vector<std::size_t> fell, woke;  // bodies
    std::string cause;                    // of the first island that wakes
  };
  /// @param stage,setup  outlive it   @param detection  [m]
  SleepRules(const Stage& stage, const Setup& setup, const State& state, double detection);
  SleepRules(const SleepRules&) = delete;
  SleepRules& operator=(const SleepRules&) = delete;
  ~SleepRules();
  /// Evaluates the rules before a step, once, and sets State::sleep. Velocities stay.
  /// @param until  end of the next step, at least
  [[nodiscard]] std::optional<Change> evaluate(State& state, const TimeIntegrator& integrator, Tick until);

 private:
  /// What acts on some bodies and may change: a time function, the motion of a viscous edge, a driven body.
  struct Source {
    FunctionId function;
    MotionId motion;
    const Body* driven = nullptr;  // joined to them by a bolt
    std::vector<BlockId> blocks;   // empty: all
  };
  void find_sources(const State& state);
  [[nodiscard]] bool changes(const Source& source, Tick from, Tick to) const;
  [[nodiscard]] bool drives(const Body& b, Tick from, Tick to) const;
  /// Wakes islands on whose blocks something acts.
  void wake(State& state, Tick until, Change& change);
  void wake_near(const State& state, Tick from, Tick to, Change& change);
  /// Why a source wakes a block.
  [[nodiscard]] std::string cause_of(const Source& source) const;
  /// Marks the island of a body that is asleep.
  void mark(const State& state, std::size_t body, Change& change, const std::string& cause);
  void wake_marked(State& state, Change& change);
  [[nodiscard]] Box box_of(EdgeIndex edge, std::span<const double> q) const;
  /// Puts the edges of blocks that are asleep in the tree.
  void plant(const State& state);
  void count_calm(State& state, const TimeIntegrator& integrator);
  void fall_asleep(State& state, Change& change);

  const Stage* stage_;
  const Setup* setup_;
  double reach_;  // [m]
  ForceBalance balance_;
  std::vector<Source> sources_;
  std::vector<std::size_t> first_edge_;  // per body, and the end
  std::unique_ptr<BoxTree> tree_;        // of the boxes below; the last one is a query
  std::vector<Box> boxes_;
  std::vector<EdgeIndex> planted_;
  std::vector<char> marked_;      // per island: 1 if it wakes
  std::vector<Box> own_;          // scratch: around the edges of a body
  std::vector<std::size_t> hit_;  // scratch: bodies asleep that it comes near
};

}  // namespace scree::coupling
