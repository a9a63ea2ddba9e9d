#include "pipeline/commands/line/program.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <ostream>
#include <streambuf>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/printable_stream.h"
#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/line/installed_fonts.h"
#include "pipeline/tasks/interruption.h"

namespace mien::pipeline {

namespace {

/// Buffered standard output for results. It keeps the reason of a failed write, which std::cout
/// does not, so that lost results are reported at the program's end.
///
/// After the first failure it discards further output. During its lifetime SIGPIPE is ignored and
/// std::cerr flushes it first, so that both keep their order on a terminal.
class StandardOutput : private std::streambuf {
 public:
  StandardOutput();
  ~StandardOutput() override;
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;

  std::ostream& stream() { return stream_; }

  /// Flushes the buffer. Returns `code`, or that of a failure if results could not be written,
  /// which is reported in one line. A reader that has closed the pipe (`| head`) is not a failure.
  int finish(int code, std::ostream& err);

 private:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;
  int sync() override;
  bool write(std::string_view text);

  std::array<char, 65536> buffer_;
  std::error_code failure_;
  bool is_terminal_;
  std::ostream stream_;
};

StandardOutput::StandardOutput() : is_terminal_(isatty(STDOUT_FILENO) != 0), stream_(this) {
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is reported by the write
  std::cerr.tie(&stream_);
}

StandardOutput::~StandardOutput() { std::cerr.tie(&std::cout); }

bool StandardOutput::write(std::string_view text) {
  while (!text.empty() && !failure_) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      failure_ = {errno, std::generic_category()};
    }
  }
  return !failure_;
}

int StandardOutput::sync() {
  const bool is_written = write({pbase(), static_cast<std::size_t>(pptr() - pbase())});
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return is_written ? 0 : -1;
}

StandardOutput::int_type StandardOutput::overflow(int_type letter) {
  if (sync() != 0) return traits_type::eof();
  if (!traits_type::eq_int_type(letter, traits_type::eof()))
    sputc(traits_type::to_char_type(letter));
  return traits_type::not_eof(letter);
}

std::streamsize StandardOutput::xsputn(const char* text, std::streamsize count) {
  const std::streamsize put = std::streambuf::xsputn(text, count);
  const std::string_view written(text, static_cast<std::size_t>(count));
  const bool ends_line = is_terminal_ && written.find('\n') != std::string_view::npos;
  return ends_line && sync() != 0 ? 0 : put;
}

int StandardOutput::finish(int code, std::ostream& err) {
  sync();
  if (!failure_ || failure_ == std::errc::broken_pipe) return code;
  err << "mien: standard output cannot be written (" << failure_.message() << ")\n";
  return code == exit_done ? exit_failed : code;
}

/// Opens /dev/null for standard streams that were closed by the parent process: otherwise the first
/// file opened would get such a descriptor, and output would be written into it. Reading from or
/// writing to them still fails.
void keep_standard_streams_open() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) != -1) continue;
    ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // takes the lowest number
  }
}

constexpr char examples[] = R"(Examples:
  mien run quickstart                      make everything that a manifest specifies
  mien manifests quickstart > my.yaml      print it as a starting point for your own
  mien check my.yaml                       check a manifest for faults
  mien render walk.bvh                     a video of any motion file
  mien motion info walk.bvh                show the contents of a motion file
)";

/// "Exit codes: 0 done, …"
std::string exit_codes_text() {
  std::string text;
  for (const ExitCode& exit : exit_codes)
    text += (text.empty() ? "Exit codes: " : ", ") + std::to_string(exit.code) + " " + exit.meaning;
  return text + ".\n";
}

/// Makes the allocator return full-size images to the system when they are freed. By default it
/// would keep them after the first one and split them for smaller allocations.
void return_freed_images() {
#ifdef __GLIBC__
  constexpr int picture_bytes = 4 << 20;
  mallopt(M_MMAP_THRESHOLD, picture_bytes);
  mallopt(M_TRIM_THRESHOLD, 2 * picture_bytes);
#endif
}

/// Reports an uncaught failure in one line, without a stack trace, and ends the program.
[[noreturn]] void end_at_once() {
  try {
    if (const std::exception_ptr failure = std::current_exception())
      std::rethrow_exception(failure);
  } catch (const std::exception& failure) {
    std::cerr << "mien: " << failure_text(failure) << '\n';
  } catch (...) {
    std::cerr << "mien: failed for an unknown reason\n";
  }
  std::_Exit(exit_failed);
}

}  // namespace

Command program_of(std::vector<Command> commands) {
  return {.name = "mien",
          .summary =
              "mien makes human motion stimuli: from adjectives to walks, videos and comparison "
              "sheets.",
          .options = {flag("--version", {}, "Show the version and exit")},
          .commands = std::move(commands),
          .notes = examples + ("\n" + exit_codes_text()) +
                   "Progress and faults go to standard error, results to standard output."};
}

int run_program(int argc, char** argv, const std::function<Command()>& program) {
  return_freed_images();
  std::set_terminate(end_at_once);
  keep_standard_streams_open();
  use_installed_fonts();
  refuse_version_mismatch();
  exec_external_program(argc, argv);
  const SignalWatch signals;
  StandardOutput output;
  PrintableStream err(std::cerr, StreamReader::terminal);
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  int code = exit_failed;
  {
    PrintableStream out(output.stream(), isatty(STDOUT_FILENO) != 0 ? StreamReader::terminal
                                                                    : StreamReader::program);
    code = run_command_line(program(), argc, argv, {out, err, is_terminal, signals.token()});
  }  // what it still held is passed on
  return output.finish(code, err);
}

}  // namespace mien::pipeline
