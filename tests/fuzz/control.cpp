// The gate of control: commands one after another, with corrected CRCs, while the clocks advance.
#include <cstdlib>
#include <cstring>

#include "io/live/control_client.h"
#include "io/live/control_gate.h"
#include "io/live/wire.h"
#include "tests/fuzz/harness.h"

namespace scree::fuzz {
namespace {

constexpr std::int64_t kSession = 1000, kNow = 2'000'000'000;
constexpr std::size_t kHead = 4;  // of a command in an input: CRC corrected or not, time since the last [0.1 s], length

}  // namespace

void take(std::span<const std::uint8_t> input) {
  io::ControlGate gate(kSession);
  double now = 0.0;
  for (int k = 0; input.size() > kHead && k < 200; ++k) {
    now += 0.1 * input[1];
    const std::size_t said = input[2] + 256U * input[3], size = std::min(said, input.size() - kHead);
    io::Bytes bytes(input.begin() + kHead, input.begin() + static_cast<std::ptrdiff_t>(kHead + size));
    if (input[0] % 8 != 7 && bytes.size() >= 4) io::write_crc(bytes);
    input = input.subspan(kHead + size);
    const auto verdict = gate.take(bytes, kNow + static_cast<std::int64_t>(1e6 * now), now);
    // An accepted command must be valid, and the gate must not accept it twice.
    if (verdict.command) {
      if (!io::control_value_error(verdict.command->verb, verdict.command->value).empty()) std::abort();
      const auto again = gate.take(bytes, kNow + static_cast<std::int64_t>(1e6 * now), now);
      if (again.command) std::abort();
      gate.remember({*verdict.command, "done", ""});
    }
  }
}

std::vector<Input> seeds() {
  std::vector<Input> out;
  Input all;
  std::int64_t sequence = kNow;
  for (const auto verb :
       {io::ControlVerb::who, io::ControlVerb::pause, io::ControlVerb::resume, io::ControlVerb::step,
        io::ControlVerb::checkpoint, io::ControlVerb::stop, io::ControlVerb::rate, io::ControlVerb::field}) {
    const double value =
        verb == io::ControlVerb::step || verb == io::ControlVerb::rate || verb == io::ControlVerb::field ? 3.0 : 0.0;
    const io::Bytes bytes = io::encode_command(kSession, {verb, value, sequence += 100'000, 5});
    Input one = message(0, 1, bytes);
    all.insert(all.end(), one.begin(), one.end());
    out.push_back(std::move(one));
  }
  out.push_back(std::move(all));
  return out;
}

}  // namespace scree::fuzz
