#include "end_to_end/program.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mien::test {

namespace {

int wait_for(pid_t child, double kill_after_seconds, int signal) {
  const auto start = std::chrono::steady_clock::now();
  int status = 0;
  bool sent = kill_after_seconds < 0.0;
  while (waitpid(child, &status, sent ? 0 : WNOHANG) == 0) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (passed.count() >= kill_after_seconds) {
      kill(child, signal);
      sent = true;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

Ended run_program(const std::vector<std::string>& words, double kill_after_seconds, int signal) {
  const Scratch scratch;
  const std::string output = scratch.path() / "output";
  const std::string errors = scratch.path() / "errors";
  const pid_t child = fork();
  if (child == 0) {
    const int out = open(output.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    const int err = open(errors.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  Ended ended;
  ended.code = wait_for(child, kill_after_seconds, signal);
  ended.output = text_of(output);
  ended.errors = text_of(errors);
  return ended;
}

Ended run_mien(const std::vector<std::string>& arguments, double kill_after_seconds, int signal) {
  std::vector<std::string> words = {MIEN_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(words, kill_after_seconds, signal);
}

Scratch::Scratch() {
  std::string pattern = (std::filesystem::temp_directory_path() / "mien-test-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a scratch folder");
  path_ = pattern;
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path Scratch::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), {});
}

}  // namespace mien::test
