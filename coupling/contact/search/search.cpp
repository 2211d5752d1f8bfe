#include "coupling/contact/search/search.h"

#include <algorithm>
#include <array>
#include <limits>

#include "coupling/contact/search/box_tree.h"

namespace scree::coupling {
namespace {

constexpr double kManyMoved = 0.05;  // of all boxes
constexpr std::size_t kAhead = 200;  // nodes
constexpr double kFar = std::numeric_limits<double>::infinity();

/// What decides whether two segments may touch, close together.
struct Owner {
  std::int32_t edge, body, opposite;
  bool touches, touched;
};

/// Pairs worth keeping: segments of different bodies, one of which contact forces move, and of the two faces of a
/// crack.
bool may_touch(const Owner& a, const Owner& b) {
  if (a.body == b.body) return a.opposite == b.edge;
  return a.touches && b.touches && (a.touched || b.touched) && a.opposite < 0 && b.opposite < 0;
}

/// Two segments whose boxes overlap.
struct SegmentPair {
  std::uint32_t a, b;
};

}  // namespace

struct Search::Impl {
  Impl(const Setup& s, double r);

  /// Makes the box of a segment anew, with the slack around it.
  void fatten(std::size_t segment, std::span<const Vec2> x);
  /// Where a node may be without leaving the boxes of its segments.
  void set_room(std::size_t node);
  void list_all();
  /// Lists the pairs of the boxes that moved anew.
  void list_moved();
  /// Makes pairs of edges: by the first edge in one pass, then the few of each.
  void sort();

  const Setup* setup;
  double reach;
  std::vector<Owner> owners;       // of segments
  std::vector<std::size_t> first;  // per node: its first in segments_at, and the end
  std::vector<std::size_t> segments_at;
  std::vector<Box> fat;   // of segments
  std::vector<Box> room;  // of nodes: in all boxes of its segments, half the reach away from their sides
  std::unique_ptr<BoxTree> tree;
  std::vector<std::size_t> moved;  // boxes anew
  std::vector<char> has_moved;     // of segments
  std::vector<SegmentPair> near;
  std::vector<EdgePair> pairs;
  std::vector<std::size_t> first_pair;  // an edge: its first in pairs, while they are sorted
};

Search::Impl::Impl(const Setup& s, double r) : setup(&s), reach(r) {
  const Outlines& o = s.outlines();
  for (const Outlines::Segment& segment : o.segments) {
    const Outlines::Edge& e = o.edges[static_cast<std::size_t>(segment.edge)];
    const bool touched = s.bodies()[static_cast<std::size_t>(e.body)].touched;
    owners.push_back({segment.edge, e.body, e.opposite, e.touches, touched});
  }
  first.resize(o.nodes.size() + 2);  // counted one further on, so that filling leaves the first ones
  for (const Outlines::Segment& segment : o.segments)
    for (const std::int32_t node : {segment.a, segment.b}) ++first[static_cast<std::size_t>(node) + 2];
  for (std::size_t i = 2; i < first.size(); ++i) first[i] += first[i - 1];
  segments_at.resize(first.back());
  for (std::size_t i = 0; i < o.segments.size(); ++i)
    for (const std::int32_t node : {o.segments[i].a, o.segments[i].b})
      segments_at[first[static_cast<std::size_t>(node) + 1]++] = i;
  fat.resize(o.segments.size());
  room.resize(o.nodes.size());
  moved.reserve(o.segments.size());
  has_moved.resize(o.segments.size());
  first_pair.resize(o.edges.size() + 1);
}

void Search::Impl::fatten(std::size_t segment, std::span<const Vec2> x) {
  const Outlines::Segment& s = setup->outlines().segments[segment];
  const Vec2 &a = x[static_cast<std::size_t>(s.a)], &b = x[static_cast<std::size_t>(s.b)];
  const double around = 1.5 * reach;  // half the reach on either side of a pair, and as much slack as the reach
  fat[segment] = {a.cwiseMin(b).array() - around, a.cwiseMax(b).array() + around};
}

void Search::Impl::set_room(std::size_t node) {
  Box& box = room[node] = {Vec2(-kFar, -kFar), Vec2(kFar, kFar)};
  for (std::size_t k = first[node]; k < first[node + 1]; ++k) {
    box.lo = box.lo.cwiseMax(fat[segments_at[k]].lo);
    box.hi = box.hi.cwiseMin(fat[segments_at[k]].hi);
  }
  box.lo.array() += 0.5 * reach;
  box.hi.array() -= 0.5 * reach;
}

void Search::Impl::list_all() {
  near.clear();
  tree->for_overlaps([&](std::size_t a, std::size_t b) {
    if (may_touch(owners[a], owners[b])) near.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
  });
}

void Search::Impl::list_moved() {
  std::erase_if(near, [&](const SegmentPair& p) { return has_moved[p.a] != 0 || has_moved[p.b] != 0; });
  for (const std::size_t a : moved)
    tree->for_overlaps_of(a, [&](std::size_t b) {
      const bool listed = has_moved[b] != 0 && b < a;
      if (!listed && may_touch(owners[a], owners[b]))
        near.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    });
}

void Search::Impl::sort() {
  std::fill(first_pair.begin(), first_pair.end(), 0);
  const auto edges = [&](const SegmentPair& p) { return std::minmax(owners[p.a].edge, owners[p.b].edge); };
  for (const SegmentPair& p : near) ++first_pair[static_cast<std::size_t>(edges(p).first) + 1];
  for (std::size_t e = 1; e < first_pair.size(); ++e) first_pair[e] += first_pair[e - 1];
  pairs.resize(near.size());
  for (const SegmentPair& p : near) {
    const auto [a, b] = edges(p);
    pairs[first_pair[static_cast<std::size_t>(a)]++] = {a, b};
  }
  for (auto begin = pairs.begin(), end = begin; begin != pairs.end(); begin = end) {
    while (end != pairs.end() && end->a == begin->a) ++end;
    std::sort(begin, end);
  }
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

Search::Search(const Setup& setup, double reach) : impl_(std::make_unique<Impl>(setup, reach)) {}

Search::~Search() = default;

bool Search::refit(std::span<const Vec2> x, bool all) {
  Impl& s = *impl_;
  const Outlines& o = s.setup->outlines();
  const auto note = [&](std::size_t segment) {
    if (s.has_moved[segment] != 0) return;
    s.has_moved[segment] = 1;
    s.moved.push_back(segment);
  };
  for (const std::size_t i : s.moved) s.has_moved[i] = 0;
  s.moved.clear();
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      // Processors do not look ahead from one page of memory to the next by themselves.
      if (n + kAhead < end) {
        __builtin_prefetch(&s.room[n + kAhead]);
        __builtin_prefetch(&x[n + kAhead]);
      }
      const Box& room = s.room[n];
      if ((x[n].array() >= room.lo.array()).all() && (x[n].array() <= room.hi.array()).all()) continue;
      for (std::size_t k = s.first[n]; k < s.first[n + 1]; ++k) note(s.segments_at[k]);
    }
  };
  if (all || s.tree == nullptr)
    for (std::size_t i = 0; i < o.segments.size(); ++i) note(i);
  else
    for (const Outlines::Range& r : o.moving_nodes)
      look(static_cast<std::size_t>(r.begin), static_cast<std::size_t>(r.end));
  for (const std::size_t i : s.moved) s.fatten(i, x);
  for (const std::size_t i : s.moved)
    for (const std::int32_t node : {o.segments[i].a, o.segments[i].b}) s.set_room(static_cast<std::size_t>(node));
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
      if (!setup.can_touch(a, b)) continue;
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
  // A few boxes look for their pairs one by one; of many it is cheaper to hold the tree against itself once.
  const bool many = kManyMoved * static_cast<double>(s.fat.size()) < static_cast<double>(s.moved.size());
  if (s.tree == nullptr)
    s.tree = std::make_unique<BoxTree>(s.fat);
  else if (many)
    s.tree->move(s.moved, s.fat);
  else
    for (const std::size_t i : s.moved) s.tree->move(i, s.fat[i]);
  if (many)
    s.list_all();
  else
    s.list_moved();
  s.sort();
  ++times_listed_;
}

}  // namespace scree::coupling
