#include "io/results/h5_driver.h"

#include <unordered_map>

#include "io/results/h5.h"

namespace scree::io::h5 {

namespace {

/// HDF5's driver for plain files; ours is a copy of it in which a few functions are replaced.
H5FD_class_t plain;
/// The undo log of each open file.
std::unordered_map<const H5FD_t*, UndoLog*>& logs() {
  static std::unordered_map<const H5FD_t*, UndoLog*> map;
  return map;
}

bool saved(const H5FD_t* file, haddr_t at, hsize_t size) {
  try {
    logs().at(file)->save(at, size);
    return true;
  } catch (const FileError& e) {
    // In the form in which HDF5's own driver reports the system's message.
    (void)H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_IO, H5E_WRITEERROR,
                   "error message = '%s'", e.what());
    return false;
  }
}

H5FD_t* open(const char* name, unsigned flags, hid_t access, haddr_t most) {
  H5FD_t* file = plain.open(name, flags, access, most);
  if (file == nullptr) return nullptr;
  logs()[file] = *static_cast<UndoLog* const*>(H5Pget_driver_info(access));
  return file;
}

herr_t close(H5FD_t* file) {
  logs().erase(file);
  return plain.close(file);
}

herr_t write(H5FD_t* file, H5FD_mem_t type, hid_t transfer, haddr_t at, size_t size, const void* data) {
  return saved(file, at, size) ? plain.write(file, type, transfer, at, size, data) : -1;
}

/// Sets the length of the file to its allocated space, which may make it shorter.
herr_t truncate(H5FD_t* file, hid_t transfer, hbool_t closing) {
  const haddr_t end = plain.get_eoa(file, H5FD_MEM_DEFAULT), now = plain.get_eof(file, H5FD_MEM_DEFAULT);
  return end >= now || saved(file, end, now - end) ? plain.truncate(file, transfer, closing) : -1;
}

/// Registers the driver, once.
hid_t driver(const std::filesystem::path& path) {
  static const hid_t kDriver = [&] {
    const Handle access(check(H5Pcreate(H5P_FILE_ACCESS), path, "set up HDF5"), H5Pclose);
    check(H5Pset_fapl_sec2(access.get()), path, "set up HDF5");
    // The functions of the driver are accessible only in a file that it has opened.
    H5FD_t* probe = H5FDopen("/dev/null", H5F_ACC_RDONLY, access.get(), HADDR_UNDEF);
    if (probe == nullptr) fail(path, "set up HDF5");
    plain = *probe->cls;
    (void)H5FDclose(probe);
    H5FD_class_t mine = plain;
    mine.name = "scree";
    mine.terminate = nullptr;
    mine.fapl_size = sizeof(UndoLog*);  // NOLINT(bugprone-sizeof-expression): what is stored is the pointer
    mine.open = open;
    mine.close = close;
    mine.write = write;
    mine.truncate = truncate;
    return check(H5FDregister(&mine), path, "set up HDF5");
  }();
  return kDriver;
}

}  // namespace

void write_through(hid_t access, UndoLog& log, const std::filesystem::path& path) {
  UndoLog* const info = &log;
  check(H5Pset_driver(access, driver(path), &info), path, "set up HDF5");
}

}  // namespace scree::io::h5
