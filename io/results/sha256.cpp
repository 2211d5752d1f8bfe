#include "io/results/sha256.h"

#include <fmt/format.h>
#include <openssl/err.h>
#include <openssl/evp.h>

#include <array>
#include <new>
#include <stdexcept>

namespace scree::io {

namespace {

/// libcrypto fails if it has no memory (it may then be unable to record the error), or if its configuration has no
/// SHA-256.
[[noreturn]] void fail() {
  const unsigned long error = ::ERR_peek_last_error();
  if (error == 0 || ERR_GET_REASON(error) == ERR_R_MALLOC_FAILURE) throw std::bad_alloc();
  const char* reason = ::ERR_reason_error_string(error);
  throw std::runtime_error(fmt::format("libcrypto computes no SHA-256: {}", reason == nullptr ? "no reason" : reason));
}

}  // namespace

struct Sha256::Context {
  struct Free {
    void operator()(EVP_MD_CTX* context) const { ::EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> of{::EVP_MD_CTX_new()};
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  if (context_->of == nullptr || ::EVP_DigestInit_ex(context_->of.get(), ::EVP_sha256(), nullptr) != 1) fail();
}

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  if (::EVP_DigestUpdate(context_->of.get(), bytes.data(), bytes.size()) != 1) fail();
}

std::string Sha256::digest() {
  std::array<unsigned char, 32> digest{};
  if (::EVP_DigestFinal_ex(context_->of.get(), digest.data(), nullptr) != 1) fail();
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

std::string sha256(std::string_view bytes) {
  Sha256 all;
  all.add(bytes);
  return all.digest();
}

}  // namespace scree::io
