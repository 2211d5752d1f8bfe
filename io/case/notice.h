// What a long piece of reading tells before it begins.
#pragma once

#include <functional>
#include <string>

namespace scree::io {

/// Takes a line of text, without its end.
using Notice = std::function<void(const std::string&)>;

}  // namespace scree::io
