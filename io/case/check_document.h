// A parsed case against the table of keys.
#pragma once

#include <string_view>

#include "io/case/document.h"

namespace scree::io {

/// Checks every key, type, unit and range, and leaves a tree that the reader can trust: numbers as double in the unit
/// of the key (whole numbers of keys that count stay integers), defaults filled in. Top-level tables are made if they
/// have defaults and no required key.
/// @throws CaseError for the first fault in the order of the file; the keys that a table contains are checked before
///         its missing keys
void check_document(Value& root, std::string_view file);

/// Why a text cannot be a name (names become parts of paths of result files); empty if it can.
[[nodiscard]] std::string name_fault(std::string_view name);

}  // namespace scree::io
