// What is no recording, named as one of each format, to the program itself: one clear line, within
// two seconds of processor time and 512 MB of memory.

#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

/// The endings of the formats, from what the program says of another one.
std::set<std::string> endings() {
  const Scratch scratch;
  const std::filesystem::path other = scratch.write("walk.xyz", "walk");
  const std::string told = run_mien({"motion", "info", other.string()}).errors;
  static const std::regex ending(R"([( ](\.[a-z0-9]+)[,)])");
  std::set<std::string> found;
  for (std::sregex_iterator match(told.begin(), told.end(), ending), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

/// Runs `mien motion info` with no more memory and time than it may need.
Ended bounded_info(const std::filesystem::path& file) {
  std::vector<std::string> words = {"sh", "-c", "ulimit -d 524288; ulimit -t 2; exec \"$@\"", "sh"};
  for (const std::string& word : mien_with({"motion", "info", file.string()}))
    words.push_back(word);
  return run_program(words, 60.0);
}

TEST(ForeignRecordings, AreNamedForWhatTheyAre) {
  const Scratch scratch;
  const std::vector<std::pair<std::string, std::string>> others = {
      {"", "is empty"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
       "is a git LFS pointer"},
      {"<!DOCTYPE html>\n<html><head><title>404</title></head></html>\n", "is a web page (HTML)"},
      {"\x89PNG\r\n\x1a\n" + std::string(64, '\1'), "is a picture (PNG)"},
      {"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n", "is a document (PDF)"},
  };
  const std::set<std::string> all = endings();
  EXPECT_GE(all.size(), 15u);
  for (const std::string& ending : all) {
    for (const auto& [bytes, told] : others) {
      const std::filesystem::path file = scratch.write("walk" + ending, bytes);
      const Ended ended = bounded_info(file);
      EXPECT_EQ(ended.code, 2) << ending << "\n" << ended.errors;
      EXPECT_NE(ended.errors.find("walk" + ending + ": " + told), std::string::npos)
          << ended.errors;
      EXPECT_EQ(ended.errors.find('\n'), ended.errors.size() - 1) << ended.errors;
      EXPECT_EQ(ended.output, "");
    }
  }
}

}  // namespace
}  // namespace mien::test
