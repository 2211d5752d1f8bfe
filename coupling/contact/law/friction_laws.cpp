#include "coupling/contact/law/friction_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace scree::coupling {
namespace {

struct Registry {
  std::deque<FrictionLaw> laws = {velocity_weakening()};
  bool closed = false;
};

Registry& registry() {
  static Registry all;
  return all;
}

}  // namespace

const std::deque<FrictionLaw>& friction_laws() {
  registry().closed = true;
  return registry().laws;
}

void register_friction_law(FrictionLaw law) {
  Registry& all = registry();
  const auto refuse = [&](const char* why) {
    throw std::logic_error(fmt::format("law of friction '{}': {}", law.name, why));
  };
  if (all.closed) refuse("registered after the laws were first used: register it before a case is read");
  if (law.name.empty() || law.evolve == nullptr || law.least == nullptr || law.fault == nullptr)
    refuse("a name, evolve, least and fault are needed");
  const auto same = [&](const FrictionLaw& other) { return other.name == law.name; };
  if (std::any_of(all.laws.begin(), all.laws.end(), same)) refuse("there is one of that name");
  all.laws.push_back(std::move(law));
}

}  // namespace scree::coupling
