// The water in the joints of a model in the results file.
#pragma once

#include "io/results/h5.h"
#include "model/model.h"

namespace scree::io {

/// Writes /water: the points of the piezometric lines, and the joint laws to which each line applies; tables without
/// rows where the model has no water.     @throws FileError
void write_water(const h5::File& file, const Model& model);

}  // namespace scree::io
