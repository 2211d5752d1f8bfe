#include "coupling/transfer/transfer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "coupling/bodies/partition.h"
#include "coupling/bolts/bolt_rows.h"
#include "coupling/integrate/point_springs.h"
#include "coupling/transfer/construction.h"
#include "coupling/transfer/contact_forces.h"
#include "coupling/transfer/field_transfer.h"
#include "coupling/transfer/transfer_mode.h"
#include "model/elasticity.h"

namespace scree::coupling {
namespace {

BodyTotals totals_of(const Setup& setup, std::size_t body, const State& state) {
  const Body& b = setup.bodies()[body];
  const auto p = static_cast<std::size_t>(b.pool);
  return setup.pool_of(b).totals(b.index, setup.part(std::span<const double>(state.q), p),
                                 setup.part(std::span<const double>(state.v), p));
}

/// Errors against natural scales: momentum m sqrt(2T/m), angular momentum about the centre sqrt(2 T tr S).
void measure(TransferRow& row, double inertia) {
  const BodyTotals &a = row.before, &b = row.after;
  const auto relative = [](double error, double scale) { return scale > 0.0 ? std::abs(error) / scale : 0.0; };
  row.mass_error = relative(b.mass - a.mass, a.mass);
  row.momentum_error = relative((b.momentum - a.momentum).norm(), std::sqrt(2.0 * a.mass * a.kinetic));
  const double spin_a = a.angular_momentum - cross(a.centre, a.momentum),
               spin_b = b.angular_momentum - cross(b.centre, b.momentum);
  row.angular_error = relative(spin_b - spin_a, std::sqrt(2.0 * inertia * a.kinetic));
  row.energy_error = relative(
      b.kinetic + b.elastic + row.reservoir_kinetic + row.reservoir_elastic + row.booked - a.kinetic - a.elastic,
      a.kinetic + a.elastic);
}

/// Restores a body that has been affine since its release: its former unknowns, moved with the affine motion.
void bring_back(const Remainder& rest, const AffineMotion& motion, std::span<double> q, std::span<double> v) {
  const Mat2 R = polar_rotation(motion.F);
  for (std::size_t i = 0; i < rest.position.size(); i += 2) {
    const Vec2 y(rest.position[i], rest.position[i + 1]), w(rest.velocity[i], rest.velocity[i + 1]);
    const Vec2 x = motion.c + motion.F * y, u = motion.vc + motion.Fdot * y + R * w;
    for (std::size_t d = 0; d < 2; ++d) {
      q[i + d] = x[static_cast<Eigen::Index>(d)];
      v[i + d] = u[static_cast<Eigen::Index>(d)];
    }
  }
}

/// Elastic energy of the affine part of a release [J].
double elastic_of(const Elasticity& law, const Release& release) {
  return release.shape.area * elastic_response(law, release.motion.F, release.initial).energy;
}

}  // namespace

std::vector<BodyRequest> body_requests(const Model& model, const Stage& stage, std::span<const char> explicit_side,
                                       std::span<const char> other_method) {
  Formulation form;
  form.kinematics = stage.kinematics;
  std::vector<char> first;
  if (stage.integrator == Integrator::partitioned && explicit_side.empty())
    explicit_side = first = first_sides(model, stage.partition, stage.construction);
  form.cover_size = stage.cover_size;
  form.cracks = stage.cracks;
  std::vector<BodyRequest> out(model.blocks.size(), BodyRequest{stage.method, form});
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool is_explicit =
        !stage.has_implicit_steps() || (stage.integrator == Integrator::partitioned && explicit_side[i] != 0);
    const bool divided = stage.integrator == Integrator::partitioned && explicit_side[i] == kDivided;
    out[i].form.mass = stage.mass.value_or(is_explicit && !divided ? MassKind::affine_exact : MassKind::consistent);
    if (divided) out[i].form.division.region = stage.partition.explicit_region;
    if (model.blocks[i].cover_size > 0.0) out[i].form.cover_size = model.blocks[i].cover_size;
  }
  for (const MethodRule& rule : stage.rules)
    for (BlockId b : rule.blocks) {
      BodyRequest& w = out[b.index()];
      w.method = rule.method;
      w.form.onefold = rule.onefold;
      w.form.model_triangle = rule.model_triangle;
      if (rule.cover_size > 0.0) w.form.cover_size = rule.cover_size;
    }
  for (std::size_t i = 0; i < other_method.size(); ++i)
    if (other_method[i] != 0) out[i].method = out[i].method == "nmm" ? "dda" : "nmm";
  for (BodyRequest& w : out)
    if (w.method != "nmm") w.form = Formulation{.rotation = stage.rotation};
  for (const BlockId b : stage.construction.absent) out[b.index()].absent = true;
  return out;
}

std::vector<BodyRecord> initial_records(const Model& model, const std::vector<BodyRequest>& request) {
  std::vector<BodyRecord> records;
  records.reserve(model.blocks.size());
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const BlockId block{static_cast<std::int32_t>(i)};
    records.push_back({block, request[i].method, reference_shape(model, block), request[i].form});
    records.back().absent = request[i].absent;
  }
  return records;
}

namespace {

double edge_energy_of(const Setup& setup, std::size_t i, std::span<const double> q) {
  const Body& b = setup.bodies()[i];
  return setup.pool_of(b).edge_energy(b.index, setup.part(q, static_cast<std::size_t>(b.pool)));
}

/// One hand-over: the data of each body before it, and the body after it.
class Change {
 public:
  Change(const Model& model, const Methods& methods, const Setup& from, const Stage& stage, State& state)
      : model_(model), methods_(methods), from_(from), stage_(stage), state_(state), bodies_(state.bodies.size()) {}

  /// Measures the bodies that change, and puts their new records into the state.
  void release(const std::vector<BodyRequest>& request);
  /// Flags of bodies whose contacts are measured anew.
  [[nodiscard]] std::vector<char> changed() const;
  [[nodiscard]] std::vector<BlockId> blocks_of(bool gone) const;
  /// Sets the unknowns of the new bodies.
  void place(const Setup& to);
  /// Books each body's energies after the change, measured by its new method, the reservoir and the cross terms.
  void book(const Setup& to);

  std::vector<TransferRow> rows;

 private:
  // reformed: the same unknowns with other operators; halved: covers doubled by a division are added or removed;
  // remeshed: the same fields on other covers; back: from the reservoir, on its former covers or, remade, on others;
  // gone: removed, with its energies; come: present from now on.
  enum class Kind { stays, reformed, halved, remeshed, affine, back, gone, come };
  struct One {
    Kind kind = Kind::stays;
    Release release;
    BodyTotals before;
    double edges = 0.0;       // part of before.elastic in its edge supports [J]
    Remainder back;           // of Kind::back
    bool remade = false;      // of Kind::back: on other covers than those it was left on
    std::ptrdiff_t row = -1;  // into rows
  };
  void release_one(std::size_t i, const BodyRequest& request);
  /// False where a block has a mesh with its present mass and a onefold cover with the mass of `form`, or the other way
  /// round: which of the two a narrow block has depends on the step that its mass allows.
  [[nodiscard]] bool keeps_fields(std::size_t i, const Formulation& form) const;
  /// Begins the row of a body that changes, and measures `before`.
  TransferRow& begin_row(std::size_t i, const BodyRequest& request);
  /// Takes out the remainder from which the block can return to the requested body; empty: there is none, and the
  /// fields of a remainder that does not fit are discarded.
  /// @param affine  the present body is purely affine: otherwise its own fields would be lost
  [[nodiscard]] std::optional<Remainder> find_remainder(BlockId block, const BodyRequest& request, bool affine);
  /// Sets the nodes of a body that becomes divided, or undivided.
  void join_or_halve(const Setup& to, std::size_t i, std::span<double> q, std::span<double> v) const;
  /// Sets the nodes of a body that returns to its former method with its fields on other covers.
  void remake(const Setup& to, std::size_t i, std::span<double> q, std::span<double> v) const;
  void book_return(const Setup& to, std::size_t i, TransferRow& row);

  const Model& model_;
  const Methods& methods_;
  const Setup& from_;
  const Stage& stage_;
  State& state_;
  std::vector<One> bodies_;
};

void Change::release(const std::vector<BodyRequest>& request) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodyRecord& record = state_.bodies[i];
    if (record.absent != request[i].absent) {
      bodies_[i].kind = request[i].absent ? Kind::gone : Kind::come;
      if (request[i].absent && !from_.bodies()[i].driven) bodies_[i].before = totals_of(from_, i, state_);
      record = {record.block, request[i].method, reference_shape(model_, record.block), request[i].form};
      record.absent = request[i].absent;
      record.placed = !record.absent;
    } else if (record.method != request[i].method || !record.form.same_covers(request[i].form) ||
               !keeps_fields(i, request[i].form)) {
      release_one(i, request[i]);
    } else if (record.form != request[i].form) {
      bodies_[i].kind = record.form.same_mesh(request[i].form) ? Kind::reformed : Kind::halved;
      bodies_[i].before = totals_of(from_, i, state_);
      record.form = request[i].form;
    }
  }
}

bool Change::keeps_fields(std::size_t i, const Formulation& form) const {
  const BodyRecord& record = state_.bodies[i];
  const Body& b = from_.bodies()[i];
  if (b.driven || record.form.mass == form.mass) return true;
  BodyRecord other = record;
  other.form = form;
  const std::unique_ptr<Pool> made = methods_.at(record.method)();
  made->add(model_, other);
  made->finish();
  return has_fields(*made, 0) == has_fields(from_.pool_of(b), b.index);
}

void Change::release_one(std::size_t i, const BodyRequest& request) {
  One& one = bodies_[i];
  BodyRecord& record = state_.bodies[i];
  const Body& b = from_.bodies()[i];
  const auto p = static_cast<std::size_t>(b.pool);
  one.kind = Kind::affine;
  if (b.driven) {
    const bool absent = record.absent, placed = record.placed;
    record = {record.block, request.method, reference_shape(model_, record.block), request.form};  // it never deforms
    record.absent = absent;
    record.placed = placed;
    one.release.shape = record.shape;
    return;
  }
  TransferRow& row = begin_row(i, request);
  if (record.method == request.method && !request.form.onefold && has_fields(from_.pool_of(b), b.index)) {
    one.kind = Kind::remeshed;
    one.release.shape = record.shape;
    (void)find_remainder(record.block, request, false);
    record.form = request.form;
    return;
  }
  one.release = from_.pool_of(b).release(b.index, from_.part(std::span<const double>(state_.q), p),
                                         from_.part(std::span<const double>(state_.v), p));
  if (std::optional<Remainder> rest = find_remainder(record.block, request, one.release.position.empty())) {
    one.kind = Kind::back;
    one.remade = !rest->record.form.same_mesh(request.form);
    one.back = std::move(*rest);
    row.reservoir_kinetic = -one.back.kinetic;
    row.reservoir_elastic = -one.back.elastic;
    record = one.back.record;
    record.form = request.form;
  } else {
    row.booked = limit_release(stage_.transfer, stage_.transfer_cap, one.release) + one.release.elastic_cross;
    row.reservoir_kinetic = one.release.kinetic_rest;
    row.reservoir_elastic = one.release.elastic_rest;
    if (row.reservoir_kinetic != 0.0 || row.reservoir_elastic != 0.0)
      state_.rest.push_back({record.block, row.reservoir_kinetic, row.reservoir_elastic, record,
                             std::move(one.release.position), std::move(one.release.velocity_rest)});
    const bool placed = record.placed;
    record = {record.block, request.method, one.release.shape, request.form};
    record.placed = placed;
    // The new outline fits the first one except for bending, and the in-situ stress is evaluated on it: the change of
    // this stress does work on the strain.
    const Mat2& F = one.release.motion.F;
    const Mat2 U = polar_rotation(F).transpose() * F, strain = 0.5 * (U + U.transpose()) - Mat2::Identity(),
               change = InSituStress(model_, record).mean() - one.release.initial;
    row.booked -= one.release.shape.area * change.cwiseProduct(strain).sum();
  }
}

TransferRow& Change::begin_row(std::size_t i, const BodyRequest& request) {
  One& one = bodies_[i];
  one.before = totals_of(from_, i, state_);
  one.edges = edge_energy_of(from_, i, state_.q);
  one.row = std::ssize(rows);
  TransferRow& row = rows.emplace_back();
  row.time = seconds(state_.time);
  row.block = state_.bodies[i].block;
  row.from = state_.bodies[i].method;
  row.to = request.method;
  row.before = one.before;
  return row;
}

std::optional<Remainder> Change::find_remainder(BlockId block, const BodyRequest& request, bool affine) {
  std::optional<Remainder> found;
  for (std::size_t k = state_.rest.size(); k-- > 0;) {
    Remainder& rest = state_.rest[k];
    if (rest.block != block || rest.position.empty()) continue;
    if (affine && rest.record.method == request.method &&
        (rest.record.form.same_mesh(request.form) ||
         (carries_fields(*methods_.at(request.method)()) && !request.form.onefold))) {
      found = std::move(rest);
      state_.rest.erase(state_.rest.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      rest.record = BodyRecord{block, {}, {}, {}};
      rest.position = rest.velocity = {};
    }
    break;  // only the latest can have fields
  }
  return found;
}

std::vector<char> Change::changed() const {
  std::vector<char> flags;
  for (const One& one : bodies_)
    flags.push_back(one.kind == Kind::affine || one.kind == Kind::back || one.kind == Kind::remeshed ? 1 : 0);
  // Where a division is added or removed, cracks may end in other places: a crack cuts where the covers on its two
  // sides are not joined around its tip, and the border separates such covers too. Outlines stay as they are.
  for (const Crack& c : model_.cracks)
    if (bodies_[c.block.index()].kind == Kind::halved) flags[c.block.index()] = 1;
  return flags;
}

std::vector<BlockId> Change::blocks_of(bool gone) const {
  std::vector<BlockId> out;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].kind == (gone ? Kind::gone : Kind::come)) out.push_back(state_.bodies[i].block);
  return out;
}

void Change::place(const Setup& to) {
  std::vector<double> q(2 * static_cast<std::size_t>(to.nodes()), 0.0), v = q;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body &a = from_.bodies()[i], &b = to.bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool);
    const auto begin = 2 * static_cast<std::ptrdiff_t>(a.first_node), size = 2 * static_cast<std::ptrdiff_t>(a.nodes);
    const auto first = 2 * static_cast<std::ptrdiff_t>(b.first_node),
               size_to = 2 * static_cast<std::ptrdiff_t>(b.nodes);
    const One& one = bodies_[i];
    if (one.kind == Kind::gone || one.kind == Kind::come) {
      AffineMotion still;
      still.c = b.centre;
      to.pool_of(b).place(b.index, still, to.part(std::span<double>(q), p), to.part(std::span<double>(v), p));
    } else if (one.kind == Kind::affine) {
      to.pool_of(b).place(b.index, one.release.motion, to.part(std::span<double>(q), p),
                          to.part(std::span<double>(v), p));
    } else if (one.kind == Kind::halved) {
      join_or_halve(to, i, q, v);
    } else if (one.kind == Kind::remeshed) {
      const auto old = static_cast<std::size_t>(a.pool);
      project_fields(from_.pool_of(a), a.index, from_.part(std::span<const double>(state_.q), old),
                     from_.part(std::span<const double>(state_.v), old), to.pool_of(b), b.index, one.before,
                     to.part(std::span<double>(q), p), to.part(std::span<double>(v), p));
    } else if (one.kind == Kind::back && (one.remade || std::ssize(one.back.position) != size_to)) {
      remake(to, i, q, v);
    } else if (one.kind == Kind::back) {
      const auto at = static_cast<std::size_t>(first);
      bring_back(one.back, one.release.motion, std::span(q).subspan(at), std::span(v).subspan(at));
    } else {
      std::copy_n(state_.q.begin() + begin, size, q.begin() + first);
      std::copy_n(state_.v.begin() + begin, size, v.begin() + first);
    }
  }
  to.prescribe(seconds(state_.time), q, v);
  state_.q = std::move(q);
  state_.v = std::move(v);
  state_.a.clear();
  state_.v_before.clear();
  state_.damping.clear();
  state_.sliding.clear();
}

void Change::join_or_halve(const Setup& to, std::size_t i, std::span<double> q, std::span<double> v) const {
  const Body &a = from_.bodies()[i], &b = to.bodies()[i];
  const Pool &before = from_.pool_of(a), &after = to.pool_of(b);
  const auto p = static_cast<std::size_t>(a.pool), p_to = static_cast<std::size_t>(b.pool);
  // Per node number of the undivided body: mass, and its products with position and velocity.
  const std::span<const std::int32_t> old = before.undivided(a.index), now = after.undivided(b.index);
  const auto number = [](std::span<const std::int32_t> numbers, std::int32_t k) {
    return 2 * static_cast<std::size_t>(numbers.empty() ? k : numbers[static_cast<std::size_t>(k)]);
  };
  std::vector<double> weight(state_.q.size(), 0.0);
  before.body_force(Vec2(1.0, 1.0), from_.part(std::span<double>(weight), p));
  std::vector<double> mass(2 * static_cast<std::size_t>(std::max(a.nodes, b.nodes)), 0.0), x = mass, u = mass;
  for (std::int32_t k = 0; k < a.nodes; ++k)
    for (std::size_t d = 0; d < 2; ++d) {
      const std::size_t at = 2 * static_cast<std::size_t>(a.first_node + k) + d, to_at = number(old, k) + d;
      // Nodes that follow others have no mass.
      const double m = weight[at] > 0.0 ? weight[at] : 1e-200;
      mass[to_at] += m;
      x[to_at] += m * state_.q[at];
      u[to_at] += m * state_.v[at];
    }
  for (std::int32_t k = 0; k < b.nodes; ++k)
    for (std::size_t d = 0; d < 2; ++d) {
      const std::size_t at = number(now, k) + d, to_at = 2 * static_cast<std::size_t>(b.first_node + k) + d;
      q[to_at] = x[at] / mass[at];
      v[to_at] = u[at] / mass[at];
    }
  const auto q_part = to.part(q, p_to), v_part = to.part(v, p_to);
  after.settle(b.index, q_part, v_part);
  // The change of the momenta by other masses at the nodes is compensated by a rigid motion of all nodes.
  keep_momenta(after, b.index, bodies_[i].before, q_part, v_part);
}

void Change::remake(const Setup& to, std::size_t i, std::span<double> q, std::span<double> v) const {
  const One& one = bodies_[i];
  const Body& b = to.bodies()[i];
  const auto p = static_cast<std::size_t>(b.pool);
  const std::unique_ptr<Pool> was = methods_.at(one.back.record.method)();
  was->add(model_, one.back.record);
  was->finish();
  std::vector<double> q_was(one.back.position.size()), v_was(q_was.size());
  bring_back(one.back, one.release.motion, q_was, v_was);
  BodyTotals before = was->totals(0, q_was, v_was);
  before.centre = one.before.centre;
  before.momentum = one.before.momentum;
  before.angular_momentum = one.before.angular_momentum;
  project_fields(*was, 0, q_was, v_was, to.pool_of(b), b.index, before, to.part(q, p), to.part(v, p));
}

/// Splits the body after its return as a release would do, and books the energy of the reservoir and the affine body
/// minus that of the same parts now. The difference is zero if it returns at once.
void Change::book_return(const Setup& to, std::size_t i, TransferRow& row) {
  const Body& b = to.bodies()[i];
  const auto p = static_cast<std::size_t>(b.pool);
  const One& one = bodies_[i];
  const Release now = to.pool_of(b).release(b.index, to.part(std::span<const double>(state_.q), p),
                                            to.part(std::span<const double>(state_.v), p));
  const Elasticity law = model_.elasticity_of(row.block);
  const double kinetic = kinetic_of(one.release.shape, one.release.motion) + one.back.kinetic -
                         kinetic_of(now.shape, now.motion) - now.kinetic_rest;
  const double elastic =
      elastic_of(law, one.release) + one.back.elastic - elastic_of(law, now) - now.elastic_rest - now.elastic_cross;
  row.booked = kinetic + elastic;
}

void Change::book(const Setup& to) {
  Ledger& ledger = state_.ledger;
  double kinetic = ledger[Column::kinetic], elastic = ledger[Column::elastic], reservoir = ledger[Column::reservoir];
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const One& one = bodies_[i];
    if (one.kind == Kind::gone) {
      kinetic -= one.before.kinetic;
      elastic -= one.before.elastic;
      ledger.book(Column::excavated, one.before.kinetic);
      ledger.book(Column::excavated, one.before.elastic);
    }
    if (to.bodies()[i].driven || one.kind == Kind::stays || one.kind == Kind::come) continue;
    const BodyTotals after = totals_of(to, i, state_);
    kinetic += after.kinetic - one.before.kinetic;
    elastic += after.elastic - one.before.elastic;
    if (one.kind == Kind::reformed ||
        one.kind == Kind::halved) {  // another mass, another strain measure: change of energy for the same motion
      ledger.book(Column::transfer, after.kinetic - one.before.kinetic);
      ledger.book(Column::transfer, after.elastic - one.before.elastic);
      continue;
    }
    TransferRow& row = rows[static_cast<std::size_t>(one.row)];
    row.after = after;
    if (one.kind == Kind::back) book_return(to, i, row);
    if (one.kind == Kind::remeshed)  // energy that the new covers cannot represent
      row.booked = (one.before.kinetic - after.kinetic) + (one.before.elastic - after.elastic);
    if (one.kind == Kind::affine || one.kind == Kind::back)  // energy neither in the fields nor in the reservoir
      row.booked += one.edges - edge_energy_of(to, i, state_.q);
    if (!to.pool_of(to.bodies()[i]).strains()) {  // energy of strain and strain rates is left in the reservoir
      const double held = kinetic_of(one.release.shape, one.release.motion);
      row.reservoir_kinetic += held - after.kinetic;
      row.reservoir_elastic += elastic_of(model_.elasticity_of(row.block), one.release);
      state_.rest.push_back({row.block, held - after.kinetic, row.reservoir_elastic, {row.block, {}, {}, {}}, {}, {}});
    }
    measure(row, one.release.shape.second.trace());
    reservoir += row.reservoir_kinetic + row.reservoir_elastic;
    ledger.book(Column::transfer, -row.booked);
  }
  ledger.set(Column::kinetic, kinetic);
  ledger.set(Column::elastic, elastic);
  ledger.set(Column::reservoir, reservoir);
}

}  // namespace

TransferReport transfer_bodies(const Model& model, const Methods& methods, const Setup& from, const Stage& stage,
                               State& state, Clocks clocks) {
  Change change(model, methods, from, stage, state);
  const std::vector<BodyRequest> request = body_requests(model, stage, state.explicit_side, state.rules.other_method);
  std::vector<char> gone(request.size(), 0);
  for (std::size_t i = 0; i < gone.size(); ++i) gone[i] = request[i].absent && !state.bodies[i].absent ? 1 : 0;
  if (std::find(gone.begin(), gone.end(), 1) != gone.end()) {
    end_contacts(from, gone, state);
    end_supports(from, gone, state);
  }
  std::vector<PointSpring> supports = point_springs(from, state);
  std::erase_if(supports, [&](const PointSpring& s) { return gone[s.body.index()] != 0; });
  const std::vector<BoltRows> bolts = acting_bolts(from, state);
  const std::vector<double> q = state.q;
  const std::vector<BodyRecord> bodies = model.edge_supports.empty() ? std::vector<BodyRecord>() : state.bodies;
  change.release(request);
  hand_contacts_over(from, change.changed(), state);
  TransferReport out;
  out.setup = std::make_unique<Setup>(model, methods, state.bodies, slow_bodies(model, stage, state.explicit_side),
                                      std::move(clocks), &from);
  change.place(*out.setup);
  keep_elongations(supports, q, *out.setup, change.changed(), state);
  keep_bolt_forces(bolts, q, *out.setup, state);
  if (!model.edge_supports.empty()) {
    keep_edges(from, q, bodies, *out.setup, change.changed(), state);
    // Springs are added or removed with methods that do not hold their edges themselves.
    double energy = 0.0;
    for (const PointSpring& s : point_springs(*out.setup, state)) energy += spring_energy(s, state.q);
    state.ledger.book(Column::transfer, energy - state.ledger[Column::support_springs]);
    state.ledger.set(Column::support_springs, energy);
  }
  change.book(*out.setup);
  out.rows = std::move(change.rows);
  out.left = change.blocks_of(true);
  out.came = change.blocks_of(false);
  return out;
}

}  // namespace scree::coupling
