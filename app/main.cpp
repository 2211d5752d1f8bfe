// The `scree` command: turns errors into exit codes.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/library_faults.h"
#include "app/output.h"
#include "app/process_settings.h"
#include "app/signals.h"
#include "coupling/stages/driver.h"
#include "io/case/case_error.h"
#include "io/results/file_error.h"
#include "model/mesh_error.h"

namespace {

using namespace scree::app;

/// For errors that main cannot catch as exceptions: in globals of libraries, before main, and in threads.
[[noreturn]] void end_without_memory() {
  constexpr std::string_view kWhy = "error: out of memory, or an error where none can be handled\n";
  (void)!::write(STDERR_FILENO, kWhy.data(), kWhy.size());
  ::_exit(kFailed);
}
/// HDF5 ends the program by exit(-1) where an allocation for its tables fails.
void end_of_library(int code, void* /*unused*/) {
  if (code != -1) return;
  std::fflush(nullptr);
  end_without_memory();
}
[[gnu::constructor(101)]] void before_globals() {
  std::set_terminate(end_without_memory);
  ::on_exit(end_of_library, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && computes(argv[1])) restart_with_settings(argv);
  open_standard_streams();
  take_signals_of_writes();
  take_faults_of_hdf5();
  try {
    const int code = dispatch(argc, argv);
    if (code != kDone || output_error() == 0 || output_error() == EPIPE) return code;
    complain("error: cannot write to standard output: {}\n", std::strerror(output_error()));
    return kFiles;
  } catch (const scree::io::CaseError& e) {
    complain("{}\n", e.what());
    return kBadCase;
  } catch (const scree::coupling::PlanError& e) {
    complain("error: {}\n", e.what());
    return kBadCase;
  } catch (const scree::MeshError& e) {
    complain("error: {}\n", e.what());
    return kBadCase;
  } catch (const scree::io::FileError& e) {
    complain("error: {}\n", e.what());
    return kFiles;
  } catch (const std::exception& e) {
    complain("error: {}\n", e.what());
    return kFailed;
  }
}
