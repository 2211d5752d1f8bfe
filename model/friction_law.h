// How the friction of a joint changes with its motion: the data and functions that define such a law.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/number_key.h"

namespace scree {

/// A contact point in a step.
struct FrictionRow {
  double slip = 0.0;    // path of the slider, >= 0; slip / step is the slip rate [m]
  double change = 0.0;  // tan phi - tan phi_p at the start of the step, replaced by the value at its end; initially 0
};

/// A law by which tan phi of a contact point deviates from tan phi_p of the joint's friction angle. Explicit and
/// implicit steps use the value at their start. Stages to rest, which have no physical velocity, do not change it.
/// The work of friction is booked with the friction force that results: a law has no energy of its own.
struct FrictionLaw {
  std::string name;     // in a case file: the table joint.NAME.<name>, which selects the law
  std::string meaning;  // of that table; a full sentence
  std::vector<NumberKey> keys;

  using Constants = std::span<const double>;  // in the order of keys
  /// Replaces the change of each row.   @param step  [s]   @pre 0 < step; constants have no fault
  void (*evolve)(double tan_peak, Constants constants, double step, std::span<FrictionRow> rows) = nullptr;
  /// Smallest tan phi that the law can reach.
  double (*least)(double tan_peak, Constants constants) = nullptr;
  /// What is wrong with constants that are each within their bounds; empty: nothing.
  std::string (*fault)(double tan_peak, Constants constants) = nullptr;
};

}  // namespace scree
