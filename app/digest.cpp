#include <fmt/format.h>
#include <omp.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <type_traits>

#include "app/commands.h"
#include "app/output.h"
#include "app/session.h"
#include "coupling/stages/driver.h"
#include "io/case/read_case.h"

namespace scree::app {
namespace {

using coupling::Column;

/// FNV-1a over the bytes of numbers.
class Hash {
 public:
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) {
    std::uint64_t bits = 0;
    if constexpr (std::is_same_v<T, double>)
      bits = std::bit_cast<std::uint64_t>(value);
    else
      bits = static_cast<std::uint64_t>(value);
    for (int i = 0; i < 8; ++i, bits >>= 8U) hash_ = (hash_ ^ (bits & 0xFFU)) * 0x100000001B3ULL;
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.size());
    for (const T value : values) add(value);
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

double norm(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values) sum += x * x;
  return std::sqrt(sum);
}

/// One line per frame. The list of printed quantities is written out here instead of using State::visit(), so that it
/// stays the same while the program is restructured.
class Lines final : public coupling::Sink {
 public:
  void begin(const Model& /*model*/, const coupling::Plan& /*plan*/) override {
    say("time,step,stage,hash,q,v,a,open,slip,stick,gap,stretch,fn,ft,slipped");
    for (int c = 0; c < coupling::kColumns; ++c) say(",{}", coupling::info(static_cast<Column>(c)).name);
    say("\n");
  }
  void frame(const coupling::FrameView& view) override {
    const coupling::State& s = *view.state;
    Hash hash;
    hash.add(s.time);
    hash.add(s.step);
    for (const auto* values : {&s.q, &s.v, &s.a}) hash.add(*values);
    std::map<coupling::ContactStatus, int> number;
    double gap = 0.0, stretch = 0.0, fn = 0.0, ft = 0.0, slip = 0.0;
    for (const coupling::ContactMemory& m : s.contacts) {
      for (const std::int32_t part : {m.key.block_p, m.key.ring_p, m.key.vertex, m.key.part, m.key.block_e,
                                      m.key.ring_e, m.key.edge, static_cast<std::int32_t>(m.status)})
        hash.add(part);
      for (const double value : {m.gap, m.stretch, m.fn, m.ft, m.slip}) hash.add(value);
      ++number[m.status];
      gap += std::abs(m.gap);
      stretch += std::abs(m.stretch);
      fn += std::abs(m.fn);
      ft += std::abs(m.ft);
      slip += m.slip;
    }
    for (int c = 0; c < coupling::kColumns; ++c) hash.add(s.ledger[static_cast<Column>(c)]);
    say("{:.17g},{},{},{:016x},{:.17g},{:.17g},{:.17g},{},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", view.time,
        view.step, view.stage, hash.value(), norm(s.q), norm(s.v), norm(s.a), number[coupling::ContactStatus::open],
        number[coupling::ContactStatus::slip], number[coupling::ContactStatus::stick], gap, stretch, fn, ft, slip);
    for (int c = 0; c < coupling::kColumns; ++c) say(",{:.17g}", s.ledger[static_cast<Column>(c)]);
    say("\n");
  }
};

}  // namespace

int digest(const DigestOptions& options) {
  const io::Case c = io::read_case(options.case_file, options.set, method_names(), complain_line);
  const coupling::Methods methods = coupling::methods_with(c.plan.constants);
  if (options.threads > 0) omp_set_num_threads(options.threads);
  coupling::Driver run(c.model, c.plan, methods);
  Lines lines;
  run.add_sink(lines);
  const coupling::RunEnd end = run.run(options.until);
  if (end.status == coupling::RunEnd::Status::done || end.status == coupling::RunEnd::Status::interrupted) return kDone;
  complain("error: {}\n", end.reason);
  return kNotConverged;
}

}  // namespace scree::app
