// Groups of a DXF text: a code in one line, its value in the next.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "io/drawing/drawing.h"

namespace scree::io {

struct DxfGroup {
  int code = 0;
  std::string_view value;  // without white space at its end, numbers without any around
  int row = 0;             // line of the value, from 1
};

/// Reads groups and checks that values that are numbers by their code are numbers, and finite.
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

/// Number of a group.   @pre the code is that of a number
[[nodiscard]] double real_of(const DxfGroup& group);
[[nodiscard]] std::int64_t whole_of(const DxfGroup& group);

/// True for codes whose values are reals, and whole numbers.
[[nodiscard]] bool is_real(int code);
[[nodiscard]] bool is_whole(int code);

}  // namespace scree::io
