// What a file was at an instant, kept while it is written on: a rollback log, as databases keep one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <unordered_set>
#include <vector>

#include "io/results/file_error.h"

namespace scree::io {

/// Stands beside a file as "<file>.undo". It holds the length that the file had when start() was called, and the pages
/// of it that were overwritten since, as they were. What is written behind that length needs no page. So its size goes
/// by what changes between two starts, not by the length of the file.
///
/// A program that is killed leaves the pages with the system, and roll_back() brings the file back to what it was, byte
/// for byte. A loss of power may lose pages: they are not brought to the disk one by one.
class UndoLog {
 public:
  /// @param file  whose log it is; no log is made yet
  explicit UndoLog(std::filesystem::path file) : file_(std::move(file)) {}
  UndoLog(const UndoLog&) = delete;
  UndoLog& operator=(const UndoLog&) = delete;
  ~UndoLog();

  [[nodiscard]] static std::filesystem::path path_of(const std::filesystem::path& file);

  /// From now on the file can be brought back to what it is now; the log before is replaced at once.
  /// @param descriptor  of the file, whose bytes are with the system; stays open while this is used
  /// @throws FileError; the log before stays
  void start(int descriptor);
  /// Stores the pages under [at, at + size) that were there at start() and are not stored yet: to be called before
  /// they are overwritten.   @throws FileError
  void save(std::uint64_t at, std::uint64_t size);
  /// Ends: the file is whole as it is.   @throws FileError
  void remove();

  /// Brings a file back to what it was, as far as there is a log beside it, and removes the log. Being killed here does
  /// no harm: it can be done again.
  /// @return true where there was one   @throws FileError
  static bool roll_back(const std::filesystem::path& file);

 private:
  void put(const void* data, std::size_t size);
  std::filesystem::path file_;
  int log_ = -1, source_ = -1;
  std::uint64_t length_ = 0;               // of the file at start()
  std::unordered_set<std::uint64_t> has_;  // pages stored
  std::vector<char> record_;
};

}  // namespace scree::io
