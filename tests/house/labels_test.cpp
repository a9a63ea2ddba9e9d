#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mien::test {
namespace {

namespace fs = std::filesystem;

const fs::path tests = fs::path(MIEN_SOURCE_DIR) / "tests";

struct Label {
  std::string label;
  std::string name;  ///< of a suite or a test
};

std::vector<Label> all_labels() {
  std::vector<Label> all;
  std::ifstream file(tests / "labels.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with("#")) continue;
    Label& one = all.emplace_back();
    std::istringstream(line) >> one.label >> one.name;
  }
  return all;
}

/// Suites ("FootLock") and tests ("FootLock.HoldsPlantedFeetStill") of all sources.
std::set<std::string> names_of_tests() {
  static const std::regex declared(R"((?:^|\n)TEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(tests)) {
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

/// The expressions of ctest for tests that a name means (find_tests.awk), without repetitions.
std::string expression_of(const std::string& name) {
  const std::string command =
      "cd '" + tests.string() + "' && find . -name '*_test.cpp' | sort | xargs awk -v names='" +
      name + "' -f find_tests.awk | cut -d ' ' -f 3 | uniq | paste -sd '|' -";
  std::string found;
  FILE* pipe = popen(command.c_str(), "r");
  for (int c = fgetc(pipe); c != EOF && c != '\n'; c = fgetc(pipe)) found += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << name;
  return found;
}

bool means(const std::string& name, const std::string& test) {
  return std::regex_search(test, std::regex("(^|/)(" + expression_of(name) + ")"));
}

// Expressions of ctest have at most some thirty parentheses, and a module has hundreds of suites.
TEST(NamedTests, AreSuitesOrTestsWithoutParentheses) {
  EXPECT_EQ(expression_of("motion").find('('), std::string::npos);
  for (const char* name : {"FootLock", "motion/gait", "motion"}) {
    EXPECT_TRUE(means(name, "motion/FootLock")) << name;
    EXPECT_TRUE(means(name, "motion/FootLock.HoldsPlantedFeetStill")) << name;
    EXPECT_FALSE(means(name, "pipeline/FootLocker")) << name;
  }
  EXPECT_TRUE(means("Contract", "render/Tracer/Contract"));
  EXPECT_TRUE(means("Contract", "render/Tracer/Contract.HoldsPerBlock/feet"));
  EXPECT_TRUE(means("FootLock.HoldsPlantedFeetStill", "motion/FootLock.HoldsPlantedFeetStill"));
  EXPECT_FALSE(
      means("FootLock.HoldsPlantedFeetStill", "motion/FootLock.HoldsPlantedFeetStillMore"));
}

TEST(Labels, AreOfTestsThatThereAre) {
  const std::set<std::string> names = names_of_tests();
  const std::set<std::string> labels = {"slow", "long", "browser", "slurm"};
  const std::vector<Label> all = all_labels();
  for (const Label& one : all) {
    EXPECT_TRUE(labels.contains(one.label)) << one.label << " " << one.name;
    EXPECT_TRUE(names.contains(one.name)) << one.label << " " << one.name;
  }
  EXPECT_FALSE(all.empty());
}

// What nobody asks for runs seldom: something of each suite runs always.
TEST(Labels, LeaveEachSuiteATestThatIsNotLong) {
  std::set<std::string> names = names_of_tests();
  std::set<std::string> suites;
  for (const Label& one : all_labels()) {
    if (one.label != "long") continue;
    const std::size_t dot = one.name.find('.');
    EXPECT_NE(dot, std::string::npos) << one.name << " is a suite";
    suites.insert(one.name.substr(0, dot) + ".");
    names.erase(one.name);
  }
  for (const std::string& suite : suites) {
    const auto first = names.lower_bound(suite);
    EXPECT_TRUE(first != names.end() && first->starts_with(suite)) << suite;
  }
}

// Tests that mostly wait for a browser share the processors with others, if they say that they need
// one.
TEST(Labels, NameWhatNeedsABrowser) {
  static const std::regex derived(R"(class (\w+) : public (?:QuestionnairePage|LivePage)\b)");
  std::set<std::string> labelled;
  for (const Label& one : all_labels())
    if (one.label == "browser") labelled.insert(one.name);
  int found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(tests)) {
    if (!entry.path().string().ends_with("_test.cpp")) continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::sregex_iterator at(text.begin(), text.end(), derived), end; at != end; ++at, ++found)
      EXPECT_TRUE(labelled.contains((*at)[1])) << (*at)[1];
  }
  EXPECT_GT(found, 5);
}

}  // namespace
}  // namespace mien::test
