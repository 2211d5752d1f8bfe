// A run with a number that is not finite in its state or its ledger does not end with "done".
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/schemes.h"
#include "tests/third_method/rigid_pool.h"

namespace scree::test::finite_end_test {
namespace {

using namespace coupling;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Rigid blocks with a planted fault.
class Faulty final : public RigidPool {
 public:
  enum class Fault { none, energy, late_energy };
  explicit Faulty(Fault fault) : fault_(fault) {}
  [[nodiscard]] double kinetic_energy(std::span<const double> q, std::span<const double> v,
                                      std::span<const char> counted) const override {
    const double energy = RigidPool::kinetic_energy(q, v, counted);
    const bool wrong = fault_ == Fault::energy || (fault_ == Fault::late_energy && energy > 1.5e3);
    return wrong ? kNone : energy;
  }

 private:
  Fault fault_;
};

struct Ended {
  RunEnd end;
  double time = 0.0;
  int told = 0;
};
Ended ended(Faulty::Fault fault, Integrator integrator) {
  Scene scene;
  scene.add("faller", rectangle(0.0, 0.0, 1.0, 1.0));
  scene.stage("rigid", integrator, 0.2, integrator == Integrator::implicit ? std::optional(1e-3) : std::nullopt);
  Methods methods = standard_methods();
  methods["rigid"] = [fault] { return std::make_unique<Faulty>(fault); };
  struct Events final : Sink {
    int not_converged = 0;
    void event(const Event& e) override { not_converged += e.kind == EventKind::not_converged ? 1 : 0; }
  } events;
  Driver run(scene.model, scene.plan, methods);
  run.add_sink(events);
  Ended out;
  out.end = run.run();
  out.time = seconds(run.state().time);
  out.told = events.not_converged;
  return out;
}

TEST(FiniteEnd, a_number_that_is_not_finite_ends_the_run_where_it_is_seen) {
  for (const Integrator integrator : {Integrator::explicit_, Integrator::implicit}) {
    EXPECT_EQ(ended(Faulty::Fault::none, integrator).end.status, RunEnd::Status::done);
    const Ended first = ended(Faulty::Fault::energy, integrator);
    EXPECT_EQ(first.end.status, RunEnd::Status::non_finite);
    EXPECT_NE(first.end.reason.find("'kinetic' of the energy ledger is not finite"), std::string::npos)
        << first.end.reason;
    EXPECT_EQ(first.told, 1);
    EXPECT_GE(first.time, 0.02 - 1e-9);
    EXPECT_LT(first.time, 0.03);  // the first check after a step
    // 1/2 m (g t)^2 = 1.5 kJ at 0.1096 s.
    const Ended late = ended(Faulty::Fault::late_energy, integrator);
    EXPECT_EQ(late.end.status, RunEnd::Status::non_finite);
    EXPECT_GE(late.time, 0.12 - 1e-9);  // the first step at or after a sample
    EXPECT_LT(late.time, 0.13);
  }
}

TEST(FiniteEnd, a_ledger_names_its_first_number_that_is_not_finite) {
  Ledger ledger;
  ledger.open(std::array{1.0});
  EXPECT_EQ(ledger.not_finite(), "");
  EXPECT_EQ(ledger.relative_closure(), 0.0);
  Ledger booked = ledger, large = ledger;
  booked.book(Column::prescribed_motion, kNone);
  EXPECT_EQ(booked.not_finite(), "prescribed_motion");
  EXPECT_FALSE(std::isfinite(booked.relative_closure()));  // not a ledger that closes
  large.book(Column::gravity, 1e308);
  large.book(Column::gravity, -1e308);
  large.book(Column::loads, 1e308);
  EXPECT_EQ(large.not_finite(), "moved");
}

}  // namespace
}  // namespace scree::test::finite_end_test
