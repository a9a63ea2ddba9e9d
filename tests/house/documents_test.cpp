// What pages and other documents state about each other.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace mien::test {
namespace {

namespace fs = std::filesystem;

const fs::path source = MIEN_SOURCE_DIR;

TEST(Version, IsTheSameInAllDocuments) {
  EXPECT_EQ(std::system(("'" + source.string() + "/.ci/version'").c_str()), 0);
  EXPECT_NE(std::system(("'" + source.string() + "/.ci/version' 77.0.0 2>/dev/null").c_str()), 0);
}

/// Pages without their ending, as the navigation names them: "motion/README".
std::set<std::string> pages() {
  std::set<std::string> names;
  for (fs::recursive_directory_iterator at(source), end; at != end; ++at) {
    const std::string name = at->path().filename().string();
    const bool at_root = at->path().parent_path() == source;
    if (at->is_directory() && (name.starts_with('.') || name == "node_modules" ||
                               (at_root && (name.starts_with("build") || name == "out"))))
      at.disable_recursion_pending();
    else if (at->path().extension() == ".md")
      names.insert(fs::relative(at->path(), source).replace_extension().string());
  }
  return names;
}

TEST(Site, NamesEveryPageInItsNavigation) {
  std::ifstream file(source / ".ci/site/conf.py");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::set<std::string> named = {"README"};  // the first page, which has the navigation
  const std::regex entry(R"re(\("[^"]+", "([\w/-]+)"\))re");
  for (std::sregex_iterator at(text.begin(), text.end(), entry), end; at != end; ++at)
    EXPECT_TRUE(named.insert((*at)[1]).second) << (*at)[1] << " is named twice";
  EXPECT_EQ(named, pages());
}

}  // namespace
}  // namespace mien::test
