// SHA-256, for the identity of a case.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace scree::io {

/// Digest of the bytes as 64 lower-case hexadecimal digits.   @source [FIPS180-4] section 6.2
[[nodiscard]] std::string sha256(std::string_view bytes);

/// SHA-256 of bytes that are added in pieces.
class Sha256 {
 public:
  Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;
  ~Sha256();
  void add(std::string_view bytes);
  /// Digest of all bytes so far; no more may be added.
  [[nodiscard]] std::string digest();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace scree::io
