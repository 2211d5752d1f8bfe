#include "coupling/contact/table/quiet_pairs.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {

void QuietPairs::begin(OutlinePositions x, std::span<const IndexRange<OutlineNode>> moving,
                       std::span<const EdgePair> near, bool listed_anew) {
  if (!known_) {
    known_ = true;
    travel_ = 0.0;
    ++epoch_;
    const std::size_t most = near.size() + near.size() / 4;  // so that steps need not allocate
    for (auto* pairs : {&pairs_, &before_}) pairs->reserve(most);
    for (auto* until : {&until_, &until_before_}) until->reserve(most);
    x_.values().assign(x.begin(), x.end());
    pairs_.assign(near.begin(), near.end());
    until_.assign(near.size(), 0.0);
    return;
  }
  double farthest = 0.0;  // squared
  bool finite = true;
  for (const IndexRange<OutlineNode> r : moving)
    for (const OutlineNode i : r) {
      const double way = (x[i] - x_[i]).squaredNorm();
      finite = finite && std::isfinite(way);
      farthest = std::max(farthest, way);
      x_[i] = x[i];
    }
  travel_ += std::sqrt(farthest);
  if (!finite) {
    std::fill(until_.begin(), until_.end(), 0.0);
    ++epoch_;
  }
  if (!listed_anew) return;
  before_.swap(pairs_);
  until_before_.swap(until_);
  pairs_.assign(near.begin(), near.end());
  until_.assign(near.size(), 0.0);
  for (std::size_t k = 0, old = 0; k < pairs_.size(); ++k) {
    while (old < before_.size() && before_[old] < pairs_[k]) ++old;
    if (old < before_.size() && before_[old] == pairs_[k]) until_[k] = until_before_[old];
  }
}

}  // namespace scree::coupling
