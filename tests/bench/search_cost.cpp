// Cost of the contact search: Search::update and ContactFinder::find per step, for a brick wall at rest and one whose
// bricks all move, by number of edges. Prints microseconds per step and the growth of the cost relative to linear.
//
//   usage: bench_search_cost [steps]
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>

#include "coupling/contact/search/search.h"
#include "coupling/contact/table/contact_finder.h"
#include "tests/support/by_hand.h"

namespace scree::bench {
namespace {

/// Processor time [s]: independent of other processes.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Cost {
  double edges = 0.0, points = 0.0;
  double search = 0.0, find = 0.0;  // [s] per step
};

/// @param speed  of the bricks, each in its own direction, in detection distances per step
Cost measure(int edges, double speed, int steps) {
  test::Scene scene;
  const int bricks = edges / 4, columns = static_cast<int>(std::sqrt(bricks));
  for (int i = 0; i < bricks; ++i) {
    const int row = i / columns;
    const double x = 2.0 * (i % columns) + (row % 2);
    scene.add("b", test::rectangle(x, row, x + 2.0, row + 1.0), row == 0);
  }
  test::ByHand hand(scene.model, scene.stage("dda", coupling::Integrator::explicit_, 1.0, std::nullopt));
  const double detection = 0.05 * std::sqrt(2.0);
  coupling::Search search(*hand.setup, 2.0 * detection);
  coupling::ContactFinder finder(*hand.setup, detection);
  coupling::ContactList list, next;
  std::vector<double> q = hand.state.q;
  IndexedVector<coupling::OutlineNode, Vec2> x(hand.setup->outlines().nodes.size());
  Cost cost{4.0 * bricks, 0.0, 0.0, 0.0};
  for (int step = -3; step < steps; ++step) {
    // Each brick moves back and forth on its own line, ten steps each way: a pile that shakes and stays together.
    const double way = speed * detection * (((step + 30) / 10) % 2 == 0 ? 1.0 : -1.0);
    for (const coupling::Body& b : hand.setup->bodies()) {
      const double angle = 2.4 * static_cast<double>(b.block.value);
      if (b.driven) continue;
      q[2 * static_cast<std::size_t>(b.first_node)] += way * std::cos(angle);
      q[2 * static_cast<std::size_t>(b.first_node) + 1] += way * std::sin(angle);
    }
    for (const coupling::OutlineNode i : x.indices()) x[i] = coupling::position(hand.setup->outlines().nodes[i], q);
    const double begin = now();
    (void)search.update(x);
    const double middle = now();
    finder.find(q, list, step == -3, next);
    const double end = now();
    std::swap(list, next);
    if (step < 0) continue;
    cost.search += (middle - begin) / steps;
    cost.find += (end - middle) / steps;
    cost.points += static_cast<double>(list.points.size()) / steps;
  }
  return cost;
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 100;
  fmt::print("{:>8} {:>10} {:>8} {:>12} {:>10} {:>12} {:>10} {:>12}\n", "edges", "motion", "points", "search us",
             "to linear", "find us", "to linear", "ns a point");
  for (const double speed : {0.0, 1e-3, 0.1, 0.5}) {
    scree::bench::Cost first;
    for (const int edges : {1000, 10000, 50000}) {
      const scree::bench::Cost c = scree::bench::measure(edges, speed, steps);
      if (first.edges == 0.0) first = c;
      const double linear = c.edges / first.edges;
      fmt::print("{:>8.0f} {:>10g} {:>8.0f} {:>12.1f} {:>10.2f} {:>12.1f} {:>10.2f} {:>12.1f}\n", c.edges, speed,
                 c.points, 1e6 * c.search, c.search / first.search / linear, 1e6 * c.find, c.find / first.find / linear,
                 1e9 * c.find / c.points);
    }
  }
}
