#include "pipeline/base/documents/environment.h"

#include <map>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

Expansion expanded(const std::string& text) {
  const std::map<std::string, std::string> variables = {
      {"HOME", "/home/a"}, {"EMPTY", ""}, {"LATIN", "\xE9"}};
  return expand(text, [&](const std::string& name) -> std::optional<std::string> {
    const auto found = variables.find(name);
    if (found == variables.end()) return std::nullopt;
    return found->second;
  });
}

TEST(Environment, ReplacesVariablesAndTakesDefaults) {
  EXPECT_EQ(expanded("${HOME}/x").text, "/home/a/x");
  EXPECT_EQ(expanded("${NONE:-../data}/x").text, "../data/x");
  EXPECT_EQ(expanded("${EMPTY:-d}").text, "d");
  EXPECT_EQ(expanded("${EMPTY}").text, "");
  EXPECT_EQ(expanded("${NONE:-}").text, "");
  EXPECT_EQ(expanded("${HOME:-x}${HOME}").text, "/home/a/home/a");
}

TEST(Environment, LeavesOtherDollarsAlone) {
  EXPECT_EQ(expanded("$HOME costs 5$").text, "$HOME costs 5$");
  EXPECT_FALSE(expanded("$HOME").expanded);
  EXPECT_TRUE(expanded("${HOME}").expanded);
  EXPECT_EQ(expanded("$${HOME}").text, "${HOME}");
}

TEST(Environment, SaysWhatIsWrongAndHowToMendIt) {
  EXPECT_EQ(expanded("a${NONE}b").wrong, "the environment variable NONE is not set");
  EXPECT_EQ(expanded("a${NONE}b").remedy, "set it, or write ${NONE:-default}");
  EXPECT_EQ(expanded("${HOME").wrong, "\"${\" without \"}\"");
  EXPECT_EQ(expanded("${1A}").wrong, "\"${1A}\" is not a valid environment variable");
  EXPECT_EQ(expanded("${}").wrong, "\"${}\" is not a valid environment variable");
  EXPECT_EQ(expanded("${LATIN}").wrong, "the environment variable LATIN is not UTF-8 text");
}

}  // namespace
}  // namespace mien::pipeline
