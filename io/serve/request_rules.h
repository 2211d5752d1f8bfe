// Which requests a server on the loopback interface answers. Other pages in the same browser can send requests to
// 127.0.0.1 too, and a foreign name may be made to resolve to it: the headers show this.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scree::io {

/// Whether a request names this server: 127.0.0.1:PORT or localhost:PORT, nothing else. A page of a foreign name that
/// resolves to 127.0.0.1 sends that name.
[[nodiscard]] bool host_is_ours(std::string_view host, std::uint16_t port);

/// Whether the page that made a request came from this server: http://127.0.0.1:PORT or http://localhost:PORT.
[[nodiscard]] bool origin_is_ours(std::string_view origin, std::uint16_t port);

/// N of "/prefix/N" as a decimal number without sign or leading zeros; empty for anything else.
/// @param prefix  with both slashes
[[nodiscard]] std::optional<std::size_t> number_of_path(std::string_view path, std::string_view prefix);

}  // namespace scree::io
