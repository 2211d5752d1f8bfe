// Shift of a model to a local origin: bit for bit, because the origin is chosen so that differences are exact.
#include "model/local_origin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::local_origin_test {
namespace {

/// A model with at least one object of every kind; `at` is added to every position.
Model everything(const Vec2& at) {
  const auto p = [&](double x, double y) { return Vec2(at + Vec2(x, y)); };
  Model m;
  m.title = "everything";
  m.materials.push_back({"rock", 2600.0, 1e9, 0.2, InitialStress{Mat2::Identity(), Mat2::Identity(), at.y() + 7.0}});
  m.materials.push_back({"soil", 1900.0, 1e8, 0.3});
  m.joints.emplace_back();
  m.joints[0].friction = 0.5;
  m.default_joint = JointId{0};
  Block block{.name = "block", .polygon = {}, .material = MaterialId{0}, .joint = JointId{0}, .edges = {}};
  block.polygon.outer = {p(0, 0), p(8, 0), p(8, 6), p(0, 6)};
  block.polygon.holes = {{p(1, 1), p(1, 2), p(2, 2), p(2, 1)}, {p(4, 1), p(4, 2), p(5, 2)}};
  m.blocks = {block, block};
  m.blocks[1].polygon = {{p(8, 0), p(9, 0), p(8.5, 1.0 / 3.0)}, {}};
  m.block_supports.push_back({BlockId{1}, MotionId{0}});
  m.point_supports.push_back({BlockId{0}, p(0, 6), true, false, 1e6});
  m.edge_supports.push_back({{BlockId{0}, {0, 3}, 0.25, 0.5}, Mat2::Identity(), 1e7});
  m.monitors.push_back({"crest", BlockId{0}, p(8, 6)});
  m.motions.emplace_back(std::vector{0.0, 1.0}, std::vector{0.0, 2.0}, Vec2(1.0, 0.0));
  m.initial_velocities.push_back({BlockId{0}, Vec2(3.0, 4.0), 5.0});
  m.functions.emplace_back();
  m.functions[0].amplitude = 2.0;
  m.point_loads.push_back({BlockId{0}, p(8, 3), Vec2(1e3, 2e3), FunctionId{0}});
  m.tractions.push_back({{BlockId{0}, {0, 1}, 0.25, 0.75}, Vec2(10.0, 20.0), FunctionId{0}});
  m.body_accelerations.push_back({{BlockId{0}}, Vec2(0.1, 0.2), FunctionId{0}});
  m.viscous_edges.push_back({{BlockId{0}, {0, 2}, 0.125, 0.5}});
  Bolt bolt;
  bolt.head = at + Vec2(0.5, 0.5);
  bolt.toe = at + Vec2(1.5, 0.25);
  bolt.stiffness = 1e6;
  m.bolts.push_back(bolt);
  m.waters.push_back({{p(-3, 2), p(5, 3), p(40, 4)},
                      9810.0,
                      {JointId{0}},
                      {{BlockId{0}, {0, 1}, 0.0, 0.5}},
                      {{StageId{0}, {p(-3, 1), p(40, 2)}}}});
  m.joint_sets.emplace_back();
  m.joint_sets[0].total_length = 12.0;
  m.joint_lines.push_back({p(0, 3), p(4, 4), JointId{0}, JointLine::Kind::arc, 2});
  m.cracks.push_back({p(1, 3), p(2, 4), JointId{0}, BlockId{0}});
  m.cutting = CuttingReport{.crack_length = 1.5, .area = 48.0, .least_area = 0.2, .least_edge = 0.1, .snap = 1e-8};
  return m;
}

/// The numbers of a model in groups: positions and heights, which shift with the origin, and others, which do not.
struct Numbers {
  std::vector<Vec2> places;
  std::vector<double> heights, others;

  void other(const Vec2& v) { others.insert(others.end(), {v.x(), v.y()}); }
  void other(const Mat2& m) { others.insert(others.end(), m.data(), m.data() + 4); }
  void other(const EdgeSpan& s) { others.insert(others.end(), {s.s0, s.s1}); }
};

// The bindings name every member: a new member does not compile here until it is assigned to one of the groups.
Numbers numbers_of(const Model& model) {
  const auto& [title, plane, gravity, origin, materials, joints, default_joint, blocks, block_supports, point_supports,
               edge_supports, monitors, motions, initial_velocities, functions, point_loads, tractions,
               body_accelerations, viscous_edges, bolts, waters, joint_lines, cracks, joint_sets, cutting] = model;
  Numbers n;
  n.other(gravity);
  for (const auto& [name, density, young, poisson, in_situ, rock_strength] : materials) {
    n.others.insert(n.others.end(), {density, young, poisson});
    if (!in_situ) continue;
    const auto& [stress, gradient, level] = *in_situ;
    n.other(stress), n.other(gradient), n.heights.push_back(level);
  }
  for (const JointLaw& law : joints) n.others.insert(n.others.end(), {law.friction, law.contact_length});
  for (const auto& [name, polygon, material, joint, edges, cover_size] : blocks) {
    const auto& [outer, holes] = polygon;
    n.places.insert(n.places.end(), outer.begin(), outer.end());
    for (const Ring& hole : holes) n.places.insert(n.places.end(), hole.begin(), hole.end());
    n.others.push_back(cover_size);
  }
  for (const auto& [block, motion] : block_supports) n.others.push_back(block.value + motion.value);
  for (const auto& [block, point, fix_x, fix_y, stiffness] : point_supports)
    n.places.push_back(point), n.others.push_back(stiffness.value_or(0.0));
  for (const auto& [span, held, bedding] : edge_supports)
    n.other(span), n.other(held), n.others.push_back(bedding.value_or(0.0));
  for (const auto& [name, block, point] : monitors) n.places.push_back(point);
  for (const GroundMotion& motion : motions) n.other(motion.displacement(0.5));
  for (const auto& [block, velocity, spin] : initial_velocities) n.other(velocity), n.others.push_back(spin);
  for (const TimeFunction& function : functions) n.others.push_back(function.value(0.5));
  for (const auto& [block, point, force, function] : point_loads) n.places.push_back(point), n.other(force);
  for (const auto& [span, traction, function] : tractions) n.other(span), n.other(traction);
  for (const auto& [of, acceleration, function] : body_accelerations) n.other(acceleration);
  for (const auto& [span, motion, upgoing] : viscous_edges) n.other(span), n.others.push_back(upgoing);
  for (const Bolt& bolt : bolts) {  // nodes and crossings are stored as distances along the bolt
    n.places.insert(n.places.end(), {bolt.head, bolt.toe});
    n.others.push_back(bolt.stiffness);
  }
  for (const auto& [line, unit_weight, of, faces, levels] : waters) {
    n.places.insert(n.places.end(), line.begin(), line.end()), n.others.push_back(unit_weight);
    for (const EdgeSpan& face : faces) n.other(face);
    for (const auto& [stage, lowered] : levels) n.places.insert(n.places.end(), lowered.begin(), lowered.end());
  }
  for (const auto& [from, to, joint, kind, source] : joint_lines) n.places.insert(n.places.end(), {from, to});
  for (const SetStatistics& set : joint_sets) n.others.push_back(set.total_length);
  for (const auto& [from, to, joint, block] : cracks) n.places.insert(n.places.end(), {from, to});
  const auto& [count, lines, cracks_kept, crack_length, cracks_trimmed, trimmed_length, ends_extended, extended_length,
               slivers_joined, slivers_left, area, least_area, least_edge, least_angle, snap, least_width] = *cutting;
  n.others.insert(n.others.end(), {crack_length, extended_length, area, least_area, least_edge, snap});
  return n;
}

TEST(LocalOrigin, everything_moves_by_the_origin_and_nothing_else_changes) {
  for (const Vec2& at : {Vec2(5e5, 4e6), Vec2(-1e6, 1e6), Vec2(512345.678, -4123456.789), Vec2(1e9, -1e9)}) {
    const Numbers near = numbers_of(everything(Vec2(0.0, 0.0)));
    Model model = everything(at);
    move_to_local_origin(model);
    const Numbers local = numbers_of(model);
    const Vec2 moved = at - model.origin;
    const double last_place = at.cwiseAbs().maxCoeff() * std::numeric_limits<double>::epsilon();
    EXPECT_LT(moved.cwiseAbs().maxCoeff(), 16.0) << "the local box lies about zero";
    ASSERT_EQ(local.places.size(), near.places.size());
    for (std::size_t i = 0; i < near.places.size(); ++i)
      EXPECT_LE((local.places[i] - moved - near.places[i]).cwiseAbs().maxCoeff(), last_place) << "place " << i;
    ASSERT_EQ(local.heights.size(), near.heights.size());
    for (std::size_t i = 0; i < near.heights.size(); ++i)
      EXPECT_NEAR(local.heights[i] - moved.y(), near.heights[i], last_place) << "height " << i;
    EXPECT_EQ(local.others, near.others);
  }
}

TEST(LocalOrigin, differences_are_exact) {
  for (const double far : {901.0, 1234.5678, 5e5 / 3.0, -4123456.789, 8.123456789e8}) {
    const Model before = everything({far, far});
    Model model = before;
    move_to_local_origin(model);
    ASSERT_NE(model.origin, Vec2(0.0, 0.0)) << far;
    EXPECT_EQ(std::fmod(model.origin.x(), 16.0), 0.0) << "the extent is 9 m";
    const Numbers a = numbers_of(before), b = numbers_of(model);
    for (std::size_t i = 0; i < a.places.size(); ++i)  // adding the origin restores every bit of the position
      EXPECT_EQ(b.places[i] + model.origin, a.places[i]) << far << ", place " << i;
  }
}

TEST(LocalOrigin, model_that_lies_near_stays_bit_for_bit) {
  // The extent is 9 m: the box begins or ends at 900 m, the largest distance that counts as near.
  for (const Vec2& at :
       {Vec2(0.0, 0.0), Vec2(-4.0, -3.0), Vec2(0.1, 123.4), Vec2(900.0, -906.0), Vec2(-909.0, 900.0)}) {
    const Model before = everything(at);
    Model model = before;
    move_to_local_origin(model);
    EXPECT_EQ(model.origin, Vec2(0.0, 0.0));
    const Numbers a = numbers_of(before), b = numbers_of(model);
    EXPECT_EQ(a.places, b.places);
    EXPECT_EQ(a.heights, b.heights);
  }
}

TEST(LocalOrigin, far_in_one_direction_leaves_the_other_bit_for_bit) {
  const Model before = everything({5e5, 120.3});  // a section: x of a survey, y an elevation
  Model model = before;
  move_to_local_origin(model);
  EXPECT_NEAR(model.origin.x(), 5e5, 16.0);
  EXPECT_EQ(model.origin.y(), 0.0);
  const Numbers a = numbers_of(before), b = numbers_of(model);
  EXPECT_EQ(a.heights, b.heights);
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    EXPECT_EQ(a.places[i].y(), b.places[i].y());
    EXPECT_EQ(a.places[i].x(), b.places[i].x() + model.origin.x());
  }
}

TEST(LocalOrigin, second_call_does_nothing) {
  Model model = everything({5e5, 4e6});
  move_to_local_origin(model);
  const Vec2 origin = model.origin;
  const Numbers once = numbers_of(model);
  move_to_local_origin(model);
  EXPECT_EQ(model.origin, origin);
  EXPECT_EQ(numbers_of(model).places, once.places);
}

TEST(LocalOrigin, moves_add_up) {
  Model model = everything({5e5, 4e6});
  move_to_local_origin(model);
  const Vec2 first = model.origin;
  for (Block& b : model.blocks) b.polygon = transformed(b.polygon, Vec2(0.0, 1e5), Mat2::Identity());
  move_to_local_origin(model);
  EXPECT_EQ(model.origin.x(), first.x());
  EXPECT_NEAR(model.origin.y(), first.y() + 1e5, 16.0);
}

TEST(LocalOrigin, model_without_blocks_or_extent_stays) {
  Model model;
  move_to_local_origin(model);
  EXPECT_EQ(model.origin, Vec2(0.0, 0.0));
  model.blocks.emplace_back();
  move_to_local_origin(model);
  EXPECT_EQ(model.origin, Vec2(0.0, 0.0));
}

TEST(PlaceText, tells_the_coordinates_of_the_user) {
  EXPECT_EQ(place_text({0.5, 2.0}, {0.0, 0.0}), "(0.5, 2)");
  EXPECT_EQ(place_text({0.123456, -1234.56}, {0.0, 0.0}), "(0.1235, -1235)");
  EXPECT_EQ(place_text({12.5, -0.25}, {5e5, 4e6}), "(500012.5, 3999999.75)");
  EXPECT_EQ(place_text({12.5, 0.123456}, {5e5, 0.0}), "(500012.5, 0.1235)");
}

}  // namespace
}  // namespace scree::local_origin_test
