// Scenes with bolts, run in every method and scheme.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/scene.h"
#include "tests/support/schemes.h"

namespace scree::test {

/// A method and a scheme.
struct Way {
  const char* method;
  coupling::Integrator integrator;
  [[nodiscard]] bool is_explicit() const { return integrator == coupling::Integrator::explicit_; }
  [[nodiscard]] std::string name() const { return std::string(method) + (is_explicit() ? "_explicit" : "_implicit"); }
};

/// A bar of 60 MN without bond.
inline Bolt bar(const Vec2& head, const Vec2& toe) {
  Bolt b;
  b.name = "bolt";
  b.head = head;
  b.toe = toe;
  b.stiffness = 60e6;
  return b;
}

/// Keeps the texts of events of one kind.
struct Watched : coupling::Sink {
  explicit Watched(coupling::EventKind of) : kind(of) {}
  void event(const coupling::Event& e) override {
    if (e.kind == kind) lines.push_back(e.text);
  }
  coupling::EventKind kind;
  std::vector<std::string> lines;
};

struct Bolted : Scene {
  explicit Bolted(double friction_deg = 30.0, double young = 50e9) : Scene(young, 0.2, 2600.0, friction_deg) {}
  /// Adds a stage to rest: implicit by static steps, explicit by kinetic damping.
  void rest(const Way& way, double duration, double dt = 1e-2, double cover_size = 1.0) {
    coupling::Stage& s =
        stage(way.method, way.integrator, duration, way.is_explicit() ? std::nullopt : std::optional(dt), cover_size);
    s.rest = true;
    s.rest_force = 1e-6;
  }
  /// Adds a stage of motion.
  void go(const Way& way, double duration, double dt = 1e-3, double cover_size = 1.0) {
    stage(way.method, way.integrator, duration, way.is_explicit() ? std::nullopt : std::optional(dt), cover_size);
  }
  void bolt(Bolt b) {
    if (const std::string wrong = lay_out(model, b); !wrong.empty()) throw std::runtime_error(wrong);
    model.bolts.push_back(std::move(b));
  }
  const coupling::Driver& run() {
    driver = std::make_unique<coupling::Driver>(model, plan, methods());
    if (sink != nullptr) driver->add_sink(*sink);
    const coupling::RunEnd end = driver->run();
    EXPECT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
    return *driver;
  }
  [[nodiscard]] const coupling::BoltMemory& memory(std::size_t i = 0) const { return driver->state().bolts[i]; }
  void expect_closed() const {
    const coupling::Ledger& ledger = driver->state().ledger;
    EXPECT_LT(std::abs(ledger.closure()), 1e-11 * ledger.moved() + ledger.last_places())
        << "of " << ledger.moved() << " J moved";
  }
  std::unique_ptr<coupling::Driver> driver;
  coupling::Sink* sink = nullptr;
};

}  // namespace scree::test
