// Checks of a contact state after a step: each violation against what is allowed, the worst one told in words.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "coupling/contact/table/known_contacts.h"

namespace scree::coupling {

/// What the checks of a run have found.
class Audit {
 public:
  /// Notes a value of which `allowed` is the most that may be; what() says in words what it is.
  template <class What>
  void check(double value, double allowed, What&& what) {
    ++checks_;
    if (value == 0.0) return;  // and `allowed` may be 0: nothing moves, nothing weighs
    const double ratio = std::abs(value) / allowed;
    if (ratio <= worst_) return;
    worst_ = std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio;
    text_ = what();
  }
  [[nodiscard]] std::int64_t checks() const { return checks_; }
  /// The largest value over what is allowed.
  [[nodiscard]] double worst() const { return worst_; }
  /// What it is; empty: nothing was above 0.
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

/// Contacts against the positions, whatever found them: gap and stretch of every point are those of the geometry, and
/// no corner of a free block lies deep inside another one that no contact parts from it, closed or on its way out
/// (looked for over all blocks, without the search).
/// @param detection  of contacts; a corner may lie unheld within a tenth of it, and of two diagonal blocks where joints
/// cross as deep as the joints beside it are pressed [m]
void audit_geometry(const Setup& setup, const ContactList& list, std::span<const double> q, double detection,
                    Audit& audit);

/// The law of a point at given forces: no pull beyond what it bears, friction within Coulomb's limit.
/// @param tolerance  [N]
void audit_law(const Setup& setup, const ContactMemory& m, double fn, double ft, double tolerance, Audit& audit);

}  // namespace scree::coupling
