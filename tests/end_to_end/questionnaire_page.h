#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/browser.h"
#include "end_to_end/program.h"
#include "shared_set_up.h"

namespace mien::test {

/// A questionnaire of three participants, as a manifest.
inline constexpr char study_text[] = R"(mien: 1
study: gaits
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 72], fps: 15, cycles: 1, quality: draft, video: [mp4], frames: none}
stimuli:
  - {id: usual, weights: {normal: 1}}
  - {id: sad, weights: {normal: 0.4, sad: 0.6}}
  - {id: proud, weights: {normal: 0.4, proud: 0.6}}
questionnaire:
  title: How does this person walk?
  participants: 3
  consent: Taking part is voluntary.
  instructions: Watch each video, then say how the movement looks to you.
  ending: Thank you.
  stimuli: [sad, proud]
  scales: emotions
  practice: [usual]
  warm_up: 1
  attention: {every: 2}
  comments: true
  reference: usual
  demographics:
    - {id: age, ask: "How old are you?", answer: number, required: true}
    - {id: hand, ask: "Which hand do you write with?", answer: [left, right]}
)";

/// A questionnaire of two participants whose two trials are rated while the film plays.
inline constexpr char continuous_study_text[] = R"(mien: 1
study: courses
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 72], fps: 15, cycles: 3, in_place: true, quality: draft, video: [mp4], frames: none}
stimuli:
  - {id: sad, weights: {normal: 0.4, sad: 0.6}}
questionnaire:
  participants: 2
  stimuli: [sad]
  scales: [sad-happy, weak-strong]
  trials: continuous
  continuous: {lead: 0.5, speed: 40}
  demographics:
    - {id: age, ask: "How old are you?", answer: number, required: true}
)";

/// The folder of the scripts that drive a browser, beside the program, where ./mien test brings it.
std::filesystem::path page_tests();

/// Fields of CSV rows by their columns; quotes may hold line ends.
std::vector<std::map<std::string, std::string>> rows_in(const std::string& csv);

/// The rows of a trial in the table of answers of a participant.
std::vector<std::map<std::string, std::string>> rows_of_trial(const nlohmann::json& taken,
                                                              int trial);

/// A WAV of 16 bits with a tone.
std::string wav_of_tone(double seconds);

/// Exports the questionnaire into folder/questionnaire.
void export_study(const std::filesystem::path& folder);

/// A questionnaire that was exported once, and people who take it in Chromium.
class QuestionnairePage : public testing::Test {
 protected:
  static std::string skip_reason() {
    if (chromium().empty()) return "no Chromium here: install it to test pages";
    if (run_program({"node", "--version"}).code != 0) return "no Node.js here";
    if (!std::filesystem::exists(page_tests().parent_path().parent_path() /
                                 "node_modules/playwright-core"))
      return "no playwright-core in build/release/pages/work: ./mien test brings it";
    return "";
  }

  static void SetUpTestSuite() {
    if (!skip_reason().empty()) return;
    scratch = std::make_unique<Scratch>();
    std::filesystem::copy(shared_set_up("questionnaire_page", export_study), scratch->path(),
                          std::filesystem::copy_options::recursive);
  }
  static void TearDownTestSuite() { scratch.reset(); }

  void SetUp() override {
    if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  }

  static std::filesystem::path folder() { return scratch->path() / "questionnaire"; }

  /// What a scenario of page/tests/questionnaire/scenarios.mjs tells.
  static nlohmann::json played(const std::string& scenario) { return played(scenario, folder()); }

  static nlohmann::json played(const std::string& scenario, const std::filesystem::path& given) {
    return output_of({(page_tests() / "scenarios.mjs").string(), scenario, given.string()});
  }

  /// The JSON that a script with these arguments prints.
  static nlohmann::json output_of(const std::vector<std::string>& script) {
    std::vector<std::string> command = {"env", "MIEN_CHROMIUM=" + chromium_path(), "node"};
    command.insert(command.end(), script.begin(), script.end());
    const Ended ended = run_program(command, 400.0);
    EXPECT_EQ(ended.code, 0) << ended.errors;
    return nlohmann::json::parse(ended.output, nullptr, false);
  }

  static std::string chromium_path() {
    const std::string said = run_program({"sh", "-c", "command -v " + chromium()}).output;
    return said.substr(0, said.find('\n'));
  }

  /// All trials in their order, each scale of theirs answered as the participants of
  /// page/tests/questionnaire/participant.mjs answer.
  static void expect_complete(const nlohmann::json& played, const std::string& participant) {
    const nlohmann::json experiment = nlohmann::json::parse(text_of(folder() / "experiment.json"));
    nlohmann::json session;
    for (const nlohmann::json& one : experiment.at("sessions"))
      if (one.at("participant") == participant) session = one;
    const auto rows = rows_in(played.at("answers").get<std::string>());
    std::size_t at = 0;
    for (const nlohmann::json& trial : session.at("trials")) {
      const int number = trial.at("number");
      const bool is_check = trial.at("kind") == "attention";
      for (std::size_t i = 0; i < trial.at("items").size(); ++i, ++at) {
        ASSERT_LT(at, rows.size());
        const auto& row = rows[at];
        EXPECT_EQ(row.at("participant"), participant);
        EXPECT_EQ(row.at("trial"), std::to_string(number));
        EXPECT_EQ(row.at("item"), trial.at("items")[i].at("item").get<std::string>());
        EXPECT_EQ(row.at("is_practice"), trial.at("practice").get<bool>() ? "1" : "0");
        EXPECT_EQ(row.at("is_warmup"), trial.at("warm_up").get<bool>() ? "1" : "0");
        if (is_check) {
          EXPECT_EQ(row.at("passed"), "1");
          continue;
        }
        const int raw = static_cast<int>((i + static_cast<std::size_t>(number)) % 5) + 1;
        const bool is_flipped = trial.at("items")[i].at("flipped");
        EXPECT_EQ(row.at("value_raw"), std::to_string(raw));
        EXPECT_EQ(row.at("value"), std::to_string(is_flipped ? 3 - raw : raw - 3));
        EXPECT_EQ(row.at("pole_left"), is_flipped ? "high" : "low");
        EXPECT_EQ(row.at("stimulus"), experiment.at("stimuli")
                                          .at(trial.at("media")[0].get<std::string>())
                                          .get<std::string>());
        EXPECT_EQ(row.at("against"), "usual");
        EXPECT_EQ(row.at("stimulus_sha256").size(), 64U);
        EXPECT_LT(std::stod(row.at("play_start_ms")), std::stod(row.at("ended_ms")));
        EXPECT_LE(std::stod(row.at("ended_ms")), std::stod(row.at("trial_ms")));
        EXPECT_EQ(row.at("viewport_width"), "1366");
        EXPECT_EQ(row.at("seed"), session.at("seed").get<std::string>());
      }
    }
    EXPECT_EQ(at, rows.size());
    const auto people = rows_in(played.at("participant").get<std::string>());
    ASSERT_EQ(people.size(), 1U);
    EXPECT_EQ(people[0].at("finished"), "1");
    EXPECT_FALSE(people[0].at("age").empty());
  }

  inline static std::unique_ptr<Scratch> scratch;
};

}  // namespace mien::test
