// How blocks of a run move: they slide, topple or fall.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/results/run_reader.h"

namespace scree::app {

enum class Mode { stands, slides, topples, slides_and_topples, falls };
[[nodiscard]] std::string_view name(Mode mode);

/// What a block did between two frames.
struct BlockMotion {
  std::string name;
  Vec2 displacement{0.0, 0.0};  // of its centroid [m]
  double rotation = 0.0;        // counter-clockwise [rad]
  double radius = 0.0;          // from the centroid to its farthest point [m]
  double slip = 0.0;            // largest at its contacts: how much it has grown [m]
  double gap = 0.0;             // largest opening at its contacts that were closed [m]
  double speed = 0.0;           // of its centroid, at the later frame [m/s]
  double first_speed = 0.0;     // the same at the earlier frame
  double area = 0.0;            // [m2]
  bool touches = true;          // at the later frame
  Mode mode = Mode::stands;
};

/// Motions of all blocks that are not held.
/// @param from,to  frames of one mesh   @throws FileError
[[nodiscard]] std::vector<BlockMotion> block_motions(const io::RunReader& run, std::size_t from, std::size_t to);

/// Gives every motion its mode. A block moves that has gone a tenth as far as the farthest, by its centroid or by
/// turning. It falls where it touches nothing, or accelerates as if it did (three quarters of g, downwards). Else the
/// way by turning, |rotation| radius, over that of the centroid tells: above 0.6 it topples, below 0.2 it slides, and
/// does both between; one that turns without slip at its contacts, a twentieth of its way, topples.
/// @param seconds  between the frames, from rest; 0: unknown   @param gravity  [m/s2]
void name_modes(std::vector<BlockMotion>& motions, double seconds, const Vec2& gravity);

/// The mode of most of what moves, by area times way. stands: nothing moves.
[[nodiscard]] Mode leading_mode(const std::vector<BlockMotion>& motions);

}  // namespace scree::app
