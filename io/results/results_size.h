// How large the results of a run are going to be, before its first step: what chunks are sized by.
#pragma once

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::io {

/// Rows that are expected, from the case alone: the same for every run of it, however often it is stopped. Stages that
/// end by their rules, and blocks that change method on the way, make it less or more; nothing depends on it but the
/// size of the file and the time to write it.
struct ResultsSize {
  double frames = 0.0, samples = 0.0;  // samples: of monitors and ledger
  double points = 0.0, cells = 0.0;    // of the finest mesh, a frame
  double contacts = 0.0;               // contact points a frame; 0: not stored
  /// Of all frames, before they are deflated.
  [[nodiscard]] double bytes() const { return frames * (72.0 * points + 88.0 * cells + 140.0 * contacts); }
};

[[nodiscard]] ResultsSize results_size(const Model& model, const coupling::Plan& plan);

}  // namespace scree::io
