#include "app/sweep/slurm.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include "io/results/file_error.h"

namespace scree::app {
namespace {

/// Both ends of a pipe; closes what is open.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw io::FileError("sbatch", std::string("cannot make a pipe: ") + std::strerror(errno));
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() { close_reader(), close_writer(); }
  [[nodiscard]] int reader() const { return ends_[0]; }
  [[nodiscard]] int writer() const { return ends_[1]; }
  void close_reader() { close_end(0); }
  void close_writer() { close_end(1); }
  /// Adds what there is to read now.   @return false at its end
  [[nodiscard]] bool read_into(std::string& text) const {
    std::array<char, 4096> buffer{};
    const ssize_t n = ::read(reader(), buffer.data(), buffer.size());
    if (n > 0) text.append(buffer.data(), static_cast<std::size_t>(n));
    return n > 0 || (n < 0 && (errno == EINTR || errno == EAGAIN));
  }

 private:
  void close_end(std::size_t i) {
    if (ends_[i] >= 0) ::close(ends_[i]);
    ends_[i] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

pid_t start(std::vector<std::string> words, const Pipe& out, const Pipe& err) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, out.writer(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, err.writer(), STDERR_FILENO);
  pid_t pid = 0;
  const int error = ::posix_spawnp(&pid, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw io::FileError("sbatch", std::string("cannot be started: ") + std::strerror(error) +
                                      "; --on slurm needs the commands of Slurm on this machine");
  return pid;
}

}  // namespace

Submission submit(const std::filesystem::path& script, bool wait, const std::function<bool()>& stop,
                  const std::function<void(const std::string&)>& submitted) {
  std::vector<std::string> words{"sbatch", "--parsable"};
  if (wait) words.emplace_back("--wait");
  words.push_back(script.string());
  Pipe out, err;
  const pid_t pid = start(words, out, err);
  out.close_writer();
  err.close_writer();

  Submission s;
  std::string printed;
  std::array<pollfd, 2> ready{{{out.reader(), POLLIN, 0}, {err.reader(), POLLIN, 0}}};
  while (ready[0].fd >= 0 || ready[1].fd >= 0) {
    if (stop && stop()) {
      s.stopped = true;
      ::kill(pid, SIGTERM);
      break;
    }
    if (::poll(ready.data(), ready.size(), 100) <= 0) continue;
    if (ready[0].revents != 0 && !out.read_into(printed)) ready[0].fd = -1;
    if (ready[1].revents != 0 && !err.read_into(s.errors)) ready[1].fd = -1;
    if (s.job.empty() && printed.find('\n') != std::string::npos) {
      s.job = printed.substr(0, printed.find_first_of(";\n"));  // "number" or "number;cluster"
      if (submitted) submitted(s.job);
    }
  }
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  s.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return s;
}

}  // namespace scree::app
