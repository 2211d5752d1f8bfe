// Loops on threads whose results do not depend on the number of threads.
#include "model/parallel.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

namespace scree::parallel_test {
namespace {

/// of(threads) with one, two and three threads.
template <class Of>
void with_threads(Of&& of) {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    of(threads);
  }
  omp_set_num_threads(before);
}

TEST(Parallel, lists_in_the_order_of_the_items) {
  std::vector<std::vector<int>> by_chunk;
  std::vector<int> out, expected;
  constexpr int kItems = 20'000;
  for (int i = 0; i < kItems; ++i)
    for (int k = 0; k < i % 3; ++k) expected.push_back(10 * i + k);
  with_threads([&](int threads) {
    parallel_list(kItems, by_chunk, out, [](std::int64_t i, std::vector<int>& list) {
      for (int k = 0; k < static_cast<int>(i) % 3; ++k) list.push_back(10 * static_cast<int>(i) + k);
    });
    EXPECT_EQ(out, expected) << threads;
  });
  parallel_list(0, by_chunk, out, [](std::int64_t, std::vector<int>&) {});
  EXPECT_TRUE(out.empty());
}

TEST(Parallel, finds_the_largest_wherever_it_is) {
  const auto of = [](std::int64_t at) {
    return [at](std::int64_t i) { return i == at ? 7.5 : std::sin(static_cast<double>(i)); };
  };
  with_threads([&](int threads) {
    for (const std::int64_t n : {10, 4096, 9999})
      for (const std::int64_t at : {std::int64_t{0}, n / 2, n - 1})
        EXPECT_EQ(parallel_largest(n, of(at)), 7.5) << threads;
    EXPECT_EQ(parallel_largest(0, of(0)), 0.0);
    EXPECT_EQ(parallel_largest(5000, [](std::int64_t) { return -1.0; }), 0.0);
  });
}

TEST(Parallel, parts_cover_all_slots_once_and_each_takes_the_chunks_that_reach_it) {
  with_threads([&](int threads) {
    for (const std::int32_t n : {0, 1, 2, 100}) {
      std::vector<int> times(static_cast<std::size_t>(n), 0);
      parallel_parts(n, true, [&](std::int64_t part, std::int32_t begin, std::int32_t end) {
        EXPECT_LT(part, threads);
        for (std::int32_t i = begin; i < end; ++i) ++times[static_cast<std::size_t>(i)];
      });
      EXPECT_EQ(times, std::vector<int>(static_cast<std::size_t>(n), 1)) << threads;
    }
    parallel_parts(10, false, [](std::int64_t part, std::int32_t begin, std::int32_t end) {
      EXPECT_EQ(part, 0);
      EXPECT_EQ(begin, 0);
      EXPECT_EQ(end, 10);
    });
  });
  Reach reach;
  EXPECT_FALSE(reach.meets(0, 100));
  reach.take(7);
  reach.take(4);
  EXPECT_TRUE(reach.meets(7, 9));
  EXPECT_TRUE(reach.meets(0, 5));
  EXPECT_FALSE(reach.meets(8, 9));
  EXPECT_FALSE(reach.meets(0, 4));
}

TEST(Parallel, sums_have_the_same_bits) {
  std::vector<double> partial;
  double one = 0.0;
  with_threads([&](int threads) {
    const double sum = parallel_sum(
        30'000, partial,
        [](std::int64_t begin, std::int64_t end) {
          double out = 0.0;
          for (std::int64_t i = begin; i < end; ++i) out += 1.0 / (1.0 + static_cast<double>(i));
          return out;
        },
        100);
    if (threads == 1) one = sum;
    EXPECT_EQ(sum, one) << threads;
  });
  EXPECT_NEAR(one, std::log(30'000.0) + 0.5772156649, 2e-5);
}

}  // namespace
}  // namespace scree::parallel_test
