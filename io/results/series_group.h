// What every writer of several datasets does with all of them.
#pragma once

#include <vector>

#include "io/results/h5_series.h"

namespace scree::io {

/// Base of a writer whose each(see) calls see() for every series, what is counted before what counts it.
template <class Writer>
class SeriesGroup {
 public:
  /// Every dataset as it is now, and a start with what another file had then (results_mark.h).
  [[nodiscard]] std::vector<SeriesMark> marks() {
    std::vector<SeriesMark> out;
    self().each([&](auto& series) { out.push_back(series.mark()); });
    return out;
  }
  void take(const h5::File& from, const std::vector<SeriesMark>& marks) {
    std::size_t at = 0;
    self().each([&](auto& series) { series.take(from, marks.at(at++)); });
  }
  void flush() {
    self().each([](auto& series) { series.flush(); });
  }
  void close() {
    self().each([](auto& series) { series.close(); });
  }

 private:
  Writer& self() { return static_cast<Writer&>(*this); }
};

}  // namespace scree::io
