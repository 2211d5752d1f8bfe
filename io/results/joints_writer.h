// The discontinuities of a model in the results file.
#pragma once

#include "io/results/h5.h"
#include "model/model.h"

namespace scree::io {

/// Writes /joints: the laws, the lines that were drawn into the domain, and the cracks (parts of lines that end inside
/// a block); tables without rows where the model was not cut from a domain.     @throws FileError
void write_joints(const h5::File& file, const Model& model);

}  // namespace scree::io
