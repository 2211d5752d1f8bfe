#include "app/library_faults.h"

#include <execinfo.h>
#include <link.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <span>
#include <string_view>

#include "app/commands.h"

namespace scree::app {
namespace {

struct Code {  // of the program or of a library, where it is loaded
  std::uintptr_t begin = 0, end = 0;
  bool of_hdf5 = false;
};
std::array<Code, 16> codes;
std::size_t known = 0;

int add_code(dl_phdr_info* object, std::size_t /*size*/, void* /*unused*/) {
  const std::string_view name = object->dlpi_name != nullptr ? object->dlpi_name : "";
  const bool of_hdf5 = name.find("libhdf5") != std::string_view::npos;
  if (!of_hdf5 && !name.empty()) return 0;  // the program itself has no name
  for (const ElfW(Phdr) & part : std::span(object->dlpi_phdr, object->dlpi_phnum)) {
    if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0 || known == codes.size()) continue;
    const std::uintptr_t begin = object->dlpi_addr + part.p_vaddr;
    codes[known++] = {begin, begin + part.p_memsz, of_hdf5};
  }
  return 0;
}

const Code* code_of(const void* call) {
  const auto at = reinterpret_cast<std::uintptr_t>(call);
  for (std::size_t i = 0; i < known; ++i)
    if (at >= codes[i].begin && at < codes[i].end) return &codes[i];
  return nullptr;
}

extern "C" void on_fault(int signal) {
  std::array<void*, 64> calls{};
  const int count = ::backtrace(calls.data(), static_cast<int>(calls.size()));
  for (int i = 1; i < count; ++i) {  // the first is this function
    const Code* code = code_of(calls[static_cast<std::size_t>(i)]);
    if (code == nullptr) continue;
    if (!code->of_hdf5) break;
    constexpr std::string_view kWhy =
        "error: the HDF5 library failed, most likely for lack of memory\n  hint: scree resume FOLDER continues from "
        "the last checkpoint\n";
    (void)!::write(STDERR_FILENO, kWhy.data(), kWhy.size());
    ::_exit(kFiles);
  }
  std::signal(signal, SIG_DFL);
  (void)::raise(signal);
}

}  // namespace

void take_faults_of_hdf5() {
  ::dl_iterate_phdr(add_code, nullptr);
  std::array<void*, 1> here{};
  (void)::backtrace(here.data(), 1);  // loads what it needs
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT}) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
    std::signal(signal, on_fault);
  }
}

}  // namespace scree::app
