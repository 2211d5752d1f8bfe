// Numbers with units: "30 MPa" in the unit that a key is defined in.
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace scree::io {

/// Why a text is not a number in the required unit.
struct UnitFault {
  std::string problem, hint;
};

/// Value of `text` in `base`. A unit is a product of
///   g t  m  s min h  N  Pa  Hz  rad deg
/// each with a prefix n u m c k M G T where usual (u also as the micro sign) and a power ("m3", "m^3"), joined by * and
/// /: "GN/m", "2.6 t/m3", "m/s^2". Powers of ten move the decimal exponent before the number is rounded, so that "0.1
/// ms" is exactly 1e-4 s.
/// @param base  the key's own unit; empty: a plain number, text is refused
[[nodiscard]] std::variant<double, UnitFault> in_unit(std::string_view text, std::string_view base);

}  // namespace scree::io
