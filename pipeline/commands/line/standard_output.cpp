#include "pipeline/commands/line/standard_output.h"

#include <cerrno>
#include <csignal>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

StandardOutput::StandardOutput() : is_terminal_(isatty(STDOUT_FILENO) != 0), stream_(this) {
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  std::signal(SIGPIPE, SIG_IGN);  // that a reader has gone is told by the write
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

void keep_standard_streams_open() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) != -1) continue;
    ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // takes the lowest number
  }
}

}  // namespace mien::pipeline
