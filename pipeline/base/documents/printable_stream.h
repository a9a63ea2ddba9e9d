#pragma once

#include <memory>
#include <ostream>
#include <string_view>

namespace mien::pipeline {

/// Destination of a stream, which determines what is escaped.
enum class StreamReader {
  terminal,  ///< all special characters are escaped as in motion/text/excerpt.h
  program    ///< a file or a pipe: only control characters are escaped, so that JSON stays valid
};

/// An output stream that forwards text to another stream and escapes what a terminal would
/// interpret, since file names and other texts in it may contain control sequences. Line feeds and
/// tabs are kept, carriage returns only for StreamReader::program. Fails if the other stream fails.
/// Thread-safe.
class PrintableStream : public std::ostream {
 public:
  /// `target` must outlive the stream.
  PrintableStream(std::ostream& target, StreamReader reader);
  ~PrintableStream() override;

 private:
  class Buffer;
  friend void put_control(std::ostream& out, std::string_view sequence);
  std::unique_ptr<Buffer> buffer_;
};

/// Writes a control sequence of the program itself, such as clearing the line, to a terminal. It is
/// not escaped, even if `out` is a PrintableStream.
void put_control(std::ostream& out, std::string_view sequence);

}  // namespace mien::pipeline
