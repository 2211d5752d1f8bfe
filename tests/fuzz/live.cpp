// Messages that a viewer receives, one after another, with corrected CRCs so that they reach the decoders.
#include "io/live/channel.h"
#include "io/live/decode.h"
#include "tests/fuzz/harness.h"
#include "tests/unit/io/live_strip.h"

namespace scree::fuzz {
namespace {

constexpr std::int64_t kNow = 1'800'000'000'000'000;  // [us since 1970]
constexpr std::size_t kHead = 4;                      // of a message in an input: kind, CRC corrected or not, length

}  // namespace

void take(std::span<const std::uint8_t> input) {
  io::LiveAssembly assembly;
  for (int k = 0; input.size() > kHead && k < 200; ++k) {
    const auto kind = static_cast<io::LiveKind>(input[0] % 8);
    const std::size_t said = input[2] + 256U * input[3], size = std::min(said, input.size() - kHead);
    io::Bytes bytes(input.begin() + kHead, input.begin() + static_cast<std::ptrdiff_t>(kHead + size));
    if (input[1] % 8 != 7 && bytes.size() >= 4) io::write_crc(bytes);
    input = input.subspan(kHead + size);
    assembly.take(io::channel_name("short", kind), bytes, kNow);
  }
  static_cast<void>(assembly.take_events());
}

std::vector<Input> seeds() {
  std::vector<Input> out;
  for (const std::int32_t cells : {1, 10, 300}) {
    io::test::Strip strip(cells);
    Input all;
    for (auto [channel, bytes] : io::test::short_run(strip, 0.5)) {
      if (bytes.size() > 0xFFFF) continue;
      const auto kind = io::channel_kind(channel);
      if (!kind) continue;
      Input one = message(static_cast<std::uint8_t>(*kind), 0, bytes);
      all.insert(all.end(), one.begin(), one.end());
      out.push_back(std::move(one));
    }
    out.push_back(std::move(all));
  }
  return out;
}

}  // namespace scree::fuzz
