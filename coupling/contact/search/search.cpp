#include "coupling/contact/search/search.h"

#include <algorithm>
#include <array>
#include <limits>

#include "coupling/contact/search/box_tree.h"

namespace scree::coupling {
namespace {

constexpr double kManyMoved = 0.05;   // of all boxes
constexpr std::int32_t kAhead = 200;  // nodes
constexpr double kFar = std::numeric_limits<double>::infinity();

/// Data that decide whether two segments may touch, contiguous in memory.
struct Owner {
  EdgeIndex edge, opposite;
  BodyIndex body;
  bool touches, touched;
};

/// Pairs worth keeping: segments of different bodies, one of which contact forces move, and of the two faces of a
/// crack.
bool may_touch(const Owner& a, const Owner& b) {
  if (a.body == b.body) return a.opposite == b.edge;
  return a.touches && b.touches && (a.touched || b.touched) && !a.opposite.valid() && !b.opposite.valid();
}

/// The segment of a box in the tree.
SegmentIndex segment_of(std::size_t box) { return SegmentIndex::of(box); }

/// Two segments whose boxes overlap.
struct SegmentPair {
  SegmentIndex a, b;
};

}  // namespace

struct Search::Impl {
  Impl(const Setup& s, double r);

  /// Makes the box of a segment anew, with the slack around it.
  void fatten(SegmentIndex segment, OutlinePositions x);
  /// Sets the range of a node within the boxes of its segments.
  void set_room(OutlineNode node);
  void list_all();
  /// Lists the pairs of the boxes that moved anew.
  void list_moved();
  /// Makes pairs of edges: by the first edge in one pass, then the few of each.
  void sort();

  const Setup* setup;
  double reach;
  IndexedVector<SegmentIndex, Owner> owners;
  IndexedVector<OutlineNode, std::size_t> first;  // its first in segments_at, and the end
  std::vector<SegmentIndex> segments_at;
  IndexedVector<SegmentIndex, Box> fat;
  IndexedVector<OutlineNode, Box> room;  // in all boxes of its segments, half the reach away from their sides
  std::unique_ptr<BoxTree> tree;
  std::vector<SegmentIndex> moved;  // with new boxes
  IndexedVector<SegmentIndex, char> has_moved;
  std::vector<SegmentPair> near;
  std::vector<EdgePair> pairs;
  IndexedVector<EdgeIndex, std::size_t> first_pair;  // its first in pairs, while they are sorted
};

Search::Impl::Impl(const Setup& s, double r) : setup(&s), reach(r) {
  const Outlines& o = s.outlines();
  for (const Outlines::Segment& segment : o.segments) {
    const Outlines::Edge& e = o.edges[segment.edge];
    owners.push_back({segment.edge, e.opposite, e.body, e.touches, s.body(e.body).touched});
  }
  first.resize(o.nodes.size() + 2);  // counts are one place further on, so that filling leaves the first ones
  for (const Outlines::Segment& segment : o.segments)
    for (const OutlineNode node : {segment.a, segment.b}) ++first[node + 2];
  std::vector<std::size_t>& first_of = first.values();
  for (std::size_t i = 2; i < first_of.size(); ++i) first_of[i] += first_of[i - 1];
  segments_at.resize(first.back());
  for (const SegmentIndex i : o.segments.indices())
    for (const OutlineNode node : {o.segments[i].a, o.segments[i].b}) segments_at[first[node + 1]++] = i;
  fat.resize(o.segments.size());
  room.resize(o.nodes.size());
  moved.reserve(o.segments.size());
  has_moved.resize(o.segments.size());
  first_pair.resize(o.edges.size() + 1);
}

void Search::Impl::fatten(SegmentIndex segment, OutlinePositions x) {
  const Outlines::Segment& s = setup->outlines().segments[segment];
  const Vec2 &a = x[s.a], &b = x[s.b];
  const double around = 1.5 * reach;  // half the reach on either side of a pair, and as much slack as the reach
  fat[segment] = {a.cwiseMin(b).array() - around, a.cwiseMax(b).array() + around};
}

void Search::Impl::set_room(OutlineNode node) {
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
    const SegmentPair pair{segment_of(a), segment_of(b)};
    if (may_touch(owners[pair.a], owners[pair.b])) near.push_back(pair);
  });
}

void Search::Impl::list_moved() {
  std::erase_if(near, [&](const SegmentPair& p) { return has_moved[p.a] != 0 || has_moved[p.b] != 0; });
  for (const SegmentIndex a : moved)
    tree->for_overlaps_of(a.index(), [&](std::size_t box) {
      const SegmentIndex b = segment_of(box);
      const bool listed = has_moved[b] != 0 && b < a;
      if (!listed && may_touch(owners[a], owners[b])) near.push_back({a, b});
    });
}

void Search::Impl::sort() {
  first_pair.assign(first_pair.size(), 0);
  const auto edges = [&](const SegmentPair& p) { return std::minmax(owners[p.a].edge, owners[p.b].edge); };
  for (const SegmentPair& p : near) ++first_pair[edges(p).first + 1];
  std::vector<std::size_t>& first_of = first_pair.values();
  for (std::size_t e = 1; e < first_of.size(); ++e) first_of[e] += first_of[e - 1];
  pairs.resize(near.size());
  for (const SegmentPair& p : near) {
    const auto [a, b] = edges(p);
    pairs[first_pair[a]++] = {a, b};
  }
  for (auto begin = pairs.begin(), end = begin; begin != pairs.end(); begin = end) {
    while (end != pairs.end() && end->a == begin->a) ++end;
    std::sort(begin, end);
  }
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

Search::Search(const Setup& setup, double reach) : impl_(std::make_unique<Impl>(setup, reach)) {}

Search::~Search() = default;

bool Search::refit(OutlinePositions x, bool all) {
  Impl& s = *impl_;
  const Outlines& o = s.setup->outlines();
  const auto note = [&](SegmentIndex segment) {
    if (s.has_moved[segment] != 0) return;
    s.has_moved[segment] = 1;
    s.moved.push_back(segment);
  };
  for (const SegmentIndex i : s.moved) s.has_moved[i] = 0;
  s.moved.clear();
  const auto look = [&](IndexRange<OutlineNode> nodes) {
    for (const OutlineNode n : nodes) {
      // Processors do not prefetch from one page of memory to the next by themselves.
      if (n + kAhead < nodes.end_index()) {
        __builtin_prefetch(&s.room[n + kAhead]);
        __builtin_prefetch(&x[n + kAhead]);
      }
      const Box& room = s.room[n];
      if ((x[n].array() >= room.lo.array()).all() && (x[n].array() <= room.hi.array()).all()) continue;
      for (std::size_t k = s.first[n]; k < s.first[n + 1]; ++k) note(s.segments_at[k]);
    }
  };
  if (all || s.tree == nullptr)
    for (const SegmentIndex i : o.segments.indices()) note(i);
  else
    for (const IndexRange<OutlineNode> r : o.moving_nodes) look(r);
  for (const SegmentIndex i : s.moved) s.fatten(i, x);
  for (const SegmentIndex i : s.moved)
    for (const OutlineNode node : {o.segments[i].a, o.segments[i].b}) s.set_room(node);
  return !s.moved.empty();
}

std::span<const EdgePair> Search::update(OutlinePositions x) {
  if (refit(x, false)) collect();
  return impl_->pairs;
}

double Search::room_between_bodies(OutlinePositions x) const {
  constexpr std::size_t kMany = 64;  // bodies; pairs of their boxes are tested one by one
  const Setup& setup = *impl_->setup;
  const Outlines& o = setup.outlines();
  const std::size_t count = setup.bodies().size();
  const bool cracked =
      std::any_of(o.edges.begin(), o.edges.end(), [](const Outlines::Edge& e) { return e.opposite.valid(); });
  if (count > kMany || cracked) return 0.0;
  std::array<Box, kMany> box;
  for (std::size_t b = 0; b < count; ++b) box[b] = {Vec2(kFar, kFar), Vec2(-kFar, -kFar)};
  for (const OutlineNode i : o.nodes.indices()) {
    Box& b = box[o.node_body[i].index()];
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

double Search::clearance(OutlinePositions x) {
  if (!impl_->pairs.empty()) return 0.0;
  if (const double room = room_between_bodies(x); room > 0.0) return room;
  (void)refit(x, true);
  collect();
  return impl_->pairs.empty() ? impl_->reach : 0.0;  // the slack of every box
}

void Search::collect() {
  Impl& s = *impl_;
  // For a few boxes the pairs are searched box by box; for many it is cheaper to test the tree against itself once.
  const bool many = kManyMoved * static_cast<double>(s.fat.size()) < static_cast<double>(s.moved.size());
  if (s.tree == nullptr) {
    s.tree = std::make_unique<BoxTree>(s.fat.values());
  } else if (many) {
    for (const SegmentIndex i : s.moved) s.tree->place(i.index(), s.fat[i]);
    s.tree->refit();
  } else {
    for (const SegmentIndex i : s.moved) s.tree->move(i.index(), s.fat[i]);
  }
  if (many)
    s.list_all();
  else
    s.list_moved();
  s.sort();
  ++times_listed_;
}

}  // namespace scree::coupling
