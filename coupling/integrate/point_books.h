// Work and energies of an implicit step's contact points, booked on threads.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "coupling/contact/table/contact_pairs.h"
#include "coupling/ledger/ledger.h"
#include "model/parallel.h"

namespace scree::coupling {

/// Books point after point in chunks of kContactChunk, each in a ledger of its own; these are added in the order of the
/// points, so that the sums have the same bits for any number of threads. Keeps its scratch between steps.
class PointBooks {
 public:
  struct Chunk {
    Ledger ledger;                                       // increments of its points
    std::vector<std::pair<std::size_t, double>> slides;  // points whose friction is to be checked, and their slip [m]
    double energy = 0.0;                                 // of springs [J]
    bool adopts = false;                                 // a point may change to another kind
  };

  /// of_point(i, booking, chunk) for i in [0, points).
  template <class OfPoint>
  void book(std::size_t points, bool on_threads, Ledger& ledger, OfPoint&& of_point) {
    constexpr std::int64_t kFew = 2048;  // fewer points are not worth waking threads
    const auto n = static_cast<std::int64_t>(points);
    chunks_.resize(static_cast<std::size_t>((n + kContactChunk - 1) / kContactChunk));
    const auto of_chunk = [&](std::int64_t begin, std::int64_t end) {
      Chunk& chunk = chunks_[static_cast<std::size_t>(begin / kContactChunk)];
      chunk.ledger = Ledger();
      chunk.slides.clear();
      chunk.energy = 0.0;
      chunk.adopts = false;
      Ledger::Booking booking(chunk.ledger);
      for (std::int64_t i = begin; i < end; ++i) of_point(static_cast<std::size_t>(i), booking, chunk);
    };
    parallel_for_chunks(n, of_chunk, on_threads ? kFew : n + 1, kContactChunk);
    for (const Chunk& chunk : chunks_) ledger.add(chunk.ledger);
  }
  /// Those of the last book().
  [[nodiscard]] const std::vector<Chunk>& chunks() const { return chunks_; }

 private:
  std::vector<Chunk> chunks_;
};

}  // namespace scree::coupling
