// Large things in pieces: MODEL and DETAIL.
#pragma once

#include <optional>
#include <scree/part_v1_t.hpp>
#include <vector>

#include "io/live/wire.h"

namespace scree::io {

/// Puts the pieces of one thing after the other together. Pieces of one number are the same bytes each time they are
/// sent, so what one sending lost the next one fills in.
class PartAssembly {
 public:
  /// @param most  bytes of a whole   @return false: no piece can be like this
  [[nodiscard]] bool put(part_v1_t&& part, std::size_t most);
  /// The whole that the last piece completed, once.
  [[nodiscard]] std::optional<Bytes> take();

 private:
  std::int64_t number_ = -1;  // of the thing that comes, or came last
  std::vector<Bytes> pieces_;
  std::size_t missing_ = 0;  // 0: it is complete
  bool fresh_ = false;       // and has not been taken
};

}  // namespace scree::io
