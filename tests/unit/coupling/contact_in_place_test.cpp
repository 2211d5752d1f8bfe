// Contact points kept in the list from step to step equal, to the last bit, points listed anew: state, ledger and every
// field of every point, over steps with sliding, impact, corners passing corners, opening and closing.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::contact_in_place_test {
namespace {

using coupling::CentralDifference;
using coupling::Integrator;
using test::ByHand;
using test::Scene;

/// Every bit of the points.
std::string bits(const std::vector<coupling::ContactPoint>& points) {
  std::string out;
  const auto see = [&out]<class T>(const char*, const T& value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, static_cast<const void*>(&value), sizeof(T));
    out.append(bytes, sizeof(T));
  };
  for (const coupling::ContactPoint& p : points) p.visit(see);
  return out;
}

struct Counts {
  std::int64_t in_place = 0, anew = 0, slipping = 0, opened = 0;

  /// Compares two states after a step and counts the contacts of the first.
  bool same(const coupling::State& a, const coupling::ContactList& of_a, const coupling::State& b,
            const coupling::ContactList& of_b) {
    const bool equal = coupling::state_hash(a) == coupling::state_hash(b) && bits(of_a.points) == bits(of_b.points);
    EXPECT_TRUE(equal) << "step " << a.step;
    for (const coupling::ContactMemory& m : a.contacts) {
      slipping += m.status == coupling::ContactStatus::slip ? 1 : 0;
      opened += m.status == coupling::ContactStatus::open ? 1 : 0;
    }
    return equal;
  }
  void end(int steps, const auto& first, const auto& anew_always) {
    in_place = first.contact_steps_in_place();
    anew = steps - in_place;
    EXPECT_EQ(anew_always.contact_steps_in_place(), 0);
  }
};

/// Steps a scene twice, with lists kept in place where possible and with lists made anew; compares after every step.
Counts compare(const Scene& scene, int steps, double detection, coupling::ExplicitDamping damping = {}) {
  struct Side {
    ByHand hand;
    CentralDifference integrator;
    Side(const Scene& s, double near, const coupling::ExplicitDamping& d)
        : hand(s.model, s.plan.stages[0]), integrator(*hand.setup, {.max_displacement = 1.0}, near, d) {
      integrator.enter(hand.state);
    }
  };
  damping.sliding = 0.15;
  Side a(scene, detection, damping), b(scene, detection, damping);
  b.integrator.list_contacts_always_anew();
  Counts counts;
  Tick h = 0;
  for (int i = 0; i < steps; ++i) {
    if (h == 0 || !a.integrator.step_still_stable()) h = ticks(0.5 * a.integrator.stable_step(a.hand.state, nullptr));
    for (Side* s : {&a, &b}) {
      const coupling::StepReport report = s->integrator.step(s->hand.state, h);
      EXPECT_EQ(report.status, coupling::StepReport::Status::ok) << report.cause;
    }
    if (!counts.same(a.hand.state, a.integrator.contacts(), b.hand.state, b.integrator.contacts())) break;
  }
  counts.end(steps, a.integrator, b.integrator);
  return counts;
}

/// compare() for implicit steps.
Counts compare_implicit(Scene scene, int steps, double detection) {
  scene.plan.stages[0].integrator = Integrator::implicit;
  struct Side {
    ByHand hand;
    coupling::Newmark integrator;
    Side(const Scene& s, double near)
        : hand(s.model, s.plan.stages[0]),
          integrator(*hand.setup, {.max_passes = 40, .max_displacement = 0.1}, near, {.sliding_damping = 0.15}) {
      integrator.enter(hand.state);
    }
  };
  Side a(scene, detection), b(scene, detection);
  b.integrator.list_contacts_always_anew();
  Counts counts;
  for (int i = 0; i < steps; ++i) {
    Tick h = ticks(1e-3);
    for (;; h /= 3) {
      const auto status = a.integrator.step(a.hand.state, h).status;
      EXPECT_EQ(b.integrator.step(b.hand.state, h).status, status) << "step " << i;
      if (status == coupling::StepReport::Status::ok || h < 1000) break;
    }
    if (!counts.same(a.hand.state, a.integrator.list(), b.hand.state, b.integrator.list())) break;
  }
  counts.end(steps, a.integrator, b.integrator);
  return counts;
}

/// Blocks of three to six corners that fall on a valley and on each other.
Scene heap(const std::string& method, int blocks, unsigned seed) {
  Scene scene(2e8, 0.2, 2500.0);
  scene.model.joints[0].friction = 0.5;
  scene.add("left", {{{-8, 8}, {-8, -1}, {0, -1}, {0, 0}}, {}}, true);
  scene.add("right", {{{0, 0}, {0, -1}, {8, -1}, {8, 6}}, {}}, true);
  std::mt19937 random(seed);
  const auto between = [&random](double a, double b) {
    return a + (b - a) * static_cast<double>(random() % 1000003) / 1000003.0;
  };
  for (int i = 0; i < blocks; ++i) {
    const int course = i / 3;
    const Vec2 c(-1.5 + 1.5 * (i % 3), 3.2 + 1.4 * course);
    const int corners = 3 + static_cast<int>(random() % 4);
    Polygon p;
    for (int k = 0; k < corners; ++k) {
      const double a = 2.0 * std::numbers::pi * (k + between(-0.25, 0.25)) / corners;
      p.outer.emplace_back(c + between(0.45, 0.7) * Vec2(std::cos(a), std::sin(a)));
    }
    const BlockId id = scene.add("b" + std::to_string(i), p);
    scene.model.initial_velocities.push_back({id, {between(-2, 2), between(-4, -1)}, between(-2, 2)});
  }
  scene.stage(method, Integrator::explicit_, 1.0, std::nullopt, 0.5);
  return scene;
}

/// Shaken bricks in running bond on a held course.
Scene wall(const std::string& method, double speed) {
  Scene scene(1e9, 0.2, 2500.0);
  scene.model.joints[0].friction = 0.4;
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 4; ++i) {
      const double x = 2.0 * i + row % 2;
      const BlockId id = scene.add("b", test::rectangle(x, row, x + 2.0, row + 1.0), row == 0);
      const double angle = 2.4 * id.value;
      if (row > 0)
        scene.model.initial_velocities.push_back({id, {speed * std::cos(angle), speed * std::sin(angle)}, 0.0});
    }
  scene.stage(method, Integrator::explicit_, 1.0, std::nullopt, 0.7);
  return scene;
}

/// Parallelograms between joints of 8 and 84 degrees on a base: sides inclined by 6 or 8 degrees to what they stand on,
/// which face it or not depending on the closed points beside them.
Scene leaning_wall(const std::string& method, double speed) {
  Scene scene(1e9, 0.2, 2600.0);
  scene.add("base", test::rectangle(-2.0, -1.0, 12.0, 0.0), true);
  const Vec2 along(std::cos(8.0 * test::kDegree), std::sin(8.0 * test::kDegree)),
      up(std::cos(84.0 * test::kDegree), std::sin(84.0 * test::kDegree));
  std::mt19937 random(5);
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 6; ++i) {
      const double begin = 1.1 * i + 0.3 * (row % 3), end = begin + 1.1;
      const auto corner = [&](double a, double h) {
        Vec2 c = a * along + h * up;
        if (row == 0 && h == 0.0) c.y() = 0.0;
        return c;
      };
      const BlockId id = scene.add("b", {{corner(begin, 0.9 * row), corner(end, 0.9 * row),
                                          corner(end, 0.9 * row + 0.9), corner(begin, 0.9 * row + 0.9)},
                                         {}});
      const double angle = static_cast<double>(random() % 628) / 100.0;
      scene.model.initial_velocities.push_back(
          {id, {speed * std::cos(angle), speed * std::sin(angle)}, speed * std::cos(3.0 * angle)});
    }
  scene.stage(method, Integrator::explicit_, 1.0, std::nullopt, 0.7);
  return scene;
}

TEST(ContactInPlace, of_sides_that_lean_is_that_listed_anew) {
  EXPECT_GT(compare(leaning_wall("dda", 0.1), 1500, 0.01).in_place, 1000);
  EXPECT_GT(compare_implicit(leaning_wall("dda", 0.1), 120, 0.005).in_place, 100);
}

TEST(ContactInPlace, of_heaps_that_fall_and_pass_corners_is_that_listed_anew) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Counts c = compare(heap("dda", 9, seed), 6000, 0.05);
    EXPECT_GT(c.in_place, 1000);
    EXPECT_GT(c.anew, 30);
    EXPECT_GT(c.slipping, 500);
    EXPECT_GT(c.opened, 500);
  }
}

TEST(ContactInPlace, of_meshes_that_fall_and_slide_is_that_listed_anew) {
  const Counts c = compare(heap("nmm", 5, 7U), 4000, 0.05);
  EXPECT_GT(c.in_place, 500);
  EXPECT_GT(c.anew, 30);
  EXPECT_GT(c.slipping, 100);
}

TEST(ContactInPlace, of_a_mesh_that_slides_along_a_bent_one_is_that_listed_anew) {
  // Its nodes pass the nodes below one by one, most of them at some distance from the ends of a segment in each step;
  // the slab below is soft, so that its edge is bent, and the block hops.
  Scene scene(5e7, 0.3, 2500.0);
  scene.model.joints[0].friction = 0.3;
  scene.add("base", test::rectangle(-1.0, -1.0, 7.0, 0.0), true);
  scene.add("slab", test::rectangle(0.0, 0.0, 6.0, 0.6));
  const BlockId block = scene.add("block", test::rectangle(0.4, 0.6, 1.9, 1.5));
  scene.model.initial_velocities.push_back({block, {4.0, -0.5}, 0.4});
  scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.35);
  const Counts c = compare(scene, 3000, 0.03);
  EXPECT_GT(c.in_place, 2500);
  EXPECT_GT(c.slipping, 5000);
  EXPECT_GT(c.opened, 5000);
}

TEST(ContactInPlace, of_shaken_walls_is_that_listed_anew) {
  for (const char* method : {"dda", "nmm"}) {
    const Counts c = compare(wall(method, 0.3), 1500, 0.02);
    EXPECT_GT(c.in_place, 1000) << method;
    EXPECT_GT(c.slipping, 500) << method;
    EXPECT_GT(c.opened, 500) << method;
  }
  const Counts rest = compare(wall("dda", 0.0), 200, 0.02);
  EXPECT_GT(rest.in_place, 190);
}

TEST(ContactInPlace, of_implicit_steps_is_that_listed_anew) {
  for (const char* method : {"dda", "nmm"}) {
    const Counts fallen = compare_implicit(heap(method, 6, 4U), 600, 0.05);
    EXPECT_GT(fallen.in_place, 400) << method;
    EXPECT_GT(fallen.anew, 5) << method;
    EXPECT_GT(fallen.slipping, 50) << method;
    EXPECT_GT(fallen.opened, 50) << method;
    const Counts shaken = compare_implicit(wall(method, 0.3), 200, 0.02);
    EXPECT_GT(shaken.in_place, 190) << method;
    EXPECT_GT(shaken.slipping, 100) << method;
  }
}

TEST(ContactInPlace, of_bonds_dilation_weakening_and_water_is_that_listed_anew) {
  Scene bonded = wall("dda", 0.5);
  bonded.model.joints[0].cohesion = 2e4;
  bonded.model.joints[0].tensile_strength = 1e4;
  EXPECT_GT(compare(bonded, 800, 0.02).in_place, 500);

  Scene dilating = wall("dda", 0.3);
  dilating.model.joints[0].dilation = 0.1;
  dilating.model.joints[0].dilation_slip = 0.002;
  EXPECT_GT(compare(dilating, 800, 0.02).in_place, 500);

  Scene weak = wall("nmm", 0.3);
  weak.model.joints[0].residual_friction = 0.2;
  weak.model.joints[0].weakening_slip = 0.001;
  EXPECT_GT(compare(weak, 400, 0.02).in_place, 200);

  Scene wet = wall("dda", 0.1);
  wet.model.waters.push_back({{{-10.0, 3.0}, {20.0, 2.0}}});
  EXPECT_GT(compare(wet, 800, 0.02).in_place, 500);
}

}  // namespace
}  // namespace scree::contact_in_place_test
