// A harness without libFuzzer, for every compiler: the seeds, the kept corpus, and changes of them for some seconds.
// An input that crashes the program, or takes longer than 20 s, is written to fuzz-fault first.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/fuzz/harness.h"

namespace scree::fuzz {
namespace {

constexpr unsigned kMost = 20;               // seconds of one input
constexpr std::size_t kLongest = 1U << 16U;  // bytes
const Input* present = nullptr;

extern "C" void write_input(int signal) {
  if (std::FILE* out = std::fopen("fuzz-fault", "wb")) {
    std::fwrite(present->data(), 1, present->size(), out);
    std::fclose(out);
  }
  std::fprintf(stderr, "signal %d; the input is in fuzz-fault (%zu bytes)\n", signal, present->size());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Small changes of one input, or an input that contains a piece of another.
class Mutator {
 public:
  Mutator(const std::vector<Input>& seeds, std::uint64_t start) : seeds_(seeds), random_(start) {}

  Input next() {
    Input out = seeds_[below(seeds_.size())];
    for (std::size_t n = 1 + below(8); n > 0; --n) change(out);
    if (out.size() > kLongest) out.resize(kLongest);
    return out;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random_() % n); }

  void change(Input& x) {
    static constexpr std::array<std::string_view, 12> kTexts = {
        "0", "-1", "1e308", "-1e-308", "nan", "inf", "[]", "\"", "\n", "true", "=", "9223372036854775808"};
    static constexpr std::array<std::int64_t, 8> kNumbers = {0,          -1,         1LL << 31U, (1LL << 31U) - 1,
                                                             0xFFFFFFFF, 1LL << 62U, INT64_MIN,  255};
    const auto at = [&] { return static_cast<std::ptrdiff_t>(below(x.size() + 1)); };
    std::ptrdiff_t a = at(), b = at();
    if (a > b) std::swap(a, b);
    switch (below(9)) {
      case 0:
        if (!x.empty()) x[below(x.size())] ^= static_cast<std::uint8_t>(1U << below(8));
        break;
      case 1:
        if (!x.empty()) x[below(x.size())] = static_cast<std::uint8_t>(random_());
        break;
      case 2:
        x.erase(x.begin() + a, x.begin() + std::min<std::ptrdiff_t>(b, a + 64));
        break;
      case 3: {  // a copy of a piece at another place
        const Input piece(x.begin() + a, x.begin() + std::min<std::ptrdiff_t>(b, a + 256));
        x.insert(x.begin() + at(), piece.begin(), piece.end());
        break;
      }
      case 4: {  // a piece of another input
        const Input& other = seeds_[below(seeds_.size())];
        const auto from = static_cast<std::ptrdiff_t>(below(other.size() + 1)),
                   to = std::min<std::ptrdiff_t>(std::ssize(other), from + 1 + static_cast<std::ptrdiff_t>(below(256)));
        x.insert(x.begin() + a, other.begin() + from, other.begin() + to);
        break;
      }
      case 5: {
        const std::string_view text = kTexts[below(kTexts.size())];
        x.insert(x.begin() + a, text.begin(), text.end());
        break;
      }
      case 6: {  // a number in text is replaced by another
        const auto digit = [](std::uint8_t c) { return c >= '0' && c <= '9'; };
        const auto first = std::find_if(x.begin() + a, x.end(), digit), last = std::find_if_not(first, x.end(), digit);
        const std::string_view text = kTexts[below(6)];
        if (first != x.end()) x.insert(x.erase(first, last), text.begin(), text.end());
        break;
      }
      case 7: {  // a binary number is replaced by another
        const std::size_t size = std::size_t{1} << below(4);
        const std::int64_t value = kNumbers[below(kNumbers.size())];
        if (x.size() >= size) std::memcpy(x.data() + below(x.size() - size + 1), &value, size);
        break;
      }
      default:
        x.resize(static_cast<std::size_t>(b));
    }
  }

  const std::vector<Input>& seeds_;
  std::mt19937_64 random_;
};

void one(const Input& input) {
  present = &input;
  alarm(kMost);
  take(input);
  alarm(0);
}

int replay(const char* name, double seconds, std::uint64_t start) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGALRM}) std::signal(signal, write_input);
  std::vector<Input> inputs = seeds();
  const std::size_t sound = inputs.size();
  for (Input& kept : files_of(std::string("tests/fuzz/corpus/") + name, {""})) inputs.push_back(std::move(kept));
  for (const Input& input : inputs) one(input);
  Mutator mutator(inputs, start);
  std::int64_t runs = 0;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  for (; std::chrono::duration<double>(Clock::now() - begin).count() < seconds; ++runs) one(mutator.next());
  std::printf("%s: %zu seeds, %zu kept inputs, %lld changed ones: no fault\n", name, sound, inputs.size() - sound,
              static_cast<long long>(runs));
  return 0;
}

}  // namespace
}  // namespace scree::fuzz

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "Usage: %s CORPUS SECONDS [START]   (CORPUS: a folder of tests/fuzz/corpus)\n", argv[0]);
    return 2;
  }
  return scree::fuzz::replay(argv[1], std::strtod(argv[2], nullptr),
                             argc == 4 ? std::strtoull(argv[3], nullptr, 10) : 1);
}
