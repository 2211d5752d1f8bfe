// The command line of `scree`: commands, their options, and the messages about wrong ones.
#pragma once

namespace scree::app {

/// Reads the command line and carries out its command.
/// @return exit code (commands.h)   @throws what the commands throw
[[nodiscard]] int dispatch(int argc, char** argv);

}  // namespace scree::app
