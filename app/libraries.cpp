#include "app/libraries.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <string_view>

#include "app/output.h"

namespace scree::app {
namespace {

template <class Function>
Function* symbol(void* library, const char* name) {
  return reinterpret_cast<Function*>(::dlsym(library, name));
}

std::string load(const std::string& file) {
  std::error_code ignored;
  // With a slash the loader opens the file itself, not one of that name among the system's libraries.
  const std::filesystem::path path = std::filesystem::absolute(file, ignored);
  if (!std::filesystem::is_regular_file(path, ignored))
    return "there is no such file; --load takes a shared library (.so) that was built for Scree";
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) return fmt::format("it cannot be loaded: {}", ::dlerror());
  auto* const version = symbol<const char*()>(library, "scree_library_version");
  auto* const add = symbol<void()>(library, "scree_library_add");
  if (version == nullptr || add == nullptr)
    return "it is no library of Scree: it has no SCREE_LIBRARY (coupling/library.h)";
  if (std::string_view(version()) != SCREE_VERSION)
    return fmt::format("it was built for Scree {}, this is {}: build it again", version(), SCREE_VERSION);
  try {
    add();
  } catch (const std::exception& e) {
    return e.what();
  }
  return {};
}

}  // namespace

std::string load_libraries(const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (const std::string wrong = load(file); !wrong.empty()) return fmt::format("--load {}: {}", file, wrong);
  return {};
}

}  // namespace scree::app
