#include "coupling/stages/method_rules.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "coupling/transfer/transfer_mode.h"
#include "model/elasticity.h"

namespace scree::coupling {
namespace {

constexpr Tick kEvaluations = 10;  // evaluations within the time `hold` for which a block must be calm

/// The largest absolute principal value.
double largest_principal(const Mat2& a) {
  return 0.5 * std::abs(a.trace()) + std::hypot(0.5 * (a(0, 0) - a(1, 1)), 0.5 * (a(0, 1) + a(1, 0)));
}

double ratio(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

/// Unknowns of a body per step; explicit: per second, with its own certified bound 2/h = sqrt(theta lambda).
double cost(const Pool& pool, int body, bool is_explicit) {
  if (!is_explicit) return pool.dofs(body);
  const double unknowns = 2.0 * (pool.first_node(body + 1) - pool.first_node(body));
  return 0.5 * unknowns * std::sqrt(pool.mass_ratio(body) * pool.frequency_bound(body));
}

}  // namespace

MethodRules::MethodRules(const Stage& stage, const Methods& methods, const Setup& setup, const State& state)
    : stage_(&stage), methods_(&methods), setup_(&setup) {
  const SwitchRules& rules = stage.change;
  for (std::size_t i = 0; i < setup.bodies().size(); ++i) {
    const Body& b = setup.bodies()[i];
    const BodyRecord& record = state.bodies[i];
    const bool meant =
        rules.blocks.empty() || std::find(rules.blocks.begin(), rules.blocks.end(), b.block) != rules.blocks.end();
    const std::vector<Crack>& cracks = setup.model().cracks;
    const bool cut = stage.cracks && std::any_of(cracks.begin(), cracks.end(),
                                                 [&](const Crack& crack) { return crack.block == b.block; });
    if (b.driven || !meant || cut || record.form.division.divides()) continue;
    if (record.method == "nmm" && !record.form.onefold) nmm_.push_back(i);
    if (record.method == "dda" && rules.back.used()) dda_.push_back(i);
  }
}

void MethodRules::sum_contacts(const State& state, const TimeIntegrator& integrator) {
  force_.assign(state.q.size(), 0.0);
  if (stage_->change.back.acceleration > 0.0) integrator.contact_forces(state, force_);
}

MethodMeasures MethodRules::measure(const Body& b, const State& state) const {
  const auto p = static_cast<std::size_t>(b.pool);
  const Pool& pool = setup_->pool_of(b);
  const Release r = pool.release(b.index, setup_->part(std::span<const double>(state.q), p),
                                 setup_->part(std::span<const double>(state.v), p));
  const ElasticResponse affine = elastic_response(setup_->model().elasticity_of(b.block), r.motion.F, r.initial);
  const double T = kinetic_of(r.shape, r.motion) + r.kinetic_rest,
               U = std::abs(r.shape.area * affine.energy + r.elastic_rest + r.elastic_cross);
  MethodMeasures m;
  m.kinetic = ratio(r.kinetic_rest, T + U);
  m.elastic = ratio(r.elastic_rest, T + U);
  m.inhomogeneity = std::sqrt(ratio(r.elastic_rest, U));
  m.strain_rate = largest_principal(r.motion.Fdot * r.motion.F.inverse());
  m.stress = largest_principal(affine.stress);
  Vec2 force = Vec2::Zero();
  const std::span<const double> moves = pool.translation(b.index);
  for (std::size_t k = 0; k < static_cast<std::size_t>(b.nodes); ++k) {
    const std::size_t i = 2 * (static_cast<std::size_t>(b.first_node) + k);
    force += moves[k] * Vec2(force_[i], force_[i + 1]);
  }
  m.acceleration = force.norm() / r.shape.mass;
  return m;
}

bool MethodRules::strained(const MethodMeasures& m) const {
  const SwitchRules::Back& back = stage_->change.back;
  const auto above = [](double value, double bound) { return bound > 0.0 && value > bound; };
  return above(m.strain_rate, back.strain_rate) || above(m.stress, back.stress) ||
         above(m.acceleration, back.acceleration);
}

bool MethodRules::calm(const MethodMeasures& m) const {
  const SwitchRules& rules = stage_->change;
  const auto below = [](double value, double bound) { return bound == 0.0 || value <= bound; };
  return below(m.kinetic, rules.kinetic) && below(m.elastic, rules.elastic) &&
         below(m.inhomogeneity, rules.inhomogeneity) && !strained(m);
}

bool MethodRules::cheaper(const Body& b, const State& state, MethodMeasures& m) const {
  const bool is_explicit = !stage_->has_implicit_steps() ||
                           (stage_->integrator == Integrator::partitioned && state.explicit_side[b.block.index()] != 0);
  const auto p = static_cast<std::size_t>(b.pool);
  const Pool& now = setup_->pool_of(b);
  const Release r = now.release(b.index, setup_->part(std::span<const double>(state.q), p),
                                setup_->part(std::span<const double>(state.v), p));
  const std::unique_ptr<Pool> alone = methods_->at("dda")();
  alone->add(setup_->model(), {b.block, "dda", r.shape, Formulation{.rotation = stage_->rotation}});
  alone->finish();
  m.cost_before = cost(now, b.index, is_explicit);
  m.cost_after = cost(*alone, 0, is_explicit);
  return m.cost_after < m.cost_before;
}

std::vector<MethodChange> MethodRules::evaluate(State& state, const TimeIntegrator& integrator) {
  std::vector<MethodChange> out;
  RuleMemory& memory = state.rules;
  if (memory.evaluated == state.time) return out;
  memory.evaluated = state.time;
  memory.calm_since.resize(setup_->bodies().size(), -1);
  const bool all = state.time >= memory.next_evaluation;
  if (!all && dda_.empty()) return out;
  sum_contacts(state, integrator);
  for (const std::size_t i : dda_) {
    const Body& b = setup_->bodies()[i];
    const MethodMeasures m = measure(b, state);
    if (strained(m)) out.push_back({b.block, m});
  }
  if (!all) return out;
  const Tick hold = stage_->change.hold;
  memory.next_evaluation = state.time + std::max<Tick>(1, hold / kEvaluations);
  for (const std::size_t i : nmm_) {
    const Body& b = setup_->bodies()[i];
    Tick& since = memory.calm_since[i];
    MethodMeasures m = measure(b, state);
    if (!calm(m)) {
      since = -1;
      continue;
    }
    if (since < 0) since = state.time;
    if (state.time - since < hold) continue;
    since = state.time;  // if the change is not cheaper, it is evaluated again after another `hold`
    if (cheaper(b, state, m)) out.push_back({b.block, m});
  }
  for (const MethodChange& c : out) memory.calm_since[c.block.index()] = -1;
  std::sort(out.begin(), out.end(), [](const MethodChange& a, const MethodChange& b) { return a.block < b.block; });
  return out;
}

std::string text(const MethodMeasures& m) {
  std::string out = fmt::format(
      "dT {:.2e} and dU {:.2e} of its energy, inhomogeneity {:.3g}, strain rate {:.3g} 1/s, stress {:.3g} Pa, contacts "
      "{:.3g} m/s2",
      m.kinetic, m.elastic, m.inhomogeneity, m.strain_rate, m.stress, m.acceleration);
  if (m.cost_before > 0.0) out += fmt::format(", cost {:.3g} -> {:.3g}", m.cost_before, m.cost_after);
  return out;
}

}  // namespace scree::coupling
