// How much of the case library is run.
#pragma once

namespace scree::app {

/// Each has the rows of those before it.
enum class Tier { quick, full, exhaustive };

}  // namespace scree::app
