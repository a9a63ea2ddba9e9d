#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// Suites ("FootLock") and tests ("FootLock.HoldsPlantedFeetStill") of all sources.
std::set<std::string> names_of_tests(const fs::path& folder) {
  static const std::regex declared(R"((?:^|\n)TEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::sregex_iterator at(text.begin(), text.end(), declared), end; at != end; ++at) {
      names.insert((*at)[1]);
      names.insert((*at)[1].str() + "." + (*at)[2].str());
    }
  }
  return names;
}

TEST(Labels, AreOfTestsThatThereAre) {
  const fs::path folder = fs::path(MIEN_SOURCE_DIR) / "tests";
  const std::set<std::string> names = names_of_tests(folder);
  const std::set<std::string> labels = {"slow", "browser", "slurm"};
  std::ifstream file(folder / "labels.txt");
  int count = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with("#")) continue;
    std::string label, name;
    std::istringstream(line) >> label >> name;
    EXPECT_TRUE(labels.contains(label)) << line;
    EXPECT_TRUE(names.contains(name)) << line;
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace mien::test
