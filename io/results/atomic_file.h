// A file that is put in place complete: a reader finds the old content or the new content, never a part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace scree::io {

/// A file under a temporary name in the same folder until commit(). @throws FileError from every member that writes;
/// the old file is unchanged then, except after a failed fsync of the folder, when the new file is in place.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();  // removes the temporary file unless it was put in place

  void write(std::string_view text);
  /// Appends the first `bytes` of `from`, which may be in place already, and renamed or deleted since.
  void copy(const AtomicFile& from, std::int64_t bytes);
  /// fsync, rename, fsync of the folder. The content can still be read by copy().
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
  bool in_place_ = false;
};

/// Writes the whole file at once.   @throws FileError as AtomicFile
void write_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace scree::io
