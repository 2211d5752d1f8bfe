#include "io/results/sha256.h"

#include <fmt/format.h>
#include <openssl/err.h>
#include <openssl/evp.h>

#include <array>
#include <new>
#include <stdexcept>

namespace scree::io {

namespace {

/// libcrypto fails where it has no memory, which it may not be able to record, or where its configuration has no
/// SHA-256.
[[noreturn]] void fail() {
  const unsigned long error = ::ERR_peek_last_error();
  if (error == 0 || ERR_GET_REASON(error) == ERR_R_MALLOC_FAILURE) throw std::bad_alloc();
  const char* reason = ::ERR_reason_error_string(error);
  throw std::runtime_error(fmt::format("libcrypto computes no SHA-256: {}", reason == nullptr ? "no reason" : reason));
}

}  // namespace

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  if (::EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, ::EVP_sha256(), nullptr) != 1) fail();
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace scree::io
