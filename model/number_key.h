// A number that a law or a method reads from the case file.
#pragma once

#include <limits>
#include <string>

namespace scree {

/// A constant within bounds, which becomes a key of case files.
struct NumberKey {
  std::string name;  // in the table of its owner
  std::string unit;  // SI, as in "m/s"; empty: none
  double low = 0.0;
  bool low_open = true;  // the bound itself is not allowed
  double high = std::numeric_limits<double>::infinity();
  bool high_open = false;
  std::string meaning;        // a full sentence
  std::string fallback = {};  // value if the key is absent, as written in a case file; empty: the key must be given
};

}  // namespace scree
