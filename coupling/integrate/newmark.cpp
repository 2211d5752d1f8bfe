#include "coupling/integrate/newmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "coupling/integrate/anderson.h"

namespace scree::coupling {

double DofRow::change(std::span<const double> d) const {
  double sum = known;
  for (std::size_t i = 0; i < dof.size(); ++i) sum += h[i] * d[static_cast<std::size_t>(dof[i])];
  return sum;
}

Newmark::Newmark(const Setup& setup, const StepControl& control, double detection, bool rest)
    : setup_(&setup), control_(control), rest_(rest), finder_(setup, detection) {
  for (const Body& b : setup.bodies()) {
    first_dof_.push_back(b.driven ? -1 : dofs_);
    if (!b.driven) dofs_ += setup.pool_of(b).dofs(b.index);
  }
  driven_move_.resize(setup.bodies().size());
  gravity_.assign(2 * static_cast<std::size_t>(setup.nodes()), 0.0);
  for (std::size_t p = 0; p < setup.pools(); ++p)
    setup.pool(p).body_force(setup.model().gravity, setup.part(std::span<double>(gravity_), p));
  for (auto* v : {&rhs_, &base_, &d_, &rate_}) v->assign(static_cast<std::size_t>(dofs_), 0.0);
}

double Newmark::enter(State& state) {
  springs_ = point_springs(*setup_, state);
  finder_.restore(state.contacts, before_);
  finder_.find(state.q, before_, state.step == 0, list_);
  (void)finder_.adopt_kinds(list_);  // the energy returned below has it
  state.contacts = list_.memory;
  state.a.clear();
  state.last_step = 0;
  return contact_energy(list_);
}

void Newmark::leave(State& state) {
  update_ledger(state);
  state.last_step = 0;  // no shadow of ours
}

double Newmark::stable_step(const State&, std::string*) { return std::numeric_limits<double>::infinity(); }

void Newmark::update_ledger(State& state) {
  double kinetic = 0.0;
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    kinetic += setup_->pool(p).kinetic_energy(setup_->part(std::span<const double>(state.q), p),
                                              setup_->part(std::span<const double>(state.v), p), setup_->counted(p));
  state.ledger.set(Column::kinetic, kinetic);
}

void Newmark::add_point(DofRow& out, std::int32_t body, const Row& row, const Vec2& c,
                        std::span<const double> q) const {
  const Body& b = setup_->bodies()[static_cast<std::size_t>(body)];
  if (b.driven) {
    out.known += c.dot(driven_move_[static_cast<std::size_t>(body)]);
    return;
  }
  const auto p = static_cast<std::size_t>(b.pool);
  const Pool& pool = setup_->pool_of(b);
  const ChartRow chart = pool.chart_row(b.index, setup_->local(b, row), setup_->part(q, p));
  const std::int32_t shift = first_dof_[static_cast<std::size_t>(body)] - chart.dof[0];
  for (std::size_t k = 0; k < static_cast<std::size_t>(chart.n); ++k) {
    const std::int32_t dof = chart.dof[k] + shift;
    const double h = c.x() * chart.tx[k] + c.y() * chart.ty[k];
    const auto at = std::find(out.dof.begin(), out.dof.end(), dof);
    if (at == out.dof.end()) {
      out.dof.push_back(dof);
      out.h.push_back(h);
    } else {
      out.h[static_cast<std::size_t>(at - out.dof.begin())] += h;
    }
  }
}

DofRow Newmark::dof_row(const ContactPoint& p, const ContactRow& row, std::span<const double> q) const {
  const Outlines& o = setup_->outlines();
  DofRow out;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto node = static_cast<std::size_t>(p.node[i]);
    add_point(out, o.node_body[node], o.nodes[node], row[i], q);
  }
  return out;
}

void Newmark::linearise(const State& state, double h) {
  const std::span<const double> q(state.q), v(state.v);
  blocks_.clear();
  std::fill(base_.begin(), base_.end(), 0.0);
  for (std::size_t i = 0; i < setup_->bodies().size(); ++i) {
    const Body& b = setup_->bodies()[i];
    const double t0 = seconds(state.time);
    driven_move_[i] =
        b.driven ? Vec2(setup_->driven_displacement(b, t0 + h) - setup_->driven_displacement(b, t0)) : Vec2(0.0, 0.0);
    if (b.driven) continue;
    const auto p = static_cast<std::size_t>(b.pool);
    const Pool& pool = setup_->pool_of(b);
    const std::size_t first_block = blocks_.size();
    pool.linearise(b.index, setup_->part(q, p), setup_->part(v, p), blocks_);
    const std::int32_t shift = first_dof_[i] - blocks_[first_block].first_dof;
    for (std::size_t k = first_block; k < blocks_.size(); ++k) {
      ImplicitBlock& block = blocks_[k];
      block.first_dof += shift;
      const ImplicitBlock::Vector load = block.force + 2.0 / h * (block.M * block.rate);
      for (Eigen::Index j = 0; j < load.size(); ++j) {
        base_[static_cast<std::size_t>(block.first_dof + j)] += load[j];
        rate_[static_cast<std::size_t>(block.first_dof + j)] = block.rate[j];
      }
    }
    for (std::int32_t k = b.first_node; k < b.first_node + b.nodes; ++k) {
      const auto n = 2 * static_cast<std::size_t>(k);
      if (gravity_[n] == 0.0 && gravity_[n + 1] == 0.0) continue;
      DofRow row;
      add_point(row, static_cast<std::int32_t>(i), Row{{k, k, k}, {1.0, 0.0, 0.0}}, {gravity_[n], gravity_[n + 1]}, q);
      for (std::size_t j = 0; j < row.dof.size(); ++j) base_[static_cast<std::size_t>(row.dof[j])] += row.h[j];
    }
  }
  trial_.resize(list_.points.size());
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const ContactPoint& p = list_.points[i];
    const ContactMemory& m = list_.memory[i];
    Trial& t = trial_[i];
    t.normal = dof_row(p, gap_row(p.at), q);
    t.tangential = dof_row(p, stretch_row(p.at, m.anchor), q);
    t.status = p.suppressed ? ContactStatus::open : m.status;
    t.direction = m.ft < 0.0 ? -1.0 : 1.0;
    t.load = m.fn;
  }
  spring_rows_.assign(springs_.size(), {});
  spring_offset_.resize(springs_.size());
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const Vec2 u = position(springs_[i].row, q) - springs_[i].anchor;
    for (int d = 0; d < 2; ++d) {
      add_point(spring_rows_[i][std::size_t(d)], springs_[i].body, springs_[i].row,
                d == 0 ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0), q);
      spring_offset_[i][std::size_t(d)] = u[d];
    }
  }
}

double Newmark::limit(std::size_t i) const {
  const ContactMemory& m = list_.memory[i];
  return friction_limit(setup_->model().joints[static_cast<std::size_t>(m.joint)], m, trial_[i].load);
}

void Newmark::assemble(double h) {
  rhs_ = base_;
  cholesky_.begin(dofs_);
  for (const ImplicitBlock& b : blocks_) {
    const ImplicitBlock::Matrix A = 2.0 / (h * h) * b.M + b.K;
    cholesky_.add_block(b.first_dof, static_cast<std::int32_t>(A.rows()), A.data());
  }
  const auto spring = [&](const DofRow& row, double k, double at) {
    cholesky_.add_outer(row.dof, row.h, k);
    if (k != 0.0)
      for (std::size_t j = 0; j < row.dof.size(); ++j)
        rhs_[static_cast<std::size_t>(row.dof[j])] -= k * (at + row.known) * row.h[j];
  };
  for (std::size_t i = 0; i < springs_.size(); ++i)
    for (int d = 0; d < 2; ++d)
      spring(spring_rows_[i][std::size_t(d)], springs_[i].k[d], spring_offset_[i][std::size_t(d)]);
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const Trial& t = trial_[i];
    const ContactMemory& m = list_.memory[i];
    spring(t.normal, t.status == ContactStatus::open ? 0.0 : m.kn, m.gap);
    spring(t.tangential, t.status == ContactStatus::stick ? m.kt : 0.0,
           m.status == ContactStatus::open ? 0.0 : m.stretch);
  }
}

void Newmark::evaluate_points() {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    const ContactMemory& m = list_.memory[i];
    t.gap = m.gap + t.normal.change(d_);
    t.moved = t.tangential.change(d_);
    t.fn = t.status == ContactStatus::open ? 0.0 : -m.kn * t.gap;
    const double before = m.status == ContactStatus::open ? 0.0 : m.stretch;
    if (t.status == ContactStatus::stick) {
      t.stretch = before + t.moved;
      t.ft = -m.kt * t.stretch;
    } else if (t.status == ContactStatus::slip) {
      t.ft = t.direction * limit(i);
      t.stretch = -t.ft / m.kt;
    } else {
      t.ft = t.stretch = 0.0;
    }
  }
}

bool Newmark::solve_with_friction(StepReport& report) {
  if (!cholesky_.factorise()) {
    report.status = StepReport::Status::not_definite;
    report.cause = "the implicit matrix is not positive definite";
    return false;
  }
  ++report.factorisations;
  std::vector<std::size_t> slipping;
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (trial_[i].status == ContactStatus::slip) slipping.push_back(i);
  const auto n = static_cast<Eigen::Index>(slipping.size());
  Eigen::VectorXd load(n), found(n);
  for (Eigen::Index k = 0; k < n; ++k) load[k] = trial_[slipping[static_cast<std::size_t>(k)]].load;
  Anderson anderson(10);
  std::vector<double> rhs(rhs_.size());
  for (int pass = 0; pass < 100; ++pass) {
    rhs = rhs_;
    for (Eigen::Index k = 0; k < n; ++k) {
      Trial& t = trial_[slipping[static_cast<std::size_t>(k)]];
      t.load = std::max(load[k], 0.0);
      const double ft = t.direction * limit(slipping[static_cast<std::size_t>(k)]);
      for (std::size_t j = 0; j < t.tangential.dof.size(); ++j)
        rhs[static_cast<std::size_t>(t.tangential.dof[j])] += ft * t.tangential.h[j];
    }
    cholesky_.solve(rhs, d_);
    evaluate_points();
    double change = 0.0, size = 0.0;
    for (Eigen::Index k = 0; k < n; ++k) {
      found[k] = std::max(trial_[slipping[static_cast<std::size_t>(k)]].fn, 0.0);
      change = std::max(change, std::abs(found[k] - load[k]));
      size = std::max(size, std::abs(found[k]));
    }
    if (change <= 1e-8 + 1e-11 * size) return true;
    load = anderson.next(load, found);
  }
  report.status = StepReport::Status::no_friction;
  report.cause = "friction forces did not settle (a wedge whose friction exceeds what its walls can balance?)";
  return false;
}

bool Newmark::may_close(std::size_t i) const {
  // The foot must be on the edge where the step ends; of two edges at a convex corner the one that is nearer takes
  // over.
  const ContactPoint& p = list_.points[i];
  const double foot = p.at.xi * p.at.length + trial_[i].moved;
  if (foot < p.s_low || foot > p.s_high) return false;
  for (const std::int32_t other : p.partner) {
    if (other < 0 || list_.points[static_cast<std::size_t>(other)].suppressed) continue;
    const Trial& t = trial_[static_cast<std::size_t>(other)];
    if (t.status != ContactStatus::open) return false;
    const ContactPoint& po = list_.points[static_cast<std::size_t>(other)];
    const double foot_other = po.at.xi * po.at.length + t.moved;
    if (t.gap < 0.0 && foot_other >= po.s_low && foot_other <= po.s_high &&
        (t.gap > trial_[i].gap || (t.gap == trial_[i].gap && other < static_cast<std::int32_t>(i))))
      return false;
  }
  return true;
}

int Newmark::switch_states(bool only_worst) {
  // How far each point violates its state, as a force; the worst one alone is switched once a cycle was seen.
  int switched = 0;
  double worst = 0.0;
  std::size_t worst_point = 0;
  ContactStatus worst_status = ContactStatus::open;
  double worst_direction = 0.0;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    const ContactMemory& m = list_.memory[i];
    if (list_.points[i].suppressed) continue;
    const JointLaw& law = setup_->model().joints[static_cast<std::size_t>(m.joint)];
    ContactStatus to = t.status;
    double violation = 0.0, direction = t.direction;
    if (t.status == ContactStatus::open) {
      if (t.gap < 0.0 && may_close(i)) {
        // By what its springs would carry if the bodies did not mind: a point that sticks while the joint slides may be
        // lifted by its own tangential spring, and never settle.
        violation = -m.kn * t.gap;
        const double ft = -m.kt * ((m.status == ContactStatus::open ? 0.0 : m.stretch) + t.moved);
        const bool slips = std::abs(ft) > friction_limit(law, m, violation);
        to = slips ? ContactStatus::slip : ContactStatus::stick;
        direction = ft < 0.0 ? -1.0 : 1.0;
      }
    } else if (t.gap > 0.0) {
      to = ContactStatus::open;
      violation = m.kn * t.gap;
    } else if (t.status == ContactStatus::stick) {
      const double cap = friction_limit(law, m, t.fn);
      if (std::abs(t.ft) > cap) {
        to = ContactStatus::slip;
        violation = std::abs(t.ft) - cap;
        direction = t.ft < 0.0 ? -1.0 : 1.0;
      }
    } else {
      const double before = m.status == ContactStatus::open ? 0.0 : m.stretch;
      const double slip = before + t.moved - t.stretch;
      if (t.ft * slip > 0.0) {
        to = ContactStatus::stick;
        violation = m.kt * std::abs(slip);
      }
    }
    if (to == t.status) continue;
    ++switched;
    if (only_worst) {
      if (violation > worst) {
        worst = violation;
        worst_point = i;
        worst_status = to;
        worst_direction = direction;
      }
      continue;
    }
    t.status = to;
    t.direction = direction;
    t.load = std::max(t.fn, 0.0);
  }
  if (only_worst && switched > 0) {
    trial_[worst_point].status = worst_status;
    trial_[worst_point].direction = worst_direction;
    trial_[worst_point].load = std::max(trial_[worst_point].fn, 0.0);
  }
  return switched;
}

bool Newmark::iterate(double h, StepReport& report) {
  std::set<std::vector<std::int8_t>> seen;
  bool only_worst = false;
  // After a cycle points switch one at a time, which takes more, cheaper-to-trust passes.
  for (int most = control_.max_passes; report.passes < most;) {
    ++report.passes;
    assemble(h);
    if (!solve_with_friction(report)) return false;
    std::vector<std::int8_t> states;
    for (const Trial& t : trial_)
      states.push_back(static_cast<std::int8_t>(static_cast<int>(t.status) * (t.direction < 0.0 ? -1 : 1)));
    if (!seen.insert(states).second && !only_worst) {
      only_worst = true;
      most = 3 * control_.max_passes;
    }
    if (switch_states(only_worst) == 0) return true;
  }
  report.status = StepReport::Status::no_states;
  report.cause = fmt::format("contact states did not settle in {} passes", report.passes);
  return false;
}

StepReport Newmark::step(State& state, Tick ticks_of_step) {
  StepReport report;
  const double h = seconds(ticks_of_step);
  linearise(state, h);
  if (!iterate(h, report)) return report;

  // Retract every body, then look at how far its outline went.
  q_new_ = state.q;
  v_new_ = state.v;
  std::vector<double> rate(d_.size());
  for (std::size_t i = 0; i < d_.size(); ++i) rate[i] = 2.0 / h * d_[i] - rate_[i];
  for (std::size_t i = 0; i < setup_->bodies().size(); ++i) {
    const Body& b = setup_->bodies()[i];
    if (b.driven) continue;
    const auto p = static_cast<std::size_t>(b.pool);
    const auto first = static_cast<std::size_t>(first_dof_[i]),
               n = static_cast<std::size_t>(setup_->pool_of(b).dofs(b.index));
    setup_->pool_of(b).retract(b.index, std::span<const double>(d_).subspan(first, n),
                               std::span<const double>(rate).subspan(first, n),
                               setup_->part(std::span<double>(q_new_), p), setup_->part(std::span<double>(v_new_), p));
  }
  setup_->prescribe(seconds(state.time + ticks_of_step), q_new_, v_new_);
  double farthest = 0.0;
  const Outlines& o = setup_->outlines();
  for (std::size_t k = 0; k < o.nodes.size(); ++k) {
    const double u = (position(o.nodes[k], q_new_) - position(o.nodes[k], state.q)).norm();
    if (!(u <= farthest)) {
      farthest = u;
      report.body = o.node_body[k];
    }
  }
  if (!(farthest <= control_.max_displacement)) {
    report.status = std::isfinite(farthest) ? StepReport::Status::too_far : StepReport::Status::non_finite;
    report.suggested = std::isfinite(farthest) ? 0.9 * control_.max_displacement / farthest : 0.0;
    report.cause = std::isfinite(farthest) ? fmt::format("a point would move {:.3g} m in one step, {:.3g} m is allowed",
                                                         farthest, control_.max_displacement)
                                           : "a displacement is not finite";
    return report;
  }
  report.body = -1;
  accept(state, ticks_of_step);
  return report;
}

void Newmark::book_linear(Ledger& ledger, double& spring_after, double& elastic_after, double& support_after,
                          double& kinetic_after, double h) {
  const auto dot = [](const auto& a, const auto& b) { return a.dot(b); };
  for (const ImplicitBlock& b : blocks_) {
    const Eigen::Map<const Eigen::VectorXd> d(d_.data() + b.first_dof, b.force.size());
    const double damping = 0.5 * dot(d, b.K * d);
    ledger.book(Column::newmark_damping, damping);
    elastic_after += -dot(b.force, d) + damping;
    const Eigen::VectorXd rate = 2.0 / h * d - b.rate;
    kinetic_after += 0.5 * dot(rate, b.M * rate);
  }
  for (std::size_t i = 0; i < springs_.size(); ++i)
    for (int d = 0; d < 2; ++d) {
      const double k = springs_[i].k[d], u = spring_rows_[i][std::size_t(d)].change(d_),
                   at = spring_offset_[i][std::size_t(d)] + u;
      ledger.book(Column::newmark_damping, 0.5 * k * u * u);
      support_after += 0.5 * k * at * at;
    }
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const Trial& t = trial_[i];
    const ContactMemory& m = list_.memory[i];
    ledger.book(Column::prescribed_motion, -(t.fn * t.normal.known + t.ft * t.tangential.known));
    // Normal: -(f dg + dU), split by what happened.
    const double g0 = m.gap, g1 = t.gap, dg = g1 - g0;
    const bool counted =
        !list_.points[i].suppressed && !list_.points[i].beyond;  // its energy, at the start of the step
    if (t.fn > 0.0) {
      if (counted && g0 < 0.0)
        ledger.book(Column::newmark_damping, 0.5 * m.kn * dg * dg);
      else
        ledger.book(Column::contact_closing, 0.5 * m.kn * g1 * g1 - m.kn * g1 * g0);
      spring_after += 0.5 * m.kn * g1 * g1;
    } else if (counted && g0 < 0.0) {
      ledger.book(Column::contact_closing, 0.5 * m.kn * g0 * g0);
    }
    // Tangential.
    const double e0 = m.status == ContactStatus::open ? 0.0 : m.stretch, e1 = t.stretch;
    if (t.status == ContactStatus::open) {
      ledger.book(Column::springs_dropped, 0.5 * m.kt * e0 * e0);
      continue;
    }
    ledger.book(Column::newmark_damping, 0.5 * m.kt * (e1 - e0) * (e1 - e0));
    if (t.status == ContactStatus::slip) ledger.book(Column::friction, -t.ft * (e0 + t.moved - e1));
    spring_after += 0.5 * m.kt * e1 * e1;
  }
}

void Newmark::accept(State& state, Tick ticks_of_step) {
  const double h = seconds(ticks_of_step);
  Ledger& ledger = state.ledger;
  double work = 0.0;
  for (std::size_t i = 0; i < setup_->bodies().size(); ++i) {  // gravity on the displacement that the solve knew
    const Body& b = setup_->bodies()[i];
    if (b.driven) continue;
    for (std::int32_t k = b.first_node; k < b.first_node + b.nodes; ++k) {
      const auto n = 2 * static_cast<std::size_t>(k);
      if (gravity_[n] == 0.0 && gravity_[n + 1] == 0.0) continue;
      DofRow row;
      add_point(row, static_cast<std::int32_t>(i), Row{{k, k, k}, {1.0, 0.0, 0.0}}, {gravity_[n], gravity_[n + 1]},
                state.q);
      work += row.change(d_);
    }
  }
  ledger.book(Column::gravity, work);
  double springs = 0.0, elastic = ledger[Column::elastic], supports = 0.0, kinetic = 0.0;
  book_linear(ledger, springs, elastic, supports, kinetic, h);

  state.q.swap(q_new_);
  state.v.swap(v_new_);
  state.time += ticks_of_step;
  ++state.step;
  state.last_step = ticks_of_step;

  // Memory: a stick keeps its anchor in the material, a slip has its spring at the limit on the new geometry.
  const Outlines& o = setup_->outlines();
  std::vector<double> linear(trial_.size(), 0.0);
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const Trial& t = trial_[i];
    ContactMemory& m = list_.memory[i];
    const ContactPoint& p = list_.points[i];
    linear[i] = 0.5 * m.kn * (t.fn > 0.0 ? t.gap * t.gap : 0.0) +
                (t.status == ContactStatus::open ? 0.0 : 0.5 * m.kt * t.stretch * t.stretch);
    if (t.status == ContactStatus::slip) {
      const double before = m.status == ContactStatus::open ? 0.0 : m.stretch;
      m.slip += std::abs(before + t.moved - t.stretch);
      if (setup_->model().joints[static_cast<std::size_t>(m.joint)].cohesion > 0.0) m.failed = 1;
      const ContactGeometry g = contact_geometry(position(o.nodes[static_cast<std::size_t>(p.node[0])], state.q),
                                                 position(o.nodes[static_cast<std::size_t>(p.node[1])], state.q),
                                                 position(o.nodes[static_cast<std::size_t>(p.node[2])], state.q));
      m.anchor = g.xi - t.stretch / g.length;
    }
    m.status = t.status;
    m.fn = t.fn;
    m.fd = m.fdt = 0.0;
    m.ft = t.ft;
  }
  std::swap(list_, before_);
  finder_.find(state.q, before_, false, list_);
  for (std::size_t b = 0; b < list_.memory.size(); ++b) {
    const ContactPoint& p = list_.points[b];
    ContactMemory m = list_.memory[b];
    const double now = normal_energy(p, m) + tangential_energy(m);
    if (p.from < 0) {
      if (now != 0.0) ledger.book(Column::contact_edges, now);
      continue;
    }
    const auto a = static_cast<std::size_t>(p.from);
    m.kn = before_.memory[a].kn;
    m.kt = before_.memory[a].kt;
    const double with_old_share = normal_energy(p, m) + tangential_energy(m);
    ledger.book(Column::update_contact, with_old_share - linear[a]);
    ledger.book(Column::contact_share, now - with_old_share);
    linear[a] = 0.0;
  }
  for (const double left : linear) ledger.book(Column::springs_dropped, left);  // of contacts that ended
  ledger.book(Column::contact_share, finder_.adopt_kinds(list_));
  state.contacts = list_.memory;
  ledger.set(Column::contact_springs, contact_energy(list_));

  double elastic_now = 0.0, kinetic_now = 0.0, supports_now = 0.0;
  q_new_.assign(state.q.size(), 0.0);  // scratch for forces that only their energy is wanted of
  for (std::size_t p = 0; p < setup_->pools(); ++p) {
    const auto q = setup_->part(std::span<const double>(state.q), p);
    elastic_now += setup_->pool(p).internal_force(q, setup_->part(std::span<double>(q_new_), p));
    kinetic_now +=
        setup_->pool(p).kinetic_energy(q, setup_->part(std::span<const double>(state.v), p), setup_->counted(p));
  }
  for (const PointSpring& s : springs_) supports_now += spring_energy(s, state.q);
  ledger.set(Column::elastic, elastic_now);
  ledger.book(Column::update_elastic, elastic_now - elastic);
  ledger.set(Column::kinetic, kinetic_now);
  ledger.book(Column::update_kinetic, kinetic_now - kinetic);
  if (!springs_.empty()) {
    ledger.set(Column::support_springs, supports_now);
    ledger.book(Column::update_contact, supports_now - supports);
  }
  if (rest_) {
    ledger.book(Column::rest_damping, kinetic_now);
    ledger.set(Column::kinetic, 0.0);
    std::fill(state.v.begin(), state.v.end(), 0.0);
    setup_->prescribe(seconds(state.time), state.q, state.v);
  }
}

}  // namespace scree::coupling
