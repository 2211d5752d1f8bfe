// Loaded before a program (LD_PRELOAD): lets one write, fsync, truncation or rename in a folder fail, or the program
// die there.
//   SCREE_FAULT_FOLDER  folder; calls on files elsewhere go through and are not counted
//   SCREE_FAULT_AT      number of the call, from 1 on; 0: none, calls are only counted
//   SCREE_FAULT_KIND    eio, enospc: it fails so, and every later one; short: half of a write is done, then enospc;
//                       kill: half of a write is done, other calls not, and the program is killed; killed: after the
//                       call
//   SCREE_FAULT_TRACE   file that receives a line for every call: its name, and the file that it is for
// What the C library writes through its own streams (run.log) does not come through here.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

const char* setting(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

struct Faults {
  std::string folder = setting("SCREE_FAULT_FOLDER"), kind = setting("SCREE_FAULT_KIND");
  long at = std::atol(setting("SCREE_FAULT_AT")), calls = 0;

  std::FILE* trace = *setting("SCREE_FAULT_TRACE") != '\0' ? std::fopen(setting("SCREE_FAULT_TRACE"), "w") : nullptr;
  std::string path;  // of the call

  ~Faults() {
    if (trace != nullptr) std::fclose(trace);
  }
  bool within(const char* name) {
    path = name;
    return !folder.empty() && path.starts_with(folder);
  }
  bool within(int fd) {
    char link[64], name[PATH_MAX];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    const ssize_t n = ::readlink(link, name, sizeof name - 1);
    if (n <= 0) return false;
    name[n] = '\0';
    return within(name);
  }
};

Faults& faults() {
  static Faults f;
  return f;
}

[[noreturn]] void die() {
  ::raise(SIGKILL);
  std::abort();
}

template <class F>
F real(const char* name) {
  return reinterpret_cast<F>(::dlsym(RTLD_NEXT, name));
}

/// What `call` gives, or what the fault makes of it; `half` does half of it.   @param name  of the call
template <class Result, class Call, class Half>
Result go(const char* name, bool counts, Call&& call, Half&& half) {
  Faults& f = faults();
  if (!counts) return call();
  const long now = ++f.calls;
  if (f.trace != nullptr) std::fprintf(f.trace, "%s %s\n", name, f.path.c_str());
  if (f.at == 0 || now < f.at) return call();
  if (f.kind == "killed") {
    if (now == f.at) (void)call(), die();
    return call();
  }
  if (f.kind == "kill") (void)half(), die();
  if (f.kind == "short" && now == f.at) return half();
  errno = f.kind == "eio" ? EIO : ENOSPC;
  return -1;
}

}  // namespace

extern "C" {

ssize_t write(int fd, const void* data, size_t size) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t)>("write");
  return go<ssize_t>(
      "write", fd > 2 && faults().within(fd), [&] { return next(fd, data, size); },
      [&] { return next(fd, data, size / 2); });
}

ssize_t writev(int fd, const struct iovec* parts, int count) {
  static const auto next = real<ssize_t (*)(int, const struct iovec*, int)>("writev");
  return go<ssize_t>(
      "writev", fd > 2 && faults().within(fd), [&] { return next(fd, parts, count); },
      [&] { return next(fd, parts, 1); });
}

ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
  return go<ssize_t>(
      "pwrite", faults().within(fd), [&] { return next(fd, data, size, at); },
      [&] { return next(fd, data, size / 2, at); });
}

ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
  return go<ssize_t>(
      "pwrite64", faults().within(fd), [&] { return next(fd, data, size, at); },
      [&] { return next(fd, data, size / 2, at); });
}

int fsync(int fd) {
  static const auto next = real<int (*)(int)>("fsync");
  return go<int>(
      "fsync", faults().within(fd), [&] { return next(fd); }, [] { return 0; });
}

int fdatasync(int fd) {
  static const auto next = real<int (*)(int)>("fdatasync");
  return go<int>(
      "fdatasync", faults().within(fd), [&] { return next(fd); }, [] { return 0; });
}

int ftruncate(int fd, off_t size) {
  static const auto next = real<int (*)(int, off_t)>("ftruncate");
  return go<int>(
      "ftruncate", faults().within(fd), [&] { return next(fd, size); }, [] { return 0; });
}

int ftruncate64(int fd, off64_t size) {
  static const auto next = real<int (*)(int, off64_t)>("ftruncate64");
  return go<int>(
      "ftruncate64", faults().within(fd), [&] { return next(fd, size); }, [] { return 0; });
}

int rename(const char* from, const char* to) {
  static const auto next = real<int (*)(const char*, const char*)>("rename");
  return go<int>(
      "rename", faults().within(to), [&] { return next(from, to); }, [] { return 0; });
}

}  // extern "C"
