// `--set key=value`: changes to a parsed case from the command line.
#pragma once

#include <span>
#include <string>

#include "io/case/document.h"

namespace scree::io {

/// Applies the options in order. A key is dotted; a list is entered by number from 0 or by the name of an item:
///   stage.0.duration=0.1      material.rock.young="2 GPa"      block.slider.velocity=[1, 0]
/// Parts may be quoted. Missing tables are made; items of lists are not.
/// @throws CaseError with "--set" as the file and the number of the option as the line
void apply_overrides(Value& root, std::span<const std::string> overrides);

}  // namespace scree::io
