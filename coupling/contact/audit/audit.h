// Checks of a contact state after a step: each violation relative to its allowed value, and a text about the worst.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "coupling/contact/table/known_contacts.h"

namespace scree::coupling {

/// Results of the checks of a run.
class Audit {
 public:
  /// Checks a value against the largest one allowed; what() returns a description of the value.
  template <class What>
  void check(double value, double allowed, What&& what) {
    ++checks_;
    if (value == 0.0) return;  // and `allowed` may be 0: nothing moves, nothing has weight
    const double ratio = std::abs(value) / allowed;
    if (ratio <= worst_) return;
    worst_ = std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
    text_ = what();
  }
  [[nodiscard]] std::int64_t checks() const { return checks_; }
  /// The largest ratio of a value to its allowed one.
  [[nodiscard]] double worst() const { return worst_; }
  /// Description of the value with this ratio; empty: no value was above 0.
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool passed() const { return worst_ <= 1.0; }
  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("audit.checks", checks_);
    see("audit.worst", worst_);
    see("audit.text", text_);
  }

 private:
  std::int64_t checks_ = 0;
  double worst_ = 0.0;
  std::string text_;
};

/// "blocks 'a' and 'b', corner 2 on edge 0"; faces of cracks by their ring.
[[nodiscard]] std::string contact_name(const Model& model, const ContactKey& key);

/// Checks the contacts against the positions, independently of the contact search: gap and stretch of every point must
/// be those of the geometry, and no corner of a free block may lie deep inside another block unless a contact of the
/// two is closed or still moves out of a depth at which it closed. All pairs of blocks are tested.
/// @param detection  distance of detection; a corner without contact may lie within a tenth of it, and one of two
/// diagonal blocks where joints cross as deep as the joints beside it are pressed [m]
void audit_geometry(const Setup& setup, const ContactList& list, std::span<const double> q, double detection,
                    Audit& audit);

/// Checks the law of a point at given forces: no pull beyond its tension limit, friction within Coulomb's limit.
/// @param tolerance  [N]
void audit_law(const Setup& setup, const ContactMemory& m, double fn, double ft, double tolerance, Audit& audit);

}  // namespace scree::coupling
