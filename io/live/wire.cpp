#include "io/live/wire.h"

#include <algorithm>
#include <chrono>
#include <scree/ack_v1_t.hpp>
#include <scree/ctrl_v1_t.hpp>
#include <scree/detail_v1_t.hpp>
#include <scree/energy_v1_t.hpp>
#include <scree/event_v1_t.hpp>
#include <scree/hist_v1_t.hpp>
#include <scree/info_v1_t.hpp>
#include <scree/mesh_v1_t.hpp>
#include <scree/model_v1_t.hpp>
#include <scree/part_v1_t.hpp>
#include <scree/state_v1_t.hpp>
#include <scree/topo_v1_t.hpp>

#include "io/live/crc32.h"

namespace scree::io {
namespace {

std::uint32_t big_endian(std::span<const std::uint8_t> b) {
  return std::uint32_t{b[0]} << 24U | std::uint32_t{b[1]} << 16U | std::uint32_t{b[2]} << 8U | std::uint32_t{b[3]};
}

/// Traverses a message without copying any data.
class Walker {
 public:
  explicit Walker(std::span<const std::uint8_t> rest) : rest_(rest) {}
  [[nodiscard]] bool skip(std::uint64_t size) {
    if (size > rest_.size()) return false;
    rest_ = rest_.subspan(static_cast<std::size_t>(size));
    return true;
  }
  [[nodiscard]] std::optional<std::uint32_t> count() {
    if (rest_.size() < 4) return std::nullopt;
    const std::uint32_t value = big_endian(rest_);
    rest_ = rest_.subspan(4);
    if (value > 0x7FFFFFFFU) return std::nullopt;  // negative as an int32
    return value;
  }
  [[nodiscard]] bool text() {
    const auto size = count();
    if (!size || *size == 0 || *size > rest_.size()) return false;
    const auto body = rest_.first(*size);
    return std::find(body.begin(), body.end(), 0) == body.end() - 1 && skip(*size);
  }
  [[nodiscard]] bool many(char element, std::uint64_t times) {
    if (element != 's') return skip(static_cast<std::uint64_t>(element - '0') * times);
    while (times-- > 0)  // ends early on large counts: a text has at least five bytes
      if (!text()) return false;
    return true;
  }
  [[nodiscard]] bool done() const { return rest_.empty(); }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace

// clang-format off
template <> std::string_view layout<info_v1_t>()   { return "H" "ssssssssss" "8888" "88" "8888" "8888888" "888" "888ss" "4"; }
template <> std::string_view layout<mesh_v1_t>()   { return "8" "88" "n4a4a8a8a" "n4b4b4b4b" "n4c" "nsd" "4"; }
template <> std::string_view layout<topo_v1_t>()   { return "H" "444" "4" "n1a" "4"; }
template <> std::string_view layout<state_v1_t>()  { return "H" "44444" "4n4a4a4a4a4a4a4a" "888" "4n2b2b" "4n4c" "4"; }
template <> std::string_view layout<hist_v1_t>()   { return "H" "44" "nsa8a8a8a8a8a8a" "4"; }
template <> std::string_view layout<energy_v1_t>() { return "H" "nsasa8a" "88888" "4"; }
template <> std::string_view layout<event_v1_t>()  { return "H" "ss" "4ss8888" "4"; }
template <> std::string_view layout<part_v1_t>()   { return "H" "444" "4" "n1a" "4"; }
template <> std::string_view layout<model_v1_t>()  { return "nsa4a1a" "nsb8b8b8b" "nsc8c8c8c" "n8d8d8d8d4d1d" "n8e8e1e1e" "n8f8f8f8f1f" "n8g8g4g" "n4h4h" "4" "4"; }
template <> std::string_view layout<detail_v1_t>() { return "88" "n4a4a4a4a4a4a4a4a4a4a1a" "n4b4b4b" "n4c4c4c4c" "4"; }
template <> std::string_view layout<ctrl_v1_t>()   { return "H" "8s8" "4"; }
template <> std::string_view layout<ack_v1_t>()    { return "H" "8ssss" "4"; }
// clang-format on

bool fits(std::string_view layout, std::span<const std::uint8_t> body) {
  constexpr std::uint64_t kHeader = 5 * 8 + 4 + 8;
  Walker walker(body);
  std::vector<std::uint32_t> counts;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    const char field = layout[i];
    const bool array = i + 1 < layout.size() && layout[i + 1] >= 'a' && layout[i + 1] <= 'h';
    if (field == 'H') {
      if (!walker.skip(kHeader)) return false;
    } else if (field == 'n') {
      const auto count = walker.count();
      if (!count) return false;
      counts.push_back(*count);
    } else if (!walker.many(field, array ? counts.at(static_cast<std::size_t>(layout[i + 1] - 'a')) : 1)) {
      return false;
    }
    if (array) ++i;
  }
  return walker.done();
}

bool crc_holds(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 4 && big_endian(bytes.last(4)) == crc32(bytes.first(bytes.size() - 4));
}

void write_crc(Bytes& bytes) {
  std::uint32_t crc = crc32(std::span(bytes).first(bytes.size() - 4));
  for (std::size_t i = 0; i < 4; ++i, crc >>= 8U) bytes[bytes.size() - 1 - i] = static_cast<std::uint8_t>(crc & 0xFFU);
}

std::int64_t utime_now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

void stamp(Bytes& bytes, std::int64_t utime) {
  constexpr std::size_t kFingerprint = 8;
  auto rest = static_cast<std::uint64_t>(utime);
  for (std::size_t i = 0; i < 8; ++i, rest >>= 8U)
    bytes[kFingerprint + 7 - i] = static_cast<std::uint8_t>(rest & 0xFFU);
  write_crc(bytes);
}

std::string wire_text(std::string_view text, std::size_t most) {
  text = text.substr(0, text.find('\0'));
  std::size_t size = std::min(most, text.size());
  if (size < text.size())
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U)
      --size;  // not inside a UTF-8 character
  return std::string(text.substr(0, size));
}

}  // namespace scree::io
