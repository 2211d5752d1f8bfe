#include "coupling/stages/sleep_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "coupling/bolts/bolt_rows.h"
#include "coupling/contact/contact_energy.h"
#include "coupling/contact/search/box_tree.h"

namespace scree::coupling {
namespace {

constexpr double kReach = 2.0;      // in detection distances: a step moves a point by at most half of one
constexpr double kNoStrain = 1e-9;  // energies of smaller strains count as none
constexpr double kNowhere = 1e300;  // [m]
constexpr double kStill = 1e-12;    // [m/s]: the sum of a record's accelerations ends at round-off, not at 0

bool overlap(const Box& a, const Box& b) {
  return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

/// Sets of bodies that are joined, by the lowest of each.
class Islands {
 public:
  explicit Islands(std::size_t bodies) : above_(bodies) { std::iota(above_.begin(), above_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> above_;
};

}  // namespace

SleepRules::SleepRules(const Stage& stage, const Setup& setup, const State& state, double detection)
    : stage_(&stage), setup_(&setup), reach_(kReach * detection), balance_(setup, state) {
  const Outlines& o = setup.outlines();
  first_edge_.assign(setup.bodies().size() + 1, o.edges.size());
  for (std::size_t i = o.edges.size(); i > 0; --i) first_edge_[o.edges[EdgeIndex::of(i - 1)].body.index()] = i - 1;
  for (std::size_t b = setup.bodies().size(); b > 0; --b)
    first_edge_[b - 1] = std::min(first_edge_[b - 1], first_edge_[b]);
  find_sources(state);
  plant(state);
}

SleepRules::~SleepRules() = default;

void SleepRules::find_sources(const State& state) {
  const Model& model = setup_->model();
  const auto add = [&](FunctionId f, std::vector<BlockId> blocks) {
    if (f.valid()) sources_.push_back({f, {}, nullptr, std::move(blocks)});
  };
  for (const PointLoad& load : model.point_loads) add(load.function, {load.block});
  for (const EdgeTraction& load : model.tractions) add(load.function, {load.span.block});
  for (const BodyAcceleration& load : model.body_accelerations) add(load.function, load.blocks);
  for (const ViscousEdge& edge : model.viscous_edges)
    if (edge.motion.valid()) sources_.push_back({{}, edge.motion, nullptr, {edge.span.block}});
  for (const BoltRows& rows : acting_bolts(*setup_, state)) {
    std::vector<BlockId> blocks;
    for (const BodyIndex b : rows.body)
      if (!setup_->body(b).driven) blocks.push_back(setup_->body(b).block);
    for (const BodyIndex b : rows.body)
      if (setup_->body(b).motion.valid()) sources_.push_back({{}, {}, &setup_->body(b), blocks});
  }
}

bool SleepRules::changes(const Source& source, Tick from, Tick to) const {
  if (source.function.valid())
    return setup_->factor(source.function, seconds(from)) != setup_->factor(source.function, seconds(to));
  if (source.driven != nullptr) return drives(*source.driven, from, to);
  return setup_->ground_velocity(source.motion, seconds(to)).norm() > kStill;
}

bool SleepRules::drives(const Body& b, Tick from, Tick to) const {
  if (!b.motion.valid()) return false;
  const Vec2 way = setup_->driven_displacement(b, seconds(to)) - setup_->driven_displacement(b, seconds(from));
  return setup_->ground_velocity(b.motion, seconds(to)).norm() > kStill || way.norm() > kStill * seconds(to - from);
}

Box SleepRules::box_of(EdgeIndex edge, std::span<const double> q) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& e = o.edges[edge];
  Box box{Vec2(kNowhere, kNowhere), Vec2(-kNowhere, -kNowhere)};
  for (std::int32_t k = 0; k <= e.segments; ++k) {
    const Vec2 x = position(o.nodes[o.vertices[e.vertex(k)].node], q);
    box.lo = box.lo.cwiseMin(x);
    box.hi = box.hi.cwiseMax(x);
  }
  return box;
}

void SleepRules::plant(const State& state) {
  tree_.reset();
  boxes_.clear();
  planted_.clear();
  for (std::size_t b = 0; b < setup_->bodies().size(); ++b)
    for (std::size_t e = first_edge_[b]; state.sleep.asleep(b) && e < first_edge_[b + 1]; ++e) {
      planted_.push_back(EdgeIndex::of(e));
      boxes_.push_back(box_of(planted_.back(), state.q));
    }
  if (planted_.empty()) return;
  boxes_.push_back(boxes_.front());
  tree_ = std::make_unique<BoxTree>(boxes_);
}

void SleepRules::mark(const State& state, std::size_t body, Change& change, const std::string& cause) {
  if (change.cause.empty()) change.cause = cause;
  marked_[static_cast<std::size_t>(state.sleep.island[body])] = 1;
}

void SleepRules::wake_marked(State& state, Change& change) {
  if (change.cause.empty()) return;
  for (std::size_t b = 0; b < state.sleep.island.size(); ++b) {
    std::int32_t& island = state.sleep.island[b];
    if (island < 0 || marked_[static_cast<std::size_t>(island)] == 0) continue;
    island = -1;
    state.sleep.calm[b] = 0;
    change.woke.push_back(b);
  }
}

void SleepRules::wake_near(const State& state, Tick from, Tick to, Change& change) {
  const Outlines& o = setup_->outlines();
  const std::size_t query = planted_.size();
  for (std::size_t b = 0; b < setup_->bodies().size(); ++b) {
    const Body& body = setup_->bodies()[b];
    if (body.absent || state.sleep.asleep(b) || (body.driven && !drives(body, from, to))) continue;
    own_.clear();
    Box around{Vec2(kNowhere, kNowhere), Vec2(-kNowhere, -kNowhere)};
    for (std::size_t e = first_edge_[b]; e < first_edge_[b + 1]; ++e) {
      Box box = box_of(EdgeIndex::of(e), state.q);
      box.lo.array() -= reach_;
      box.hi.array() += reach_;
      around.lo = around.lo.cwiseMin(box.lo);
      around.hi = around.hi.cwiseMax(box.hi);
      own_.push_back(box);
    }
    tree_->move(query, around);
    hit_.clear();
    tree_->for_overlaps_of(query, [&](std::size_t i) {
      if (i == query) return;
      if (std::any_of(own_.begin(), own_.end(), [&](const Box& box) { return overlap(box, boxes_[i]); }))
        hit_.push_back(o.edges[planted_[i]].body.index());
    });
    if (hit_.empty()) continue;
    const std::string cause = fmt::format("block '{}' {}", setup_->model().blocks[body.block.index()].name,
                                          body.driven ? "moves" : "comes near");
    for (const std::size_t asleep : hit_) mark(state, asleep, change, cause);
  }
}

std::string SleepRules::cause_of(const Source& source) const {
  if (source.driven != nullptr)
    return fmt::format("block '{}', joined by a bolt, moves",
                       setup_->model().blocks[source.driven->block.index()].name);
  if (!source.function.valid()) return "the motion of a viscous edge";
  return fmt::format("the load of function '{}' changes", setup_->model().functions[source.function.index()].name);
}

void SleepRules::wake(State& state, Tick until, Change& change) {
  SleepMemory& sleep = state.sleep;
  const Tick from = sleep.seen, to = std::max(until, from);
  sleep.seen = to;
  marked_.assign(setup_->bodies().size(), 0);
  for (const Source& source : sources_) {
    if (!changes(source, from, to)) continue;
    const auto act = [&](std::size_t b) {
      sleep.calm[b] = 0;
      if (sleep.asleep(b)) mark(state, b, change, cause_of(source));
    };
    for (const BlockId b : source.blocks) act(b.index());
    for (std::size_t b = 0; source.blocks.empty() && b < sleep.calm.size(); ++b) act(b);
  }
  if (tree_ != nullptr) wake_near(state, from, to, change);
  wake_marked(state, change);
}

void SleepRules::count_calm(State& state, const TimeIntegrator& integrator) {
  (void)balance_.measure(state, integrator);
  std::vector<double> elastic(setup_->bodies().size(), 0.0);
  for (const ContactMemory& m : state.contacts)
    for (const std::int32_t b : {m.key.block_p, m.key.block_e})
      elastic[static_cast<std::size_t>(b)] += 0.5 * closed_energy(m);
  const double tolerance = stage_->sleep;
  for (std::size_t i = 0; i < elastic.size(); ++i) {
    const Body& b = setup_->bodies()[i];
    if (b.driven || state.sleep.asleep(i)) continue;
    const auto p = static_cast<std::size_t>(b.pool);
    const BodyTotals totals = setup_->pool_of(b).totals(b.index, setup_->part(std::span<const double>(state.q), p),
                                                        setup_->part(std::span<const double>(state.v), p));
    const double least =
        0.5 * setup_->model().elasticity_of(b.block).p_modulus() * kNoStrain * kNoStrain * state.bodies[i].shape.area;
    const double most = tolerance * tolerance * std::max(elastic[i] + std::max(0.0, totals.elastic), least);
    const bool calm = balance_.ratio_of(BodyIndex::of(i)) <= tolerance && totals.kinetic <= most;
    state.sleep.calm[i] = calm ? std::min(state.sleep.calm[i] + 1, kChecks) : 0;
  }
}

void SleepRules::fall_asleep(State& state, Change& change) {
  SleepMemory& sleep = state.sleep;
  const auto& bodies = setup_->bodies();
  if (std::none_of(sleep.calm.begin(), sleep.calm.end(), [](std::int32_t n) { return n >= kChecks; })) return;
  const Outlines& o = setup_->outlines();
  const auto steps = [&](std::size_t b) { return !bodies[b].driven && !sleep.asleep(b); };
  std::vector<Box> boxes;
  std::vector<std::size_t> owner;
  for (const EdgeIndex e : o.edges.indices()) {
    const std::size_t b = o.edges[e].body.index();
    const bool moves = bodies[b].driven && drives(bodies[b], state.time, sleep.seen);
    if (!steps(b) && !moves) continue;
    Box box = box_of(e, state.q);
    box.lo.array() -= 0.5 * reach_;
    box.hi.array() += 0.5 * reach_;
    boxes.push_back(box);
    owner.push_back(b);
  }
  Islands islands(bodies.size());
  std::vector<char> awake(bodies.size(), 0);
  BoxTree tree(boxes);
  tree.for_overlaps([&](std::size_t i, std::size_t j) {
    const std::size_t a = owner[i], b = owner[j];
    if (bodies[a].driven != bodies[b].driven) awake[bodies[a].driven ? b : a] = 1;
    if (!bodies[a].driven && !bodies[b].driven) islands.join(a, b);
  });
  for (const BoltRows& rows : acting_bolts(*setup_, state))
    for (std::size_t k = 0, first = bodies.size(); k < rows.body.size(); ++k) {
      const std::size_t b = rows.body[k].index();
      if (bodies[b].driven) continue;
      if (first < bodies.size()) islands.join(first, b);
      first = b;
    }
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (steps(b) && (sleep.calm[b] < kChecks || awake[b] != 0)) awake[islands.of(b)] = 1;
  std::size_t stepping = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!steps(b)) continue;
    ++stepping;
    if (awake[islands.of(b)] == 0) change.fell.push_back(b);
  }
  const bool few = static_cast<double>(change.fell.size()) < kShare * static_cast<double>(stepping);
  if (few && state.step - sleep.fell < kPatience) change.fell.clear();
  if (change.fell.empty()) return;
  sleep.fell = state.step;
  for (const std::size_t b : change.fell) sleep.island[b] = static_cast<std::int32_t>(islands.of(b));
}

std::optional<SleepRules::Change> SleepRules::evaluate(State& state, const TimeIntegrator& integrator, Tick until) {
  SleepMemory& sleep = state.sleep;
  if (std::exchange(sleep.evaluated, state.step) == state.step) return {};
  sleep.island.resize(setup_->bodies().size(), -1);
  sleep.calm.resize(setup_->bodies().size(), 0);
  Change change;
  wake(state, until, change);
  const bool loose =
      state.support.releasing(state.time) || (stage_->strength.used() && stage_->strength.from != stage_->strength.to);
  if (!loose && state.step % kEvery == 0) {
    count_calm(state, integrator);
    fall_asleep(state, change);
  }
  if (change.fell.empty() && change.woke.empty()) return {};
  plant(state);
  return change;
}

}  // namespace scree::coupling
