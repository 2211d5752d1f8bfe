// Keeps the content that a file had at an instant while the file is written further: a rollback log, as in databases.
#pragma once

#include <cstdint>
#include <filesystem>
#include <unordered_set>
#include <vector>

#include "io/results/file_error.h"

namespace scree::io {

/// Stored beside a file as "<file>.undo". It contains the length of the file at the time of start(), and the original
/// bytes of the pages that were overwritten since. Bytes written beyond that length need no page. So the size of the
/// log depends on what changes between two starts, not on the length of the file.
///
/// When a program is killed, the system still has the pages, and roll_back() restores the file byte for byte. A loss of
/// power may lose pages: they are not written to the disk one by one.
class UndoLog {
 public:
  /// @param file  the file to protect; no log is made yet
  explicit UndoLog(std::filesystem::path file) : file_(std::move(file)) {}
  UndoLog(const UndoLog&) = delete;
  UndoLog& operator=(const UndoLog&) = delete;
  ~UndoLog();

  [[nodiscard]] static std::filesystem::path path_of(const std::filesystem::path& file);

  /// From now on the file can be restored to its present content; an earlier log is replaced atomically.
  /// @param descriptor  of the file, whose bytes have been passed to the system; stays open while this is used
  /// @throws FileError; the earlier log stays
  void start(int descriptor);
  /// Stores the pages that overlap [at, at + size), existed at start() and are not stored yet. To be called before they
  /// are overwritten, or cut off at the end of the file.   @throws FileError
  void save(std::uint64_t at, std::uint64_t size);
  /// Ends and removes the log: the file is complete as it is.   @throws FileError
  void remove();

  /// Restores a file from the log beside it, if there is one, and removes the log. If the program is killed meanwhile,
  /// roll_back() can be repeated. A file that is shorter than the log and its pages explain is left as it is.
  /// @return true if there was a log   @throws FileError
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
