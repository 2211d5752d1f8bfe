// Progress output of a run: a bar on a terminal, plain lines in a log.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "coupling/sink.h"
#include "coupling/stages/checkpoint.h"

namespace scree::app {

/// On a terminal one line is redrawn ten times per second; elsewhere there is a line every tenth of the run, and every
/// five seconds of a long one. Warnings and step cuts get lines of their own (at most five step cuts, and five changes
/// of a partition).
class Progress final : public coupling::Sink {
 public:
  /// @param from  null: the run is at its start
  Progress(bool terminal, double end_time, const coupling::Checkpoint* from);

  void begin(const Model& model, const coupling::Plan& plan) override;
  /// The ledger is complete at the instants of the history only: its closure is shown as of the last one.
  void history(const coupling::HistoryView& history) override { closure_ = history.ledger->relative_closure(); }
  void event(const coupling::Event& event) override;
  void frame(const coupling::FrameView& frame) override;
  void step(double time, const coupling::RunStats& stats, const coupling::Ledger& ledger) override;
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;

 private:
  using Clock = std::chrono::steady_clock;
  void line(const std::string& text);
  void draw(double time, const coupling::RunStats& stats);

  bool terminal_;
  double end_, closure_ = 0.0;
  double begin_ = 0.0;           // simulated time at which this program began [s]
  std::int64_t steps_made_ = 0;  // before it
  double next_tenth_ = 0.0;
  std::map<coupling::EventKind, int> shown_;  // of kinds that come often
  std::string stage_;
  std::vector<std::string> stages_;
  std::size_t stage_index_ = 0;
  Clock::time_point start_ = Clock::now(), drawn_{};
};

}  // namespace scree::app
