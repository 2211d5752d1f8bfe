// The built page of the viewer (io/viewer/dist), compiled into the program.
#pragma once

#include <string_view>

namespace scree::io {

[[nodiscard]] std::string_view viewer_script();    // JavaScript
[[nodiscard]] std::string_view viewer_style();     // CSS
[[nodiscard]] std::string_view viewer_body();      // HTML inside <body>
[[nodiscard]] std::string_view viewer_licences();  // of what the script holds

}  // namespace scree::io
