#include "coupling/stages/observer.h"

#include <algorithm>
#include <limits>

#include "coupling/contact/table/contact_point.h"

namespace scree::coupling {
namespace {

void put(const Vec2& x, std::size_t at, std::vector<double>& out) {
  out[2 * at] = x.x();
  out[2 * at + 1] = x.y();
}

}  // namespace

Observer::Observer(const Setup& setup, const State& state, std::uint32_t mesh_id, Contacts contacts)
    : setup_(&setup), contacts_(contacts), bolts_(setup, state) {
  offsets_.assign(1, 0);
  std::vector<std::vector<const Body*>> of_pool(setup.pools());
  for (const Body& b : setup.bodies()) of_pool[static_cast<std::size_t>(b.pool)].push_back(&b);
  for (std::size_t p = 0; p < setup.pools(); ++p) {
    MeshPart part;
    setup.pool(p).topology(part);
    pool_cells_.push_back(static_cast<std::int32_t>(offsets_.size()) - 1);
    hide_absent(of_pool[p], part);
    const auto first_point = static_cast<std::int32_t>(points_.size()), first_entry = offsets_.back();
    for (std::size_t i = 0; i < part.points.size(); ++i) {
      points_.push_back(setup.global(*of_pool[p].front(), part.points[i]));
      origin_.insert(origin_.end(), {part.origin[i].x(), part.origin[i].y()});
    }
    for (std::int32_t c : part.connectivity) connectivity_.push_back(first_point + c);
    for (std::size_t c = 1; c < part.offsets.size(); ++c) offsets_.push_back(first_entry + part.offsets[c]);
    cell_explicit_.insert(cell_explicit_.end(), part.explicit_half.begin(), part.explicit_half.end());
    for (std::int32_t b : part.body) {
      const BlockId block = of_pool[p][static_cast<std::size_t>(b)]->block;
      cell_block_.push_back(block.value);
      cell_material_.push_back(setup.model().blocks[block.index()].material.value);
      cell_method_.push_back(static_cast<std::int32_t>(p));
    }
    view_.methods.emplace_back(setup.pool(p).method());
  }
  position_.resize(2 * points_.size());
  velocity_.resize(2 * points_.size());
  stress_.resize(3 * cell_block_.size());
  for (const Monitor& m : setup.model().monitors) {
    const Body& b = setup.body(m.block);
    const ReferenceShape& shape = state.bodies[m.block.index()].shape;
    const AffineMotion map = affine_fit(shape.origin, shape.outline);
    monitors_.push_back(setup.global(b, setup.pool_of(b).row_at(b.index, map.c + map.F * m.point)));
  }
  recovers_.resize(setup.pools());
  recovered_.resize(setup.pools());
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    const auto p = static_cast<std::size_t>(setup.body(setup.model().monitors[i].block).pool);
    const std::int32_t first = setup.pool_first(p);
    monitor_pool_.push_back(p);
    recovers_[p].resize(static_cast<std::size_t>(setup.pool_first(p + 1) - first), 0);
    recovered_[p].resize(3 * recovers_[p].size());
    for (const std::int32_t node : monitors_[i].node) recovers_[p][static_cast<std::size_t>(node - first)] = 1;
  }
  monitor_stress_.resize(3 * monitors_.size());
  for (auto* v : {&monitor_position_, &monitor_displacement_, &monitor_velocity_}) v->resize(2 * monitors_.size());
  view_.id = mesh_id;
  view_.offsets = offsets_;
  view_.connectivity = connectivity_;
  view_.cell_block = cell_block_;
  view_.cell_material = cell_material_;
  view_.cell_method = cell_method_;
  view_.cell_explicit = cell_explicit_;
  view_.origin = origin_;
}

void Observer::hide_absent(const std::vector<const Body*>& bodies, MeshPart& part) {
  part.explicit_half.resize(part.body.size(), 0);
  std::vector<std::int32_t>& shown = shown_.emplace_back();
  const bool hides = std::any_of(bodies.begin(), bodies.end(), [](const Body* b) { return b->absent; });
  hides_.push_back(hides ? 1 : 0);
  if (!hides) return;
  all_stress_.resize(std::max(all_stress_.size(), 3 * part.body.size()));
  MeshPart out;
  out.offsets.assign(1, 0);
  std::vector<std::int32_t> number(part.points.size(), -1);
  for (std::size_t c = 0; c < part.body.size(); ++c) {
    if (bodies[static_cast<std::size_t>(part.body[c])]->absent) continue;
    for (std::int32_t k = part.offsets[c]; k < part.offsets[c + 1]; ++k) {
      const auto point = static_cast<std::size_t>(part.connectivity[static_cast<std::size_t>(k)]);
      if (number[point] < 0) {
        number[point] = static_cast<std::int32_t>(out.points.size());
        out.points.push_back(part.points[point]);
        out.origin.push_back(part.origin[point]);
      }
      out.connectivity.push_back(number[point]);
    }
    out.offsets.push_back(static_cast<std::int32_t>(out.connectivity.size()));
    out.body.push_back(part.body[c]);
    out.explicit_half.push_back(part.explicit_half[c]);
    shown.push_back(static_cast<std::int32_t>(c));
  }
  part = std::move(out);
}

void Observer::find_stress(std::size_t p, std::span<const double> q) {
  const std::span<double> stress = std::span<double>(stress_).subspan(3 * static_cast<std::size_t>(pool_cells_[p]));
  if (all_shown(p)) {
    setup_->pool(p).stress(q, stress);
    return;
  }
  setup_->pool(p).stress(q, all_stress_);
  for (std::size_t c = 0; c < shown_[p].size(); ++c)
    std::copy_n(all_stress_.begin() + 3 * static_cast<std::ptrdiff_t>(shown_[p][c]), 3,
                stress.begin() + 3 * static_cast<std::ptrdiff_t>(c));
}

FrameView Observer::frame(const State& state, const RunStats& stats, bool last) {
  const std::span<const double> q(state.q), v(state.v);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    put(scree::coupling::position(points_[i], q), i, position_);
    put(scree::coupling::position(points_[i], v), i, velocity_);
  }
  for (std::size_t p = 0; p < setup_->pools(); ++p) find_stress(p, setup_->part(q, p));
  FrameView f;
  f.time = seconds(state.time);
  f.tick = state.time;
  f.step = state.step;
  f.stage = state.stage;
  f.position = position_;
  f.velocity = velocity_;
  f.stress = stress_;
  f.mesh = &view_;
  f.state = &state;
  f.stats = &stats;
  f.bolts = bolts_.view(state);
  if (contacts_due(last)) {
    const auto begin = std::chrono::steady_clock::now();
    see_contacts(state);
    f.contacts = &contact_view_;
    const auto end = std::chrono::steady_clock::now();
    contacts_at_ = end + kShare * (end - begin);
  }
  return f;
}

bool Observer::contacts_due(bool last) const {
  if (contacts_ != Contacts::now_and_then) return contacts_ == Contacts::all;
  return last || std::chrono::steady_clock::now() >= contacts_at_;
}

void Observer::see_contacts(const State& state) {
  const Outlines& o = setup_->outlines();
  const auto at = [&](OutlineNode node) { return scree::coupling::position(o.nodes[node], state.q); };
  contact_position_.resize(2 * state.contacts.size());
  contact_normal_.resize(2 * state.contacts.size());
  for (std::size_t i = 0; i < state.contacts.size(); ++i) {
    const ContactMemory& m = state.contacts[i];
    const ContactKey& k = m.key;
    const Outlines::Edge& own = o.edges[setup_->edge_of(k.block_p, k.ring_p, k.vertex)];
    const Outlines::Edge& edge = o.edges[setup_->edge_of(k.block_e, k.ring_e, k.edge)];
    const Vec2 corner = at(o.vertices[own.first_vertex() + k.part].node);
    const Outlines::Segment& s = o.segments[edge.first_segment + m.segment];
    put(corner, i, contact_position_);
    put(contact_geometry(corner, at(s.a), at(s.b)).n, i, contact_normal_);
  }
  contact_view_ = {contact_position_, contact_normal_, state.contacts.memory};
}

void Observer::recover_stress(const State& state) {
  for (std::size_t p = 0; p < recovered_.size(); ++p)
    if (!recovered_[p].empty())
      setup_->pool(p).recovered_stress(setup_->part(std::span<const double>(state.q), p), recovers_[p], recovered_[p]);
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    const std::size_t p = monitor_pool_[i];
    for (std::size_t c = 0; c < 3; ++c) {
      double s = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = static_cast<std::size_t>(monitors_[i].node[k] - setup_->pool_first(p));
        s += monitors_[i].w[k] * recovered_[p][3 * node + c];
      }
      monitor_stress_[3 * i + c] = s;
    }
  }
}

HistoryView Observer::history(const State& state, const RunStats& stats) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    if (setup_->body(setup_->model().monitors[i].block).absent) {  // the block is absent
      for (auto* values : {&monitor_position_, &monitor_displacement_, &monitor_velocity_})
        put(Vec2(kNone, kNone), i, *values);
      continue;
    }
    const Vec2 x = scree::coupling::position(monitors_[i], state.q);
    put(x, i, monitor_position_);
    put(x - setup_->model().monitors[i].point, i, monitor_displacement_);
    put(scree::coupling::position(monitors_[i], state.v), i, monitor_velocity_);
  }
  recover_stress(state);
  for (std::size_t i = 0; i < monitors_.size(); ++i)
    if (setup_->body(setup_->model().monitors[i].block).absent)
      std::fill_n(monitor_stress_.begin() + 3 * static_cast<std::ptrdiff_t>(i), 3, kNone);
  HistoryView h;
  h.time = seconds(state.time);
  h.tick = state.time;
  h.position = monitor_position_;
  h.displacement = monitor_displacement_;
  h.velocity = monitor_velocity_;
  h.stress = monitor_stress_;
  h.ledger = &state.ledger;
  h.stats = &stats;
  h.bolts = bolts_.view(state);
  return h;
}

}  // namespace scree::coupling
