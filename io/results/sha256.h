// SHA-256, for the identity of a case.
#pragma once

#include <string>
#include <string_view>

namespace scree::io {

/// Digest of the bytes as 64 lower-case hexadecimal digits.   @source [FIPS180-4] section 6.2
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace scree::io
