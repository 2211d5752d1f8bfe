// Datasets that grow row by row, buffered, in chunks, shuffled and deflated.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/results/h5.h"
#include "io/results/h5_chunk.h"
#include "io/results/results_mark.h"

namespace scree::io::h5 {

/// Hash of a sequence of rows, independent of how it is split into calls: detects damage, not manipulation.
class RowHash {
 public:
  void add(const void* data, std::size_t bytes);
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

/// A file, and the number of rows that its growing datasets are expected to reach.
struct Growing {
  // NOLINTNEXTLINE(google-explicit-constructor): a file of which nothing is expected
  Growing(const File& in, double rows_expected = 0.0) : file(&in), rows(rows_expected) {}
  const File* file;
  double rows;
};

/// Rows of a chunk, a power of two: a quarter of the expected rows, but at least 256 bytes and less than 128 KiB. So
/// small runs make small files, and a chunk that is stored unpacked (below) takes little room.
[[nodiscard]] hsize_t rows_of_chunk(double rows_expected, hsize_t bytes_of_row);

/// A growing table of numbers, `width` per row. A width of 1 makes a dataset of one dimension.
/// flush() stores the last chunk, while it is not full, unpacked and at its full length: it stays at its place in the
/// file, so its earlier rows can still be read when the run is killed during a flush. A deflated chunk would change its
/// length and be moved, and until the index is updated its old place may contain another chunk (of 40 runs that were
/// killed, 5 to 11 files could not be read). Full chunks, and the last one at close(), are shuffled and deflated.
template <class T>
class Series {
 public:
  Series() = default;
  /// Makes the dataset (and its groups), empty.   @throws FileError
  Series(const Growing& in, std::string name, hsize_t width, const Label& label);

  /// Adds whole rows; written when a chunk is full or at flush().   @pre rows.size() is a multiple of the width
  void append(std::span<const T> rows);
  void append(T value) { append(std::span<const T>(&value, 1)); }
  /// Appends the first rows of the dataset of the same name in another file.   @pre nothing was appended yet
  /// @throws DamagedFile where they cannot be read, or differ from the rows that were written
  void take(const File& from, const SeriesMark& mark);
  [[nodiscard]] SeriesMark mark() const { return {rows(), hash_.value()}; }
  /// Writes what is buffered.   @throws FileError
  void flush();
  /// Writes what is buffered and closes the dataset.   @throws FileError
  void close();
  /// Rows appended so far, buffered ones included.
  [[nodiscard]] std::int64_t rows() const { return static_cast<std::int64_t>(first_ + rows_.size() / width_); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::filesystem::path path_;
  std::string name_;
  void grow(hsize_t rows);
  void write_chunks(std::span<const T> rows);

  std::shared_ptr<ChunkPacker> packer_;
  hsize_t width_ = 1, chunk_ = 0;   // rows
  hsize_t first_ = 0, stored_ = 0;  // first row of the last chunk; rows in the file
  std::vector<T> rows_;             // from first_ on, in the file or not yet
  RowHash hash_;
  Handle dataset_;
};

/// A growing list of texts.
class TextSeries {
 public:
  TextSeries() = default;
  TextSeries(const Growing& in, std::string name, const Label& label);
  void append(std::string text);
  /// Same as Series::take(), for texts.
  void take(const File& from, const SeriesMark& mark);
  [[nodiscard]] SeriesMark mark() const { return {rows(), hash_.value()}; }
  void flush();
  void close();
  [[nodiscard]] std::int64_t rows() const { return static_cast<std::int64_t>(written_ + pending_.size()); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::filesystem::path path_;
  std::string name_;
  hsize_t written_ = 0;
  std::vector<std::string> pending_;
  RowHash hash_;
  Handle dataset_;
};

/// Writes a complete dataset.
template <class T>
void write(const File& file, const std::string& name, hsize_t width, std::span<const T> rows, const Label& label) {
  Series<T> series({file, static_cast<double>(rows.size()) / static_cast<double>(width)}, name, width, label);
  series.append(rows);
  series.close();
}
void write(const File& file, const std::string& name, std::span<const std::string> texts, const Label& label);

}  // namespace scree::io::h5
