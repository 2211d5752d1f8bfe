#include "io/results/h5.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/results/h5_chunk.h"
#include "io/results/h5_driver.h"

namespace scree::io::h5 {

namespace fs = std::filesystem;

Handle::Handle(Handle&& other) noexcept
    : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(std::exchange(other.closer_, nullptr)) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  if (this != &other) {
    (void)close();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    closer_ = std::exchange(other.closer_, nullptr);
  }
  return *this;
}

bool Handle::close() noexcept {
  if (id_ < 0) return true;
  return closer_(std::exchange(id_, H5I_INVALID_HID)) >= 0;
}

namespace {

/// Collects the innermost description of the error stack: the cause, not the calls that passed it on.
herr_t collect(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

std::string cause() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect, &text);
  H5Eclear2(H5E_DEFAULT);
  // The message of the file driver contains many addresses; only the system's message inside it is kept.
  const std::string mark = "error message = '";
  if (const std::size_t at = text.find(mark); at != std::string::npos) {
    const std::size_t from = at + mark.size();
    text = text.substr(from, text.find('\'', from) - from);
  }
  return text.empty() ? "HDF5 gives no reason" : text;
}

/// Errors are reported by FileError, not on stderr. No clean-up by HDF5 at exit: every identifier here has an owner,
/// and HDF5 1.10 crashes at exit if closing a file failed on a full disk, which would hide our exit code.
void quiet() {
  (void)H5dont_atexit();           // fails if it was called before
  constexpr int kKept = 8 * 1024;  // bytes per kind that are kept for reuse; without a limit they accumulate
  H5set_free_list_limits(kKept, kKept, kKept, kKept, kKept, kKept);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle access_list(const fs::path& path) {
  Handle list(check(H5Pcreate(H5P_FILE_ACCESS), path, "set up HDF5"), H5Pclose);
  check(H5Pset_file_locking(list.get(), false, true), path, "set up HDF5");
  // Chunks are written whole and once, so no chunk cache is needed. The metadata of frames written long ago need not
  // stay in memory either. HDF5 counts a window of a frame as 400 bytes, but uses 20 times as much memory for it.
  constexpr std::size_t kSlots = 521, kMetadata = 48 * 1024;
  check(H5Pset_cache(list.get(), 0, kSlots, 0, 0.75), path, "set up HDF5");
  H5AC_cache_config_t metadata;
  metadata.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  check(H5Pget_mdc_config(list.get(), &metadata), path, "set up HDF5");
  metadata.incr_mode = H5C_incr__off;
  metadata.flash_incr_mode = H5C_flash_incr__off;
  metadata.decr_mode = H5C_decr__off;
  metadata.set_initial_size = 1;
  metadata.initial_size = metadata.min_size = metadata.max_size = kMetadata;
  check(H5Pset_mdc_config(list.get(), &metadata), path, "set up HDF5");
  return list;
}

/// A node of a table of chunks, or of names, has room for twice this number of entries, used or not. The defaults of
/// HDF5 are 32 and 16, with which the tables of a hundred short datasets are larger than their data.
constexpr unsigned kEntriesOfSmall = 4;
constexpr double kSmall = 16.0 * 1024 * 1024;  // bytes

Handle open_object(const File& file, const std::string& name) {
  return {check(H5Oopen(file.id(), name.c_str(), H5P_DEFAULT), file.path(), "open " + name), H5Oclose};
}

}  // namespace

void fail(const fs::path& path, std::string_view what) {
  throw FileError(path, "cannot " + std::string(what) + ": " + cause());
}

template <>
hid_t type_of<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t type_of<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
hid_t type_of<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t type_of<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}
template <>
hid_t type_of<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

Handle text_type(const fs::path& path) {
  Handle type(check(H5Tcopy(H5T_C_S1), path, "make a text type"), H5Tclose);
  check(H5Tset_size(type.get(), H5T_VARIABLE), path, "make a text type");
  check(H5Tset_cset(type.get(), H5T_CSET_UTF8), path, "make a text type");
  return type;
}

File::File() = default;
File::File(File&&) noexcept = default;
File& File::operator=(File&&) noexcept = default;
File::~File() = default;

File File::make(const fs::path& where, const fs::path& path, double bytes) {
  quiet();
  File file;
  file.path_ = path;
  file.packer_ = std::make_shared<ChunkPacker>();
  file.undo_ = std::make_unique<UndoLog>(path);
  const Handle access = access_list(path);
  write_through(access.get(), *file.undo_, path);
  const Handle list(check(H5Pcreate(H5P_FILE_CREATE), path, "make the file"), H5Pclose);
  if (bytes < kSmall) {
    check(H5Pset_istore_k(list.get(), kEntriesOfSmall), path, "make the file");
    check(H5Pset_sym_k(list.get(), kEntriesOfSmall, kEntriesOfSmall), path, "make the file");
  }
  file.handle_ =
      Handle(check(H5Fcreate(where.c_str(), H5F_ACC_TRUNC, list.get(), access.get()), path, "make the file"), H5Fclose);
  return file;
}

File File::create(const fs::path& path, double bytes) { return make(path, path, bytes); }

File File::create_beside(const fs::path& path, double bytes) { return make(beside(path), path, bytes); }

File File::open(const fs::path& path) {
  quiet();
  File file;
  file.path_ = path;
  const Handle access = access_list(path);
  file.handle_ = Handle(check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), path, "open the file"), H5Fclose);
  return file;
}

void File::group(const std::string& name) const {
  if (has(name)) return;
  const Handle made(
      check(H5Gcreate2(id(), name.c_str(), links(), H5P_DEFAULT, H5P_DEFAULT), path_, "make group " + name), H5Gclose);
}

bool File::has(const std::string& name) const {
  for (std::size_t at = name.find('/', 1);; at = name.find('/', at + 1)) {
    const std::string part = name.substr(0, at);
    if (part != "/" && check(H5Lexists(id(), part.c_str(), H5P_DEFAULT), path_, "look for " + part) == 0) return false;
    if (at == std::string::npos) return true;
  }
}

hid_t File::links() const {
  if (!below_.valid()) {
    below_ = Handle(check(H5Pcreate(H5P_LINK_CREATE), path_, "set up HDF5"), H5Pclose);
    check(H5Pset_create_intermediate_group(below_.get(), 1), path_, "set up HDF5");
  }
  return below_.get();
}

void File::label(const Handle& object, const std::string& name, const Label& label) const {
  const std::string what = "write attributes of " + name;
  if (!text_.valid()) text_ = text_type(path_);
  if (!scalar_.valid()) scalar_ = Handle(check(H5Screate(H5S_SCALAR), path_, what), H5Sclose);
  for (const auto& [key, text] : {std::pair{"units", &label.units}, {"long_name", &label.long_name}}) {
    Handle made(check(H5Acreate2(object.get(), key, text_.get(), scalar_.get(), H5P_DEFAULT, H5P_DEFAULT), path_, what),
                H5Aclose);
    const char* value = text->c_str();
    check(H5Awrite(made.get(), text_.get(), &value), path_, what);
    if (!made.close()) fail(path_, what);
  }
}

void File::put(const std::string& name, const std::string& key, hid_t type, hid_t space, const void* value) const {
  const std::string what = "write attribute " + key + " of " + name;
  const Handle object = open_object(*this, name);
  if (check(H5Aexists(object.get(), key.c_str()), path_, what) > 0)
    check(H5Adelete(object.get(), key.c_str()), path_, what);
  Handle made(check(H5Acreate2(object.get(), key.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), path_, what),
              H5Aclose);
  check(H5Awrite(made.get(), type, value), path_, what);
  if (!made.close()) fail(path_, what);
}

void File::attribute(const std::string& name, const std::string& key, const std::string& text) const {
  const Handle type = text_type(path_);
  const Handle space(check(H5Screate(H5S_SCALAR), path_, "make an attribute"), H5Sclose);
  const char* value = text.c_str();
  put(name, key, type.get(), space.get(), &value);
}

void File::attribute(const std::string& name, const std::string& key, std::int64_t value) const {
  const Handle space(check(H5Screate(H5S_SCALAR), path_, "make an attribute"), H5Sclose);
  put(name, key, type_of<std::int64_t>(), space.get(), &value);
}

void File::attribute(const std::string& name, const std::string& key, double value) const {
  const Handle space(check(H5Screate(H5S_SCALAR), path_, "make an attribute"), H5Sclose);
  put(name, key, type_of<double>(), space.get(), &value);
}

void File::attribute(const std::string& name, const std::string& key, const std::array<double, 2>& pair) const {
  const hsize_t two = 2;
  const Handle space(check(H5Screate_simple(1, &two, nullptr), path_, "make an attribute"), H5Sclose);
  put(name, key, type_of<double>(), space.get(), pair.data());
}

void File::attribute_ascii(const std::string& name, const std::string& key, const std::string& text) const {
  const Handle type(check(H5Tcopy(H5T_C_S1), path_, "make a text type"), H5Tclose);
  check(H5Tset_size(type.get(), text.size()), path_, "make a text type");
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), path_, "make a text type");
  const Handle space(check(H5Screate(H5S_SCALAR), path_, "make an attribute"), H5Sclose);
  put(name, key, type.get(), space.get(), text.data());
}

void File::attribute_pair(const std::string& name, const std::string& key, std::int64_t a, std::int64_t b) const {
  const std::array<std::int64_t, 2> pair{a, b};
  const hsize_t two = 2;
  const Handle space(check(H5Screate_simple(1, &two, nullptr), path_, "make an attribute"), H5Sclose);
  put(name, key, type_of<std::int64_t>(), space.get(), pair.data());
}

void File::flush() const { check(H5Fflush(id(), H5F_SCOPE_LOCAL), path_, "write to the disk"); }

void File::hold(bool tables) const {
  H5AC_cache_config_t config;
  config.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  check(H5Fget_mdc_config(id(), &config), path_, "set up HDF5");
  // Memory of held tables is never released, so a long run holds its tables only while they are small.
  constexpr std::size_t kFew = 128 * 1024;  // [bytes], as HDF5 counts
  std::size_t most = 0, clean = 0, now = 0;
  int entries = 0;
  check(H5Fget_mdc_size(id(), &most, &clean, &now, &entries), path_, "set up HDF5");
  config.evictions_enabled = !tables || now > kFew;
  check(H5Fset_mdc_config(id(), &config), path_, "set up HDF5");
}

int File::descriptor() const {
  void* handle = nullptr;
  check(H5Fget_vfd_handle(id(), H5P_DEFAULT, &handle), path_, "write to the disk");
  return *static_cast<int*>(handle);
}

void File::sync() const {
  flush();
  if (::fdatasync(descriptor()) != 0)
    throw FileError(path_, std::string("cannot write to the disk: ") + std::strerror(errno));
}

void File::keep() {
  sync();
  undo_->start(descriptor());
}

void File::put_in_place() {
  std::error_code error;
  fs::rename(beside(path_), path_, error);
  if (error) throw FileError(path_, "cannot put the new file in place: " + error.message());
}

void File::close() {
  if (!handle_.close()) fail(path_, "close the file");
  if (undo_) undo_->remove();
}

}  // namespace scree::io::h5
