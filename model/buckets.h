// Items sorted into buckets on threads.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/parallel.h"

namespace scree {

/// Sorts items into buckets, those of one bucket in the order of the items. Keeps its scratch.
class Buckets {
 public:
  /// @param first      receives the place of the first item of every bucket, and the number of items
  /// @param for_items  for_items(begin, end, see) calls see(bucket, item) for the items of buckets from begin to end,
  ///                   in order; it is called twice, for different buckets on several threads
  /// @param put        put(place, item) is called once per item
  template <class ForItems, class Put>
  void sort(std::span<std::int32_t> first, bool on_threads, ForItems&& for_items, Put&& put) {
    const auto buckets = static_cast<std::int32_t>(first.size()) - 1;
    count_.assign(static_cast<std::size_t>(omp_get_max_threads()) + 1, 0);
    next_.resize(first.size());
    parallel_parts(buckets, on_threads, [&](std::int64_t part, std::int32_t begin, std::int32_t end) {
      std::fill(next_.begin() + begin, next_.begin() + end, 0);
      std::int32_t count = 0;
      for_items(begin, end, [&](std::int32_t bucket, const auto&) {
        ++next_[static_cast<std::size_t>(bucket)];
        ++count;
      });
      count_[static_cast<std::size_t>(part) + 1] = count;
    });
    for (std::size_t p = 1; p < count_.size(); ++p) count_[p] += count_[p - 1];
    parallel_parts(buckets, on_threads, [&](std::int64_t part, std::int32_t begin, std::int32_t end) {
      std::int32_t place = count_[static_cast<std::size_t>(part)];
      for (auto b = static_cast<std::size_t>(begin); b < static_cast<std::size_t>(end); ++b) {
        first[b] = place;
        place += std::exchange(next_[b], place);
      }
      for_items(begin, end,
                [&](std::int32_t bucket, const auto& item) { put(next_[static_cast<std::size_t>(bucket)]++, item); });
    });
    first.back() = count_.back();
  }

 private:
  std::vector<std::int32_t> next_, count_;  // the place of a bucket's next item; items of a part, then before it
};

}  // namespace scree
