// Names of events in results and logs.
#include "coupling/sink.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace scree::test::sink_test {
namespace {

using namespace coupling;

TEST(EventNames, are_different_and_known_for_every_kind) {
  std::set<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(EventKind::warning); ++kind)
    names.emplace(name(static_cast<EventKind>(kind)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(EventKind::warning) + 1);
  EXPECT_FALSE(names.contains("unknown"));
}

TEST(EventNames, of_events_that_come_often_are_those_of_cuts_changes_of_method_and_side_and_sleep) {
  std::set<std::string> often;
  for (int kind = 0; kind <= static_cast<int>(EventKind::warning); ++kind)
    if (const std::string of(name(static_cast<EventKind>(kind))); comes_often(of)) often.insert(of);
  EXPECT_EQ(often, (std::set<std::string>{"step_cut", "transfer", "partition", "sleep"}));
}

}  // namespace
}  // namespace scree::test::sink_test
