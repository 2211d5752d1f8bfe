// Items sorted into buckets on threads, against a stable sort.
#include "model/buckets.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <numeric>

namespace scree::buckets_test {
namespace {

/// Buckets of items that are nearly in their order, as contact points are in that of their edges.
std::vector<std::int32_t> nearly_in_order(std::int32_t items, std::int32_t buckets) {
  std::vector<std::int32_t> out;
  std::uint32_t random = 7;
  for (std::int32_t i = 0; i < items; ++i) {
    random = 1664525U * random + 1013904223U;
    const auto near = static_cast<std::int32_t>(std::int64_t{i} * buckets / items);
    out.push_back(std::clamp(near + static_cast<std::int32_t>((random >> 16) % 41) - 20, 0, buckets - 1));
  }
  return out;
}

TEST(Buckets, keep_the_order_of_the_items_on_any_number_of_threads) {
  constexpr std::int32_t kItems = 5000, kBuckets = 1300;
  const std::vector<std::int32_t> bucket_of = nearly_in_order(kItems, kBuckets);
  std::vector<std::int32_t> expected(kItems);
  std::iota(expected.begin(), expected.end(), 0);
  std::stable_sort(expected.begin(), expected.end(), [&](std::int32_t a, std::int32_t b) {
    return bucket_of[static_cast<std::size_t>(a)] < bucket_of[static_cast<std::size_t>(b)];
  });
  const int before = omp_get_max_threads();
  Buckets buckets;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    std::vector<std::int32_t> first(kBuckets + 1, -1), sorted(kItems, -1);
    const auto for_items = [&](std::int32_t begin, std::int32_t end, auto&& see) {
      for (std::int32_t i = 0; i < kItems; ++i)
        if (const std::int32_t b = bucket_of[static_cast<std::size_t>(i)]; b >= begin && b < end) see(b, i);
    };
    buckets.sort(first, true, for_items,
                 [&](std::int32_t place, std::int32_t i) { sorted[static_cast<std::size_t>(place)] = i; });
    EXPECT_EQ(sorted, expected) << threads;
    for (std::int32_t b = 0; b <= kBuckets; ++b)
      EXPECT_EQ(first[static_cast<std::size_t>(b)],
                std::count_if(bucket_of.begin(), bucket_of.end(), [b](std::int32_t other) { return other < b; }))
          << threads << " threads, bucket " << b;
  }
  omp_set_num_threads(before);
}

TEST(Buckets, may_all_be_empty) {
  Buckets buckets;
  std::vector<std::int32_t> first(4, -1);
  buckets.sort(
      first, false, [](std::int32_t, std::int32_t, auto&&) {}, [](std::int32_t, std::int32_t) { FAIL(); });
  EXPECT_EQ(first, (std::vector<std::int32_t>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace scree::buckets_test
