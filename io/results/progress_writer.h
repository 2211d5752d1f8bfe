// Progress of a run at each frame, in the results file: shown by viewers beside the frames of a replay.
#pragma once

#include <string>
#include <vector>

#include "coupling/sink.h"
#include "io/results/series_group.h"

namespace scree::io {

/// /progress/{cuts, passes, contacts, unknowns, contact_depth, contact_force, contact_depth_at, contact_force_at}: one
/// entry per frame.
class ProgressWriter : public SeriesGroup<ProgressWriter> {
 public:
  ProgressWriter(const h5::Growing& in, const Model& model);
  /// @pre frame.state and frame.stats are set
  void frame(const coupling::FrameView& frame);

 private:
  friend SeriesGroup<ProgressWriter>;
  template <class Visitor>
  void each(Visitor&& see) {
    // The numbers of unknowns are written last: every column has at least as many complete rows.
    see(cuts_), see(passes_), see(contacts_), see(depth_), see(force_), see(depth_at_), see(force_at_), see(unknowns_);
  }

  std::vector<std::string> blocks_;  // names
  h5::Series<std::int64_t> cuts_, passes_, contacts_, unknowns_;
  h5::Series<double> depth_, force_;
  h5::TextSeries depth_at_, force_at_;
};

}  // namespace scree::io
