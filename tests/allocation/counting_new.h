// Counts every operator new of the program that it is linked into.
#pragma once

#include <cstdint>

namespace scree::test {

[[nodiscard]] std::int64_t allocations_so_far();

}  // namespace scree::test
