// Contact points of every frame in the results file.
#pragma once

#include "coupling/sink.h"
#include "io/results/h5_series.h"

namespace scree::io {

/// /contacts/{corner, edge, joint, state, ...}: a row a point, frame after frame, and /contacts/frames/{first, count},
/// a row a frame in the order of /frames: the points of frame k are the rows first[k] to first[k] + count[k] - 1.
class ContactWriter {
 public:
  explicit ContactWriter(const h5::File& file);
  /// @pre frame.contacts
  void frame(const coupling::FrameView& frame);
  void flush();
  void close();

 private:
  template <class Visitor>
  void each(Visitor&& see);

  h5::Series<std::int32_t> corner_, edge_, joint_, state_, facing_, bonded_, failed_;
  h5::Series<double> position_, normal_, share_, gap_, gap0_, fn_, ft_, water_, slip_;
  h5::Series<std::int64_t> first_, count_;
};

}  // namespace scree::io
