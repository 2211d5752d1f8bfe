#include "app/built_from.h"

namespace scree::app {

const char* built_from() { return SCREE_COMMIT; }  // in a file of its own: a new commit recompiles nothing else

}  // namespace scree::app
