// A temporary folder of this program's own.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "io/results/file_error.h"

namespace scree::app {

/// Made in the folder for temporary files, removed by the destructor.
class OwnFolder {
 public:
  /// @param purpose  a word for its name   @throws FileError
  explicit OwnFolder(const std::string& purpose) {
    std::string name = (std::filesystem::temp_directory_path() / ("scree-" + purpose + "-XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) throw io::FileError(name, "cannot be made");
    path_ = name;
  }
  ~OwnFolder() {
    std::error_code ignored;  // a folder left behind in the temporary one does no harm
    std::filesystem::remove_all(path_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace scree::app
