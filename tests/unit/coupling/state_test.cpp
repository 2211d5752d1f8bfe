#include <gtest/gtest.h>

#include <array>

#include "tests/support/scene.h"

namespace scree::test::state_test {
namespace {

using namespace coupling;

/// Changes the k-th scalar that visit() passes; counts the scalars.
class Changer {
 public:
  explicit Changer(std::int64_t which) : which_(which) {}
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void operator()(const char*, T& value) {
    if (count_++ == which_) reinterpret_cast<unsigned char*>(&value)[0] ^= 1U;
  }
  void operator()(const char*, std::string& text) {
    if (count_++ == which_) text += 'x';
  }
  template <class T>
  void operator()(const char* name, std::vector<T>& values) {
    for (T& v : values) (*this)(name, v);
  }
  template <class T, std::size_t N>
  void operator()(const char* name, std::array<T, N>& values) {
    for (T& v : values) (*this)(name, v);
  }
  void operator()(const char* name, Vec2& x) {
    (*this)(name, x.x());
    (*this)(name, x.y());
  }
  void operator()(const char* name, Mat2& m) {
    for (int i = 0; i < 4; ++i) (*this)(name, m.data()[i]);
  }
  void operator()(const char* name, Polygon& p) {
    for (std::size_t r = 0; r < p.rings(); ++r)
      for (Vec2& x : p.ring(r)) {
        (*this)(name, x.x());
        (*this)(name, x.y());
      }
  }
  template <class T>
  void size(const char*, const std::vector<T>&) {}
  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  std::int64_t which_, count_ = 0;
};

TEST(StateHash, any_changed_value_changes_it) {
  Scene scene(1e8, 0.2, 2000.0, 25.0);
  scene.add("base", rectangle(-2, -1, 6, 0), true);
  scene.add("block", rectangle(0, 0, 1, 1));
  scene.stage("nmm", Integrator::explicit_, 0.01, std::nullopt, 0.5);
  scene.stage("dda", Integrator::implicit, 0.01, 1e-3);
  const Methods methods = standard_methods();
  Driver run(scene.model, scene.plan, methods);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  State state = run.state();
  state.anchors = {1e-3, 0.0};
  state.rules.slips.push_back({0, 1, 0.5});
  state.rules.calm_since = {-1, 5};
  state.rules.other_method = {0, 1};
  state.bodies[1].form.division.region = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}};
  const std::uint64_t hash = state_hash(state);
  Changer all(-1);
  visit_to_write(state, all);
  ASSERT_EQ(state_hash(state), hash);
  ASSERT_GT(all.count(), 150);
  ASSERT_FALSE(state.contacts.empty());
  ASSERT_EQ(state.contacts.points.size(), state.contacts.memory.size());
  ASSERT_FALSE(state.rest.empty());
  for (std::int64_t k = 0; k < all.count(); ++k) {
    State other = state;
    Changer one(k);
    visit_to_write(other, one);
    EXPECT_NE(state_hash(other), hash) << "value " << k;
  }
}

TEST(StateHash, writes_nothing) {
  State state;
  state.bodies.resize(1);
  state.bodies[0].form.division.region = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}};
  const State& shared = state;
  const Vec2* region = shared.bodies[0].form.division.region.data();
  const std::uint64_t hash = state_hash(shared);
  EXPECT_EQ(shared.bodies[0].form.division.region.data(), region) << "a buffer has moved";
  EXPECT_EQ(state_hash(shared), hash);
}

}  // namespace
}  // namespace scree::test::state_test
