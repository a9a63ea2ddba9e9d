// Levels that C++ chooses, with which those of the page must agree
// (pipeline/study/page/tests/questionnaire/tracks.mjs reads the same file).

#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/study/thresholds/dose_study.h"
#include "pipeline/study/thresholds/simulated_observer.h"
#include "pipeline/study/thresholds/track_json.h"

namespace mien::pipeline {
namespace {

using nlohmann::ordered_json;

constexpr char cases_path[] = MIEN_SOURCE_DIR "/tests/pipeline/study/thresholds/track_cases.json";

/// A track that an observer answers; or, without a threshold, at random.
ordered_json case_of(const Manifest& manifest, const TrackProcedure& procedure,
                     const TrackLevels& levels, std::optional<double> threshold, unsigned seed) {
  constexpr std::size_t trials = 40;
  PsychometricFunction observer;
  if (threshold)
    observer = simulated_observer(manifest, procedure,
                                  {.threshold = threshold, .threshold_deviation = 0.0}, 1);
  std::mt19937 random(seed);
  std::vector<TrackAnswer> answers;
  std::string given;
  ordered_json places = ordered_json::array();
  while (const auto place = levels.next(answers)) {
    places.push_back(*place);
    if (answers.size() == trials) break;
    const double drawn = static_cast<double>(random()) / 4294967296.0;
    const double positive =
        threshold ? answer_probability(observer, procedure.ease[*place]).positive : 0.5;
    answers.push_back({*place, drawn < positive});
    given += answers.back().is_positive ? '1' : '0';
  }
  return {{"answers", given}, {"places", places}};
}

std::string cases_text() {
  ordered_json all = ordered_json::array();
  for (const char* form : {"two_interval", "yes_no"})
    for (const char* more :
         {"factor: dose", "factor: dots, easier: falling",
          "factor: dose, method: staircase, trials: 40, down: 3",
          "factor: dose, method: staircase, trials: 40, up: 2, down: 2, step: {up: 3, down: 1}, "
          "start: middle, reversals: 9",
          "factor: dots, easier: falling, method: staircase, trials: 35, start: hardest, step: "
          "2",
          "factor: dose, until: {sd: 0.4, at_most: 35}",
          "factor: dots, easier: falling, until: {sd: 8, at_most: 30}, proportion: 0.6"}) {
      const Manifest manifest = mien::test::dose_study(mien::test::adaptive_members(form, more));
      const TrackProcedure procedure = track_procedure(manifest);
      const TrackLevels levels(procedure);
      const double range = procedure.ease.back() - procedure.ease.front();
      ordered_json cases = ordered_json::array();
      for (unsigned seed = 0; seed < 8; ++seed) {
        std::optional<double> threshold;
        if (seed > 1) threshold = std::abs(procedure.ease.front() + range * (seed - 1) / 8.0);
        cases.push_back(case_of(manifest, procedure, levels, threshold, seed));
      }
      all.push_back({{"procedure", procedure_json(procedure)}, {"cases", cases}});
    }
  std::string text = "[";
  for (const ordered_json& one : all) text += (text.size() > 1 ? ",\n" : "\n") + one.dump();
  return text + "\n]\n";
}

TEST(TrackCases, AreThoseOfTheFile) {
  const std::string text = cases_text();
  if (text != read_file(cases_path)) {
    const std::string written = testing::TempDir() + "track_cases.json";
    std::ofstream(written) << text;
    FAIL() << "the file must be as " << written;
  }
}

}  // namespace
}  // namespace mien::pipeline
