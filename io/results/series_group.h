// Operations on all datasets of a writer.
#pragma once

#include <vector>

#include "io/results/h5_series.h"

namespace scree::io {

/// Base of a writer whose each(see) calls see() for every series, the rows before the series that count them.
template <class Writer>
class SeriesGroup {
 public:
  /// marks(): rows and hash of every dataset now. take(): appends the rows that another file had at such marks
  /// (results_mark.h).
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
