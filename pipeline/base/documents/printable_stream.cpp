#include "pipeline/base/documents/printable_stream.h"

#include <algorithm>
#include <mutex>
#include <streambuf>
#include <string>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

/// Number of bytes of an incomplete UTF-8 character at the text's end.
std::size_t incomplete_character_bytes(std::string_view text) {
  for (std::size_t back = 1; back <= std::min<std::size_t>(3, text.size()); ++back) {
    const auto byte = static_cast<unsigned char>(text[text.size() - back]);
    if ((byte & 0xC0U) == 0x80U) continue;
    const std::size_t needed = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
    return needed > back ? back : 0;
  }
  return 0;
}

bool is_control_character(char character) {
  const auto code = static_cast<unsigned char>(character);
  return code < 0x20 && character != '\n' && character != '\t' && character != '\r';
}

std::string with_escaped_controls(std::string_view text) {
  std::string shown;
  for (const char character : text) {
    if (is_control_character(character)) {
      shown += motion::printable({&character, 1});
    } else {
      shown += character;
    }
  }
  return shown;
}

}  // namespace

class PrintableStream::Buffer : public std::streambuf {
 public:
  Buffer(std::ostream& target, StreamReader reader) : target_(target), reader_(reader) {}
  ~Buffer() override {
    const std::lock_guard lock(mutex_);
    pass_on(0);
  }

  void put_control(std::string_view sequence) {
    const std::lock_guard lock(mutex_);
    pass_on(0);
    target_.write(sequence.data(), static_cast<std::streamsize>(sequence.size()));
  }

 protected:
  int_type overflow(int_type character) override {
    if (traits_type::eq_int_type(character, traits_type::eof())) return 0;
    const char one = traits_type::to_char_type(character);
    return xsputn(&one, 1) == 1 ? character : traits_type::eof();
  }

  std::streamsize xsputn(const char* text, std::streamsize size) override {
    const std::lock_guard lock(mutex_);
    waiting_.append(text, static_cast<std::size_t>(size));
    return pass_on(reader_ == StreamReader::terminal ? incomplete_character_bytes(waiting_) : 0)
               ? size
               : 0;
  }

  int sync() override {
    const std::lock_guard lock(mutex_);
    return target_.flush() ? 0 : -1;
  }

 private:
  /// All but the last bytes.
  bool pass_on(std::size_t last) {
    const std::string_view whole = std::string_view(waiting_).substr(0, waiting_.size() - last);
    const std::string shown = reader_ == StreamReader::terminal
                                  ? motion::printable(whole, motion::LineEnds::kept)
                                  : with_escaped_controls(whole);
    waiting_.erase(0, whole.size());
    return static_cast<bool>(
        target_.write(shown.data(), static_cast<std::streamsize>(shown.size())));
  }

  std::ostream& target_;
  StreamReader reader_;
  std::mutex mutex_;
  std::string waiting_;
};

PrintableStream::PrintableStream(std::ostream& target, StreamReader reader)
    : std::ostream(nullptr), buffer_(std::make_unique<Buffer>(target, reader)) {
  rdbuf(buffer_.get());
}

PrintableStream::~PrintableStream() { rdbuf(nullptr); }

void put_control(std::ostream& out, std::string_view sequence) {
  if (auto* const buffer = dynamic_cast<PrintableStream::Buffer*>(out.rdbuf())) {
    buffer->put_control(sequence);
  } else {
    out << sequence;
  }
}

}  // namespace mien::pipeline
