// The law of a contact point at random states: limits, symmetry, energy and bonds.
#include "coupling/contact/law/explicit_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling::explicit_law_test {
namespace {

struct Drawn {
  JointLaw law;
  PointMotion motion;
  ContactMemory memory;
};

/// A law with or without cohesion, bond, weakening and dilation; a point at a random state around its kinks.
Drawn draw(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto yes = [&] { return unit(random) < 0.5; };
  const auto either_way = [&] { return 2.0 * unit(random) - 1.0; };
  Drawn d;
  d.law.friction = 0.1 + 0.9 * unit(random);
  if (yes()) d.law.cohesion = 1e6 * unit(random);
  if (yes()) d.law.residual_cohesion = d.law.cohesion * unit(random);
  if (yes()) d.law.tensile_strength = 1e6 * unit(random);
  if (yes()) d.law.residual_friction = d.law.friction * unit(random);
  if (yes()) d.law.weakening_slip = 1e-2 * unit(random);
  if (yes()) d.law.dilation = d.law.friction * unit(random);
  if (yes()) d.law.dilation_slip = 1e-2 * unit(random);
  ContactMemory& m = d.memory;
  m.tributary = 0.1 + unit(random);
  m.kn = 1e9 * (0.1 + unit(random));
  m.kt = 1e9 * (0.1 + unit(random));
  m.gap = 1e-3 * either_way();
  m.stretch = 1e-3 * either_way();
  m.slip = 2e-2 * unit(random);
  m.status = yes() ? ContactStatus::stick : yes() ? ContactStatus::slip : ContactStatus::open;
  m.failed = yes() ? 1 : 0;
  m.bonded = m.failed == 0 && m.status == ContactStatus::stick && d.law.tensile_strength > 0.0 ? 1 : 0;
  if (m.status == ContactStatus::open) m.stretch = 0.0;
  d.motion.foot = unit(random);
  d.motion.length = 0.1 + unit(random);
  if (yes()) {
    d.motion.rate = either_way();
    d.motion.shear = either_way();
    d.motion.per_time = 1e5;
    d.motion.cn = 1e5 * unit(random);
    d.motion.ct = 1e5 * unit(random);
  }
  m.anchor = d.motion.foot - m.stretch / d.motion.length;
  return d;
}

void apply(const Drawn& d, ContactMemory& m) { explicit_law(d.law, std::tan(d.law.friction), d.motion, m); }

TEST(ExplicitLaw, limits_hold_at_random_states) {
  std::mt19937_64 random(7);
  int open = 0, stick = 0, slip = 0, broke = 0;
  for (int i = 0; i < 10000; ++i) {
    const Drawn d = draw(random);
    ContactMemory m = d.memory;
    apply(d, m);
    open += m.status == ContactStatus::open ? 1 : 0;
    stick += m.status == ContactStatus::stick ? 1 : 0;
    slip += m.status == ContactStatus::slip ? 1 : 0;
    broke += d.memory.bonded != 0 && m.bonded == 0 ? 1 : 0;
    const double scale = m.kn * 1e-3 + 1e5;
    if (m.status == ContactStatus::open) {
      EXPECT_EQ(m.fn, 0.0);
      EXPECT_EQ(m.ft, 0.0);
      EXPECT_EQ(m.stretch, 0.0);
      EXPECT_TRUE(m.gap >= 0.0) << i;
      if (d.memory.bonded != 0 && d.memory.gap >= 0.0 && d.law.dilation == 0.0) {
        EXPECT_EQ(m.slip, d.memory.slip) << i;  // pulled off or sheared through: no frictional slip
      }
      continue;
    }
    EXPECT_GE(m.fn, -tension_limit(d.law, m)) << i;
    // With the strength at the time of the limit: slip weakens the point from the next step on.
    ContactMemory then = m;
    then.slip = d.memory.slip;
    const double bearing = m.failed == 0 && can_fail(d.law) ? std::max(m.fn, m.fn - m.fd) : m.fn;
    EXPECT_LE(std::abs(m.ft), friction_limit(d.law, then, bearing) + 1e-9 * scale) << i;
    EXPECT_NEAR(m.fn - m.fd, -m.kn * m.gap, 1e-9 * scale) << i;
    EXPECT_NEAR(m.ft - m.fdt, -m.kt * m.stretch, 1e-9 * scale) << i;
    EXPECT_NEAR((d.motion.foot - m.anchor) * d.motion.length, m.stretch, 1e-15) << i;
    EXPECT_GE(m.slip, d.memory.slip - 1e-15) << i;
    if (m.gap0 == d.memory.gap0) {  // dashpots dissipate
      EXPECT_LE(m.fd * d.motion.rate, 1e-9 * scale) << i;
    }
    EXPECT_LE(m.fdt * d.motion.shear, 1e-9 * scale) << i;
    EXPECT_GE(m.gap0, d.memory.gap0) << i;                                  // openings are permanent
    EXPECT_NEAR(m.gap + m.gap0, d.memory.gap + d.memory.gap0, 1e-17) << i;  // the law does not change the geometry
    if (m.status == ContactStatus::slip) {
      EXPECT_LE(m.ft * (d.memory.stretch - m.stretch), 0.0) << i;
    }
  }
  for (const int count : {open, stick, slip, broke}) EXPECT_GT(count, 300);
}

TEST(ExplicitLaw, is_symmetric_and_depends_on_nothing_else) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 10000; ++i) {
    Drawn d = draw(random);
    ContactMemory a = d.memory, again = d.memory;
    apply(d, a);
    apply(d, again);
    EXPECT_EQ(a.fn, again.fn);
    EXPECT_EQ(a.ft, again.ft);
    // Mirrored: the same normal force, the opposite tangential one.
    d.memory.stretch = -d.memory.stretch;
    d.motion.shear = -d.motion.shear;
    d.motion.foot = -d.motion.foot;
    d.memory.anchor = -d.memory.anchor;
    ContactMemory b = d.memory;
    apply(d, b);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.fn, b.fn);
    EXPECT_EQ(a.ft, -b.ft);
    EXPECT_EQ(a.slip, b.slip);
    EXPECT_EQ(a.gap, b.gap);
    EXPECT_EQ(a.bonded, b.bonded);
  }
}

/// Without damping and dilation a point stores and dissipates: the work of its forces over a small closed path of the
/// corner is never positive, and 0 while it sticks.
TEST(ExplicitLaw, closed_paths_give_no_energy) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int slipped = 0;
  for (int i = 0; i < 1000; ++i) {
    Drawn d = draw(random);
    d.law.dilation = 0.0;
    d.motion = {};
    d.motion.length = 1.0;
    ContactMemory m = d.memory;
    m.status = ContactStatus::stick;
    m.bonded = 0;
    m.gap = -1e-3;
    m.stretch = 0.0;
    m.anchor = d.motion.foot = 0.0;
    apply(d, m);
    constexpr int kSteps = 400;
    const double depth = 0.9e-3 * std::abs(unit(random)), way = 1e-3 * unit(random), turn = 3.0 * unit(random);
    double work = 0.0, gap = m.gap, foot = 0.0;
    const double stored = 0.5 * m.kn * gap * gap;
    for (int k = 1; k <= kSteps; ++k) {
      const double angle = 2.0 * std::acos(-1.0) * k / kSteps;
      const double next_gap = -1e-3 + depth * std::sin(angle) * std::cos(turn * std::sin(angle)),
                   next_foot = way * (1.0 - std::cos(angle));
      const double fn = m.fn, ft = m.ft;
      m.gap += next_gap - gap;
      m.stretch += next_foot - foot;
      d.motion.foot = next_foot;
      apply(d, m);
      slipped += m.status == ContactStatus::slip ? 1 : 0;
      work += 0.5 * (fn + m.fn) * (next_gap - gap) + 0.5 * (ft + m.ft) * (next_foot - foot);
      gap = next_gap;
      foot = next_foot;
    }
    const double left = 0.5 * m.kn * m.gap * m.gap + 0.5 * m.kt * m.stretch * m.stretch;
    EXPECT_LE(work, stored - left + 1e-9 * (stored + left)) << i;
  }
  EXPECT_GT(slipped, 10000);
}

TEST(ExplicitLaw, bond_bears_its_strength_and_not_more) {
  Drawn d;
  d.law.friction = 0.5;
  d.law.tensile_strength = 2e6;
  d.law.cohesion = 1e7;
  d.motion.length = 1.0;
  d.memory.tributary = 0.5;
  d.memory.kn = d.memory.kt = 1e9;
  d.memory.status = ContactStatus::stick;
  d.memory.bonded = 1;
  const double limit = 2e6 * 0.5 / 1e9;
  for (const double factor : {0.999999, 1.000001}) {
    ContactMemory m = d.memory;
    m.gap = factor * limit;
    apply(d, m);
    EXPECT_EQ(m.bonded, factor < 1.0 ? 1 : 0);
    EXPECT_EQ(m.failed, factor < 1.0 ? 0 : 1);
    EXPECT_DOUBLE_EQ(m.fn, factor < 1.0 ? -1e9 * m.gap : 0.0);
  }
}

}  // namespace
}  // namespace scree::coupling::explicit_law_test
