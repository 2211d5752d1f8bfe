// The direction in which most of the length of many lines runs.
#pragma once

#include <array>
#include <cstddef>

#include "model/geometry.h"

namespace scree {

/// Adds up lengths by direction, in 180 parts of half a turn.
class MainDirection {
 public:
  MainDirection();
  /// Adds a line that leads from one end to the other by the vector d.
  void add(const Vec2& d);
  /// Unit vector along the longest line of the part that has most of the length; the x axis without any line.
  [[nodiscard]] Vec2 along() const { return along_[most()]; }
  /// Length in that part, over that of all lines.   @pre add() was called
  [[nodiscard]] double share() const { return length_[most()] / all_; }

 private:
  static constexpr std::size_t kParts = 180;
  [[nodiscard]] std::size_t most() const;

  std::array<double, kParts> length_{}, longest_{};
  std::array<Vec2, kParts> along_;
  double all_ = 0.0;
};

}  // namespace scree
