#pragma once

#include <memory>
#include <ostream>
#include <string_view>

namespace mien::pipeline {

/// Who reads what a stream is given.
enum class StreamReader {
  terminal,  ///< or somebody's eyes: everything is written out as in motion/text/excerpt.h
  program    ///< a file or a pipe: control characters alone, and what JSON may hold stays
};

/// The door through which the program prints: passes text on to another stream, and writes out in
/// it what a terminal would obey, whatever name of a file or text of somebody else is in it. Line
/// ends and tabs stay. Fails when the other stream does. For several threads.
class PrintableStream : public std::ostream {
 public:
  /// `target` outlives it.
  PrintableStream(std::ostream& target, StreamReader reader);
  ~PrintableStream() override;

 private:
  class Buffer;
  friend void put_control(std::ostream& out, std::string_view sequence);
  std::unique_ptr<Buffer> buffer_;
};

/// Gives a terminal behind the stream an order of ours, such as to clear the line.
void put_control(std::ostream& out, std::string_view sequence);

}  // namespace mien::pipeline
