// Data of the block solver: systems of affine bodies in the open-close iteration.
#pragma once

#include <vector>

#include "coupling/integrate/block_system.h"
#include "coupling/linear/block_ilu.h"
#include "coupling/linear/conjugate_residuals.h"

namespace scree::coupling {

/// Block solver of affine bodies, with its state in a step.
struct BlockSolver {
  explicit BlockSolver(const ImplicitSystem& of) : system(of) {}
  BlockSystem system;
  BlockIlu factor;
  std::vector<double> first_guess;  // of the unknowns in a pass
  bool acts = false;                // this step is solved by blocks
  bool fell_back = false;           // this step began by blocks and changed to a complete factor
  bool stale = false;               // the factor was made for other contact states
  bool worn = false;                // its additional iterations cost more than a new factor
  int fresh_iterations = -1;        // iterations when the factor was new; -1: not used yet
  double work = 0.0;                // work of the step, in products of a block and a vector
};

/// Clusters of bodies; contact states are settled in one cluster after the other.
struct BodyClusters {
  std::vector<char> inside;                   // per body: 0 outside, 1 inside, 2 inside and assigned to a cluster
  std::vector<std::int32_t> bodies, cluster;  // all bodies inside; those of the present cluster, sorted
  std::vector<std::int32_t> place;            // per body: index in the cluster
  std::vector<BlockMatrix::Pair> pairs;
  std::vector<std::size_t> points, seen;  // of the cluster, sorted; hashes of its earlier states
  std::vector<double> unit, residual, change, normal, tangential;
  BlockMatrix matrix;
  BlockIlu factor;
  ConjugateResiduals residuals;
};

}  // namespace scree::coupling
