// Registers the tables of observed orders, which this program prints when all of its tests have run.
#include "tests/support/order_table.h"

namespace {
const auto* const kTables = testing::AddGlobalTestEnvironment(new scree::test::OrderTable);
}
