// Loops over the values of free and of driven nodes, in fixed chunks: sums have the same bits for any number of
// threads.
#pragma once

#include <vector>

#include "coupling/bodies/setup.h"
#include "model/parallel.h"

namespace scree::coupling {

/// A range of the state's arrays (two values per node).
struct Chunk {
  std::size_t begin = 0, end = 0;
  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// The nodes of the free bodies and of all others, cut into chunks that stay in a core's nearest cache.
class NodeChunks {
 public:
  explicit NodeChunks(const Setup& setup);

  /// Calls see(chunk, index) for every chunk of free nodes; iterations must not share anything they write.
  template <class See>
  void for_free(See&& see) const {
    const auto count = static_cast<std::int64_t>(free_.size());
    if (numbers_ < 2 * static_cast<std::size_t>(kSerialBelow)) {
      for (std::size_t c = 0; c < free_.size(); ++c) see(free_[c], c);
      return;
    }
#pragma omp parallel for schedule(static)
    for (std::int64_t c = 0; c < count; ++c) see(free_[static_cast<std::size_t>(c)], static_cast<std::size_t>(c));
  }
  /// Sum of of(chunk) over the free nodes, in order.
  template <class Of>
  [[nodiscard]] double sum_free(Of&& of) const {
    for_free([&](const Chunk& c, std::size_t i) { partial_[i] = of(c); });
    double sum = 0.0;
    for (const double p : partial_) sum += p;
    return sum;
  }
  [[nodiscard]] std::size_t count() const { return free_.size(); }
  /// Nodes of bodies with a prescribed motion, of bodies at rest, and of ghosts, which another integrator moves.
  [[nodiscard]] const std::vector<Chunk>& driven() const { return driven_; }
  [[nodiscard]] const std::vector<Chunk>& resting() const { return resting_; }
  [[nodiscard]] const std::vector<Chunk>& ghosts() const { return ghosts_; }

 private:
  std::vector<Chunk> free_, driven_, resting_, ghosts_;
  std::size_t numbers_ = 0;
  mutable std::vector<double> partial_;
};

/// x.y over a chunk.
[[nodiscard]] inline double dot(const Chunk& c, const double* x, const double* y) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = c.begin; i < c.end; ++i) sum += x[i] * y[i];
  return sum;
}
[[nodiscard]] inline double dot(const std::vector<Chunk>& chunks, const double* x, const double* y) {
  double sum = 0.0;
  for (const Chunk& c : chunks) sum += dot(c, x, y);
  return sum;
}

}  // namespace scree::coupling
