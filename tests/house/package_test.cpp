// What the package installs.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace mien {
namespace {

namespace fs = std::filesystem;

TEST(Package, HasEveryFileThatManifestsName) {
  std::ifstream in(fs::path(MIEN_SOURCE_DIR) / ".ci" / "package.cmake");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = text.find("install(DIRECTORY manifests/");
  ASSERT_NE(begin, std::string::npos);
  const std::string rule = text.substr(begin, text.find(')', begin) - begin);
  const std::regex pattern("PATTERN \"\\*([.][a-z]+)\"");
  std::set<std::string> installed;
  for (std::sregex_iterator found(rule.begin(), rule.end(), pattern), end; found != end; ++found)
    installed.insert((*found)[1]);
  // Pages, their pictures and the programs that made sounds are for readers of the sources.
  const std::set<std::string> left_out = {".md", ".py", ".png"};
  int files = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(MIEN_SOURCE_DIR) / "manifests")) {
    const std::string ending = entry.path().extension().string();
    if (entry.is_directory() || left_out.contains(ending)) continue;
    EXPECT_TRUE(installed.contains(ending)) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 20);
}

}  // namespace
}  // namespace mien
