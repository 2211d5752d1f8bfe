// Estimate of the size of the results of a run before its first step; determines the size of chunks.
#pragma once

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::io {

/// Expected numbers of rows, from the case alone: the same for every run of the case, however often it is stopped.
/// Stages that end by their rules, and blocks that change method, change the actual numbers; only the size of the file
/// and the time to write it depend on the estimate.
struct ResultsSize {
  double frames = 0.0, samples = 0.0;  // samples: of monitors and ledger
  double points = 0.0, cells = 0.0;    // of the finest mesh, per frame
  double contacts = 0.0;               // contact points per frame; 0: not stored
  /// Bytes of all frames, before they are deflated.
  [[nodiscard]] double bytes() const { return frames * (72.0 * points + 88.0 * cells + 140.0 * contacts); }
};

[[nodiscard]] ResultsSize results_size(const Model& model, const coupling::Plan& plan);

}  // namespace scree::io
