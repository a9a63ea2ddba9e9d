#include "pipeline/production/sheets/sheet_content.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/file_keys.h"
#include "pipeline/production/sheets/sheet_parts.h"
#include "pipeline/production/sheets/sheet_task.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {
namespace {

constexpr char holding_manifest[] =
    "mien: 1\nstudy: s\nexamples: {set: builtin:walks-27, ratings: builtin}\nstimuli:\n"
    "  - {id: plain, adjectives: {quickness: 0.5}}\n"
    "  - {id: held, adjectives: {quickness: 0.5}, hold: {largeness: 0.55, activeness: 0.5}}\n"
    "sheets: [{compare: {target: plain, created: held}}]\n";

std::vector<DrawnText> texts_beside_each_other(const SheetContent& content) {
  const Box box = sheet_layout().settings;
  const auto canvas = Canvas::pdf(1200.0, 900.0, "settings");
  draw_settings(*canvas, content, box);
  const std::vector<DrawnText>& texts = canvas->texts();
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlap(texts[i].box, texts[k].box)) << texts[i].text << " on " << texts[k].text;
  }
  return texts;
}

/// The heads of the table's columns, from left to right.
std::vector<DrawnText> column_heads(const std::vector<DrawnText>& texts) {
  std::vector<DrawnText> heads;
  std::ranges::copy_if(texts, std::back_inserter(heads), [](const DrawnText& one) {
    return one.text == "requested" || one.text == "reached";
  });
  std::ranges::sort(heads, {}, [](const DrawnText& one) { return one.box.x; });
  return heads;
}

/// Key of the first sheet of a study of two stimuli with these motions.
Hash key_of_sheet(const std::string& sheet, const std::string& first = "weights: {normal: 1}",
                  const std::string& second = "weights: {sad: 1}", const std::string& more = "") {
  const ManifestReading reading = parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n" + more + "stimuli:\n  - {id: a, " +
          first + "}\n  - {id: b, " + second + "}\nsheets: [{id: all, " + sheet + "}]\n",
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty()) << to_string(reading.faults.at(0));
  FileKeys files;
  Motions motions(reading.manifest);
  return sheet_task(reading.manifest.sheets.front(), reading.manifest,
                    shared_determinants(reading.manifest, files), motions)
      .determinants.key();
}

constexpr char gallery_sheet[] = "gallery: [a, b]";
constexpr char comparison_sheet[] = "compare: {target: a, created: b}";
constexpr char walked_motion[] = "path: [{walk: 1}]";

// Colours show it.
TEST(Galleries, AreDrawnAgainWhenARoleChanges) {
  const auto key_of = [](const std::string& role) {
    return key_of_sheet(gallery_sheet, "role: " + role + ", weights: {normal: 1}");
  };
  EXPECT_NE(key_of("target"), key_of("reference"));
  EXPECT_EQ(key_of("target"), key_of("target"));
}

// They state where motions come from, and the weights below show no other motion.
TEST(Galleries, AreDrawnAgainWhenTheSourceOfAMotionIsStatedInAnotherWay) {
  EXPECT_NE(key_of_sheet(gallery_sheet, "weights: {normal: 1}"),
            key_of_sheet(gallery_sheet, "weights: {normal: 1, sad: 0}"));
}

TEST(Sheets, AreDrawnAgainWhenTheyAreOfAnotherKind) {
  EXPECT_NE(key_of_sheet(gallery_sheet), key_of_sheet(comparison_sheet));
  EXPECT_NE(key_of_sheet("gallery: [a, b, normal]"),
            key_of_sheet("compare: {target: a, created: b, reference: normal}"));
}

TEST(Sheets, AreDrawnAgainInAnotherLanguage) {
  const auto key_of = [](const std::string& more) {
    return key_of_sheet(comparison_sheet, "weights: {normal: 1}", "weights: {sad: 1}", more);
  };
  EXPECT_NE(key_of("names: en\n"), key_of("names: ja\n"));
  EXPECT_NE(key_of("names: ja\n"), key_of("names: both\n"));
  // The names are those of the pages for participants.
  EXPECT_NE(key_of("matching: {participants: 4, targets: [a], language: en}\n"),
            key_of("matching: {participants: 4, targets: [a], language: ja}\n"));
}

// It is printed below, also where no motion depends on it.
TEST(Sheets, AreDrawnAgainWhenTheSeedOfTheStudyChanges) {
  for (const char* sheet : {gallery_sheet, comparison_sheet}) {
    EXPECT_NE(key_of_sheet(sheet, walked_motion, walked_motion, "seed: 1\n"),
              key_of_sheet(sheet, walked_motion, walked_motion, "seed: 2\n"));
  }
}

TEST(ComparisonSheets, KeepTheHeadsOfColumnsApart) {
  SheetContent content;
  SheetParameter& parameter = content.parameters.emplace_back();
  parameter.name = "quickness";
  parameter.target = {.requested = 0.7, .held = {}, .reached = 0.7};
  parameter.created = {.requested = 0.6, .held = {}, .reached = 0.61};
  const auto expect_heads = [&](std::size_t count) {
    const std::vector<DrawnText> heads = column_heads(texts_beside_each_other(content));
    ASSERT_EQ(heads.size(), count);
    for (std::size_t i = 1; i < heads.size(); ++i)
      EXPECT_GE(heads[i].box.x - heads[i - 1].box.right(), 4.0) << heads[i].text;
  };
  expect_heads(4);
  parameter.created.requested.reset();
  expect_heads(3);
  parameter.created.held = 0.5;
  expect_heads(4);
}

TEST(ComparisonSheets, NameParametersInTheLanguageThatIsChosen) {
  ManifestReading reading = parse_manifest(
      std::string(holding_manifest) + "questionnaire: {participants: 2, scales: emotions}\n",
      "m.yaml", [](const std::string&) { return std::nullopt; });
  Manifest& manifest = reading.manifest;
  Motions motions(manifest);
  const auto has = [&](const char* text) {
    const auto texts =
        texts_beside_each_other(sheet_content(manifest.sheets.front(), manifest, motions));
    return std::ranges::any_of(texts, [&](const DrawnText& one) { return one.text == text; });
  };
  EXPECT_TRUE(has("quickness") && has("Parameters"));
  manifest.names = NameLanguage::both;
  EXPECT_TRUE(has("quickness 速さ") && has("Parameters 指標"));
  manifest.names = NameLanguage::japanese;
  EXPECT_TRUE(has("速さ") && has("混合比"));
  manifest.names = NameLanguage::study;
  manifest.questionnaire->language = {{"ja", "en"}, true};
  EXPECT_TRUE(has("速さ"));
  manifest.questionnaire->language = {{"de"}, false};
  EXPECT_TRUE(has("quickness"));
}

TEST(ComparisonSheets, MarkWhatIsHeld) {
  const ManifestReading reading =
      parse_manifest(holding_manifest, "m.yaml", [](const std::string&) { return std::nullopt; });
  ASSERT_TRUE(reading.faults.empty()) << to_string(reading.faults.front());
  Motions motions(reading.manifest);
  const SheetContent content = sheet_content(reading.manifest.sheets[0], reading.manifest, motions);
  // What is held stands right behind what is asked for.
  ASSERT_GE(content.parameters.size(), 3u);
  EXPECT_TRUE(content.parameters[0].is_requested());
  const SheetParameter& largeness = content.parameters[1];
  EXPECT_EQ(largeness.name, "largeness");
  EXPECT_EQ(largeness.created.held, 0.55);
  EXPECT_FALSE(largeness.target.held);
  EXPECT_FALSE(largeness.is_requested());
  EXPECT_NEAR(*largeness.created.reached, 0.55, 0.03);
  EXPECT_FALSE(content.parameters[3].is_held());

  const auto says = [texts = texts_beside_each_other(content)](const char* words) {
    return std::ranges::count(texts, words, &DrawnText::text);
  };
  EXPECT_EQ(says("held 0.55"), 1);
  EXPECT_EQ(says("held 0.50"), 1);
}

}  // namespace
}  // namespace mien::pipeline
