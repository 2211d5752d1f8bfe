#include "app/progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/output.h"
#include "io/text/printable.h"

namespace scree::app {
namespace {

constexpr std::chrono::seconds kSilence{5};  // after which a log gets a line, however small the progress
constexpr int kShown = 5;                    // events of a kind that comes often

/// Events of a kind that comes often, as a noun.
const char* further(coupling::EventKind kind) {
  if (kind == coupling::EventKind::step_cut) return "cuts";
  return kind == coupling::EventKind::partition ? "changes of sides" : "changes of sleep";
}

}  // namespace

Progress::Progress(bool terminal, double end_time, const coupling::Checkpoint* from)
    : terminal_(terminal), end_(end_time) {
  if (from == nullptr) return;
  begin_ = seconds(from->state.time);
  steps_made_ = from->stats.steps;
  stage_index_ = static_cast<std::size_t>(from->state.stage);
}

void Progress::begin(const Model& model, const coupling::Plan& plan) {
  for (const coupling::Stage& s : plan.stages) stages_.push_back(s.name);
  if (begin_ > 0.0 && stage_index_ < stages_.size()) stage_ = stages_[stage_index_++];
  line(fmt::format("{}: {} blocks, {} stages, {:g} s", model.title.empty() ? "untitled case" : model.title,
                   model.blocks.size(), plan.stages.size(), end_));
}

void Progress::line(const std::string& text) {
  app::draw(fmt::format("{}{}\n", terminal_ ? "\r\033[K" : "", io::printable(text)));
}

void Progress::event(const coupling::Event& e) {
  using Kind = coupling::EventKind;
  if (e.kind == Kind::transfer) return;       // one per block: they are in the results
  if (e.kind == Kind::not_converged) return;  // the reason is printed at the end of the run
  const bool often = coupling::comes_often(coupling::name(e.kind));
  if (often && ++shown_[e.kind] > kShown) return;
  if (e.kind == Kind::stage_start && stage_index_ < stages_.size()) stage_ = stages_[stage_index_++];
  if (e.kind == Kind::stage_end) return;
  const char* what = e.kind == Kind::step_cut ? "step cut: " : e.kind == Kind::warning ? "warning: " : "";
  line(fmt::format("{:8.3f} s  {}{}", e.time, what, e.text));
  if (often && shown_[e.kind] == kShown)
    line(fmt::format("            (further {} are in the results only)", further(e.kind)));
}

void Progress::step(double time, const coupling::RunStats& stats, const coupling::Ledger&) {
  const Clock::time_point now = Clock::now();
  if (terminal_) {
    if (now - drawn_ < std::chrono::milliseconds(100)) return;
  } else if (time < next_tenth_ * end_ && now - drawn_ < kSilence) {
    return;
  }
  drawn_ = now;
  draw(time, stats);
  while (next_tenth_ * end_ <= time) next_tenth_ += 0.1;
}

void Progress::draw(double time, const coupling::RunStats& stats) {
  const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = time > begin_ ? wall * std::max(0.0, end_ - time) / (time - begin_) : 0.0;
  const double rate = static_cast<double>(stats.steps - steps_made_) / std::max(wall, 1e-9);
  const std::string facts = fmt::format(
      "{:.3f}/{:g} s  {}  {} steps  {} steps/s  {:.0f} s left  passes {:.1f}  ledger {:.0e}", time, end_, stage_,
      stats.steps, rate < 10.0 ? fmt::format("{:.2g}", rate) : fmt::format("{:.0f}", rate), left,
      static_cast<double>(stats.passes) / static_cast<double>(std::max<std::int64_t>(stats.steps, 1)), closure_);
  if (!terminal_) {
    line(facts);
    return;
  }
  const int filled = static_cast<int>(24.0 * std::min(time / end_, 1.0));
  app::draw(fmt::format("\r\033[K[{:#<{}}{:.<{}}] {}", "", filled, "", 24 - filled, io::printable(facts)));
}

void Progress::frame(const coupling::FrameView& frame) {
  if (frame.end_time > 0.0) end_ = std::min(end_, frame.end_time);  // stages may end before their time
}

void Progress::end(const coupling::RunEnd&, const coupling::FrameView& last) {
  draw(last.time, *last.stats);
  if (terminal_) say("\n");
}

}  // namespace scree::app
