#include "coupling/integrate/node_chunks.h"

#include <algorithm>

namespace scree::coupling {

NodeChunks::NodeChunks(const Setup& setup) {
  const auto list_of = [&](Setup::NodeKind kind) {
    switch (kind) {
      case Setup::NodeKind::driven:
        return &driven_;
      case Setup::NodeKind::resting:
        return &resting_;
      case Setup::NodeKind::ghost:
        return &ghosts_;
      case Setup::NodeKind::free:
        break;
    }
    return &free_;
  };
  std::vector<std::vector<Chunk>*> kind;
  kind.reserve(static_cast<std::size_t>(setup.nodes()));
  for (std::int32_t k = 0; k < setup.nodes(); ++k) kind.push_back(list_of(setup.kind(k)));
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
