#include "pipeline/base/documents/printable_stream.h"

#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "motion/text/excerpt.h"

namespace mien::pipeline {
namespace {

TEST(PrintableStream, GivesATerminalNoOrdersOfOthers) {
  std::ostringstream terminal;
  PrintableStream out(terminal, StreamReader::terminal);
  out << "a\x1b[2Jb\tc\r\n"
      << "caf\u00e9 \u202E \xC2\x9B" << 7 << '\x07' << std::flush;
  EXPECT_EQ(terminal.str(), "a\\x1b[2Jb\tc\\r\ncaf\u00e9 \\u202e \\u009b7\\x07");
}

TEST(PrintableStream, LetsOurOwnOrdersPass) {
  std::ostringstream terminal;
  PrintableStream out(terminal, StreamReader::terminal);
  out << "\x1b[K";
  put_control(out, "\r\x1b[K");
  EXPECT_EQ(terminal.str(), "\\x1b[K\r\x1b[K");
  std::ostringstream plain;
  put_control(plain, "\x1b[K");
  EXPECT_EQ(plain.str(), "\x1b[K");
}

TEST(PrintableStream, LeavesToAProgramWhatJsonAndTablesHold) {
  std::ostringstream file;
  PrintableStream out(file, StreamReader::program);
  out << "{\"name\": \"\x7f\xC2\x9B\u202E\"}\r\n" << '\0' << "\x1b[31m";
  EXPECT_EQ(file.str(), "{\"name\": \"\x7f\xC2\x9B\u202E\"}\r\n\\x00\\x1b[31m");
}

TEST(PrintableStream, ReadsCharactersThatComeInPieces) {
  std::mt19937_64 random(7);
  const std::string text = "歩く\x1b[1m \U0001F6B6 \xff\xe6 caf\u00e9\xC2";
  for (int i = 0; i < 200; ++i) {
    std::ostringstream terminal;
    {
      PrintableStream out(terminal, StreamReader::terminal);
      for (std::size_t at = 0; at < text.size();) {
        const std::size_t count = 1 + random() % 3;
        out << text.substr(at, count);
        at += count;
      }
    }
    EXPECT_EQ(terminal.str(), motion::printable(text));
  }
}

TEST(PrintableStream, FailsWithTheStreamBehindIt) {
  std::ostringstream full;
  PrintableStream out(full, StreamReader::program);
  full.setstate(std::ios::badbit);
  out << "text" << std::flush;
  EXPECT_FALSE(out);
}

}  // namespace
}  // namespace mien::pipeline
