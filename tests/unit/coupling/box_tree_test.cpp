// Overlaps of moving boxes against the test of all pairs.
#include "coupling/contact/search/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace scree::coupling::box_tree_test {
namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

bool overlap(const Box& a, const Box& b) {
  return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

Pairs by_hand(const std::vector<Box>& boxes) {
  Pairs out;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (overlap(boxes[i], boxes[j])) out.emplace(i, j);
  return out;
}

Pairs listed(BoxTree& tree, std::size_t& calls) {
  Pairs out;
  calls = 0;
  tree.for_overlaps([&](std::size_t i, std::size_t j) {
    out.emplace(std::min(i, j), std::max(i, j));
    ++calls;
  });
  return out;
}

TEST(BoxTree, overlaps_are_those_of_all_pairs_as_boxes_move) {
  std::mt19937_64 random(51);
  std::uniform_real_distribution<double> place(0.0, 20.0), size(0.1, 1.5), step(-0.4, 0.4);
  std::vector<Box> boxes(300);
  for (Box& b : boxes) {
    b.lo = Vec2(place(random), place(random));
    b.hi = b.lo + Vec2(size(random), size(random));
  }
  BoxTree tree(boxes);
  for (int round = 0; round < 40; ++round) {
    std::size_t calls = 0;
    const Pairs expected = by_hand(boxes), found = listed(tree, calls);
    ASSERT_EQ(found, expected) << round;
    ASSERT_EQ(calls, expected.size()) << round;  // every overlap once
    ASSERT_GT(calls, 100U);
    for (const std::size_t i : {std::size_t{0}, std::size_t{17}, boxes.size() - 1}) {
      std::set<std::size_t> others;
      tree.for_overlaps_of(i, [&](std::size_t j) { EXPECT_TRUE(others.insert(j).second); });
      for (std::size_t j = 0; j < boxes.size(); ++j)
        EXPECT_EQ(others.contains(j), j != i && overlap(boxes[i], boxes[j])) << i << ", " << j;
    }
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (round % 2 == 0 && i % 7 != 0) continue;
      const Vec2 way(step(random), step(random));
      boxes[i].lo += way;
      boxes[i].hi += way;
      if (round % 2 == 0)
        tree.move(i, boxes[i]);
      else
        moved.push_back(i);
    }
    for (const std::size_t i : moved) tree.place(i, boxes[i]);
    if (!moved.empty()) tree.refit();
  }
}

}  // namespace
}  // namespace scree::coupling::box_tree_test
