// The registry of methods: what the blocks of a stage can be represented by.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/number_key.h"
#include "model/pool.h"

namespace scree::coupling {

/// A method as a case file refers to it.
struct Method {
  std::string name;     // stage[].method
  std::string meaning;  // of the table method.<name>, where there are keys; a full sentence
  std::vector<NumberKey> keys;

  using Constants = std::span<const double>;  // in the order of keys
  /// Makes an empty pool for bodies of the method.   @pre constants are within their bounds and have no fault
  std::function<std::unique_ptr<Pool>(Constants)> make;
  /// Describes a fault of constants that are each within their bounds; empty: none. May be left out.
  std::function<std::string(Constants)> fault;
};

/// All methods, "nmm" and "dda" first, then those registered, in that order. The first call closes the registry.
[[nodiscard]] const std::deque<Method>& registered_methods();

/// Adds a method before the first case is read.
/// @throws std::logic_error  a method of that name exists, its name or `make` is missing, or registered_methods() was
/// called
void register_method(Method method);

/// Constants of methods that have keys, by name.
using MethodConstants = std::map<std::string, std::vector<double>>;

/// The methods that a run can use, by name, with their constants bound.
using Methods = std::map<std::string, std::function<std::unique_ptr<Pool>()>>;
/// "nmm" and "dda".
[[nodiscard]] Methods standard_methods();
/// All registered methods except those that have keys but no constants.
[[nodiscard]] Methods methods_with(const MethodConstants& constants);

}  // namespace scree::coupling
