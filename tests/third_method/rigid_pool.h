// The third method of the examples, for tests.
#pragma once

#include "docs/examples/embed/rigid_pool.h"

namespace scree::test {
using rigid::RigidPool;
}  // namespace scree::test
