// The search for a factor of safety against slopes whose factor is known.
#include "app/fos/fos_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace scree::app::fos_search_test {
namespace {

using State = FosSearch::State;
using Slope = std::function<Trial(double)>;

/// A block whose acceleration is g (sin a - cos a tan(phi)/F).
Slope sliding(double factor) {
  return [factor](double f) {
    return Trial{f < factor ? Verdict::stable : Verdict::failed, std::max(0.0, 5.0 * (1.0 - factor / f))};
  };
}

/// Runs a search to its end.   @return number of runs
int carry_out(FosSearch& search, const Slope& slope) {
  int runs = 0;
  for (std::vector<double> next = search.next(); !next.empty(); next = search.next()) {
    EXPECT_LE(next.size(), 2U);
    std::map<double, Trial> results;
    for (const double f : next) results[f] = slope(f);
    runs += static_cast<int>(next.size());
    search.take(results);
    if (runs > 60) {
      ADD_FAILURE() << "it does not end";
      break;
    }
  }
  return runs;
}

TEST(FosSearch, brackets_a_factor_wherever_it_is) {
  for (const double factor : {1.003, 1.2345, 1.41, 2.6, 7.77}) {
    FosSearch search({0.1, 10.0, 0.01}, 1.0);
    const int runs = carry_out(search, sliding(factor));
    EXPECT_EQ(search.state(), State::found);
    EXPECT_LE(search.stands(), factor);
    EXPECT_GE(search.fails(), factor);
    EXPECT_LE(search.fails() - search.stands(), 0.01 + 1e-9);
    EXPECT_LE(runs, 12) << factor;
    EXPECT_FALSE(search.inconsistent());
  }
}

TEST(FosSearch, a_guess_from_accelerations_saves_runs) {
  FosSearch with({0.1, 10.0, 0.01}, 1.0), without({0.1, 10.0, 0.01}, 1.0);
  const Slope blind = [](double f) { return Trial{f < 1.2345 ? Verdict::stable : Verdict::failed, 0.0}; };
  EXPECT_LT(carry_out(with, sliding(1.2345)), carry_out(without, blind));
  EXPECT_EQ(without.state(), State::found);
}

TEST(FosSearch, a_wrong_guess_does_no_harm) {
  // acceleration that has nothing to do with the factor
  const Slope wild = [](double f) {
    return Trial{f < 1.7 ? Verdict::stable : Verdict::failed, 1.0 + std::abs(std::sin(40.0 * f))};
  };
  FosSearch search({0.1, 10.0, 0.01}, 1.0);
  EXPECT_LE(carry_out(search, wild), 24);
  EXPECT_EQ(search.state(), State::found);
  EXPECT_NEAR(search.stands(), 1.7, 0.01);
}

TEST(FosSearch, below_one) {
  FosSearch search({0.1, 10.0, 0.01}, 0.1);
  carry_out(search, sliding(0.83));
  EXPECT_EQ(search.state(), State::found);
  EXPECT_NEAR(search.stands(), 0.83, 0.01);
}

TEST(FosSearch, never_fails_or_is_undecided) {
  FosSearch standing({0.1, 10.0, 0.01}, 1.0);
  carry_out(standing, [](double) { return Trial{Verdict::stable, 0.0}; });
  EXPECT_EQ(standing.state(), State::at_most);
  EXPECT_EQ(standing.stands(), 10.0);
  EXPECT_TRUE(std::isinf(standing.fails()));

  FosSearch creeping({0.1, 10.0, 0.01}, 1.0);
  carry_out(creeping, [](double f) {
    return Trial{f < 1.2 ? Verdict::stable : f > 1.3 ? Verdict::failed : Verdict::undecided, f > 1.3 ? 1.0 : 0.0};
  });
  EXPECT_EQ(creeping.state(), State::undecided);
  EXPECT_NEAR(creeping.stands(), 1.2, 0.011);
  EXPECT_NEAR(creeping.fails(), 1.3, 0.011);

  FosSearch always({0.1, 10.0, 0.01}, 1.0);
  carry_out(always, [](double) { return Trial{Verdict::undecided, 0.0}; });
  EXPECT_EQ(always.state(), State::undecided);
  EXPECT_EQ(always.stands(), 1.0);
}

TEST(FosSearch, says_where_results_contradict_each_other) {
  FosSearch search({0.1, 10.0, 0.01}, 1.0);
  carry_out(search, [](double f) { return Trial{(f > 1.3 && f < 1.5) ? Verdict::failed : Verdict::stable, 0.0}; });
  EXPECT_TRUE(search.inconsistent());
  EXPECT_EQ(search.state(), State::found);
  EXPECT_NEAR(search.fails(), 1.3, 0.02);
  EXPECT_THROW(FosSearch({0.1, 10.0, 0.01}, 1.0).take({}), std::invalid_argument);
}

TEST(FosSearch, zero_of_a_line_over_one_over_f) {
  EXPECT_NEAR(*zero_of(2.0, 5.0 * (1.0 - 1.3 / 2.0), 3.0, 5.0 * (1.0 - 1.3 / 3.0)), 1.3, 1e-12);
  EXPECT_FALSE(zero_of(2.0, 1.0, 2.0, 1.0));
  EXPECT_FALSE(zero_of(2.0, 1.0, 3.0, 0.5));
}

}  // namespace
}  // namespace scree::app::fos_search_test
