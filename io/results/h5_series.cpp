#include "io/results/h5_series.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "io/results/h5_read.h"
#include "model/check.h"

namespace scree::io::h5 {

namespace {

constexpr hsize_t kMostOfChunk = 64 * 1024;  // bytes; a chunk has less than twice as many
constexpr hsize_t kLeastOfChunk = 256;       // bytes
constexpr double kChunks = 4.0;              // per expected number of rows
constexpr unsigned kDeflate = 1;             // files 4 % larger than with level 4, written in half the time

/// An empty dataset without limit in its first dimension.
Handle make_dataset(const File& file, const std::string& name, hid_t type, hsize_t width, hsize_t chunk_rows,
                    const Label& label) {
  const std::string what = "make dataset " + name;
  if (const std::size_t slash = name.rfind('/'); slash != std::string::npos && slash > 0)
    file.group(name.substr(0, slash));
  const int rank = width == 1 ? 1 : 2;
  const std::array<hsize_t, 2> size{0, width}, limit{H5S_UNLIMITED, width}, chunk{chunk_rows, width};
  const Handle space(check(H5Screate_simple(rank, size.data(), limit.data()), file.path(), what), H5Sclose);
  const Handle list(check(H5Pcreate(H5P_DATASET_CREATE), file.path(), what), H5Pclose);
  check(H5Pset_chunk(list.get(), rank, chunk.data()), file.path(), what);
  check(H5Pset_shuffle(list.get()), file.path(), what);
  check(H5Pset_deflate(list.get(), kDeflate), file.path(), what);
  Handle made(check(H5Dcreate2(file.id(), name.c_str(), type, space.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
                    file.path(), what),
              H5Dclose);
  file.label(made, name, label);
  return made;
}

[[noreturn]] void changed(const File& file, const std::string& name) {
  throw DamagedFile(file.path(), "cannot read " + name + ": it holds other values than were written");
}

/// Grows the dataset from `written` rows by `rows` and writes them.
void extend(const std::filesystem::path& path, const std::string& name, hid_t dataset, hid_t type, hsize_t width,
            hsize_t written, hsize_t rows, const void* data) {
  const std::string what = "write " + name;
  const int rank = width == 1 ? 1 : 2;
  const std::array<hsize_t, 2> size{written + rows, width}, start{written, 0}, count{rows, width};
  check(H5Dset_extent(dataset, size.data()), path, what);
  const Handle target(check(H5Dget_space(dataset), path, what), H5Sclose);
  check(H5Sselect_hyperslab(target.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), path, what);
  const Handle memory(check(H5Screate_simple(rank, count.data(), nullptr), path, what), H5Sclose);
  // HDF5 converts texts in a buffer, by default of 1 MiB.
  const Handle transfer(check(H5Pcreate(H5P_DATASET_XFER), path, what), H5Pclose);
  check(H5Pset_buffer(transfer.get(), kMostOfChunk, nullptr, nullptr), path, what);
  check(H5Dwrite(dataset, type, memory.get(), target.get(), transfer.get(), data), path, what);
}

}  // namespace

hsize_t rows_of_chunk(double rows_expected, hsize_t bytes_of_row) {
  const double bytes = std::clamp(rows_expected * static_cast<double>(bytes_of_row) / kChunks,
                                  static_cast<double>(kLeastOfChunk), static_cast<double>(kMostOfChunk));
  return std::bit_ceil((static_cast<hsize_t>(bytes) + bytes_of_row - 1) / bytes_of_row);
}

void RowHash::add(const void* data, std::size_t bytes) {
  const auto* at = static_cast<const unsigned char*>(data);
  while (bytes > 0) {
    std::uint64_t word = 0;
    const std::size_t n = std::min(bytes, sizeof word);
    std::memcpy(&word, at, n);
    value_ = (value_ ^ word) * 0x9E3779B97F4A7C15ULL;
    value_ ^= value_ >> 29U;
    at += n;
    bytes -= n;
  }
}

template <class T>
Series<T>::Series(const Growing& in, std::string name, hsize_t width, const Label& label)
    : path_(in.file->path()),
      name_(std::move(name)),
      packer_(in.file->packer()),
      width_(width),
      chunk_(rows_of_chunk(in.rows, width * sizeof(T))),
      dataset_(make_dataset(*in.file, name_, type_of<T>(), width, chunk_, label)) {
  // Memory is touched now, so that a long run needs its full memory from the start.
  rows_.resize(chunk_ * width_);
  rows_.clear();
}

template <class T>
void Series<T>::append(std::span<const T> rows) {
  SCREE_ASSERT(rows.size() % width_ == 0);
  for (const T& value : rows) hash_.add(&value, sizeof value);
  const std::size_t chunk = chunk_ * width_;
  if (!rows_.empty()) {
    const std::size_t fits = std::min(chunk - rows_.size(), rows.size());
    rows_.insert(rows_.end(), rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(fits));
    rows = rows.subspan(fits);
    if (rows_.size() == chunk) {
      grow(first_ + chunk_);
      write_chunks(rows_);
      rows_.clear();
    }
  }
  if (const std::size_t whole = rows.size() / chunk * chunk; whole > 0) {
    grow(first_ + whole / width_);
    write_chunks(rows.first(whole));
    rows = rows.subspan(whole);
  }
  rows_.insert(rows_.end(), rows.begin(), rows.end());
}

template <class T>
void Series<T>::grow(hsize_t rows) {
  const std::array<hsize_t, 2> size{rows, width_};
  check(H5Dset_extent(dataset_.get(), size.data()), path_, "write " + name_);
}

/// Writes whole chunks, packed.
template <class T>
void Series<T>::write_chunks(std::span<const T> rows) {
  const std::string what = "write " + name_;
  for (; !rows.empty(); rows = rows.subspan(chunk_ * width_)) {
    const std::span<const T> chunk = rows.first(chunk_ * width_);
    const auto packed =
        packer_->pack({reinterpret_cast<const unsigned char*>(chunk.data()), chunk.size_bytes()}, sizeof(T));
    const std::array<hsize_t, 2> at{first_, 0};
    check(H5Dwrite_chunk(dataset_.get(), H5P_DEFAULT, packed.skipped, at.data(), packed.bytes.size(),
                         packed.bytes.data()),
          path_, what);
    first_ += chunk_;
  }
  stored_ = first_;
}

template <class T>
void Series<T>::take(const File& from, const SeriesMark& mark) {
  const std::int64_t rows = mark.rows;
  constexpr std::int64_t kAtOnce = 16;  // chunks
  const std::int64_t most = kAtOnce * static_cast<std::int64_t>(chunk_);
  for (std::int64_t at = 0; at < rows; at += most) {
    const std::vector<T> part = from_whole([&] { return read<T>(from, name_, at, std::min(most, rows - at)); });
    append(part);
  }
  if (this->mark() != mark) changed(from, name_);
}

template <class T>
void Series<T>::flush() {
  const hsize_t rows = first_ + rows_.size() / width_;
  if (rows == stored_) return;
  const std::array<hsize_t, 2> at{first_, 0};
  grow(rows);
  const std::size_t held = rows_.size();
  rows_.resize(chunk_ * width_);  // zeros after the rows
  const herr_t written =
      H5Dwrite_chunk(dataset_.get(), H5P_DEFAULT, kFilters, at.data(), rows_.size() * sizeof(T), rows_.data());
  rows_.resize(held);
  check(written, path_, "write " + name_);
  stored_ = rows;
}

template <class T>
void Series<T>::close() {
  if (!dataset_.valid()) return;
  if (const hsize_t rows = rows_.size() / width_; rows > 0) {
    // Grown to its final length only: when a dataset shrinks, HDF5 reads, cuts and rewrites its last chunk.
    const hsize_t all = first_ + rows;
    grow(all);
    rows_.resize(chunk_ * width_);  // zeros after the rows
    write_chunks(rows_);
    rows_.clear();
    first_ = stored_ = all;
  }
  if (!dataset_.close()) fail(path_, "close " + name_);
}

template class Series<double>;
template class Series<std::int32_t>;
template class Series<std::int64_t>;
template class Series<std::uint64_t>;
template class Series<std::uint8_t>;

namespace {
/// Rows of a chunk of texts. HDF5 deflates it, but leaves it unpacked if it would grow; if an allocation fails just
/// then, HDF5 1.10 frees memory that it does not own. References to 64 or more texts, or zeros after them, always
/// become smaller.
hsize_t rows_of_texts(double rows_expected) {
  return std::max(rows_of_chunk(rows_expected, sizeof(hvl_t)), hsize_t{64});
}
}  // namespace

TextSeries::TextSeries(const Growing& in, std::string name, const Label& label)
    : path_(in.file->path()),
      name_(std::move(name)),
      dataset_(make_dataset(*in.file, name_, text_type(path_).get(), 1, rows_of_texts(in.rows), label)) {}

void TextSeries::append(std::string text) {
  hash_.add(text.c_str(), text.size() + 1);
  pending_.push_back(std::move(text));
}

void TextSeries::take(const File& from, const SeriesMark& mark) {
  const std::int64_t rows = mark.rows;
  if (rows == 0) return;
  std::vector<std::string> texts = from_whole([&] { return read_texts(from, name_); });
  if (static_cast<std::int64_t>(texts.size()) < rows)
    throw DamagedFile(from.path(), "cannot read " + name_ + ": it has fewer rows than it had");
  texts.resize(static_cast<std::size_t>(rows));
  for (std::string& text : texts) append(std::move(text));
  if (this->mark() != mark) changed(from, name_);
}

void TextSeries::flush() {
  if (pending_.empty()) return;
  std::vector<const char*> texts;
  for (const std::string& text : pending_) texts.push_back(text.c_str());
  extend(path_, name_, dataset_.get(), text_type(path_).get(), 1, written_, texts.size(), texts.data());
  written_ += texts.size();
  pending_.clear();
}

void TextSeries::close() {
  if (!dataset_.valid()) return;
  flush();
  if (!dataset_.close()) fail(path_, "close " + name_);
}

void write(const File& file, const std::string& name, std::span<const std::string> texts, const Label& label) {
  TextSeries series({file, static_cast<double>(texts.size())}, name, label);
  for (const std::string& text : texts) series.append(text);
  series.close();
}

}  // namespace scree::io::h5
