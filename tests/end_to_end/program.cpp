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

[[noreturn]] void become(const std::vector<std::string>& words, const std::filesystem::path& said) {
  const int out = open((said / "output").c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
  const int err = open((said / "errors").c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  _exit(127);
}

}  // namespace

Running::Running(const std::vector<std::string>& words) : process_(fork()) {
  if (process_ == 0) become(words, said_.path());
  if (process_ < 0) throw std::runtime_error("no process can be started");
}

Running::~Running() {
  send(SIGKILL);
  has_ended(0);
}

/// A process that was waited for is not asked about again: its number may be another's by then.
bool Running::has_ended(int flags) {
  if (code_) return true;
  int status = 0;
  if (waitpid(process_, &status, flags) != process_) return false;
  code_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return true;
}

bool Running::is_running() { return !has_ended(WNOHANG); }

void Running::send(int signal) {
  if (is_running()) kill(process_, signal);
}

Ended Running::wait(double seconds) {
  const double begin = seconds_now();
  while (is_running()) {
    if (seconds_now() - begin > seconds) send(SIGKILL);
    pause_for(0.001);
  }
  return {*code_, text_of(said_.path() / "output"), text_of(said_.path() / "errors")};
}

Ended run_program(const std::vector<std::string>& words, double kill_after_seconds, int signal) {
  Running program(words);
  const double begin = seconds_now();
  while (kill_after_seconds >= 0.0 && program.is_running()) {
    if (seconds_now() - begin >= kill_after_seconds) {
      program.send(signal);
      break;
    }
    pause_for(0.001);
  }
  return program.wait();
}

Ended run_mien(const std::vector<std::string>& arguments, double kill_after_seconds, int signal) {
  return run_program(mien_with(arguments), kill_after_seconds, signal);
}

std::vector<std::string> mien_with(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {MIEN_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

std::string must_run(const std::vector<std::string>& words) {
  const Ended ended = run_program(words, 300.0);
  if (ended.code == 0) return ended.output;
  std::string command;
  for (const std::string& word : words) command += word + " ";
  throw std::runtime_error(command + "ended with " + std::to_string(ended.code) + ": " +
                           ended.errors + ended.output);
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void pause_for(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
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
  const std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  if (!(std::ofstream(file, std::ios::binary) << text))
    throw std::runtime_error("cannot write " + file.string());
  return file;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), {});
}

}  // namespace mien::test
