// What a server serves: resources by their exact paths, and for viewers of a stream the newest of a few things.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

using SharedBytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Bytes of a text that lives as long as they do.
[[nodiscard]] SharedBytes bytes_of(std::string_view text);

struct Resource {
  std::string type;  // as in Content-Type
  SharedBytes body;
};

/// The newest message of one thing that viewers are to know. A viewer gets each version at most once, and none but the
/// newest.
struct Slot {
  std::uint64_t version = 0;  // 0: nothing yet
  SharedBytes message;
  bool first = false;  // goes before every slot that is not: the others refer to it
  bool paced = false;  // is sent to a viewer only when that has said that it took the ones before
};

class Site {
 public:
  Site() = default;
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;
  virtual ~Site() = default;

  /// @param path  as in the request, not decoded: whatever is not a path of the site, letter for letter, is not there
  /// @throws std::exception where it is there and cannot be given: viewers are told what()
  [[nodiscard]] virtual std::optional<Resource> find(std::string_view path) = 0;

  /// A text that a viewer has sent.   @return false: it is none that the site takes, which ends the connection
  [[nodiscard]] virtual bool take(std::string_view text) {
    (void)text;
    return false;
  }

  /// Called often by the thread of the server.   @return true: a slot has changed
  virtual bool refresh() { return false; }
  /// Of a stream; empty: there is none. Slots stay what they are, their messages change in refresh() only.
  [[nodiscard]] virtual std::span<const Slot> slots() const { return {}; }
};

}  // namespace scree::io
