#include "model/main_direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree {

MainDirection::MainDirection() { along_.fill(Vec2(1.0, 0.0)); }

void MainDirection::add(const Vec2& d) {
  const double turn = std::atan2(d.y(), d.x()) / std::numbers::pi + 1.0;  // 0 to 2, in half turns
  const std::size_t part = static_cast<std::size_t>(std::lround((turn - std::floor(turn)) * kParts)) % kParts;
  const double l = d.norm();
  all_ += l;
  length_[part] += l;
  if (l <= longest_[part]) return;
  longest_[part] = l;
  along_[part] = d / l;
}

std::size_t MainDirection::most() const {
  return static_cast<std::size_t>(std::max_element(length_.begin(), length_.end()) - length_.begin());
}

}  // namespace scree
