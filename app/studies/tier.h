// How much of the case library is run.
#pragma once

namespace scree::app {

/// Each tier includes the rows of the tiers before it.
enum class Tier { quick, full, exhaustive };

}  // namespace scree::app
