#include "coupling/integrate/node_chunks.h"

#include <algorithm>

namespace scree::coupling {

NodeChunks::NodeChunks(const Setup& setup) {
  std::vector<std::vector<Chunk>*> kind(static_cast<std::size_t>(setup.nodes()), &free_);
  for (std::size_t k = 0; k < kind.size(); ++k) {
    const Setup::NodeKind of = setup.kind(static_cast<std::int32_t>(k));
    if (of != Setup::NodeKind::free) kind[k] = of == Setup::NodeKind::ghost ? &ghosts_ : &driven_;
  }
  for (std::size_t k = 0; k < kind.size();) {
    std::size_t end = k + 1;
    while (end < kind.size() && kind[end] == kind[k] && end - k < static_cast<std::size_t>(kChunk)) ++end;
    kind[k]->push_back({2 * k, 2 * end});
    if (kind[k] == &free_) numbers_ += 2 * (end - k);
    k = end;
  }
  partial_.resize(free_.size());
}

}  // namespace scree::coupling
