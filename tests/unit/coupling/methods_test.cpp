// The registry of methods: accepted and refused entries, and constants bound to the function that makes a pool.
#include "coupling/bodies/methods.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "tests/third_method/rigid_pool.h"

namespace scree::coupling::methods_test {
namespace {

Method rigid(const std::string& name, std::vector<double>* seen = nullptr) {
  Method m;
  m.name = name;
  m.meaning = "Rigid blocks.";
  m.keys = {{"inertia_factor", "", 0.0, true, 10.0, false, "Factor.", "1.0"}};
  m.make = [seen](Method::Constants c) {
    if (seen != nullptr) seen->assign(c.begin(), c.end());
    return std::make_unique<test::RigidPool>(c[0]);
  };
  return m;
}

/// One test, since the registry closes for the whole program.
TEST(RegisteredMethods, take_others_until_first_used_and_bind_constants) {
  std::vector<double> seen;
  register_method(rigid("stiff", &seen));
  EXPECT_THROW(register_method(rigid("stiff")), std::logic_error) << "one of that name";
  EXPECT_THROW(register_method(rigid("dda")), std::logic_error) << "one of that name";
  EXPECT_THROW(register_method(rigid("")), std::logic_error) << "no name";
  Method none = rigid("none");
  none.make = nullptr;
  EXPECT_THROW(register_method(none), std::logic_error) << "nothing that makes it";

  std::vector<std::string> names;
  for (const Method& m : registered_methods()) names.push_back(m.name);
  EXPECT_EQ(names, (std::vector<std::string>{"nmm", "dda", "stiff"}));
  EXPECT_THROW(register_method(rigid("late")), std::logic_error) << "the registry is closed";

  EXPECT_FALSE(methods_with({}).contains("stiff")) << "it has keys and no constants";
  const Methods all = methods_with({{"stiff", {2.5}}});
  EXPECT_EQ(all.at("stiff")()->method(), "rigid");
  EXPECT_EQ(seen, std::vector<double>{2.5});
  EXPECT_EQ(all.at("nmm")()->method(), "nmm");
  EXPECT_EQ(all.at("dda")()->method(), "dda");
}

}  // namespace
}  // namespace scree::coupling::methods_test
