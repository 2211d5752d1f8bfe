#include "app/built_from.h"

namespace scree::app {

const char* built_from() { return SCREE_COMMIT; }  // by itself: a new commit compiles nothing else again

}  // namespace scree::app
