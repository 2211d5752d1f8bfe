// Contact search against brute force: no near pair is missed, and the result does not depend on earlier searches.
#include "coupling/contact/search/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "coupling/contact/table/contact_finder.h"
#include "model/random.h"
#include "tests/support/by_hand.h"

namespace scree::test::search_test {
namespace {

using namespace coupling;

/// Distance of two segments; 0 if they intersect.
double distance(const std::array<Vec2, 2>& a, const std::array<Vec2, 2>& b) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - p); };
  const auto to = [](const Vec2& p, const std::array<Vec2, 2>& s) {
    const Vec2 d = s[1] - s[0];
    return (p - s[0] - std::clamp((p - s[0]).dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm();
  };
  if (side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < 0.0 && side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) < 0.0)
    return 0.0;
  return std::min({to(a[0], b), to(a[1], b), to(b[0], a), to(b[1], a)});
}

/// A convex block, or a star with some reentrant corners.
Ring random_block(Random& random, const Vec2& centre, double radius) {
  const int n = 3 + static_cast<int>(random.uniform() * 6.0);
  const bool convex = random.uniform() < 0.5;
  const double start = 2.0 * std::numbers::pi * random.uniform();
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = start + 2.0 * std::numbers::pi * (i + 0.6 * random.uniform()) / n,
                 r = radius * (convex ? 1.0 : 0.4 + 0.6 * random.uniform());
    ring.push_back(centre + r * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// A heap of DDA blocks that can be placed anywhere.
class Heap {
 public:
  Heap(Random& random, int blocks) : random_(&random) {
    const int columns = std::max(1, static_cast<int>(std::sqrt(blocks)));
    for (int i = 0; i < blocks; ++i) {
      const int row = i / columns;
      const Vec2 centre(1.2 * (i % columns), 1.2 * row);
      scene_.add("b", {random_block(random, centre, 0.3 + 0.4 * random.uniform()), {}}, random.uniform() < 0.1);
      angle_.push_back(0.0);
    }
    hand_ = std::make_unique<ByHand>(scene_.model, scene_.stage("dda", Integrator::explicit_, 1.0, std::nullopt));
    for (const Body& b : hand_->setup->bodies()) centre_.push_back(b.centre);
    put();
  }
  [[nodiscard]] const Setup& setup() const { return *hand_->setup; }
  [[nodiscard]] OutlinePositions points() const { return x_; }
  /// Moves, turns and stretches every block that is not held at random; some jump far away.
  void tumble(double step, double jumps) {
    const auto signed_uniform = [&] { return 2.0 * random_->uniform() - 1.0; };
    for (std::size_t i = 0; i < centre_.size(); ++i) {
      centre_[i] += step * Vec2(signed_uniform(), signed_uniform());
      angle_[i] += step * signed_uniform();
      if (random_->uniform() < jumps)
        centre_[i] =
            centre_[static_cast<std::size_t>(random_->uniform() * 0.999 * static_cast<double>(centre_.size()))];
    }
    put();
  }

 private:
  void put() {
    const Setup& setup = *hand_->setup;
    for (std::size_t i = 0; i < centre_.size(); ++i) {
      const Body& b = setup.bodies()[i];
      if (b.resting && !x_.empty()) continue;  // the search relies on their staying in place
      AffineMotion m;
      m.c = centre_[i];
      m.F = rotation(angle_[i]) * (Mat2() << 1.0 + 0.01 * random_->uniform(), 0.01, 0.0, 1.0).finished();
      const auto p = static_cast<std::size_t>(b.pool);
      setup.pool_of(b).place(b.index, m, setup.part(std::span<double>(hand_->state.q), p),
                             setup.part(std::span<double>(hand_->state.v), p));
    }
    x_.values().clear();
    for (const Row& row : setup.outlines().nodes) x_.push_back(position(row, hand_->state.q));
  }
  Random* random_;
  Scene scene_;
  std::unique_ptr<ByHand> hand_;
  std::vector<Vec2> centre_;
  IndexedVector<OutlineNode, Vec2> x_;
  std::vector<double> angle_;
};

/// Tests every pair of segments, except those whose extents along x are apart.
std::vector<EdgePair> brute_force(const Setup& setup, OutlinePositions x, double reach) {
  const Outlines& o = setup.outlines();
  struct Item {
    double low, high;
    std::array<Vec2, 2> at;
    EdgeIndex edge;
    BodyIndex body;
  };
  std::vector<Item> items;
  for (const Outlines::Segment& s : o.segments) {
    const Vec2 &a = x[s.a], &b = x[s.b];
    items.push_back({std::min(a.x(), b.x()), std::max(a.x(), b.x()), {a, b}, s.edge, o.edges[s.edge].body});
  }
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.low < b.low; });
  std::vector<EdgePair> pairs;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = i + 1; j < items.size() && items[j].low <= items[i].high + reach; ++j) {
      const Item &a = items[i], &b = items[j];
      const auto driven = [&](BodyIndex body) { return setup.body(body).driven; };
      if (a.body == b.body || (driven(a.body) && driven(b.body)) || distance(a.at, b.at) >= reach) continue;
      pairs.push_back({std::min(a.edge, b.edge), std::max(a.edge, b.edge)});
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

TEST(Search, finds_what_brute_force_finds_in_tumbling_heaps) {
  constexpr int kSystems = 200, kCalls = 18;
  std::size_t near = 0, listed = 0;
  for (int system = 0; system < kSystems; ++system) {
    Random random(static_cast<std::uint64_t>(1000 + system));
    const double part = system / (kSystems - 1.0);
    Heap heap(random, 50 + static_cast<int>(450.0 * part * part * part * part));
    const double reach = 0.01 + 0.1 * random.uniform();
    Search search(heap.setup(), reach);
    for (int call = 0; call < kCalls; ++call) {
      const std::vector<EdgePair> expected = brute_force(heap.setup(), heap.points(), reach);
      const auto check = [&](std::span<const EdgePair> found) {
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
        ASSERT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()))
            << "system " << system << ", call " << call;
        for (const EdgePair& p : found) {
          const auto body = [&](EdgeIndex e) { return heap.setup().outlines().edges[e].body; };
          ASSERT_NE(body(p.a), body(p.b));
        }
      };
      const std::span<const EdgePair> found = search.update(heap.points());
      near += expected.size();
      listed += found.size();
      check(found);
      if (call % 6 == 5) {
        // A new search finds the same near pairs, and the clearance is positive only if there is none.
        Search fresh(heap.setup(), reach);
        check(fresh.update(heap.points()));
        EXPECT_TRUE(search.clearance(heap.points()) <= 0.0 || expected.empty());
      }
      if (HasFatalFailure()) return;
      constexpr double kSteps[] = {0.0, 0.02, 0.3, 2.0, 30.0};  // of the reach
      heap.tumble(kSteps[static_cast<std::size_t>(random.uniform() * 4.999)] * reach, call % 5 == 4 ? 0.05 : 0.0);
    }
  }
  std::printf("%zu near pairs of edges, %zu listed\n", near, listed);
  EXPECT_GT(near, 500000U);
  EXPECT_LT(listed, 12 * near);  // boxes fattened by up to three times the reach
}

/// The finder's list depends on positions and memory only: a finder used through the whole run lists the same as a new
/// one.
TEST(ContactFinder, lists_what_a_fresh_finder_lists) {
  Scene scene(1e8, 0.2, 2600.0, 25.0);
  scene.add("floor", rectangle(-3, -1, 9, 0), true);
  scene.add("left", rectangle(-1.5, 0, -0.5, 9), true);
  scene.add("right", rectangle(5.1, 0, 6.1, 9), true);
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    const int row = i / 6;
    scene.add("b", {random_block(random, Vec2(0.92 * (i % 6), 0.5 + 0.92 * row), 0.45), {}});
  }
  ByHand hand(scene.model, scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt));
  StepControl control;
  control.max_displacement = 0.01;
  const double detection = 0.03;
  CentralDifference integrator(*hand.setup, control, detection);
  integrator.enter(hand.state);
  ContactFinder followed(*hand.setup, detection);
  const Tick h = ticks(5e-5);
  int compared = 0;
  std::size_t most = 0, kept = 0;
  for (int step = 0; step < 20000; ++step) {
    ASSERT_EQ(integrator.step(hand.state, h).status, StepReport::Status::ok);
    if (step % 50 != 0) continue;
    ContactFinder fresh(*hand.setup, detection);
    ContactList known, now, again;
    followed.restore(hand.state.contacts.memory, known);
    followed.find(hand.state.q, known, false, now);
    fresh.find(hand.state.q, known, false, again);
    ASSERT_EQ(now.points.size(), again.points.size()) << "step " << step;
    for (std::size_t i = 0; i < now.points.size(); ++i) {
      const ContactPoint &a = now.points[i], &b = again.points[i];
      const ContactMemory &m = now.memory[i], &n = again.memory[i];
      ASSERT_EQ(a.key, b.key);
      ASSERT_EQ(a.from, b.from);
      ASSERT_EQ(a.beside, b.beside);
      ASSERT_EQ(a.segment, b.segment);
      ASSERT_EQ(a.suppressed, b.suppressed);
      ASSERT_EQ(a.beyond, b.beyond);
      ASSERT_EQ(a.edge_edge, b.edge_edge);
      ASSERT_EQ(a.springs, b.springs);
      ASSERT_EQ(m.status, n.status);
      ASSERT_EQ(m.gap, n.gap);
      ASSERT_EQ(m.gap0, n.gap0);
      ASSERT_EQ(m.stretch, n.stretch);
      ASSERT_EQ(m.anchor, n.anchor);
      if (m.status != ContactStatus::open) ++kept;
    }
    most = std::max(most, now.points.size());
    ++compared;
  }
  std::printf("%d lists, the longest of %zu points, %zu closed in all\n", compared, most, kept);
  EXPECT_GT(most, 50U);
  EXPECT_GT(kept, 1000U);
}

}  // namespace
}  // namespace scree::test::search_test
