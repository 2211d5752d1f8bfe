#include "io/serve/request_rules.h"

#include <algorithm>
#include <charconv>

namespace scree::io {
namespace {

constexpr std::size_t kMostDigits = 9;

}  // namespace

bool host_is_ours(std::string_view host, std::uint16_t port) {
  const std::string at = ":" + std::to_string(port);
  return host == "127.0.0.1" + at || host == "localhost" + at;
}

bool origin_is_ours(std::string_view origin, std::uint16_t port) {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && host_is_ours(origin.substr(kScheme.size()), port);
}

std::optional<std::size_t> number_of_path(std::string_view path, std::string_view prefix) {
  if (!path.starts_with(prefix)) return {};
  const std::string_view digits = path.substr(prefix.size());
  const bool plain = !digits.empty() && digits.size() <= kMostDigits &&
                     std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
                     (digits.size() == 1 || digits.front() != '0');
  if (!plain) return {};
  std::size_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace scree::io
