// The systems of the open-close iteration solved by blocks: affine bodies, incomplete factor.
#include <algorithm>
#include <cmath>

#include "coupling/integrate/open_close.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

// Work is counted in products of a block and a vector. The factors are estimates from walls of 915 and 10,050 blocks;
// what matters is the order of magnitude.

/// Solutions with a complete factor that cost as much as a new factor.
constexpr double kSolutionsPerFactor = 12.0;
/// Number of solutions in a step that keeps the factor of the previous step.
constexpr double kQuietSolutions = 4.0;

/// One iteration: the product and the incomplete factor read all blocks once each, the latter in half the memory;
/// orthogonalisation reads the unknowns some ten times.
double iteration_work(double blocks, double bodies) { return 1.75 * blocks + 4.0 * bodies; }
/// An incomplete factor: some 4 products of two blocks for each below the diagonal, of which it has a third more than
/// the matrix, and an inverse per body.
double incomplete_work(double blocks, double bodies) { return 8.0 * blocks + 10.0 * bodies; }
/// One solution with a complete factor. Fill of n bodies in a plane, ordered by minimum degree, is about n log n.
double solution_work(double bodies) { return 8.0 * bodies * std::log2(bodies + 1.0); }

}  // namespace

void OpenClose::begin_blocks() {
  BlockSolver& b = blocks_;
  b.work = 0.0;
  b.fresh_iterations = -1;
  b.fell_back = false;
  b.factor.clear();
  b.acts = factor_ == Factor::chosen && system_->affine() && damping_.empty() && choice_.direct == 0 &&
           b.system.begin(rows_, springs_->size());
}

bool OpenClose::take_blocks(bool fresh, StepReport& report) {
  BlockSolver& b = blocks_;
  b.system.assemble(A_, fresh, springs_->k, springs_->at, states_.size(),
                    [this](std::int64_t i) { return states_.linear_force(static_cast<std::size_t>(i)); });
  b.stale = true;
  // A factor of other states is used until its additional iterations cost as much as a new one.
  if (b.factor.made() && !b.worn) return true;
  return factorise_blocks(report);
}

bool OpenClose::factorise_blocks(StepReport& report) {
  BlockSolver& b = blocks_;
  b.stale = b.worn = false;
  b.fresh_iterations = -1;
  b.work += incomplete_work(static_cast<double>(b.system.matrix().blocks()), b.system.matrix().rows());
  ++report.incomplete_factors;
  return b.factor.factorise(b.system.matrix(), system_->unit());
}

bool OpenClose::solve_blocks(std::span<double> d, StepReport& report) {
  constexpr int kMost = 120;  // walls of up to 10,050 blocks take 40 per step of 1 ms; more means a stall
  BlockSolver& b = blocks_;
  b.first_guess.assign(d.begin(), d.end());
  const double iteration = iteration_work(static_cast<double>(b.system.matrix().blocks()), b.system.matrix().rows());
  int taken = improve(kMost, d, report);
  b.work += iteration * (taken >= 0 ? taken : kMost);
  if (taken < 0 && b.stale) {
    std::copy(b.first_guess.begin(), b.first_guess.end(), d.begin());
    if (!factorise_blocks(report)) return false;
    taken = improve(kMost, d, report);
    b.work += iteration * (taken >= 0 ? taken : kMost);
  }
  if (taken < 0) {
    std::copy(b.first_guess.begin(), b.first_guess.end(), d.begin());
    return false;
  }
  constexpr int kWorn = 5;  // iterations that cost as much as a factor
  if (b.fresh_iterations < 0) b.fresh_iterations = taken;
  b.worn = taken > b.fresh_iterations + kWorn;
  return true;
}

int OpenClose::iterate_blocks(double part_of, double least, int most, std::span<double> d) {
  using In = std::span<const double>;
  using Out = std::span<double>;
  const auto unit = system_->unit();
  const double of_bodies = parallel_largest(std::ssize(base_), [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    return std::abs(base_[i]) / unit[i];
  });
  // The forces at the first guess are known once its residual is.
  const auto enough = [&] { return std::max(least, part_of * std::max(of_bodies, blocks_.system.largest_force())); };
  return residuals_.solve([this](In x, Out y) { blocks_.system.balance(x, y); },
                          [this](In x, Out y) { blocks_.system.matrix().multiply(x, y); },
                          [this](In r, std::span<float> z) { blocks_.factor.solve(r, z); }, base_, unit, enough, most,
                          d);
}

bool OpenClose::find_left(std::span<double> left) const {
  if (!blocks_.acts) return false;
  const auto in_units = residuals_.residual(), unit = system_->unit();
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = in_units[i] * unit[i];
  return true;
}

void OpenClose::leave_blocks(StepReport& report) {
  blocks_.acts = false;
  blocks_.fell_back = true;
  current_ = false;
  ++report.fallbacks;
  apply_states();
}

void OpenClose::choose_solver() {
  KeptFactor::Choice& c = choice_;
  const double solution = solution_work(system_->dofs() / 6.0), factor = kSolutionsPerFactor * solution;
  if (blocks_.fell_back) {
    constexpr std::int32_t kLongest = 15;
    c.direct = c.hold = c.next_hold = std::min(2 * c.next_hold + 1, kLongest);
    c.excess = 0.0;
    return;
  }
  if (c.hold > 0) {
    if (--c.hold == 0) c.direct = 0;
    return;
  }
  // Additional work of the present solver over the other: once it adds up to a factor, the other one is used; the more
  // often such a change has been reversed, the later.
  constexpr std::int32_t kMostReturns = 6;
  if (c.direct == 0) {
    if (!blocks_.acts) return;  // the next step can probably not be solved by blocks either
    const double quiet = kQuietSolutions * solution;
    c.block_work = blocks_.work;
    c.excess = std::max(0.0, c.excess + blocks_.work - quiet - (counts_.switches > 0 ? factor : 0.0));
    if (c.excess <= factor * static_cast<double>(1 << c.returns)) return;
    c.direct = 1;
  } else {
    const double work = solution * counts_.corrections + factor * counts_.factorisations;
    c.excess = std::max(0.0, c.excess + work - c.block_work);
    if (c.excess <= 2.0 * factor) return;  // one of the two is the factor of the first step
    c.direct = 0;
    c.returns = std::min(c.returns + 1, kMostReturns);
  }
  c.excess = 0.0;
}

}  // namespace scree::coupling
