#include "coupling/integrate/point_springs.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "model/edge_selection.h"

namespace scree::coupling {
namespace {

const std::array<double, 2> kGauss{0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};

/// Force per area and displacement of an edge support on springs [Pa/m].
double bedding_of(const Model& model, const EdgeSupport& s) {
  if (s.bedding) return *s.bedding;
  return 10.0 * model.elasticity_of(s.span.block).p_modulus() /
         std::sqrt(moments(model.blocks[s.span.block.index()].polygon).area);
}

/// Axes of the springs, and 1 along those that are held.
void axes_of(const Mat2& held, Mat2& axes, Vec2& along) {
  axes = Mat2::Identity();
  along = {1.0, 1.0};
  if (held.determinant() > 0.5) return;
  const Vec2 a = (held.col(0).norm() > held.col(1).norm() ? held.col(0) : held.col(1)).normalized();
  axes.col(0) = a;
  axes.col(1) << -a.y(), a.x();
  along = {1.0, 0.0};
}

/// Position of a point of a span in the initial model.
Vec2 place_of(const Model& model, const EdgeSpan& span, double s) {
  const auto [from, to] = ends_of(model.blocks[span.block.index()].polygon, span.edge);
  return from + (span.s0 + s * (span.s1 - span.s0)) * (to - from);
}

/// Row of a material point, mapped from the initial model to the present reference shape.
Row row_of(const Setup& setup, const Body& b, const ReferenceShape& shape, const Vec2& at) {
  const AffineMotion map = affine_fit(shape.origin, shape.outline);
  return setup.global(b, setup.pool_of(b).row_at(b.index, map.c + map.F * at));
}

/// Shift of the anchor of a point of a support by a transfer.   @param number  index among those of the block
Vec2 shift_at(const BodyRecord& record, std::size_t number, double s) {
  if (record.edge_shift.size() < 4 * number + 4) return {0.0, 0.0};
  const double* x = &record.edge_shift[4 * number];
  return (1.0 - s) * Vec2(x[0], x[1]) + s * Vec2(x[2], x[3]);
}

void add_edge_springs(const Setup& setup, const State& state, std::vector<PointSpring>& springs) {
  const Model& model = setup.model();
  std::vector<std::size_t> count(model.blocks.size(), 0);
  for (const EdgeSupport& support : model.edge_supports) {
    const auto index = support.span.block.index();
    const std::size_t number = count[index]++;
    const Body& b = setup.bodies()[index];
    if (b.driven || setup.pool_of(b).holds_edges(b.index)) continue;
    const double k = 0.5 * bedding_of(model, support) * length_of(model, support.span);
    for (const double s : kGauss) {
      PointSpring spring;
      spring.body = BodyIndex::of(index);
      const Vec2 at = place_of(model, support.span, s);
      spring.row = row_of(setup, b, state.bodies[index].shape, at);
      if (!setup.applies({&spring.row, 1})) continue;
      spring.anchor = at + shift_at(state.bodies[index], number, s);
      axes_of(support.held, spring.axes, spring.k);
      spring.k *= k;
      springs.push_back(spring);
    }
  }
}

}  // namespace

std::vector<PointSpring> point_springs(const Setup& setup, const State& state) {
  const Model& model = setup.model();
  std::vector<PointSpring> springs;
  for (std::size_t i = 0; i < model.point_supports.size(); ++i) {
    const PointSupport& support = model.point_supports[i];
    const auto index = support.block.index();
    const Body& b = setup.bodies()[index];
    if (b.driven) continue;  // held as a whole
    const Elasticity law = model.elasticity_of(support.block);
    const double k = support.stiffness ? *support.stiffness : 10.0 * law.p_modulus();
    PointSpring s;
    s.body = BodyIndex::of(index);
    s.row = row_of(setup, b, state.bodies[index].shape, support.point);
    if (!setup.applies({&s.row, 1})) continue;
    s.support = static_cast<std::int32_t>(i);
    s.anchor = support.point;
    if (!state.anchors.empty()) s.anchor += Vec2(state.anchors[2 * i], state.anchors[2 * i + 1]);
    s.k = {support.fix_x ? k : 0.0, support.fix_y ? k : 0.0};
    springs.push_back(s);
  }
  if (!model.edge_supports.empty()) add_edge_springs(setup, state, springs);
  return springs;
}

void keep_elongations(const std::vector<PointSpring>& before, std::span<const double> q_before, const Setup& to,
                      const std::vector<char>& changed, State& state) {
  const std::vector<PointSpring> now = point_springs(to, state);
  for (const PointSpring& is : now) {
    if (is.support < 0) break;  // edges come after all points, see keep_edges()
    if (changed[is.body.index()] == 0) continue;
    const auto was = std::find_if(before.begin(), before.end(),
                                  [&](const PointSpring& spring) { return spring.support == is.support; });
    if (was == before.end()) continue;  // its block is new
    state.anchors.resize(2 * to.model().point_supports.size(), 0.0);
    const Vec2 shift = position(is.row, state.q) - is.anchor - position(was->row, q_before) + was->anchor;
    const auto at = 2 * static_cast<std::size_t>(is.support);
    state.anchors[at] += shift.x();
    state.anchors[at + 1] += shift.y();
  }
}

void keep_edges(const Setup& from, std::span<const double> q_before, const std::vector<BodyRecord>& bodies_before,
                Setup& to, const std::vector<char>& changed, State& state) {
  const Model& model = to.model();
  std::vector<std::size_t> count(model.blocks.size(), 0);
  for (const EdgeSupport& support : model.edge_supports) {
    const auto index = support.span.block.index();
    const std::size_t number = count[index]++;
    const Body &was = from.bodies()[index], &is = to.bodies()[index];
    if (changed[index] == 0 || is.driven || was.driven) continue;
    const bool held_before = from.pool_of(was).holds_edges(was.index), holds = to.pool_of(is).holds_edges(is.index);
    std::vector<double>& shift = state.bodies[index].edge_shift;
    if (number == 0) shift = bodies_before[index].edge_shift;
    if (!(held_before && holds)) {
      std::array<Vec2, 2> moved;  // at the Gauss points
      const double bedding = bedding_of(model, support);
      for (std::size_t g = 0; g < 2; ++g) {
        const Vec2 at = place_of(model, support.span, kGauss[g]);
        const Vec2 now = position(row_of(to, is, state.bodies[index].shape, at), state.q) - at;
        Vec2 traction(0.0, 0.0);
        if (held_before) {
          const auto p = static_cast<std::size_t>(was.pool);
          traction = from.pool_of(was).edge_reaction(was.index, number, kGauss[g], from.part(q_before, p));
        } else {
          const Vec2 then = position(row_of(from, was, bodies_before[index].shape, at), q_before) - at -
                            shift_at(bodies_before[index], number, kGauss[g]);
          traction = -bedding * (support.held * then);
        }
        moved[g] = support.held * now;
        if (!holds || support.bedding) moved[g] += traction / bedding;
      }
      const Vec2 slope = (moved[1] - moved[0]) / (kGauss[1] - kGauss[0]);
      const Vec2 first = moved[0] - kGauss[0] * slope, last = first + slope;
      shift.resize(std::max(shift.size(), 4 * number + 4), 0.0);
      for (std::size_t d = 0; d < 2; ++d) {
        shift[4 * number + d] = first[static_cast<Eigen::Index>(d)];
        shift[4 * number + 2 + d] = last[static_cast<Eigen::Index>(d)];
      }
    }
    to.shift_edges(is, shift);
  }
}

}  // namespace scree::coupling
