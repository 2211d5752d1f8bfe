// Data of the model in a stream: names, and the objects that are drawn over blocks.
#pragma once

#include <scree/model_v1_t.hpp>

#include "io/results/run_reader.h"
#include "model/model.h"

namespace scree::io {

/// MODEL of a run that is about to begin.
[[nodiscard]] model_v1_t live_model(const Model& model);
/// MODEL of a stored run.   @throws FileError
[[nodiscard]] model_v1_t live_model(const RunReader& run);

/// True when every index is in range and every position is finite.
[[nodiscard]] bool holds_together(const model_v1_t& model);

}  // namespace scree::io
