#include "coupling/bodies/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "dda/dda_pool.h"
#include "nmm/nmm_pool.h"

namespace scree::coupling {
namespace {

struct Registry {
  std::deque<Method> methods = {{"nmm", "", {}, [](auto) { return std::make_unique<nmm::NmmPool>(); }, {}},
                                {"dda", "", {}, [](auto) { return std::make_unique<dda::DdaPool>(); }, {}}};
  bool closed = false;
};

Registry& registry() {
  static Registry all;
  return all;
}

}  // namespace

const std::deque<Method>& registered_methods() {
  registry().closed = true;
  return registry().methods;
}

void register_method(Method method) {
  Registry& all = registry();
  const auto refuse = [&](const char* why) {
    throw std::logic_error(fmt::format("method '{}': {}", method.name, why));
  };
  if (all.closed) refuse("registered after the methods were first used: register it before a case is read");
  if (method.name.empty() || !method.make) refuse("a name and make are needed");
  const auto same = [&](const Method& other) { return other.name == method.name; };
  if (std::any_of(all.methods.begin(), all.methods.end(), same)) refuse("there is one of that name");
  all.methods.push_back(std::move(method));
}

Methods standard_methods() {
  return {{"nmm", [] { return std::make_unique<nmm::NmmPool>(); }},
          {"dda", [] { return std::make_unique<dda::DdaPool>(); }}};
}

Methods methods_with(const MethodConstants& constants) {
  Methods out;
  for (const Method& m : registered_methods()) {
    const auto at = constants.find(m.name);
    if (!m.keys.empty() && at == constants.end()) continue;
    std::vector<double> values = at == constants.end() ? std::vector<double>() : at->second;
    out[m.name] = [make = m.make, values = std::move(values)] { return make(values); };
  }
  return out;
}

}  // namespace scree::coupling
