#include "pipeline/study/studio/manifest_edit.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/study/studio/document_change.h"

namespace mien::pipeline {
namespace {

using nlohmann::ordered_json;

const Environment no_variables = [](const std::string&) -> std::optional<std::string> {
  return std::string("x");
};

ordered_json document_in(const std::string& text) {
  return document_of(text, "m.yaml", no_variables);
}

/// The text that says `wanted`.
std::string edited_to(const std::string& text, const ordered_json& wanted) {
  return edited(text, "m.yaml", changes_between(document_in(text), wanted), no_variables);
}

/// The text after one change: nothing for `value` removes.
std::string set(const std::string& text, const DocumentPath& path, const ordered_json& value) {
  return edited(text, "m.yaml", {{DocumentChange::Kind::set, path, value}}, no_variables);
}
std::string removed(const std::string& text, const DocumentPath& path) {
  return edited(text, "m.yaml", {{DocumentChange::Kind::remove, path, {}}}, no_variables);
}
std::string inserted(const std::string& text, const DocumentPath& path, const ordered_json& value) {
  return edited(text, "m.yaml", {{DocumentChange::Kind::insert, path, value}}, no_variables);
}

std::string fault_of(const std::string& text, const DocumentPath& path, const ordered_json& value) {
  try {
    set(text, path, value);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const std::string study =
    "# what it is for\n"
    "mien: 1   # version\n"
    "look: {scene: studio, 'figure': stick}   # quiet\n"
    "stimuli:\n"
    "  # first\n"
    "  - id: a   # the one\n"
    "    adjectives:\n"
    "      quickness: 0.7   # brisk\n"
    "      largeness: 0.65\n"
    "\n"
    "  # second\n"
    "  - id: \"b\"\n"
    "    weights: {normal: 0.6, proud: 0.4}\n";

TEST(ManifestEdit, SetsAScalarAndNothingElse) {
  std::string wanted = study;
  wanted.replace(wanted.find("0.7 "), 3, "0.25");
  EXPECT_EQ(set(study, {"stimuli", std::size_t{0}, "adjectives", "quickness"}, 0.25), wanted);
}

TEST(ManifestEdit, KeepsQuotesOfTexts) {
  std::string wanted = study;
  wanted.replace(wanted.find("\"b\""), 3, "\"new b\"");
  EXPECT_EQ(set(study, {"stimuli", std::size_t{1}, "id"}, "new b"), wanted);
  EXPECT_EQ(set("a: 'it''s'   # x\n", {"a"}, "that's"), "a: 'that''s'   # x\n");
}

TEST(ManifestEdit, AddsMembersWhereTheMapEnds) {
  std::string wanted = study;
  wanted.insert(wanted.find("\n\n  # second"), "\n      clearness: 0.5");
  EXPECT_EQ(set(study, {"stimuli", std::size_t{0}, "adjectives", "clearness"}, 0.5), wanted);
  wanted = study;
  wanted.insert(wanted.find("}   # quiet"), ", camera: side");
  EXPECT_EQ(set(study, {"look", "camera"}, "side"), wanted);
}

TEST(ManifestEdit, RemovesMembersWithTheirLines) {
  std::string wanted = study;
  const std::string line = "      quickness: 0.7   # brisk\n";
  wanted.erase(wanted.find(line), line.size());
  EXPECT_EQ(removed(study, {"stimuli", std::size_t{0}, "adjectives", "quickness"}), wanted);
  EXPECT_EQ(removed("a: {b: 1, c: 2}\n", {"a", "b"}), "a: {c: 2}\n");
  EXPECT_EQ(removed("a: {b: 1, c: 2}\n", {"a", "c"}), "a: {b: 1}\n");
  EXPECT_EQ(removed("a:\n  b: 1\nc: 2\n", {"a", "b"}), "a:\n  {}\nc: 2\n");
  EXPECT_EQ(removed("a:\n  - b: 1\n    c: 2\n", {"a", std::size_t{0}, "b"}), "a:\n  - c: 2\n");
  EXPECT_EQ(removed("a: 1\nb: 2", {"b"}), "a: 1");
}

TEST(ManifestEdit, AddsAndRemovesStimuli) {
  const ordered_json added = {{"id", "c"}, {"weights", {{"sad", 1}}}};
  EXPECT_EQ(inserted(study, {"stimuli", std::size_t{2}}, added),
            study + "  - id: c\n    weights: {sad: 1}\n");
  std::string wanted = study;
  wanted.insert(wanted.find("\n\n  # second"), "\n  - id: c\n    weights: {sad: 1}");
  EXPECT_EQ(inserted(study, {"stimuli", std::size_t{1}}, added), wanted);
  wanted = study.substr(0, study.find("  - id: \"b\""));
  EXPECT_EQ(removed(study, {"stimuli", std::size_t{1}}), wanted);
}

TEST(ManifestEdit, KeepsLineBreaksOfWindows) {
  EXPECT_EQ(set("a:\r\n  b: 1 # x\r\n", {"a", "c"}, 2), "a:\r\n  b: 1 # x\r\n  c: 2\r\n");
  EXPECT_EQ(removed("a: 1\r\nb: 2\r\n", {"a"}), "b: 2\r\n");
}

TEST(ManifestEdit, FillsWhatIsEmpty) {
  EXPECT_EQ(set("a:\nb: 2\n", {"a"}, "x"), "a: x\nb: 2\n");
  EXPECT_EQ(set("a: # why\nb: 2\n", {"a"}, "x"), "a: x # why\nb: 2\n");
  EXPECT_EQ(set("a: {}\n", {"a", "b"}, 1), "a: {b: 1}\n");
  EXPECT_EQ(inserted("a: []\n", {"a", std::size_t{0}}, 1), "a: [1]\n");
}

TEST(ManifestEdit, QuotesWhatWouldBeReadAsSomethingElse) {
  for (const std::string text :
       {"true", "12", "",     "a: b", "x # y", "${HOME}", "~",   "No", "1e3",
        "\"",   "'",  "a\nb", "- a",  "日本",  "{",       "*a",  "&a", "!a",
        "%a",   "@a", "`a",   " a ",  "0x1F",  ".5",      "null"}) {
    for (const std::string before :
         {"a: 1\n", "a: 'x'\n", "a: \"x\"\n", "a: [1]\n", "b: {a: 1}\n"}) {
      const DocumentPath path = before[0] == 'b' ? DocumentPath{"b", "a"} : DocumentPath{"a"};
      const std::string after = set(before, path, text);
      const ordered_json document = document_in(after);
      EXPECT_EQ(before[0] == 'b' ? document["b"]["a"] : document["a"], text) << after;
    }
  }
}

TEST(ManifestEdit, WritesLongMapsBelowEachOther) {
  ordered_json long_map = ordered_json::object();
  for (int i = 0; i < 12; ++i) long_map["parameter-" + std::to_string(i)] = 0.125;
  const std::string text = set("a:\n  b: 1\n", {"a", "c"}, long_map);
  EXPECT_TRUE(text.starts_with("a:\n  b: 1\n  c:\n    parameter-0: 0.125\n")) << text;
  EXPECT_EQ(document_in(text)["a"]["c"], long_map);
}

TEST(ManifestEdit, RefusesAliasesAndMergeKeys) {
  const std::string text =
      "base: &base {a: 1, b: 2}\nuse: *base\nmerged:\n  <<: *base\n  c: 3\nfree: &f {a: 1}\n";
  EXPECT_EQ(fault_of(text, {"use", "a"}, 5),
            "m.yaml:2:6: this value stands elsewhere in the file, behind an alias; write the value "
            "out here, or change it by hand where its anchor is");
  EXPECT_EQ(fault_of(text, {"base", "a"}, 5),
            "m.yaml:1:7: this value is used again by the alias on line 2; write the value out "
            "there, or change it by hand");
  EXPECT_THROW(removed(text, {"merged", "a"}), Error);
  // What a merge key brings may be set over, and an anchor that nothing names is no hindrance.
  EXPECT_EQ(document_in(set(text, {"merged", "a"}, 7))["merged"]["a"], 7);
  EXPECT_NE(set(text, {"free", "a"}, 7).find("free: &f {a: 7}"), std::string::npos);
}

TEST(ManifestEdit, RefusesSeveralDocuments) {
  EXPECT_NE(fault_of("a: 1\n---\nb: 2\n", {"a"}, 5).find("a second document begins here"),
            std::string::npos);
}

TEST(ManifestEdit, RefusesToLoseComments) {
  const std::string text = "a: [1, # one\n    2]\nb: 1\n";
  EXPECT_THROW(removed(text, {"a", std::size_t{0}}), Error);
  EXPECT_NE(set(text, {"a", std::size_t{0}}, 5).find("[5, # one"), std::string::npos);
}

// Lines of a value that was changed or taken away may go with it.
class ChangedAtRandom : public testing::TestWithParam<unsigned> {};

ordered_json random_value(std::mt19937& random) {
  switch (random() % 7) {
    case 0:
      return static_cast<double>(random() % 1000) / 1000.0;
    case 1:
      return static_cast<int>(random() % 100) - 50;
    case 2:
      return random() % 2 == 0;
    case 3:
      return std::vector<std::string>{"plain", "two words", "it's: so # quoted"}[random() % 3];
    case 4:
      return ordered_json::array({random_value(random), "x"});
    case 5:
      return ordered_json::object({{"a", random_value(random)}, {"b c", 1}});
    default:
      return ordered_json::object();
  }
}

/// Goes down at random and changes something there.
void change_somewhere(ordered_json& value, std::mt19937& random) {
  const bool goes_down = value.is_structured() && !value.empty() && random() % 4 != 0;
  if (goes_down) {
    auto member = value.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(random() % value.size()));
    return change_somewhere(*member, random);
  }
  if (value.is_object()) {
    if (random() % 2 == 0 || value.empty()) {
      value["new-" + std::to_string(random() % 100)] = random_value(random);
    } else {
      value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(random() % value.size())));
    }
  } else if (value.is_array()) {
    const auto at = static_cast<std::ptrdiff_t>(random() % (value.size() + 1));
    if (random() % 2 == 0 || at == static_cast<std::ptrdiff_t>(value.size())) {
      value.insert(value.begin() + at, random_value(random));
    } else {
      value.erase(value.begin() + at);
    }
  } else {
    value = random_value(random);
  }
}

std::vector<std::string> comments_in(const std::string& text) {
  std::vector<std::string> comments;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string::npos && line[first] == '#') comments.push_back(line);
    begin = end + 1;
  }
  return comments;
}

/// In the same order, some perhaps left out.
bool is_among(const std::vector<std::string>& some, const std::vector<std::string>& all) {
  auto at = all.begin();
  return std::all_of(some.begin(), some.end(), [&](const std::string& one) {
    at = std::find(at, all.end(), one);
    return at != all.end() && at++ != all.end();
  });
}

TEST_P(ChangedAtRandom, SaysWhatWasWantedAndKeepsTheComments) {
  std::mt19937 random(GetParam());
  int changed = 0, refused = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests")) {
    if (file.path().extension() != ".yaml") continue;
    const std::string name = file.path().filename().string();
    if (name.find(".recipes.") != std::string::npos || name.find(".scales.") != std::string::npos)
      continue;
    std::string text = read_file(file.path());
    for (int trial = 0; trial < 6; ++trial) {
      ordered_json wanted = document_in(text);
      change_somewhere(wanted, random);
      std::string after;
      try {
        after = edited_to(text, wanted);
      } catch (const Error& error) {
        ++refused;
        const std::string told = error.what();
        EXPECT_TRUE(told.find("alias") != std::string::npos ||
                    told.find("comment") != std::string::npos ||
                    told.find("merge key") != std::string::npos)
            << name << ": " << told << "\n"
            << wanted.dump().substr(0, 300);
        continue;
      }
      ++changed;
      EXPECT_TRUE(say_the_same(document_in(after), wanted)) << name;
      const auto kept = comments_in(after), were = comments_in(text);
      EXPECT_TRUE(is_among(kept, were)) << name;
      text = after;
    }
  }
  EXPECT_GT(changed, 10 * refused);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ChangedAtRandom, testing::Values(1u, 2u, 3u));

TEST(ManifestEdit, UntouchedLinesStayToTheByte) {
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests")) {
    if (file.path().extension() != ".yaml") continue;
    const std::string text = read_file(file.path());
    ordered_json wanted = document_in(text);
    if (!wanted.contains("stimuli") || wanted["stimuli"].empty()) continue;
    wanted["stimuli"][0]["id"] = "renamed";
    const std::string after = edited_to(text, wanted);
    // One line differs: what stands before and behind it is the same.
    const auto first = std::mismatch(text.begin(), text.end(), after.begin(), after.end());
    const auto last = std::mismatch(text.rbegin(), std::make_reverse_iterator(first.first),
                                    after.rbegin(), std::make_reverse_iterator(first.second));
    const std::string gone(first.first, last.first.base());
    EXPECT_EQ(gone.find('\n'), std::string::npos) << file.path();
  }
}

}  // namespace
}  // namespace mien::pipeline
