// What the open-close iteration keeps to solve systems of affine bodies by blocks.
#pragma once

#include <vector>

#include "coupling/integrate/block_system.h"
#include "coupling/linear/block_ilu.h"
#include "coupling/linear/conjugate_residuals.h"

namespace scree::coupling {

/// The solver of affine bodies, in a step.
struct BlockSolver {
  explicit BlockSolver(const ImplicitSystem& of) : system(of) {}
  BlockSystem system;
  BlockIlu factor;
  std::vector<PointTangent> tangents;  // of the points, as the states are
  std::vector<double> first_guess;     // of the pass
  bool acts = false;                   // this step is solved by it
  bool fell_back = false;              // this step began with it
  bool stale = false;                  // the factor is of other states
  bool worn = false;                   // and takes more iterations than it is worth
  int fresh_iterations = -1;           // that it took when it was new; -1: not used yet
  double work = 0.0;                   // of the step, in products of a block and a vector
};

/// Clusters of bodies whose contact states settle by themselves, one at a time.
struct BodyClusters {
  std::vector<char> inside;                   // per body: 0 outside, 1 inside, 2 and found
  std::vector<std::int32_t> bodies, cluster;  // all inside; those of the cluster at hand, in order
  std::vector<std::int32_t> place;            // per body: in the cluster
  std::vector<BlockMatrix::Pair> pairs;
  std::vector<std::size_t> points, seen;  // of the cluster, in order; hashes of states that it has had
  std::vector<double> unit, residual, change, normal, tangential;
  BlockMatrix matrix;
  BlockIlu factor;
  ConjugateResiduals residuals;
};

}  // namespace scree::coupling
