// Bolts on a snapshot.
#pragma once

#include "io/pictures/plot_area.h"
#include "io/results/run_reader.h"

namespace scree::io {

/// Draws the bolts of a frame as lines whose width grows with the axial force, relative to the largest of the frame;
/// broken bolts and those without force as thin lines.
void draw_bolts(const Canvas& canvas, const PlotArea& area, const StoredBolts& bolts);

/// The colour of bolts in every picture.
inline constexpr Colour kBoltInk{0.75, 0.1, 0.45};

/// A bolt of 14 pt for a legend, its left end at (x, y).
void draw_bolt_sample(const Canvas& canvas, double x, double y);

}  // namespace scree::io
