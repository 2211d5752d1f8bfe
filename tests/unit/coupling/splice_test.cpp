// Points replaced in place, against a list made anew; and the index of contacts that follows from it.
#include "coupling/contact/table/splice.h"

#include <gtest/gtest.h>

#include <numeric>

namespace scree::coupling::splice_test {
namespace {

/// A list of points, each with its vertex, and some vertices with other points than before.
class SpliceTest : public ::testing::Test {
 protected:
  /// @param points    of each vertex before   @param now  the same after, -1 where the vertex has not changed
  void change(const std::vector<int>& points, const std::vector<int>& now) {
    std::int32_t at = 0, made = 0;
    before_.resize(static_cast<std::size_t>(std::accumulate(points.begin(), points.end(), 0)));
    std::iota(before_.begin(), before_.end(), 0);
    splice_.begin(before_.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      const std::int32_t end = at + points[v];
      if (now[v] < 0) {
        for (std::int32_t i = at; i < end; ++i) expected_.push_back(i);
      } else {
        for (int k = 0; k < now[v]; ++k) expected_.push_back(kNew + made + k);
        splice_.replace({VertexIndex::of(v), at, end, made, now[v]});
        made += now[v];
      }
      at = end;
    }
  }
  /// before_ after the splice, with the numbers of the new points.
  [[nodiscard]] std::vector<int> spliced() const {
    std::vector<int> out = before_;
    splice_.move(out);
    splice_.for_new([&](std::size_t place, std::size_t k) { out[place] = kNew + static_cast<int>(k); });
    return out;
  }

  static constexpr int kNew = 1000;
  Splice splice_;
  std::vector<int> before_, expected_;
};

TEST_F(SpliceTest, points_that_stay_keep_their_order_whether_others_gain_or_lose) {
  for (const std::vector<int>& now : std::vector<std::vector<int>>{{-1, 3, -1, -1, 0, -1},
                                                                   {-1, 0, -1, -1, 4, -1},
                                                                   {5, -1, -1, 0, 0, 6},
                                                                   {0, 0, 7, -1, 0, 0},
                                                                   {-1, -1, 2, -1, -1, -1},
                                                                   {0, 0, 0, 0, 0, 0},
                                                                   {9, 0, 9, 0, 9, 0},
                                                                   {-1, -1, -1, -1, -1, -1}}) {
    expected_.clear();
    change({2, 1, 2, 3, 2, 1}, now);
    EXPECT_EQ(splice_.size(), expected_.size());
    EXPECT_EQ(spliced(), expected_);
    EXPECT_EQ(splice_.empty(), splice_.changed().empty());
  }
}

TEST_F(SpliceTest, tells_which_points_have_moved_and_by_how_much) {
  change({2, 1, 2, 3, 2, 1}, {-1, 3, -1, 1, -1, -1});  // two more from vertex 2 on, as many as before from vertex 4 on
  std::vector<std::pair<std::size_t, std::int32_t>> moved;
  splice_.for_moved([&](std::size_t place, std::int32_t shift) { moved.emplace_back(place, shift); });
  EXPECT_EQ(moved, (std::vector<std::pair<std::size_t, std::int32_t>>{{5, 2}, {6, 2}}));
  EXPECT_EQ(splice_.shift_after(0), 2);
  EXPECT_EQ(splice_.shift_after(1), 0);
}

}  // namespace
}  // namespace scree::coupling::splice_test
