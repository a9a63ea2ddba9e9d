#pragma once

#include <array>
#include <ostream>
#include <streambuf>
#include <string_view>
#include <system_error>

namespace mien::pipeline {

/// Where commands put their results, buffered. It remembers why something could not be written,
/// which std::cout forgets, so that results that went nowhere are told at the program's end.
///
/// From its first failure on it takes nothing more. While it lives, SIGPIPE is ignored and
/// std::cerr flushes it first, so that the two keep their order on a terminal.
class StandardOutput : private std::streambuf {
 public:
  StandardOutput();
  ~StandardOutput() override;
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;

  std::ostream& stream() { return stream_; }

  /// Writes what is left. Returns the exit code of a program that would have ended with `code`:
  /// results that could not be written are a failure, which is told in one line; a reader that has
  /// gone (`| head`) had what it wanted, and is none.
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

/// Puts /dev/null where standard input, output or error was closed by whoever started the program:
/// the first file that it opens would get that number, and what is printed would be written into
/// it. Reading from them or writing to them fails as before.
void keep_standard_streams_open();

}  // namespace mien::pipeline
