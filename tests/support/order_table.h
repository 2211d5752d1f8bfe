// Errors over refinements and their orders; the program prints all of its tables at the end.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace scree::test {

struct OrderRow {
  std::string what;                 // name of the error, and of the refined quantity
  std::vector<double> size, error;  // from coarse to fine
  double least = 0.0;               // order that must hold between the two finest
  [[nodiscard]] double order(std::size_t i) const {
    return std::log(error[i - 1] / error[i]) / std::log(size[i - 1] / size[i]);
  }
  [[nodiscard]] double finest() const { return order(error.size() - 1); }
};

class OrderTable final : public testing::Environment {
 public:
  static std::vector<OrderRow>& rows() {
    static std::vector<OrderRow> all;
    return all;
  }
  void TearDown() override {
    if (rows().empty()) return;
    std::printf("\n%-62s %10s %12s %8s %8s\n", "observed orders", "size", "error", "order", "wanted");
    for (const OrderRow& r : rows())
      for (std::size_t i = 0; i < r.error.size(); ++i) {
        std::printf("%-62s %10.4g %12.4e ", i == 0 ? r.what.c_str() : "", r.size[i], r.error[i]);
        if (i == 0)
          std::printf("\n");
        else if (i + 1 < r.error.size())
          std::printf("%8.2f\n", r.order(i));
        else
          std::printf("%8.2f %8.2f\n", r.order(i), r.least);
      }
  }
};

/// Keeps a row for the table and checks its finest order.
inline void expect_order(OrderRow row) {
  EXPECT_GE(row.finest(), row.least) << row.what;
  OrderTable::rows().push_back(std::move(row));
}

/// Keeps a row for the table and checks that its two finest orders are the theoretical ones within a tenth: a higher
/// order would mean that the errors are not those of the scheme.
inline void expect_order_of(OrderRow row, double order) {
  constexpr double kWithin = 0.1;
  for (std::size_t i = row.error.size() - 2; i < row.error.size(); ++i)
    EXPECT_NEAR(row.order(i), order, kWithin) << row.what << ", size " << row.size[i];
  row.least = order - kWithin;
  OrderTable::rows().push_back(std::move(row));
}

}  // namespace scree::test
