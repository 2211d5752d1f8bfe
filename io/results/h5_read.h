// Reading what h5_series.h writes: rows, texts, attributes, and the list of datasets.
#pragma once

#include <string>
#include <vector>

#include "io/results/h5.h"

namespace scree::io::h5 {

/// Rows and numbers a row of a dataset (1 for one dimension).
struct Extent {
  std::int64_t rows = 0, width = 1;
};
[[nodiscard]] Extent extent(const File& file, const std::string& name);

/// `count` rows from row `first`, row after row.   @throws FileError, also where the dataset has fewer rows
template <class T>
[[nodiscard]] std::vector<T> read(const File& file, const std::string& name, std::int64_t first, std::int64_t count);
template <class T>
[[nodiscard]] std::vector<T> read(const File& file, const std::string& name) {
  return read<T>(file, name, 0, extent(file, name).rows);
}
[[nodiscard]] std::vector<std::string> read_texts(const File& file, const std::string& name);

/// Text of an attribute; empty where there is none.
[[nodiscard]] std::string text_attribute(const File& file, const std::string& name, const std::string& key);
[[nodiscard]] std::int64_t integer_attribute(const File& file, const std::string& name, const std::string& key);

/// Paths of all datasets, sorted.
[[nodiscard]] std::vector<std::string> datasets(const File& file);
/// Names of what is directly in a group, sorted.
[[nodiscard]] std::vector<std::string> children(const File& file, const std::string& group);

}  // namespace scree::io::h5
