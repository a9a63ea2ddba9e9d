#include "pipeline/base/reading/yaml_tree.h"

#include <string>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

/// The tree in flow style; places are left out.
std::string flow(const YamlNode& node) {
  std::string text;
  switch (node.kind) {
    case YamlNode::Kind::null:
      return "~";
    case YamlNode::Kind::scalar:
      return node.quoted ? "\"" + node.text + "\"" : node.text;
    case YamlNode::Kind::sequence:
      for (const YamlNode& child : node.children) text += (text.empty() ? "" : ", ") + flow(child);
      return "[" + text + "]";
    case YamlNode::Kind::map:
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        text += (text.empty() ? "" : ", ") + node.keys[i].text + ": " + flow(node.children[i]);
      }
      return "{" + text + "}";
  }
  return text;
}

std::string read(const std::string& text) {
  std::vector<Fault> faults;
  const std::string tree = flow(read_yaml(text, "m.yaml", faults));
  return faults.empty() ? tree : "faulty";
}

std::string faults_in(const std::string& text) {
  std::vector<Fault> faults;
  read_yaml(text, "m.yaml", faults);
  std::string list;
  for (const Fault& fault : faults) list += to_string(fault) + "\n";
  return list;
}

TEST(YamlTree, HoldsMapsSequencesAndScalars) {
  EXPECT_EQ(read("a: 1\nb: [x, 'y', ~]\nc: {d: }\n"), "{a: 1, b: [x, \"y\", ~], c: {d: ~}}");
}

TEST(YamlTree, CountsColumnsInCharacters) {
  std::vector<Fault> faults;
  const YamlNode root = read_yaml("a: {速さ: 1, b: 2}\n", "m.yaml", faults);
  const YamlNode& b = root.children[0].keys[1];
  EXPECT_EQ(b.place.line, 1);
  EXPECT_EQ(b.place.column, 12);
}

TEST(YamlTree, ResolvesAliasesAndMergesMaps) {
  EXPECT_EQ(read("a: &x {p: 1, q: 2}\nb: *x\nc: {<<: *x, p: 3}\nd:\n  r: 4\n  <<: *x\n"),
            "{a: {p: 1, q: 2}, b: {p: 1, q: 2}, c: {p: 3, q: 2}, d: {r: 4, p: 1, q: 2}}");
  EXPECT_EQ(read("a: &x {p: 1}\nb: &y {p: 2, q: 3}\nc: {<<: [*x, *y]}\n"),
            "{a: {p: 1}, b: {p: 2, q: 3}, c: {p: 1, q: 3}}");
}

TEST(YamlTree, TellsKeysThatOccurTwice) {
  EXPECT_EQ(faults_in("a: 1\nb: 2\na: 3\n"),
            "m.yaml:3:1: \"a\" is already given on line 1; keep one of the two\n");
}

TEST(YamlTree, TellsTabs) {
  EXPECT_EQ(faults_in("a:\n\tb: 1\n"), "m.yaml:2:1: a tab in the indentation; use spaces\n");
  EXPECT_EQ(faults_in("a:\n  b: 1\n  \tc: 1\n"),
            "m.yaml:3:3: a tab in the indentation; use spaces\n");
}

TEST(YamlTree, TellsWhatIsNoSingleUtf8Document) {
  EXPECT_EQ(faults_in(""), "m.yaml:1:1: the file is empty; write a document into it\n");
  EXPECT_EQ(faults_in("# nothing\n"), "m.yaml:1:1: the file is empty; write a document into it\n");
  EXPECT_EQ(faults_in("a: \xFF\n"), "m.yaml:1:4: not UTF-8 text; save it as UTF-8\n");
  EXPECT_EQ(faults_in(std::string("\xFF\xFE"
                                  "a\0:\0",
                                  6)),
            "m.yaml:1:1: not UTF-8 text; save it as UTF-8\n");
  EXPECT_EQ(faults_in("a: 1\n---\nb: 1\n"),
            "m.yaml:3:1: a second document begins here; keep one document in a file\n");
}

TEST(YamlTree, TellsSyntaxWithThePlace) {
  EXPECT_EQ(faults_in("a: \"x\nb: 3\n"),
            "m.yaml:1:4: a quote that is not closed; add the closing quote\n");
  EXPECT_EQ(faults_in("a: 'x''\n"),
            "m.yaml:1:4: a quote that is not closed; add the closing quote\n");
  EXPECT_EQ(faults_in("a: ['x''y', \"x\\\"y\"]\n"), "");
  EXPECT_EQ(faults_in("a: b: c\n").substr(0, 24), "m.yaml:1:5: not valid YA");
  EXPECT_NE(faults_in("a: [${X:-1}]\n").find("put \"${…}\" in quotes"), std::string::npos);
  const auto is_told_of_question = [](const std::string& text) {
    return faults_in(text).find("put texts that end with ? in quotes") != std::string::npos;
  };
  EXPECT_TRUE(is_told_of_question("- {ask: How old are you?, answer: number}\n"));
  EXPECT_FALSE(is_told_of_question("- {ask: \"How old?\", answer: [number}\n"));
}

TEST(YamlTree, RefusesTagsAndOddKeys) {
  EXPECT_EQ(faults_in("a: !python/object x\n"),
            "m.yaml:1:4: the tag !python/object has no meaning here; omit it\n");
  EXPECT_EQ(faults_in("[a, b]: 1\n"),
            "m.yaml:1:1: a key must be plain text; write \"name: value\"\n");
  EXPECT_EQ(faults_in(std::string(300, 'k') + ": 1\n"),
            "m.yaml:1:1: a key of more than 200 bytes; shorten it\n");
}

TEST(YamlTree, IsNotBlownUpByAliases) {
  std::string bomb = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
  for (char c = 'b'; c <= 'j'; ++c) {
    const std::string before(1, static_cast<char>(c - 1));
    bomb += std::string(1, c) + ": &" + c + " [";
    for (int i = 0; i < 10; ++i) bomb += "*" + before + (i < 9 ? ", " : "]\n");
  }
  EXPECT_NE(faults_in(bomb).find("unfolds to more than 1,000,000 values"), std::string::npos);
  const std::string large = "a: &a " + std::string(1 << 20, 'x') + "\nb: [";
  std::string aliases;
  for (int i = 0; i < 1000; ++i) aliases += i == 0 ? "*a" : ", *a";
  EXPECT_NE(faults_in(large + aliases + "]\n").find("unfolds"), std::string::npos);
  EXPECT_NE(faults_in("a: &a [*a]\n").find("inside the value that it refers to"),
            std::string::npos);
}

TEST(YamlTree, IsNotBlownUpByAnchorsWithinAnchors) {
  // Each of them is kept by its name: 90 times the list.
  std::string nested;
  for (int i = 0; i < 90; ++i) nested += "&a" + std::to_string(i) + " [";
  for (int i = 0; i < 20'000; ++i) nested += "x, ";
  EXPECT_NE(faults_in("a: " + nested + "x" + std::string(90, ']') + "\n").find("unfolds"),
            std::string::npos);
}

TEST(YamlTree, FindsColumnsWithoutBeginningALineAgainForEach) {
  // The square of these characters would take minutes.
  std::string line = "a: [é";
  for (int i = 0; i < 150'000; ++i) line += ", x";
  std::vector<Fault> faults;
  const YamlNode root = read_yaml(line + "]\n", "m.yaml", faults);
  EXPECT_EQ(root.children[0].children.back().place.column, 5 + 3 * 150'000);
}

TEST(YamlTree, IsNotOverrunByNestingOrSize) {
  EXPECT_NE(faults_in(std::string(100000, '[')).find("nested deeper than 100 levels"),
            std::string::npos);
  EXPECT_NE(faults_in("a: " + std::string(17 << 20, 'x')).find("larger than 16 MiB"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
