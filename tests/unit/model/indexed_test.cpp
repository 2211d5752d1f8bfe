// Typed indices and the vectors and spans that accept them.
#include "model/indexed.h"

#include <gtest/gtest.h>

#include <array>
#include <concepts>
#include <vector>

namespace scree::test::indexed_test {
namespace {

using Fruit = Id<struct FruitTag>;
using Tree = Id<struct TreeTag>;

template <class Array, class Index>
concept takes = requires(Array array, Index i) {
  array[i];
};

// The index of another kind, or a plain number, does not compile.
static_assert(takes<IndexedVector<Fruit, double>, Fruit>);
static_assert(!takes<IndexedVector<Fruit, double>, Tree>);
static_assert(!takes<IndexedVector<Fruit, double>, std::size_t>);
static_assert(!takes<IndexedVector<Fruit, double>, int>);
static_assert(takes<IndexedSpan<Fruit, const double>, Fruit>);
static_assert(!takes<IndexedSpan<Fruit, const double>, Tree>);
static_assert(!takes<IndexedSpan<Fruit, const double>, std::size_t>);
static_assert(!std::equality_comparable_with<Fruit, Tree>);
static_assert(!std::convertible_to<IndexedVector<Fruit, double>, IndexedSpan<Tree, const double>>);
static_assert(!std::convertible_to<int, Fruit>);
// An index has the size of a plain number.
static_assert(sizeof(Fruit) == sizeof(std::int32_t));

TEST(Indexed, values_are_found_by_the_index_they_were_given) {
  IndexedVector<Fruit, int> v;
  EXPECT_TRUE(v.empty());
  const Fruit first = v.next();
  v.push_back(7);
  const Fruit second = v.next();
  v.push_back(8);
  EXPECT_EQ(v.last(), second);
  EXPECT_EQ(v[first], 7);
  EXPECT_EQ(v[second], 8);
  v[first] = 9;
  EXPECT_EQ(v.values(), (std::vector<int>{9, 8}));
  EXPECT_EQ(v.back(), 8);
  EXPECT_EQ(Fruit::of(1), second);
}

TEST(Indexed, sizes_and_fills_as_a_vector_does) {
  EXPECT_EQ((IndexedVector<Fruit, int>(3).values()), (std::vector<int>{0, 0, 0}));
  IndexedVector<Fruit, int> v(2, 5);
  EXPECT_EQ(v.values(), (std::vector<int>{5, 5}));
  v.assign(1, 4);
  v.resize(2);
  EXPECT_EQ(v.values(), (std::vector<int>{4, 0}));
  EXPECT_EQ(v.size(), 2U);
}

TEST(Indexed, indices_go_through_a_vector_in_order) {
  IndexedVector<Fruit, int> v(4, 0);
  int at = 0;
  for (const Fruit i : v.indices()) v[i] = at++;
  EXPECT_EQ(v.values(), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(v.indices().size(), 4);
  for (const Fruit i : IndexRange(Fruit{1}, Fruit{3})) v[i] = -1;
  EXPECT_EQ(v.values(), (std::vector<int>{0, -1, -1, 3}));
  EXPECT_EQ((IndexRange<Fruit>().size()), 0);
}

TEST(Indexed, places_after_and_before_an_index) {
  const Fruit i{5};
  EXPECT_EQ(i + 2, Fruit{7});
  EXPECT_EQ(i - 5, Fruit{0});
  EXPECT_EQ((i + 3) - i, 3);
  EXPECT_FALSE((i - 6).valid());
}

TEST(Indexed, spans_see_what_a_vector_holds) {
  IndexedVector<Fruit, int> v(3, 1);
  const IndexedSpan<Fruit, const int> s = v;
  v[Fruit{2}] = 6;
  EXPECT_EQ(s[Fruit{2}], 6);
  EXPECT_EQ(s.size(), 3U);
  std::array numbers{1, 2};
  const IndexedSpan<Tree, int> t{std::span<int>(numbers)};
  t[Tree{0}] = 3;
  EXPECT_EQ(numbers[0], 3);
}

}  // namespace
}  // namespace scree::test::indexed_test
