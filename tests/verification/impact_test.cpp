// Two blocks that hit each other at 1 to 50 m/s: momenta, ledger, restitution and depth, against the two-mass
// oscillator that stiff blocks on a contact spring are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/outlines.h"
#include "tests/support/schemes.h"

namespace scree::test {
namespace {

using namespace coupling;

constexpr double kDensity = 2600.0;
constexpr double kStiffness = 1e10;  // of joints [Pa/m]
constexpr double kRigid = 1e14;      // Young's modulus of blocks that give way by 1e-4 of what their contacts do [Pa]
constexpr double kRock = 5e10;       // [Pa]
constexpr double kApart = 0.06;      // farther than contacts are looked for [m]

const Scheme kSchemes[] = {{"dda", "dda", Integrator::explicit_},
                           {"dda_implicit", "dda", Integrator::implicit},
                           {"nmm", "nmm", Integrator::explicit_},
                           {"nmm_implicit", "nmm", Integrator::implicit}};

struct EveryStep final : Sink {
  std::function<void(double)> see;
  void step(double time, const RunStats&, const Ledger&) override { see(time); }
};

enum class Meeting { equal_faces, unequal_faces, shifted_faces, oblique_faces, corner_past_corner, corner_on_corner };
const char* name(Meeting meeting) {
  constexpr const char* kNames[] = {"equal_faces",   "unequal_faces",      "shifted_faces",
                                    "oblique_faces", "corner_past_corner", "corner_on_corner"};
  return kNames[static_cast<std::size_t>(meeting)];
}

/// A block that flies from the left towards one at rest, away from the origin.
struct Impact {
  Scene scene;
  BlockId flying, resting;
  Vec2 velocity;
  double mass[2];       // flying, resting [kg]
  double stiffness;     // of all springs that meet head-on [N/m]
  double closed_by;     // all contact is over by then [s]

  Impact(Meeting meeting, double young, double speed, double damping, double friction_deg = 30.0)
      : scene(young, 0.2, kDensity, friction_deg), velocity(speed, 0.0) {
    JointLaw& law = scene.model.joints[0];
    law.normal_stiffness = kStiffness;
    law.contact_length = 0.1;
    law.damping = damping;
    scene.model.gravity.setZero();
    const Vec2 at(3.0, -2.0);  // of the place where they meet
    const bool corners = meeting == Meeting::corner_past_corner || meeting == Meeting::corner_on_corner;
    double left = 1.0, right = 1.0, offset = 0.0, height = 1.0;
    if (meeting == Meeting::unequal_faces) {
      right = 2.5;
      height = 0.6;
    }
    if (meeting == Meeting::shifted_faces) offset = 0.3;
    if (meeting == Meeting::oblique_faces) velocity.y() = 0.8 * speed;
    if (meeting == Meeting::corner_past_corner) offset = 0.02;
    Polygon a = rectangle(-left, -0.5, 0.0, 0.5), b = rectangle(0.0, -0.5 * height, right, 0.5 * height);
    if (corners) {
      const Mat2 R = rotation(45.0 * kDegree);
      const double half = std::sqrt(0.5);
      a = transformed(rectangle(-0.5, -0.5, 0.5, 0.5), Vec2(-half, 0.0), R);
      b = transformed(rectangle(-0.5, -0.5, 0.5, 0.5), Vec2(half, 0.0), R);
    }
    const Vec2 start = -kApart / speed * velocity;
    flying = scene.add("flying", transformed(a, at + start, Mat2::Identity()));
    resting = scene.add("resting", transformed(b, at + Vec2(0.0, offset), Mat2::Identity()));
    scene.model.initial_velocities.push_back({flying, velocity, 0.0});
    mass[0] = kDensity * left;
    mass[1] = kDensity * right * height;
    stiffness = kStiffness * (corners ? law.contact_length : std::min({1.0, height, 1.0 - offset}));
    closed_by = kApart / speed + 2.0 * M_PI / rate();
  }
  [[nodiscard]] double reduced() const { return mass[0] * mass[1] / (mass[0] + mass[1]); }
  [[nodiscard]] double rate() const { return std::sqrt(stiffness / reduced()); }  // w_c of rigid blocks [1/s]
  [[nodiscard]] double energy() const { return 0.5 * mass[0] * velocity.squaredNorm(); }
};

/// What came of it.
struct Outcome {
  double linear = 0.0, angular = 0.0;  // change of the momenta over m v, m v L with L = 1 m
  double closure = 0.0;                // largest on the way, of the kinetic energy
  double deepest = 0.0;                // a corner in the other block [m]
  double restitution = 0.0;            // of the centres, along x
  double kept = 0.0;                   // kinetic energy at the end, of that at the start
  Vec2 impulse{0.0, 0.0};              // on the block that was at rest [N s]
  double in_contact = 0.0;             // [s]
  bool apart = false;
  std::int64_t cuts = 0;
  std::vector<double> steps;  // [s]
  double transition = 0.0;    // of the ledger [J]
};

Outcome run_impact(Impact& impact, const Scheme& scheme, std::optional<double> dt, double time = 0.0,
                   double cover_size = 0.5) {
  if (time == 0.0) time = impact.closed_by;
  impact.scene.stage(scheme.method, scheme.integrator, time, dt, cover_size);
  impact.scene.plan.output.every = impact.scene.plan.output.history_every = impact.scene.plan.stages[0].duration;
  Driver run(impact.scene.model, impact.scene.plan, methods());
  const double m_v = impact.mass[0] * impact.velocity.norm();
  const Vec2 momentum = impact.mass[0] * impact.velocity;
  const double angular =
      cross(moments(impact.scene.model.blocks[impact.flying.index()].polygon).centroid, momentum);
  Outcome out;
  EveryStep watch;
  double last = 0.0;
  watch.see = [&](double now) {
    const Ledger& ledger = run.state().ledger;
    out.closure = std::max(out.closure, std::abs(ledger.closure()) / impact.energy());
    out.steps.push_back(now - last);
    const bool closed = std::any_of(run.state().contacts.begin(), run.state().contacts.end(),
                                    [](const ContactMemory& m) { return m.status != ContactStatus::open; });
    if (closed) {
      out.in_contact += now - last;
      const Ring a = outline_of(run, impact.flying), b = outline_of(run, impact.resting);
      out.deepest = std::max({out.deepest, depth_in(a, b), depth_in(b, a)});
    }
    last = now;
  };
  run.add_sink(watch);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const BodyTotals a = totals_of(run, impact.flying), b = totals_of(run, impact.resting);
  out.linear = (a.momentum + b.momentum - momentum).norm() / m_v;
  out.angular = std::abs(a.angular_momentum + b.angular_momentum - angular) / m_v;
  out.restitution = (b.momentum.x() / b.mass - a.momentum.x() / a.mass) / impact.velocity.x();
  out.kept = (a.kinetic + b.kinetic) / impact.energy();
  out.impulse = b.momentum;
  const Ring ring_a = outline_of(run, impact.flying), ring_b = outline_of(run, impact.resting);
  out.apart = depth_in(ring_a, ring_b) == 0.0 && depth_in(ring_b, ring_a) == 0.0;
  out.cuts = run.stats().cuts;
  out.transition = run.state().ledger[Column::contact_transition];
  return out;
}

class Impacts : public testing::TestWithParam<std::tuple<Scheme, Meeting>> {};

TEST_P(Impacts, keep_momenta_and_books_and_nothing_tunnels) {
  const auto& [scheme, meeting] = GetParam();
  for (const double speed : {1.0, 10.0, 50.0}) {
    Impact impact(meeting, kRock, speed, 0.2);
    const Outcome o = run_impact(impact, scheme, scheme.implicit() ? std::optional<double>(0.1 / impact.rate()) : std::nullopt);
    std::printf(
        "%s %s %g m/s: linear %.1e angular %.1e closure %.1e, depth %.2e of %.2e, e %.4f, energy %.4f, contact %.2e s, "
        "%zu steps, %lld cuts, apart %d, impulse %.3g %.3g\n",
        scheme.name, name(meeting), speed, o.linear, o.angular, o.closure, o.deepest, speed / impact.rate(),
        o.restitution, o.kept, o.in_contact, o.steps.size(), static_cast<long long>(o.cuts), o.apart, o.impulse.x(),
        o.impulse.y());
    EXPECT_LT(o.linear, 1e-12);
    EXPECT_LT(o.angular, scheme.implicit() ? 1.0 : 1e-10);
    EXPECT_LT(o.closure, 1e-9);
    EXPECT_TRUE(o.apart);
  }
}
INSTANTIATE_TEST_SUITE_P(all, Impacts,
                         testing::Combine(testing::ValuesIn(kSchemes),
                                          testing::Values(Meeting::equal_faces, Meeting::unequal_faces,
                                                          Meeting::shifted_faces, Meeting::oblique_faces,
                                                          Meeting::corner_past_corner, Meeting::corner_on_corner)),
                         [](const auto& of) {
                           return std::string(std::get<0>(of.param).name) + "_" + name(std::get<1>(of.param));
                         });

}  // namespace
}  // namespace scree::test
