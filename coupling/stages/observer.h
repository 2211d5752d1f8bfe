// Converts a state into the views for sinks: mesh, points, stresses, monitors.
#pragma once

#include <chrono>
#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/sink.h"
#include "coupling/stages/bolt_observer.h"

namespace scree::coupling {

class Observer {
 public:
  /// Which frames contain the contact points. now_and_then is for a stream, which must not delay a run: as often as
  /// evaluating them takes at most 1/kShare of the wall time.
  enum class Contacts { none, now_and_then, all };
  static constexpr int kShare = 400;
  Observer(const Setup& setup, const State& state, std::uint32_t mesh_id, Contacts contacts = Contacts::none);

  [[nodiscard]] const MeshView& mesh() const { return view_; }
  /// Fills positions, velocities and stresses; valid until the next call.
  /// @param last  the last frame: it contains the contacts, except with Contacts::none
  FrameView frame(const State& state, const RunStats& stats, bool last = false);
  HistoryView history(const State& state, const RunStats& stats);

 private:
  /// Removes cells and points of absent blocks from the mesh of a pool.
  void hide_absent(const std::vector<const Body*>& bodies, MeshPart& part);
  [[nodiscard]] bool all_shown(std::size_t p) const { return hides_[p] == 0; }
  void find_stress(std::size_t p, std::span<const double> q);
  void recover_stress(const State& state);
  void see_contacts(const State& state);
  [[nodiscard]] bool contacts_due(bool last) const;

  const Setup* setup_;
  Contacts contacts_;
  std::chrono::steady_clock::time_point contacts_at_{};  // now_and_then: time from which they may be evaluated again
  std::vector<Row> points_;
  std::vector<std::int32_t> offsets_, connectivity_, cell_block_, cell_material_, cell_method_;
  std::vector<char> cell_explicit_;
  std::vector<double> origin_, position_, velocity_, stress_;
  std::vector<Row> monitors_;
  std::vector<std::size_t> monitor_pool_;
  std::vector<std::vector<char>> recovers_;     // per pool and node: 1 where a monitor needs it; empty where none does
  std::vector<std::vector<double>> recovered_;  // per pool: stress per node
  std::vector<double> monitor_position_, monitor_displacement_, monitor_velocity_, monitor_stress_;
  std::vector<std::int32_t> pool_cells_;          // first cell of each pool
  std::vector<char> hides_;                       // per pool: 1 where some of its blocks are absent,
  std::vector<std::vector<std::int32_t>> shown_;  // and the cells that are shown
  std::vector<double> all_stress_;                // of a pool with hidden cells
  std::vector<double> contact_position_, contact_normal_;
  ContactView contact_view_;
  BoltObserver bolts_;
  MeshView view_;
};

}  // namespace scree::coupling
