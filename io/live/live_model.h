// What a stream tells of the model: names and what is drawn over blocks.
#pragma once

#include <scree/model_v1_t.hpp>

#include "io/results/run_reader.h"
#include "model/model.h"

namespace scree::io {

/// Of a run that is about to begin.
[[nodiscard]] model_v1_t live_model(const Model& model);
/// Of a stored run.   @throws FileError
[[nodiscard]] model_v1_t live_model(const RunReader& run);

/// True when every number in it that counts another thing is in range and every position is finite.
[[nodiscard]] bool holds_together(const model_v1_t& model);

}  // namespace scree::io
