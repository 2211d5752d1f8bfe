// Large messages in pieces: MODEL and DETAIL.
#pragma once

#include <optional>
#include <scree/part_v1_t.hpp>
#include <vector>

#include "io/live/wire.h"

namespace scree::io {

/// Assembles large messages, one at a time, from their pieces. The pieces of a number are the same bytes each time they
/// are sent, so a piece that is lost is supplied by the next sending.
class PartAssembly {
 public:
  /// @param most  largest size of a complete message [bytes]   @return false: the piece is invalid
  [[nodiscard]] bool put(part_v1_t&& part, std::size_t most);
  /// The message that the last piece completed, returned once.
  [[nodiscard]] std::optional<Bytes> take();

 private:
  std::int64_t number_ = -1;  // sequence number of the present or last message
  std::vector<Bytes> pieces_;
  std::size_t missing_ = 0;  // 0: it is complete
  bool fresh_ = false;       // it is complete and has not been taken
};

}  // namespace scree::io
