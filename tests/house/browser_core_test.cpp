#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mien::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The words that a shell script sets a variable to.
std::vector<std::string> words_of(const std::string& script, const std::string& variable) {
  std::smatch found;
  if (!std::regex_search(script, found, std::regex("\n" + variable + "='([^']*)'"))) return {};
  std::istringstream stream(found[1].str());
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The sources that the motion core for browsers is compiled from.
std::vector<fs::path> sources_of_browser_core() {
  const fs::path motion = fs::path(MIEN_SOURCE_DIR) / "motion";
  const std::string script = text_of(motion / "live/browser/build_module.sh");
  std::vector<fs::path> sources;
  for (const std::string& file : words_of(script, "files")) sources.push_back(motion / file);
  for (const std::string& room : words_of(script, "rooms")) {
    for (const fs::directory_entry& entry : fs::directory_iterator(motion / room)) {
      if (entry.path().extension() == ".cpp") sources.push_back(entry.path());
    }
  }
  return sources;
}

// Debian 12's Emscripten comes with the library of clang 14, which lacks these. Machines without
// Emscripten would not notice.
TEST(BrowserCore, IsWrittenWithoutWhatItsLibraryLacks) {
  const std::vector<fs::path> sources = sources_of_browser_core();
  EXPECT_GT(sources.size(), 100U);
  const std::regex lacking("std::(ranges|views|to_chars|from_chars|format)\\b");
  for (const fs::path& source : sources) {
    ASSERT_TRUE(fs::is_regular_file(source)) << source;
    std::smatch found;
    const std::string text = text_of(source);
    EXPECT_FALSE(std::regex_search(text, found, lacking)) << source << ": " << found[0];
  }
}

}  // namespace
}  // namespace mien::test
