// How blocks of a run move: they slide, topple or fall.
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
  double slip = 0.0;            // largest growth of slip at its contacts [m]
  double gap = 0.0;             // largest opening at its contacts that were closed [m]
  double speed = 0.0;           // of its centroid, at the later frame [m/s]
  double first_speed = 0.0;     // of its centroid, at the earlier frame [m/s]
  double area = 0.0;            // [m2]
  bool touches = true;          // at the later frame
  Mode mode = Mode::stands;
};

/// Motions of all blocks that are not held.
/// @param from,to  frames of one mesh   @throws FileError
[[nodiscard]] std::vector<BlockMotion> block_motions(const io::RunReader& run, std::size_t from, std::size_t to);

/// Sets the mode of every motion. A block moves if its displacement, of the centroid or by rotation, |rotation| radius,
/// exceeds a tenth of the largest one. It falls if it touches nothing, or accelerates as if it touched nothing (three
/// quarters of g, downwards). Otherwise the ratio of the displacement by rotation to that of the centroid decides:
/// above 0.6 the block topples, below 0.2 it slides, in between it does both; but a block that rotates without slip at
/// its contacts (less than a twentieth of the displacement of the centroid) topples.
/// @param seconds  between the frames, from rest; 0: unknown   @param gravity  [m/s2]
void name_modes(std::vector<BlockMotion>& motions, double seconds, const Vec2& gravity);

/// The mode with the largest sum of area times displacement over its blocks. stands: no block moves.
[[nodiscard]] Mode leading_mode(const std::vector<BlockMotion>& motions);

}  // namespace scree::app
