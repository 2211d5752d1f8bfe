#include "coupling/contact/search.h"

// Bullet's headers use old-style casts and unused parameters freely.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>
#include <limits>

namespace scree::coupling {
namespace {

constexpr double kManyMoved = 0.05;  // of all boxes

/// Pairs worth keeping: segments of different bodies, not both driven, and of the two faces of a crack.
class MayTouch final : public btOverlapFilterCallback {
 public:
  explicit MayTouch(const Setup& setup) : setup_(&setup) {}
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
    const Outlines& o = setup_->outlines();
    const std::int32_t ea = edge_of(a), eb = edge_of(b);
    const Outlines::Edge &of_a = o.edges[static_cast<std::size_t>(ea)], &of_b = o.edges[static_cast<std::size_t>(eb)];
    if (of_a.body == of_b.body) return of_a.opposite == eb;
    const auto driven = [&](std::int32_t body) { return setup_->bodies()[static_cast<std::size_t>(body)].driven; };
    return of_a.touches && of_b.touches && !(driven(of_a.body) && driven(of_b.body)) && of_a.opposite < 0 &&
           of_b.opposite < 0;
  }
  static std::int32_t index_of(const btBroadphaseProxy* p) {
    return static_cast<std::int32_t>(reinterpret_cast<std::intptr_t>(p->m_clientObject));
  }

 private:
  [[nodiscard]] std::int32_t edge_of(const btBroadphaseProxy* p) const {
    return setup_->outlines().segments[static_cast<std::size_t>(index_of(p))].edge;
  }
  const Setup* setup_;
};

}  // namespace

struct Search::Impl {
  Impl(const Setup& s, double r) : setup(&s), reach(r), filter(s) {
    tree.getOverlappingPairCache()->setOverlapFilterCallback(&filter);
  }

  const Setup* setup;
  double reach;
  MayTouch filter;
  btDbvtBroadphase tree;
  std::vector<btBroadphaseProxy*> proxies;
  std::vector<Box> fat;
  std::vector<std::size_t> moved;  // boxes anew
  std::vector<EdgePair> pairs;
};

Search::Search(const Setup& setup, double reach) : impl_(std::make_unique<Impl>(setup, reach)) {}

Search::~Search() {
  // Bullet looks through all pairs for every proxy that goes: none are left for it.
  btOverlappingPairCache* cache = impl_->tree.getOverlappingPairCache();
  for (int n = cache->getNumOverlappingPairs(); n > 0; n = cache->getNumOverlappingPairs()) {
    const btBroadphasePair& last = cache->getOverlappingPairArrayPtr()[n - 1];
    cache->removeOverlappingPair(last.m_pProxy0, last.m_pProxy1, nullptr);
  }
  for (btBroadphaseProxy* p : impl_->proxies) impl_->tree.destroyProxy(p, nullptr);
}

bool Search::refit(std::span<const Vec2> x, bool all) {
  Impl& s = *impl_;
  const Outlines& o = s.setup->outlines();
  const bool first = s.proxies.empty();
  const double need = 0.5 * s.reach, slack = s.reach;  // half the reach on either side of a pair
  if (first) {
    s.fat.resize(o.segments.size());
    s.moved.reserve(o.segments.size());
  }
  s.moved.clear();
  for (std::size_t i = 0; i < o.segments.size(); ++i) {
    const Vec2 &a = x[static_cast<std::size_t>(o.segments[i].a)], &b = x[static_cast<std::size_t>(o.segments[i].b)];
    const Vec2 lo = a.cwiseMin(b).array() - need, hi = a.cwiseMax(b).array() + need;
    Box& fat = s.fat[i];
    if (!first && !all && (lo.array() >= fat.lo.array()).all() && (hi.array() <= fat.hi.array()).all()) continue;
    s.moved.push_back(i);
    fat.lo = lo.array() - slack;
    fat.hi = hi.array() + slack;
  }
  // A few boxes look for their pairs one by one; of many it is cheaper to hold the tree against itself once.
  s.tree.m_deferedcollide = kManyMoved * static_cast<double>(o.segments.size()) < static_cast<double>(s.moved.size());
  for (const std::size_t i : s.moved) {
    const Box& fat = s.fat[i];
    const btVector3 low(fat.lo.x(), fat.lo.y(), -1.0), high(fat.hi.x(), fat.hi.y(), 1.0);
    if (first) {
      s.proxies.push_back(s.tree.createProxy(low, high, 0,
                                             reinterpret_cast<void*>(i),  // NOLINT(performance-no-int-to-ptr)
                                             btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter, nullptr));
    } else {
      s.tree.setAabb(s.proxies[i], low, high, nullptr);
    }
  }
  return !s.moved.empty();
}

std::span<const EdgePair> Search::update(std::span<const Vec2> x) {
  if (refit(x, false)) collect();
  return impl_->pairs;
}

double Search::room_between_bodies(std::span<const Vec2> x) const {
  constexpr std::size_t kMany = 64;  // bodies; pairs of their boxes are looked at one by one
  const Setup& setup = *impl_->setup;
  const Outlines& o = setup.outlines();
  const std::size_t count = setup.bodies().size();
  const bool cracked =
      std::any_of(o.edges.begin(), o.edges.end(), [](const Outlines::Edge& e) { return e.opposite >= 0; });
  if (count > kMany || cracked) return 0.0;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<Box, kMany> box;
  for (std::size_t b = 0; b < count; ++b) box[b] = {Vec2(kFar, kFar), Vec2(-kFar, -kFar)};
  for (std::size_t i = 0; i < x.size(); ++i) {
    Box& b = box[static_cast<std::size_t>(o.node_body[i])];
    b.lo = b.lo.cwiseMin(x[i]);
    b.hi = b.hi.cwiseMax(x[i]);
  }
  double least = kFar;
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b) {
      if (setup.bodies()[a].driven && setup.bodies()[b].driven) continue;
      least = std::min(least, (box[a].lo - box[b].hi).cwiseMax(box[b].lo - box[a].hi).maxCoeff());
    }
  // update() lists boxes nearer than its fattening, half the reach and the slack on either side; both bodies may move.
  return 0.5 * (least - 3.0 * impl_->reach);
}

double Search::clearance(std::span<const Vec2> x) {
  if (!impl_->pairs.empty()) return 0.0;
  if (const double room = room_between_bodies(x); room > 0.0) return room;
  (void)refit(x, true);
  collect();
  return impl_->pairs.empty() ? impl_->reach : 0.0;  // the slack of every box
}

void Search::collect() {
  Impl& s = *impl_;
  const Outlines& o = s.setup->outlines();
  s.tree.calculateOverlappingPairs(nullptr);
  btOverlappingPairCache* cache = s.tree.getOverlappingPairCache();
  s.pairs.clear();
  const btBroadphasePair* found = cache->getOverlappingPairArrayPtr();
  for (int i = 0; i < cache->getNumOverlappingPairs(); ++i) {
    const auto edge = [&](const btBroadphaseProxy* proxy) {
      return o.segments[static_cast<std::size_t>(MayTouch::index_of(proxy))].edge;
    };
    const auto [a, b] = std::minmax({edge(found[i].m_pProxy0), edge(found[i].m_pProxy1)});
    s.pairs.push_back({a, b});
  }
  std::sort(s.pairs.begin(), s.pairs.end());
  s.pairs.erase(std::unique(s.pairs.begin(), s.pairs.end()), s.pairs.end());
}

}  // namespace scree::coupling
