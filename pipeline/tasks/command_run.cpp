#include "pipeline/tasks/command_run.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace mien::pipeline {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void throw_system(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// The two ends of a pipe; each is closed with the object unless it was before.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw_system(errno, "pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int from() const { return ends_[0]; }
  int into() const { return ends_[1]; }
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) ::close(ends_[end]);
    ends_[end] = -1;
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

/// Files that the child has open in place of this process's standard streams.
struct FileActions {
  FileActions(const Pipe& output, const Pipe& errors) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output.into(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors.into(), STDERR_FILENO);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  posix_spawn_file_actions_t actions;
};

/// Signals as a program expects to find them: this one blocks some for its own threads, and ignores
/// that of a pipe whose reader has gone.
struct PlainSignals {
  PlainSignals() {
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &none);
    sigset_t ignored;
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &ignored);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~PlainSignals() { posix_spawnattr_destroy(&attributes); }
  PlainSignals(const PlainSignals&) = delete;
  PlainSignals& operator=(const PlainSignals&) = delete;

  posix_spawnattr_t attributes;
};

/// Appends what can be read; false at the end.
bool take(int from, std::string& text) {
  std::array<char, 65536> bytes;
  const ssize_t count = ::read(from, bytes.data(), bytes.size());
  if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

/// Reads both pipes until the child has closed them; false when time is up before.
bool read_both(Pipe& output, Pipe& errors, CommandResult& end, Clock::time_point until) {
  std::array<pollfd, 2> open = {pollfd{output.from(), POLLIN, 0}, pollfd{errors.from(), POLLIN, 0}};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return false;
    if (::poll(open.data(), open.size(), static_cast<int>(std::min<long long>(left, 60'000))) < 0 &&
        errno != EINTR) {
      throw_system(errno, "poll");
    }
    if (open[0].revents != 0 && !take(open[0].fd, end.output)) open[0].fd = -1;
    if (open[1].revents != 0 && !take(open[1].fd, end.errors)) open[1].fd = -1;
  }
  return true;
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw_system(errno, "waitpid");
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

CommandResult run_command(const std::vector<std::string>& words, std::chrono::milliseconds limit) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  Pipe output;
  Pipe errors;
  const FileActions files(output, errors);
  const PlainSignals signals;

  CommandResult end;
  pid_t child = 0;
  const int fault = ::posix_spawnp(&child, arguments[0], &files.actions, &signals.attributes,
                                   arguments.data(), environ);
  if (fault == ENOENT || fault == EACCES || fault == ENOTDIR) {
    end.is_missing = true;
    end.code = 127;
    return end;
  }
  if (fault != 0) throw_system(fault, words.front());
  output.close_end(1);
  errors.close_end(1);
  end.timed_out = !read_both(output, errors, end, Clock::now() + limit);
  if (end.timed_out) ::kill(child, SIGKILL);
  end.code = wait_for(child);
  return end;
}

}  // namespace mien::pipeline
