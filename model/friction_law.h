// How the friction of a joint changes with its motion: what Scree has to know of such a law.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/number_key.h"

namespace scree {

/// A contact point in a step.
struct FrictionRow {
  double slip = 0.0;    // way of the slider, >= 0; slip / step is the slip rate [m]
  double change = 0.0;  // tan phi less tan phi_p: as the step begins, to be replaced by that at its end; 0 at first
};

/// A law by which tan phi of a contact point leaves that of the joint's friction angle, tan phi_p. A step takes the
/// value at its start, explicit and implicit alike. Stages to rest, which have no physical velocity, do not change it.
/// The work of friction is booked with the force that the law leaves: a law has no energy of its own.
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
