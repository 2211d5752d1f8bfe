#include "coupling/integrate/node_chunks.h"

#include <algorithm>

namespace scree::coupling {

NodeChunks::NodeChunks(const Setup& setup) {
  const std::vector<double>& free = setup.free();
  for (std::size_t k = 0; k < free.size();) {
    std::size_t end = k + 1;
    while (end < free.size() && free[end] == free[k] && end - k < static_cast<std::size_t>(kChunk)) ++end;
    (free[k] != 0.0 ? free_ : driven_).push_back({2 * k, 2 * end});
    if (free[k] != 0.0) numbers_ += 2 * (end - k);
    k = end;
  }
  partial_.resize(free_.size());
}

}  // namespace scree::coupling
