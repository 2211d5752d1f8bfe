// Parallel loops whose results do not depend on the number of threads: slots are filled in parallel, sums run over
// chunks of fixed size in fixed order.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/indexed.h"

namespace scree {

inline constexpr std::int64_t kChunk = 512;         // items per partial sum
inline constexpr std::int64_t kSerialBelow = 4096;  // fewer items run serially: waking threads costs more

/// body(i) for i in [0, n); iterations must not share anything they write.
/// @param serial_below  loops over fewer items run serially: waking threads would cost more
template <class Body>
void parallel_for(std::int64_t n, Body&& body, std::int64_t serial_below = kSerialBelow) {
  if (n < serial_below) {  // a parallel region costs something even with one thread
    for (std::int64_t i = 0; i < n; ++i) body(i);
    return;
  }
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < n; ++i) body(i);
}

/// body(i) for the indices of a range, as above.
template <class Index, class Body>
void parallel_for(IndexRange<Index> range, Body&& body, std::int64_t serial_below = kSerialBelow) {
  parallel_for(
      range.size(), [&](std::int64_t k) { body(range.first() + static_cast<std::int32_t>(k)); }, serial_below);
}

/// chunk(begin, end) over [0, n) in chunks of `size`.
/// @param serial_below  loops over fewer items run serially: waking threads would cost more
template <class Chunk>
void parallel_for_chunks(std::int64_t n, Chunk&& chunk, std::int64_t serial_below = kSerialBelow,
                         std::int64_t size = kChunk) {
  const std::int64_t chunks = (n + size - 1) / size;
  const auto end_of = [n, size](std::int64_t c) { return c * size + size < n ? c * size + size : n; };
  if (n < serial_below) {
    for (std::int64_t c = 0; c < chunks; ++c) chunk(c * size, end_of(c));
    return;
  }
#pragma omp parallel for schedule(static)
  for (std::int64_t c = 0; c < chunks; ++c) chunk(c * size, end_of(c));
}

/// out = what of(i, list) appends to `list` for i in [0, n), in the order of i.
/// @param by_chunk  scratch
template <class Item, class Of>
void parallel_list(std::int64_t n, std::vector<std::vector<Item>>& by_chunk, std::vector<Item>& out, Of&& of,
                   std::int64_t serial_below = kSerialBelow) {
  by_chunk.resize(static_cast<std::size_t>((n + kChunk - 1) / kChunk));
  parallel_for_chunks(
      n,
      [&](std::int64_t begin, std::int64_t end) {
        std::vector<Item>& list = by_chunk[static_cast<std::size_t>(begin / kChunk)];
        list.clear();
        for (std::int64_t i = begin; i < end; ++i) of(i, list);
      },
      serial_below);
  out.clear();
  for (const std::vector<Item>& list : by_chunk) out.insert(out.end(), list.begin(), list.end());
}

/// Sum of chunk(begin, end) over [0, n) in chunks of kChunk: the same bits for any number of threads.
template <class Chunk>
double parallel_sum(std::int64_t n, std::vector<double>& partial, Chunk&& chunk,
                    std::int64_t serial_below = kSerialBelow) {
  partial.resize(static_cast<std::size_t>((n + kChunk - 1) / kChunk));
  parallel_for_chunks(
      n,
      [&](std::int64_t begin, std::int64_t end) {
        partial[static_cast<std::size_t>(begin / kChunk)] = chunk(begin, end);
      },
      serial_below);
  double sum = 0.0;
  for (double p : partial) sum += p;
  return sum;
}

/// The largest of(i) for i in [0, n), at least 0: the same for any number of threads, as no number is rounded.
template <class Of>
double parallel_largest(std::int64_t n, Of&& of, std::int64_t serial_below = kSerialBelow) {
  double out = 0.0;
  if (n < serial_below) {
    for (std::int64_t i = 0; i < n; ++i) out = std::max(out, of(i));
    return out;
  }
#pragma omp parallel for schedule(static) reduction(max : out)
  for (std::int64_t i = 0; i < n; ++i) out = std::max(out, of(i));
  return out;
}

/// of_part(part, begin, end): [0, n) divided into as many parts as there are threads, or left whole. For sums over
/// items that are not in the order of their slots: each part adds to its own slots, in the order of the items.
template <class OfPart>
void parallel_parts(std::int32_t n, bool on_threads, OfPart&& of_part) {
  const std::int64_t parts = on_threads ? omp_get_max_threads() : 1;
  const auto begin_of = [&](std::int64_t part) { return static_cast<std::int32_t>(n * part / parts); };
  parallel_for(
      parts, [&](std::int64_t part) { of_part(part, begin_of(part), begin_of(part + 1)); }, 2);
}

/// The slots that a chunk of items adds to, so that a part can leave out chunks that do not concern it.
struct Reach {
  std::int32_t begin = std::numeric_limits<std::int32_t>::max(), end = 0;

  void take(std::int32_t slot) {
    begin = std::min(begin, slot);
    end = std::max(end, slot + 1);
  }
  [[nodiscard]] bool meets(std::int32_t first, std::int32_t last) const { return begin < last && first < end; }
};

}  // namespace scree
