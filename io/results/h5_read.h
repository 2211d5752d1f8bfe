// Reading what h5_series.h writes: rows, texts, attributes, and the list of datasets.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/results/h5.h"

namespace scree::io::h5 {

/// Number of rows of a dataset and of numbers per row (width: 1 for one dimension).
struct Extent {
  std::int64_t rows = 0, width = 1;
};
[[nodiscard]] Extent extent(const File& file, const std::string& name);

/// `count` rows from row `first` on, one after the other.   @throws FileError, also where the dataset has fewer rows
template <class T>
[[nodiscard]] std::vector<T> read(const File& file, const std::string& name, std::int64_t first, std::int64_t count);
template <class T>
[[nodiscard]] std::vector<T> read(const File& file, const std::string& name) {
  return read<T>(file, name, 0, extent(file, name).rows);
}
[[nodiscard]] std::vector<std::string> read_texts(const File& file, const std::string& name);

/// Text of an attribute; empty where the attribute is missing.
[[nodiscard]] std::string text_attribute(const File& file, const std::string& name, const std::string& key);
[[nodiscard]] std::int64_t integer_attribute(const File& file, const std::string& name, const std::string& key);
[[nodiscard]] bool has_attribute(const File& file, const std::string& name, const std::string& key);
/// Two numbers of an attribute; zeros where the attribute is missing.
[[nodiscard]] std::array<double, 2> pair_attribute(const File& file, const std::string& name, const std::string& key);

/// Result of read(), for a file that must be undamaged.   @throws DamagedFile where read() throws FileError
template <class Read>
[[nodiscard]] auto from_whole(Read&& read) {
  try {
    return read();
  } catch (const FileError& e) {
    throw DamagedFile(e);
  }
}

/// Paths of all datasets, sorted.
[[nodiscard]] std::vector<std::string> datasets(const File& file);
/// Names of the objects directly in a group, sorted.
[[nodiscard]] std::vector<std::string> children(const File& file, const std::string& group);

}  // namespace scree::io::h5
