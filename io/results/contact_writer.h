// Contact points of every frame in the results file.
#pragma once

#include "coupling/sink.h"
#include "io/results/series_group.h"

namespace scree::io {

/// /contacts/{corner, edge, joint, state, ...}: one row per contact point, frame after frame, and
/// /contacts/frames/{first, count}: one row per frame in the order of /frames. The contact points of frame k are the
/// rows first[k] to first[k] + count[k] - 1.
class ContactWriter : public SeriesGroup<ContactWriter> {
 public:
  /// @param in  its rows: expected number of contact points of all frames
  ContactWriter(const h5::Growing& in, double frames);
  /// @pre frame.contacts
  void frame(const coupling::FrameView& frame);

 private:
  friend SeriesGroup<ContactWriter>;
  template <class Visitor>
  void each(Visitor&& see) {
    // The rows are written before the datasets that refer to them.
    see(corner_), see(edge_), see(joint_), see(state_), see(facing_), see(bonded_), see(failed_);
    see(position_), see(normal_), see(share_), see(gap_), see(gap0_), see(fn_), see(ft_), see(water_), see(slip_);
    see(first_), see(count_);
  }

  h5::Series<std::int32_t> corner_, edge_, joint_, state_, facing_, bonded_, failed_;
  h5::Series<double> position_, normal_, share_, gap_, gap0_, fn_, ft_, water_, slip_;
  h5::Series<std::int64_t> first_, count_;
};

}  // namespace scree::io
