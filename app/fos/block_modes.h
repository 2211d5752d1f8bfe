// Modes of motion of the blocks of a run: sliding, toppling, falling.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/results/run_reader.h"

namespace scree::app {

enum class Mode { stands, slides, topples, slides_and_topples, falls };
[[nodiscard]] std::string_view name(Mode mode);

/// Motion of a block between two frames.
struct BlockMotion {
  std::string name;
  Vec2 displacement{0.0, 0.0};  // of its centroid [m]
  double rotation = 0.0;        // counter-clockwise [rad]
  double radius = 0.0;          // from the centroid to its farthest point [m]
  double slip = 0.0;            // largest increase of slip at its contacts [m]
  double gap = 0.0;             // largest increase of the opening at its contacts [m]
  double speed = 0.0;           // of its centroid, at the later frame [m/s]
  double first_speed = 0.0;     // of its centroid, at the earlier frame [m/s]
  double area = 0.0;            // [m2]
  bool touches = true;          // has a closed contact at the later frame
  Mode mode = Mode::stands;
};

/// Motions of all blocks that are not held, from one frame to another.
/// @param from,to  frame numbers; both frames have the same mesh   @throws FileError
[[nodiscard]] std::vector<BlockMotion> block_motions(const io::RunReader& run, std::size_t from, std::size_t to);

/// Sets the mode of every motion. A block moves if the displacement of its centroid, or its displacement by rotation,
/// |rotation| radius, exceeds a tenth of the largest displacement of all blocks. A block that moves falls if it has no
/// closed contact, or if its mean downward acceleration from rest exceeds three quarters of g. Otherwise the ratio of
/// the displacement by rotation to that of the centroid determines the mode: above 0.6 the block topples, below 0.2 it
/// slides, between these it does both. With a ratio between these, a block whose slip at its contacts is less than a
/// twentieth of the displacement of its centroid topples.
/// @param seconds  time between the frames, the first of which is at rest; 0: unknown   @param gravity  [m/s2]
void name_modes(std::vector<BlockMotion>& motions, double seconds, const Vec2& gravity);

/// The mode whose blocks have the largest sum of area times displacement; Mode::stands if no block moves.
[[nodiscard]] Mode leading_mode(const std::vector<BlockMotion>& motions);

}  // namespace scree::app
