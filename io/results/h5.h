// HDF5 with ownership and errors: handles close themselves, and a call that fails throws FileError with HDF5's message.
#pragma once

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "io/results/file_error.h"
#include "io/results/undo_log.h"

namespace scree::io::h5 {

class ChunkPacker;

/// Owns an HDF5 identifier. The destructor ignores errors; where data could be lost, call close() and check its result.
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle() { (void)close(); }

  [[nodiscard]] hid_t get() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  /// False when HDF5 could not close it (for a dataset a full disk is detected here). Closing twice is allowed.
  [[nodiscard]] bool close() noexcept;

 private:
  hid_t id_ = H5I_INVALID_HID;
  Closer closer_ = nullptr;
};

/// Throws FileError{path, "cannot <what>: <the cause stated by HDF5 or the system>"}.
[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what);

/// Returns `result` of an HDF5 call.   @throws FileError if it is negative, which means failure
template <class Result>
Result check(Result result, const std::filesystem::path& path, std::string_view what) {
  if (result < 0) fail(path, what);
  return result;
}

/// Attributes of every dataset. Units in SI; "1" for counts and numbers without unit, "none" for text.
struct Label {
  std::string units;
  std::string long_name;
};

/// HDF5 type in memory of a C++ number.
template <class T>
[[nodiscard]] hid_t type_of();
template <>
[[nodiscard]] hid_t type_of<double>();
template <>
[[nodiscard]] hid_t type_of<std::int32_t>();
template <>
[[nodiscard]] hid_t type_of<std::int64_t>();
template <>
[[nodiscard]] hid_t type_of<std::uint64_t>();
template <>
[[nodiscard]] hid_t type_of<std::uint8_t>();

/// Variable-length UTF-8 text.
[[nodiscard]] Handle text_type(const std::filesystem::path& path);

/// An open file. It is not locked: a run that is still computing can be read (in the state of the last flush).
class File {
 public:
  File();
  File(File&&) noexcept;
  File& operator=(File&&) noexcept;
  ~File();
  /// A new file in place of an old one.
  /// @param bytes  expected size, roughly: a small file has small tables of chunks (560 bytes per dataset in place of
  ///               2.6 kB)   @throws FileError
  [[nodiscard]] static File create(const std::filesystem::path& path, double bytes = 0.0);
  /// A new file beside an old one until put_in_place(); errors name the path of the old one.
  [[nodiscard]] static File create_beside(const std::filesystem::path& path, double bytes = 0.0);
  /// Path of such a file until then.
  [[nodiscard]] static std::filesystem::path beside(const std::filesystem::path& path) {
    return path.string() + ".new";
  }
  /// @throws FileError when missing or not HDF5
  [[nodiscard]] static File open(const std::filesystem::path& path);

  [[nodiscard]] hid_t id() const { return handle_.get(); }
  [[nodiscard]] bool is_open() const { return handle_.valid(); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Makes a group, and its parents where they are missing.
  void group(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const;

  /// Property list for making a link together with the missing groups above it. Owned by the file.
  [[nodiscard]] hid_t links() const;
  /// Writes the attributes `units` and `long_name` of a new, open object.   @param name  of the object, for errors
  void label(const Handle& object, const std::string& name, const Label& label) const;
  /// Sets an attribute of the object `name` ("/" for the file), replacing an old one.
  void attribute(const std::string& name, const std::string& key, const std::string& text) const;
  void attribute(const std::string& name, const std::string& key, std::int64_t value) const;
  void attribute(const std::string& name, const std::string& key, double value) const;
  void attribute(const std::string& name, const std::string& key, const std::array<double, 2>& pair) const;
  /// Text of fixed length in ASCII, and a pair of integers, as VTKHDF requires for its Type and Version.
  void attribute_ascii(const std::string& name, const std::string& key, const std::string& text) const;
  void attribute_pair(const std::string& name, const std::string& key, std::int64_t a, std::int64_t b) const;

  /// Passes everything so far to the operating system.   @throws FileError (a full disk is detected here)
  void flush() const;
  /// Allows HDF5 to write its tables when it needs room for others (false, the default), or not before flush() (true):
  /// other programs can read the file as of the last flush until then.   @throws FileError
  void hold(bool tables) const;
  /// Packs the chunks of the file.   @pre the file was made, not opened
  [[nodiscard]] const std::shared_ptr<ChunkPacker>& packer() const { return packer_; }
  /// Flushes, and writes to the disk: the content survives a loss of power too.   @throws FileError
  void sync() const;
  /// Calls sync(). From now on the file can be restored to its present content, until it is closed or keep() is called
  /// again (UndoLog).   @pre the file was made by create(), or create_beside() and put in place   @throws FileError
  void keep();
  /// Replaces the old file by one of create_beside().   @throws FileError
  void put_in_place();
  /// @throws FileError; the file can be restored then (see keep())
  void close();

 private:
  void put(const std::string& name, const std::string& key, hid_t type, hid_t space, const void* value) const;
  [[nodiscard]] static File make(const std::filesystem::path& where, const std::filesystem::path& path, double bytes);
  [[nodiscard]] int descriptor() const;
  std::filesystem::path path_;
  std::shared_ptr<ChunkPacker> packer_;
  std::unique_ptr<UndoLog> undo_;         // outlives the handle
  mutable Handle text_, scalar_, below_;  // text type, dataspace of one value, links(): made once
  Handle handle_;
};

}  // namespace scree::io::h5
