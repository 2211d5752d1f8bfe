// Message before a part of the reading that may take long.
#pragma once

#include <functional>
#include <string>

namespace scree::io {

/// Receives a line of text, without its line end.
using Notice = std::function<void(const std::string&)>;

}  // namespace scree::io
