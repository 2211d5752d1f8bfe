// The supports of a model in the results file.
#pragma once

#include "io/results/h5.h"
#include "model/model.h"

namespace scree::io {

/// Writes /supports: points that springs tie to their positions at the start, and stretches of outlines that are held;
/// tables without rows where the model has none.
/// Blocks that are held as a whole are in /blocks/held.     @throws FileError
void write_supports(const h5::File& file, const Model& model);

}  // namespace scree::io
