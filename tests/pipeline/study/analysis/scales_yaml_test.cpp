#include "pipeline/study/analysis/scales_yaml.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {
namespace {

void expect_equal(const ScaleSet& a, const ScaleSet& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.scales.size(), b.scales.size());
  for (size_t i = 0; i < a.scales.size(); ++i) {
    EXPECT_EQ(a.scales[i].id, b.scales[i].id);
    EXPECT_EQ(a.scales[i].low, b.scales[i].low);
    EXPECT_EQ(a.scales[i].high, b.scales[i].high);
    EXPECT_EQ(a.scales[i].japanese_low, b.scales[i].japanese_low);
    EXPECT_EQ(a.scales[i].japanese_high, b.scales[i].japanese_high);
    EXPECT_EQ(a.scales[i].least, b.scales[i].least);
    EXPECT_EQ(a.scales[i].most, b.scales[i].most);
    EXPECT_EQ(a.scales[i].loadings, b.scales[i].loadings);
  }
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (size_t i = 0; i < a.groups.size(); ++i) {
    EXPECT_EQ(a.groups[i].id, b.groups[i].id);
    EXPECT_EQ(a.groups[i].japanese, b.groups[i].japanese);
    EXPECT_EQ(a.groups[i].scales, b.groups[i].scales);
  }
  ASSERT_EQ(a.lexicon.languages.size(), b.lexicon.languages.size());
  for (size_t i = 0; i < a.lexicon.languages.size(); ++i) {
    EXPECT_EQ(a.lexicon.languages[i].name, b.lexicon.languages[i].name);
    EXPECT_EQ(a.lexicon.languages[i].called, b.lexicon.languages[i].called);
    EXPECT_EQ(a.lexicon.languages[i].grades, b.lexicon.languages[i].grades);
    EXPECT_EQ(a.lexicon.languages[i].words, b.lexicon.languages[i].words);
  }
}

TEST(ScalesYaml, OfTheAdjectivePairsIsTheFileInManifests) {
  const std::string file = std::string(MIEN_SOURCE_DIR) + "/manifests/adjective-pairs.scales.yaml";
  EXPECT_EQ(read_file(file), adjective_pairs_yaml());
  expect_equal(read_scales(file), builtin_scales());
}

TEST(ScalesYaml, KeepsTheWordsOfAScalesFile) {
  const ScaleSet set =
      read_scales(std::string(MIEN_SOURCE_DIR) + "/manifests/walking-words.scales.yaml");
  ASSERT_FALSE(set.lexicon.languages.empty());
  expect_equal(parse_scales(to_yaml(set, ""), "s.yaml"), set);
}

TEST(ScalesYaml, ReadsBackWhateverTheNamesAre) {
  ScaleSet set;
  set.name = "a: \"b\" # c";
  set.scales.push_back({"yes",
                        "no: never",
                        "yes, \"always\"",
                        "",
                        "",
                        1.0,
                        7.0,
                        {{"quickness", 0.5}, {"valence", -0.25}}});
  set.scales.push_back({"3", "{low}", "[high]", "低い", "高い", -0.5, 0.25, {}});
  set.scales.push_back({"über-alles", "-", "#", "", "", 1.0, 7.0, {}});
  set.groups.push_back({"null", "群", {"3", "yes"}});
  set.groups.push_back({"on", "", {"über-alles"}});
  expect_equal(parse_scales(to_yaml(set, "two\nlines", {{"3", "a remark"}}), "s.yaml"), set);
}

}  // namespace
}  // namespace mien::pipeline
