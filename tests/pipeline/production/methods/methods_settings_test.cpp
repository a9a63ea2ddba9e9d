#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/schema_paths.h"
#include "pipeline/production/methods/methods.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/stated_settings.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/run/option_variants.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class MethodsSettings : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::write_variant_files(folder()); }

  static const fs::path& folder() {
    static const test::TemporaryFolder files;
    return files.path();
  }

  /// The methods section of a manifest, which must be without faults.
  static std::string methods_for(const std::string& text) {
    const fs::path file = folder() / "m.yaml";
    std::ofstream(file) << text;
    const ManifestReading reading =
        check_manifest(file, [](const std::string&) { return std::nullopt; });
    if (!reading.faults.empty()) ADD_FAILURE() << Faults(reading.faults).what();
    Motions motions(reading.manifest);
    return methods_of(reading.manifest, motions).markdown;
  }
};

TEST_F(MethodsSettings, StateTheFace) {
  const auto look_with = [](const std::string& face) {
    return "look: {figure: {character: face.gltf}, face: " + face + "}\n";
  };
  const std::string head = "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n";
  const std::string stimuli = "stimuli: [{id: a, weights: {normal: 1}}]\n";
  const auto expect_stated = [&](const std::string& face, const std::string& words) {
    const std::string methods = methods_for(head + look_with(face) + stimuli);
    EXPECT_NE(methods.find(words), std::string::npos) << methods;
  };
  expect_stated("{one: 0.5}", "the face's one at a weight of 0.5");
  expect_stated("hidden", "faces hidden behind a plain oval");
  expect_stated("{file: rise.csv, start: 0.5}",
                "faces moved by the weights of the file rise.csv and weights of the face beginning "
                "at 0.5 s of the film");
}

TEST(StudyFacts, NameTheFaceAmongTheOptionsOfAFigure) {
  Look look;
  EXPECT_EQ(figure_options(look), "");
  look.figure = scenes::CharacterOptions{"folder/robot.glb", {}};
  EXPECT_EQ(figure_options(look), R"("robot.glb")");
  look.face.weights = {{"happy", 0.5}};
  EXPECT_EQ(figure_options(look), R"({"character":"robot.glb","face":{"happy":0.5}})");
}

/// Of a film: what it looks like, how it is written, what its motion is blended of and by.
bool is_of_films(const std::string& path) {
  // Orders are told of by what came of them; ratings that come with a set are simulated ones, and
  // nothing is unknown of them.
  if (path.starts_with("examples.expect")) return false;
  if (path == "examples.ratings" || path == "examples.unknown") return false;
  if (path.ends_with(".licence.share")) return false;  // of archives
  for (const char* start :
       {"look", "output", "interpolation", "examples", "stimuli[].look", "stimuli[].output",
        "stimuli[].interpolation", "overlays[].look", "overlays[].output"}) {
    if (path == start || path.starts_with(std::string(start) + ".")) return true;
  }
  return false;
}

/// Of ratings, which are told of where a stimulus rests on them: with one that does.
json with_rated_stimulus(const std::string& path, json document) {
  if (path != "examples" && (!path.starts_with("examples.") || path.starts_with("examples.set")))
    return document;
  const bool has_own_scales = document["examples"].value("scales", "builtin") != "builtin";
  const char* wanted = has_own_scales ? "slow-quick" : "quickness";
  document["stimuli"][0] = {{"id", "a"}, {"adjectives", {{wanted, 0.5}}}};
  return document;
}

// An option that is new in the schema is tried as soon as it is there.
TEST_F(MethodsSettings, TellEveryOptionOfFilmsThatTheSchemaKnows) {
  std::map<std::string, std::string> known;
  const auto told = [&](const json& document) -> const std::string& {
    const std::string text = document.dump();
    const auto [entry, is_new] = known.try_emplace(text);
    if (is_new) entry->second = methods_for(text);
    return entry->second;
  };
  int options = 0;
  for (const auto& [path, node] : test::properties_of(manifest_schema())) {
    if (!is_of_films(path) || test::has_one_value(path)) continue;
    if (path == "overlays[].look.colours") continue;  // they go by roles, whatever it says
    SCOPED_TRACE(path);
    const test::OptionVariants variants = test::variants_of(path, node);
    EXPECT_NE(told(with_rated_stimulus(path, variants.first)),
              told(with_rated_stimulus(path, variants.second)));
    ++options;
  }
  EXPECT_GT(options, 100);
}

TEST_F(MethodsSettings, StateHandsThatAreNotTheMotions) {
  const auto methods_with = [](const std::string& hands) {
    return methods_for("mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nlook: {hands: " +
                       hands + "}\nstimuli: [{id: a, weights: {sad: 1}}]\n");
  };
  EXPECT_NE(methods_with("drawn").find("hands drawn with fingers, relaxed where a motion has none"),
            std::string::npos);
  EXPECT_NE(methods_with("hidden").find("hands drawn without fingers"), std::string::npos);
  EXPECT_EQ(methods_with("auto").find("hands drawn"), std::string::npos);
}

TEST_F(MethodsSettings, StateTheFacesOfPeople) {
  const std::string methods = methods_for(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
      "look: {figure: {character: face.gltf}, face: hidden}\n"
      "stimuli:\n"
      "  - id: pair\n"
      "    people:\n"
      "      - {name: ann, weights: {sad: 1}, place: {x: 0}}\n"
      "      - {name: bo, weights: {sad: 1}, place: {x: 1}, look: {face: {one: 0.5}}}\n"
      "      - {name: cy, weights: {sad: 1}, place: {x: 2}, look: {figure: {mannequin: {sex: 1}}, "
      "face: neutral}}\n"
      "      - {name: di, weights: {sad: 1}, place: {x: 3}, look: {face: neutral}}\n");
  for (const char* stated :
       {"faces hidden behind a plain oval", "the face's one at a weight of 0.5 (pair.bo)",
        "mannequins of sex 1 (0 female, 1 male) (pair.cy)",
        "faces as in the file of the character (pair.di)"})
    EXPECT_NE(methods.find(stated), std::string::npos) << methods;
}

TEST_F(MethodsSettings, StateNoScaledFingersOfMotionsWithoutAny) {
  const std::string methods = methods_for(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
      "stimuli: [{id: a, weights: {sad: 1}, modify: {paths: 1.5, hands: scale}}]\n");
  EXPECT_NE(methods.find("path length 1.5"), std::string::npos) << methods;
  EXPECT_EQ(methods.find("fingers"), std::string::npos) << methods;
}

TEST_F(MethodsSettings, StateTheHandsOfPeople) {
  const std::string methods = methods_for(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nlook: {hands: drawn}\n"
      "stimuli:\n"
      "  - id: pair\n"
      "    people:\n"
      "      - {name: ann, weights: {sad: 1}, place: {x: 0}, look: {hands: hidden}}\n"
      "      - {name: bo, weights: {sad: 1}, place: {x: 1}, look: {hands: auto}}\n"
      "      - {name: cy, weights: {sad: 1}, place: {x: 2}}\n");
  for (const char* stated : {"hands drawn with fingers, relaxed where a motion has none",
                             "hands drawn without fingers (pair.ann)",
                             "hands with the fingers of the motion, if it has any (pair.bo)"})
    EXPECT_NE(methods.find(stated), std::string::npos) << methods;
}

TEST(StudyFacts, NameTheFacesOfPeople) {
  Stimulus pair;
  pair.look.figure = scenes::CharacterOptions{.file = "robot.glb"};
  pair.people.resize(2);
  pair.people[0].name = "ann";
  pair.people[1].name = "bo";
  EXPECT_EQ(figure_options(pair), R"("robot.glb")");
  pair.people[1].face.emplace().weights = {{"happy", 0.5}};
  EXPECT_EQ(figure_options(pair),
            R"({"character":"robot.glb","people":{"bo":{"face":{"happy":0.5}}}})");
  EXPECT_EQ(figure_options(look_of_person(pair, pair.people[0])), R"("robot.glb")");
  pair.people[0].hands = scenes::Hands::hidden;
  EXPECT_EQ(figure_options(look_of_person(pair, pair.people[0])),
            R"({"character":"robot.glb","hands":"hidden"})");
  EXPECT_EQ(figure_options(look_of_person(pair, pair.people[1])),
            R"({"character":"robot.glb","face":{"happy":0.5}})");
}

TEST(StudyFacts, CountHandsAmongTheOptionsOfAFigure) {
  Look look;
  EXPECT_EQ(figure_options(look), "");
  look.hands = scenes::Hands::drawn;
  EXPECT_EQ(figure_options(look), R"({"hands":"drawn"})");
  look.figure = scenes::MannequinOptions{.build = 0.25};
  EXPECT_EQ(figure_options(look), R"({"build":0.25,"hands":"drawn"})");
  look.figure = scenes::CharacterOptions{.file = "robot.glb"};
  look.hands = scenes::Hands::hidden;
  EXPECT_EQ(figure_options(look), R"({"character":"robot.glb","hands":"hidden"})");
}

constexpr char shown[] = R"(mien: 1
study: s
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 54], fps: 8, cycles: 1, in_place: true,
         presentation: {fixation: 0.5, blank_before: 0.2, blank_after: 0.4, fade_in: 0.3}}
stimuli:
  - {id: a, weights: {sad: 1}, look: {figure: {point-light: {size: 5, noise: 20, colour: "#ff0000"}}}}
  - {id: b, weights: {sad: 1}, look: {figure: {point-light: {size: 5, scrambled: true}}}}
  - {id: c, weights: {sad: 1}, modify: [{emotion: tired}, {tempo: 0.8, posture: {head-flexion: 15}}]}
)";

TEST_F(MethodsSettings, AreInPlainWordsWithThoseWhoHaveThem) {
  const std::string text = methods_for(shown);
  for (const char* words :
       {"walking in place", "a fixation cross for 0.5 s", "a blank of 0.2 s before the film",
        "a blank of 0.4 s after the film", "a fade-in of 0.3 s", "13 dots of 5 pixels",
        "20 noise dots", "dots of the colour #ff0000", "dots scrambled in space (b)", "(a and b)",
        "Manual changes: head-flexion 15° and tempo × 0.8.",
        "Changes at a strength of 1 were, for tired: "})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

TEST_F(MethodsSettings, AreNotToldWhereNothingIsSaid) {
  const std::string text = methods_for(
      "{mien: 1, study: s, seed: 7, examples: {set: builtin:walks-10}, stimuli: [{id: a, weights: "
      "{sad: 1}}]}");
  EXPECT_EQ(text.find("Settings that differ"), std::string::npos) << text;
  EXPECT_EQ(text.find("dots"), std::string::npos) << text;
}

// What participants saw when must be known of a paper that reports it.
TEST_F(MethodsSettings, TellTheOrderOfGuessesAndWhatPlayedBeside) {
  const auto told = [](const std::string& more) {
    return methods_for(
        "{mien: 1, study: s, seed: 7, examples: {set: builtin:walks-10}, stimuli: [{id: a, role: "
        "target, weights: {sad: 1}}], matching: {participants: 2, interfaces: [weights]" +
        more + "}}");
  };
  const std::string usual = told("");
  EXPECT_EQ(usual.find("matching"), std::string::npos) << usual;
  EXPECT_EQ(told(", order: trial-by-trial, show_examples: false"), usual);
  EXPECT_NE(told(", order: guesses-first").find("without feedback"), std::string::npos);
  EXPECT_NE(told(", show_examples: true").find("The examples were played beside the matching task"),
            std::string::npos);
}

TEST_F(MethodsSettings, StateTheQualityRulesOfAQuestionnaire) {
  const auto told = [](const std::string& more) {
    return methods_for(
        "{mien: 1, study: s, seed: 7, examples: {set: builtin:walks-10}, output: {video: [mp4]}, "
        "stimuli: [{id: a, weights: {sad: 1}}, {id: b, weights: {happy: 1}}], questionnaire: "
        "{participants: 2, scales: [sad-happy]" +
        more + "}}");
  };
  std::string usual = told("");
  EXPECT_EQ(told(", analysis: {quality: {flagged: kept}}"), usual);
  usual.pop_back();  // further sentences follow in the paragraph
  EXPECT_EQ(told(", analysis: {quality: {min_rt_ms: 250}}"),
            usual +
                " By rules stated before data collection, answers with a response time below "
                "250 ms were flagged; flagged answers, and all answers of flagged "
                "participants, were left out of the analysis.\n");
  const std::string unfinished = " The answers of participants who did not finish were included.";
  ASSERT_TRUE(usual.ends_with(unfinished));
  EXPECT_EQ(
      told(", analysis: {random_slopes: true}"),
      usual.substr(0, usual.size() - unfinished.size()) +
          " Ratings on each scale were planned to be analysed by a repeated-measures "
          "analysis of variance with all factors of the stimuli within participants, with p "
          "values corrected by Greenhouse and Geisser's method, and by mixed models with random "
          "intercepts of participants and stimuli and random slopes of the factors for "
          "participants." +
          unfinished + "\n");
}

TEST(StatedSettings, LeaveOutNoOptionThatHasNoWords) {
  StatedSettings settings;
  settings.add("look.camera", {{"lens", {{"new_one", 3}}}}, "a");
  settings.add("output.fade_in", true, "b");
  EXPECT_EQ(settings.text({"a", "b"}), "camera lens new one: 3 (a); fade in: yes (b)");
  EXPECT_EQ(settings.text({"a"}), "camera lens new one: 3; fade in: yes (b)");
}

TEST(StatedSettings, ShowForeignTextOnOneLine) {
  EXPECT_EQ(words_of_option("output.presentation.card.text", "one\n\ntwo\x1b"),
            "a card with the text one\\n\\ntwo\\x1b");
}

/// The raters are those of the answers, and not those that a manifest would simulate.
TEST_F(MethodsSettings, CountTheRatersOfTheAnswers) {
  const auto told = [&](const std::string& columns, const std::string& fields, int raters,
                        const std::string& more = "", const std::string& others = "") {
    std::string csv = "participant,stimulus,scale,value" + columns + "\n" + others;
    for (int rater = 0; rater < raters; ++rater) {
      for (const char* example : {"normal", "brisk", "slow", "happy", "sad", "angry", "proud",
                                  "afraid", "tired", "relaxed"})
        csv += "p" + std::to_string(rater) + "," + example + ",slow-quick,1" + fields + "\n";
    }
    write_file(folder() / "answers.csv", csv);
    return methods_for(
        "{mien: 1, study: s, seed: 7, examples: {set: builtin:walks-10, scales: my.scales.yaml, "
        "ratings: answers.csv" +
        more + "}, stimuli: [{id: a, adjectives: {slow-quick: 0.5}}]}");
  };
  const std::string simulated = told(",simulated", ",1", 40);
  EXPECT_NE(simulated.find("No participants rated the examples; 40 simulated raters answered"),
            std::string::npos)
      << simulated;
  EXPECT_NE(simulated.find("(answers.csv)"), std::string::npos);
  const std::string all_known = told("", "", 9);
  EXPECT_NE(all_known.find("Nine participants rated the examples"), std::string::npos);
  EXPECT_EQ(all_known.find("excluded"), std::string::npos) << all_known;
  const std::string some_unknown = told("", "", 9, ", unknown: ignore", "p1,nobody,slow-quick,1\n");
  EXPECT_NE(some_unknown.find("Answers about other motions and on other scales were excluded"),
            std::string::npos)
      << some_unknown;
}

}  // namespace
}  // namespace mien::pipeline
