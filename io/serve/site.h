// What a server serves: resources by their exact paths, and for viewers of a stream the newest message of each slot.
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

/// The newest message of one kind for viewers. A viewer gets each version at most once, and only the newest.
struct Slot {
  std::uint64_t version = 0;  // 0: nothing yet
  SharedBytes message;
  bool first = false;  // sent before every slot that is not: the others refer to it
  bool paced = false;  // sent to a viewer only after it has confirmed earlier ones (server.h)
};

class Site {
 public:
  Site() = default;
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;
  virtual ~Site() = default;

  /// @param path  as in the request, not decoded: only a path of the site, letter for letter, is found
  /// @throws std::exception where it exists and cannot be delivered: viewers receive what()
  [[nodiscard]] virtual std::optional<Resource> find(std::string_view path) = 0;

  /// A text that a viewer has sent.   @return false: the site does not accept it, which ends the connection
  [[nodiscard]] virtual bool take(std::string_view text) {
    (void)text;
    return false;
  }

  /// Called often by the thread of the server.   @return true: a slot has changed
  virtual bool refresh() { return false; }
  /// Slots of a stream; empty: there is none. The set of slots is fixed, their messages change in refresh() only.
  [[nodiscard]] virtual std::span<const Slot> slots() const { return {}; }
};

}  // namespace scree::io
