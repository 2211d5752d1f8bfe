// The commit that the program was built from.
#pragma once

namespace scree::app {

/// The first twelve digits of its hash; empty where the sources were in no repository when the build was configured.
[[nodiscard]] const char* built_from();

}  // namespace scree::app
