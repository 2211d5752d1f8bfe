// Groups of a DXF text: a code in one line, its value in the next.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "io/drawing/drawing.h"

namespace scree::io {

struct DxfGroup {
  int code = 0;
  std::string_view value;  // without white space at its ends
  int row = 0;             // line of the value, from 1
};

/// Reads groups and checks that each value whose code denotes a number is a finite number.
class DxfGroups {
 public:
  /// @throws DrawingError: a binary DXF, a DWG, an empty text
  explicit DxfGroups(std::string_view text);

  /// The next group; nothing after the last.
  /// @throws DrawingError: no code, no value, no number
  [[nodiscard]] std::optional<DxfGroup> next();

 private:
  [[nodiscard]] std::optional<std::string_view> line();

  std::string_view rest_;
  int row_ = 0;
};

/// Value of a group as a number.   @pre the code denotes a number
[[nodiscard]] double real_of(const DxfGroup& group);
[[nodiscard]] std::int64_t whole_of(const DxfGroup& group);

/// True for codes that denote real numbers (is_real) and whole numbers (is_whole).
[[nodiscard]] bool is_real(int code);
[[nodiscard]] bool is_whole(int code);

}  // namespace scree::io
