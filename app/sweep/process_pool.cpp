#include "app/sweep/process_pool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>

#include "io/results/file_error.h"

namespace scree::app {
namespace {

constexpr const char* kSelf = "/proc/self/exe";  // still the program where its file has been replaced

/// The standard streams of the child, in place of this program's.
class Streams {
 public:
  explicit Streams(const std::filesystem::path& log) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND,
                                       0666);
    ::posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
  ~Streams() { ::posix_spawn_file_actions_destroy(&actions_); }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::filesystem::path this_program() {
  std::error_code error;
  std::filesystem::path program = std::filesystem::read_symlink(kSelf, error);
  if (error) throw io::FileError(kSelf, "cannot find the program: " + error.message());
  return program;
}

ProcessPool::~ProcessPool() {
  terminate();
  for (const Process& p : processes_)
    while (::waitpid(p.pid, nullptr, 0) < 0 && errno == EINTR) {
    }
}

void ProcessPool::start(std::size_t run, const std::vector<std::string>& arguments, const std::filesystem::path& log) {
  std::vector<std::string> texts{"scree"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(texts.size() + 1);
  for (std::string& text : texts) argv.push_back(text.data());
  argv.push_back(nullptr);
  const Streams streams(log);
  pid_t pid = 0;
  if (const int error = ::posix_spawn(&pid, kSelf, streams.get(), nullptr, argv.data(), environ); error != 0)
    throw io::FileError(log, std::string("cannot start a run that prints there: ") + std::strerror(error));
  processes_.push_back({pid, run, log});
}

std::optional<ProcessPool::Ended> ProcessPool::poll() {
  for (auto p = processes_.begin(); p != processes_.end(); ++p) {
    int status = 0;
    if (::waitpid(p->pid, &status, WNOHANG) != p->pid) continue;
    Ended ended{p->run, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status)};
    if (WIFSIGNALED(status)) {
      const int signal = WTERMSIG(status);
      std::ofstream(p->log, std::ios::app)
          << fmt::format("error: ended by signal {} ({})\n", signal, ::strsignal(signal));
    }
    processes_.erase(p);
    return ended;
  }
  return std::nullopt;
}

void ProcessPool::terminate() const {
  for (const Process& p : processes_) ::kill(p.pid, SIGTERM);
}

}  // namespace scree::app
