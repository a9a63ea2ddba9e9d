#include "pipeline/production/methods/methods.h"

#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/references.h"

namespace mien::pipeline {
namespace {

Methods methods_for(const std::string& rest) {
  const ManifestReading reading =
      parse_manifest("mien: 1\nstudy: s\nseed: 7\nexamples: {set: builtin:walks-10}\n" + rest,
                     "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  Motions motions(reading.manifest);
  return methods_of(reading.manifest, motions);
}

std::set<std::string> found(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::set<std::string> all;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    all.insert((*at)[1]);
  return all;
}

void expect_in(const Methods& methods, const std::string& sentence) {
  EXPECT_NE(methods.markdown.find(sentence), std::string::npos) << sentence << "\n"
                                                                << methods.markdown;
}

constexpr char rated[] =
    "output: {fps: 25, quality: final, video: [mp4, webm]}\n"
    "stimuli:\n"
    "  - {id: a, adjectives: {quickness: 0.6}, factors: {speed: fast}}\n"
    "  - {id: b, weights: {sad: 1}, modify: {emotion: tired, strength: 0.5}, factors: {speed: "
    "slow}}\n"
    "sheets: [{compare: {target: a, created: b}}]\n";

TEST(Methods, TellTheNumbersOfTheStudy) {
  const Methods methods = methods_for(rated);
  expect_in(methods, "The 2 stimuli were made with mien ");
  expect_in(methods, "(random seed 7)");
  expect_in(methods, "The factor was speed (fast, slow).");
  expect_in(methods,
            "The examples were 10 synthetic motions (mien's built-in example set walks-10)");
  expect_in(methods, "Each example was a single gait cycle; they lasted from ");
  expect_in(methods,
            "No participants rated the examples; 14 simulated raters answered on 41 scales");
  expect_in(
      methods,
      "The recipe used (mien's own, fitted to acted motions) was tired, at a strength of 0.50.");
  expect_in(methods, "at 960 × 540 pixels with 128 samples per pixel and 25 frames per second");
  expect_in(methods, "encoded as H.264 in MP4 and VP9 in WebM");
  expect_in(methods, "For 1 compared pair, D was 0.");
}

TEST(Methods, TellBlendsFromSingleExamples) {
  const Methods methods = methods_for(
      "stimuli:\n"
      "  - {id: a, weights: {sad: 1, happy: 0}}\n"
      "  - {id: b, weights: {sad: 1, happy: 2}}\n"
      "  - {id: c, weights: {happy: 2}}\n");
  expect_in(methods, "One stimulus was blended from examples with given weights.");
  expect_in(methods, "Two stimuli were single examples.");
  expect_in(methods, "Corresponding moments of the examples were aligned");
}

TEST(Methods, TellHoldsFoilsAndAmongWhichFilmsAreAlike) {
  const Methods methods = methods_for(
      "equalize: {luminance: {by: figure}, place: true}\n"
      "output: {video: []}\n"
      "stimuli:\n"
      "  - {id: a, adjectives: {quickness: 0.6}, hold: others}\n"
      "  - {id: r, role: reference, weights: {normal: 1}, modify: {tempo: 0.9, paths: 1.2}}\n"
      "  - {id: f, foil: {of: r, differ: speed}}\n"
      "sheets: [{gallery: [a, r]}]\n");
  expect_in(methods, "to the geometric mean, by exposure), separately for each kind of figure");
  expect_in(methods,
            "In 1 stimulus, parameters that were not requested were held at their values in the "
            "stimulus r");
  expect_in(
      methods,
      "One stimulus is a foil: modified like another stimulus except for its change of speed");
  expect_in(methods, "Manual changes: ");
  EXPECT_EQ(methods.markdown.find("matching task"), std::string::npos);
}

TEST(Methods, NameTheFiguresOfPeople) {
  expect_in(
      methods_for("stimuli:\n"
                  "  - id: a\n"
                  "    people: [{weights: {sad: 1}, place: {x: 0}, look: {figure: mannequin}}, "
                  "{weights: {happy: 1}, place: {x: 1}}]\n"),
      "Motions were rendered with several figure types (mannequin and stick;");
}

TEST(Methods, TellFrozenPartsAndEndsWithoutModifications) {
  const Methods methods = methods_for(
      "stimuli:\n"
      "  - {id: a, weights: {sad: 1}, modify: {freeze: [legs, left-arm], ends: loop}}\n"
      "  - {id: b, weights: {sad: 1}, modify: {freeze: {parts: head, at: 0.2}}}\n"
      "  - {id: c, path: [{walk: 2}], modify: {ends: {before: 0.5, after: 1}}}\n"
      "  - {id: d, path: [{walk: 3}], modify: {ends: {before: 0.5, after: 1}}}\n");
  expect_in(methods,
            "In 1 stimulus (a), the legs and left arm did not move, in the pose of a typical "
            "moment.");
  expect_in(methods, "In 1 stimulus (b), the head did not move, in the pose of one moment.");
  expect_in(methods, "In 1 stimulus (a), the motion was shown as a loop; if it did not");
  expect_in(methods,
            "In 2 stimuli (c and d), the first pose was held for 0.5 s and the last pose was held "
            "for 1 s.");
  EXPECT_EQ(methods.markdown.find("modified"), std::string::npos) << methods.markdown;
  EXPECT_EQ(methods.bibtex.find("emotionthesis2010"), std::string::npos);
}

TEST(Methods, NameSeveralRecipesAsSeveral) {
  expect_in(methods_for("stimuli:\n"
                        "  - {id: a, weights: {sad: 1}, modify: {emotion: tired}}\n"
                        "  - {id: b, weights: {sad: 1}, modify: {emotion: happy}}\n"),
            "The recipes used (mien's own, fitted to acted motions) were tired and happy,");
}

TEST(Methods, LeaveOutWhatTheStudyDoesNotDo) {
  const Methods methods = methods_for("stimuli: [{id: a, features: {step-length: 0.4}}]\n");
  for (const char* word : {"rated", "modified", "recipe", "distance D", "shows recorded"})
    EXPECT_EQ(methods.markdown.find(word), std::string::npos) << word;
  EXPECT_EQ(methods.bibtex.find("emotionthesis2010"), std::string::npos);
}

TEST(Methods, CiteNothingThatIsNotInTheReferencesAndTheOtherWayRound) {
  for (const char* method : {"cardinal", "knn", "inverse-distance", "kriging", "pca", "grid"}) {
    const Methods methods =
        methods_for("interpolation: {method: " + std::string(method) + "}\n" + rated);
    const std::set<std::string> cited = found(methods.markdown, "@(\\w+)");
    const std::set<std::string> listed = found(methods.bibtex, "@\\w+\\{(\\w+),");
    EXPECT_GE(cited.size(), 6u);
    EXPECT_EQ(cited, listed) << method;
  }
}

TEST(Methods, HaveSourcesThatAreKnown) {
  for (const auto& [word, method] : motion::interpolation_methods) {
    for (const std::string& key : words_of(method).sources)
      EXPECT_NE(find_reference(key), nullptr) << key;
  }
  for (const auto& [word, method] : style_methods)
    EXPECT_NE(find_reference(source_of(method)), nullptr) << word;
}

TEST(References, NameAuthorTitleAndYearOrSayWhatToFillIn) {
  for (const Reference& reference : all_references()) {
    const std::string fields(reference.bibtex);
    const auto has = [&](const char* part) { return fields.find(part) != std::string::npos; };
    const bool is_whole = has("  author = {") && has("  title = {") && has("  year = {");
    EXPECT_NE(is_whole, !reference.missing.empty()) << reference.key;
    EXPECT_EQ(fields.empty(), !is_whole) << reference.key;
    EXPECT_TRUE(is_whole || reference.missing.find("missing") != std::string::npos)
        << reference.key;
    EXPECT_EQ(std::count(fields.begin(), fields.end(), '{'),
              std::count(fields.begin(), fields.end(), '}'))
        << reference.key;
  }
}

TEST(Methods, StandInTheReportWithAuthorsAndYears) {
  const Methods methods = methods_for(rated);
  const std::string html = methods_html(methods.markdown);
  EXPECT_TRUE(html.starts_with("<blockquote><p>To be completed by the author")) << html;
  EXPECT_NE(html.find("</blockquote>\n<p>The 2 stimuli"), std::string::npos) << html;
  EXPECT_NE(html.find("(Rose, Cohen and Bodenheimer 1998; Sloan, Rose and Cohen 2001; Huang"),
            std::string::npos)
      << html;
  EXPECT_EQ(html.find('@'), std::string::npos) << html;
}

}  // namespace
}  // namespace mien::pipeline
