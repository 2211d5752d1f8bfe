#include "io/live/live_url.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace scree::io {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kAccepted =
    "accepted: udpm://GROUP:PORT?ttl=0 (multicast, for example udpm://239.255.76.67:7667?ttl=0), file://PATH (an LCM "
    "log), memq://";

struct Bad : std::invalid_argument {
  explicit Bad(const std::string& why) : std::invalid_argument(fmt::format("{}; {}", why, kAccepted)) {}
};

std::optional<long> number(std::string_view text) {
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Splits off the text after the first `mark`.
std::string_view split(std::string_view& text, char mark) {
  const std::size_t at = text.find(mark);
  const std::string_view rest = at == text.npos ? std::string_view{} : text.substr(at + 1);
  text = text.substr(0, at);
  return rest;
}

void parse_udpm(std::string_view target, std::string_view options, LiveUrl& url) {
  if (target.empty()) target = "239.255.76.67:7667";  // LCM's own default
  const std::string_view port = split(target, ':');
  url.group = target;
  in_addr address{};
  if (inet_pton(AF_INET, url.group.c_str(), &address) != 1 || !IN_MULTICAST(ntohl(address.s_addr)))
    throw Bad(fmt::format("\"{}\" is not an IPv4 multicast address (224.0.0.0 to 239.255.255.255)", url.group));
  const auto number_of_port = number(port);
  if (!number_of_port || *number_of_port < 1 || *number_of_port > 65535)  // without one LCM sends to port 0 and fails
    throw Bad(fmt::format("\"{}\" is not a port (1 to 65535)", port));
  url.port = static_cast<std::uint16_t>(*number_of_port);
  long ttl = 0;
  std::string buffer;
  while (!options.empty()) {
    std::string_view key = options;
    options = split(key, '&');
    const std::string_view text = split(key, '=');
    const auto value = number(text);
    if (key == "ttl" && value && (*value == 0 || *value == 1)) {
      ttl = *value;
    } else if (key == "recv_buf_size" && value && *value > 0 && *value < (1L << 30)) {
      url.receive_buffer = *value;
      buffer = fmt::format("&recv_buf_size={}", *value);
    } else {
      throw Bad(fmt::format("option \"{}={}\" is not known (ttl=0 or 1, recv_buf_size=BYTES)", key, text));
    }
  }
  url.ttl = static_cast<int>(ttl);
  url.lcm = fmt::format("udpm://{}:{}?ttl={}{}", url.group, url.port, ttl, buffer);
}

/// A sender overwrites the file: an existing file must be empty or a log.
void check_writable(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) throw Bad(fmt::format("there is no folder {}", folder.string()));
  if (!fs::exists(path, ignored)) {
    // Tested by opening: permission bits do not apply to root, nor to read-only file systems.
    if (!std::ofstream(path)) throw Bad(fmt::format("{} cannot be written", path.string()));
    fs::remove(path, ignored);
    return;
  }
  if (!fs::is_regular_file(path, ignored)) throw Bad(fmt::format("{} is not a file", path.string()));
  constexpr std::array<char, 4> kLog{'\xed', '\xa1', '\xda', '\x01'};
  std::array<char, 4> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  if (!in.eof() && !in) throw Bad(fmt::format("{} cannot be read", path.string()));
  if (in.gcount() > 0 && head != kLog)
    throw Bad(fmt::format("{} exists and is not an LCM log; it will not be overwritten", path.string()));
  if (!std::ofstream(path, std::ios::app)) throw Bad(fmt::format("{} cannot be written", path.string()));
}

void parse_file(std::string_view target, std::string_view options, LiveSide side, LiveUrl& url) {
  const bool sends = side == LiveSide::sender;
  if (target.empty()) throw Bad("file:// needs a path");
  url.path = target;
  std::string speed;
  while (!options.empty()) {
    std::string_view key = options;
    options = split(key, '&');
    const std::string_view value = split(key, '=');
    const bool mode = key == "mode" && value == (sends ? "w" : "r");
    const bool pace = !sends && key == "speed" && number(value) && *number(value) >= 0;
    if (!mode && !pace) throw Bad(fmt::format("option \"{}={}\" is not known here", key, value));
    if (pace) speed = fmt::format("&speed={}", value);
  }
  std::error_code ignored;
  if (sends) check_writable(url.path);
  if (!sends && (!fs::is_regular_file(url.path, ignored) || fs::file_size(url.path, ignored) == 0))
    throw Bad(fmt::format("there is no log {}", url.path));
  url.lcm = fmt::format("file://{}?mode={}{}", url.path, sends ? 'w' : 'r', speed);
}

}  // namespace

LiveUrl parse_live_url(std::string_view url, LiveSide side) {
  const std::size_t mark = url.find("://");
  if (mark == url.npos || url.find('\0') != url.npos) throw Bad("no provider in front of ://");
  const std::string_view provider = url.substr(0, mark);
  std::string_view target = url.substr(mark + 3);
  const std::string_view options = split(target, '?');
  LiveUrl parsed;
  if (provider == "udpm") {
    parsed.kind = LiveUrl::Kind::udpm;
    parse_udpm(target, options, parsed);
  } else if (provider == "file") {
    parsed.kind = LiveUrl::Kind::file;
    parse_file(target, options, side, parsed);
  } else if (provider == "memq") {
    if (!target.empty() || !options.empty()) throw Bad("nothing may follow memq://");
    parsed.lcm = "memq://";
  } else {
    throw Bad(fmt::format("provider \"{}\" is not accepted", provider));
  }
  return parsed;
}

std::optional<std::string> check_live_url(std::string_view url, LiveSide side) {
  try {
    (void)parse_live_url(url, side);
    return std::nullopt;
  } catch (const std::invalid_argument& bad) {
    return bad.what();
  }
}

}  // namespace scree::io
