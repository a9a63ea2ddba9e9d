#include "pipeline/study/matching/experiment/matching_study.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "motion/live/live_core.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/matching/matching_evaluation.h"
#include "pipeline/study/questionnaire/service/record_check.h"

namespace mien::pipeline {
namespace {

ManifestReading reading(const std::string& matching) {
  return parse_manifest(
      "mien: 1\nstudy: m\nexamples: {set: builtin:walks-10, ratings: builtin}\noutput: {fps: 30}\n"
      "stimuli:\n"
      "  - {id: t1, role: target, weights: {normal: 0.5, sad: 0.5}}\n"
      "  - {id: t2, role: target, adjectives: {quickness: 0.6, largeness: 0.4}}\n"
      "  - {id: p1, role: target, weights: {proud: 1}}\n"
      "  - {id: round, path: [{walk: 2}]}\n"
      "  - id: pair\n"
      "    people: [{weights: {sad: 1}, place: {x: -1}}, {path: [{walk: 2}]}]\n"
      "matching: " +
          matching + "\n",
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
}

std::string fault_of(const std::string& matching) {
  const ManifestReading read = reading(matching);
  return read.faults.empty() ? std::string() : std::string(Faults(read.faults).what());
}

Manifest manifest_with(const std::string& matching) {
  ManifestReading read = reading(matching);
  EXPECT_TRUE(read.faults.empty()) << Faults(read.faults).what();
  return std::move(read.manifest);
}

TEST(MatchingChecks, RefuseWhatIsNotThere) {
  EXPECT_EQ(fault_of("{participants: 2}"), "");
  EXPECT_NE(fault_of("{participants: 2, targets: [t3]}").find("did you mean"), std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, targets: [t1, t1]}").find("twice"), std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, primary: [quicknes]}").find("quickness"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, features: [step-lenght]}").find("step-length"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, interfaces: [weights], primary: [quickness]}")
                .find("no interface has adjectives"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, practice: [t1, t2, p1]}").find("no target motion"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, target_colour: green}").find("target_colour"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, target_colour: '#102030', created_colour: '#10202f'}")
                .find("apart; give the two figures"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, order: guesses}").find("guesses-first"), std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, limit_s: 0}").find(": matching.limit_s: "),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, targets: [t1, round]}")
                .find("but this motion walks along a path"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, targets: [t1, pair.b]}")
                .find("stimuli[4].people[1].path: sliders make one gait cycle"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2, targets: [pair]}")
                .find("has several people; name one of them as a target, such as pair.a"),
            std::string::npos);
  EXPECT_NE(fault_of("{participants: 2}\nquestionnaire: {participants: 2, scales: emotions}")
                .find("use separate manifests"),
            std::string::npos);
}

TEST(MatchingStudy, OffersWhatTheManifestSays) {
  const Manifest manifest = manifest_with(
      "{participants: 2, practice: [p1], primary: [quickness], pairs_offered: [slow-fast], "
      "features: [step-length]}");
  Motions motions(manifest);
  const MatchingStudy study = matching_study(manifest, motions);
  const auto& sliders = study.experiment.at("matching").at("sliders");
  EXPECT_EQ(sliders.at("adjectives").at("shown"), nlohmann::json({"quickness"}));
  EXPECT_EQ(sliders.at("adjectives").at("offered"), nlohmann::json({"slow-fast"}));
  EXPECT_EQ(sliders.at("features").at("shown"), nlohmann::json({"step-length"}));
  EXPECT_GT(sliders.at("features").at("offered").size(), 3u);
  EXPECT_EQ(sliders.at("weights").at("shown").size(), 10u);
  EXPECT_EQ(study.bundle.targets.size(), 3u);
}

TEST(MatchingStudy, HasOneOfSeveralPeopleAsTarget) {
  const Manifest manifest = manifest_with("{participants: 2, targets: [pair.a, t1]}");
  Motions motions(manifest);
  const MatchingStudy study = matching_study(manifest, motions);
  ASSERT_EQ(study.bundle.targets.size(), 2u);
  // The person walks as the example does, and as a stimulus with that motion.
  const Eigen::Index examples = static_cast<Eigen::Index>(study.bundle.examples.examples.size());
  motion::LiveSetting sad{.kind = motion::InterfaceKind::weights};
  for (Eigen::Index i = 0; i < examples; ++i) {
    sad.sliders.push_back(study.bundle.examples.examples[static_cast<std::size_t>(i)].name);
    sad.values.push_back(sad.sliders.back() == "sad" ? 1.0 : 0.0);
  }
  motion::LiveCore core(study.bundle);
  EXPECT_LT(core.distance("pair.a", sad).mean, 1e-3);
  EXPECT_GT(core.distance("t1", sad).mean, 5e-3);
}

TEST(MatchingStudy, IsAnotherDesignWithOtherSettings) {
  const auto design_of = [](const std::string& matching) {
    const Manifest manifest = manifest_with(matching);
    Motions motions(manifest);
    return matching_study(manifest, motions).experiment.at("design").get<std::string>();
  };
  const std::string design = design_of("{participants: 2}");
  EXPECT_EQ(design, design_of("{participants: 2}"));
  EXPECT_NE(design, design_of("{participants: 3}"));
  EXPECT_NE(design, design_of("{participants: 2, limit_s: 200}"));
  EXPECT_NE(design, design_of("{participants: 2, order: guesses-first}"));
  EXPECT_NE(design, design_of("{participants: 2, show_examples: true}"));
  EXPECT_EQ(design, design_of("{participants: 2, order: trial-by-trial, show_examples: false}"));
}

class SimulatedMatching : public testing::Test {
 protected:
  SimulatedMatching()
      : manifest(manifest_with("{participants: 2, practice: [p1], limit_s: 60}")),
        motions(manifest),
        study(matching_study(manifest, motions)),
        trials(simulated_matching(manifest, motions, study)) {}

  const Manifest manifest;
  Motions motions;
  const MatchingStudy study;
  const std::vector<MatchedTrial> trials;
};

TEST_F(SimulatedMatching, IsEvaluatedAndSaysWhatItIs) {
  std::istringstream lines(matching_trials_csv(trials));
  const MatchingResults results = matching_results({parse_csv(lines.str(), "trials.csv")});
  EXPECT_EQ(results.limit_s, manifest.matching->limit_s);
  EXPECT_EQ(results.threshold_m, manifest.matching->threshold_m);
  EXPECT_TRUE(results.simulated);
  EXPECT_EQ(results.trials.size(), 2u * 3u * 2u);
  EXPECT_EQ(evaluate(results).comparisons.size(), 6u * (1 + 2));  // over all, and of each target
}

TEST_F(SimulatedMatching, KnowsHowFarUntouchedSlidersAre) {
  const std::vector<StartingDistance> distances = starting_distances(manifest, study);
  ASSERT_EQ(distances.size(), 2u * 3u);
  motion::LiveCore core(study.bundle);
  for (const StartingDistance& one : distances) {
    if (one.interface != "weights") continue;
    const Eigen::Index examples = static_cast<Eigen::Index>(study.bundle.examples.examples.size());
    motion::LiveSetting none{.kind = motion::InterfaceKind::weights};
    for (Eigen::Index i = 0; i < examples; ++i) {
      none.sliders.push_back(study.bundle.examples.examples[static_cast<std::size_t>(i)].name);
      none.values.push_back(0.0);
    }
    EXPECT_EQ(one.metres, core.distance(one.target, none).mean);
  }
  // By a threshold that fits, somebody has something to do in at least half of the trials.
  Manifest fitted = manifest;
  fitted.matching->threshold_m = suggested_threshold(distances);
  const auto free = std::ranges::count_if(distances, [&](const StartingDistance& one) {
    return one.metres < fitted.matching->threshold_m;
  });
  EXPECT_LE(2 * free, static_cast<long>(distances.size()));
  fitted.matching->threshold_m = 10.0;
  EXPECT_NE(starting_match_warning(fitted, study).find("6 of 6 pairs"), std::string::npos);
  fitted.matching->threshold_m = 1e-6;
  EXPECT_EQ(starting_match_warning(fitted, study), "");
}

TEST(StartingDistance, GivesAThresholdNoHigherThanThePapers) {
  const auto threshold = [](std::vector<double> metres) {
    std::vector<StartingDistance> distances;
    for (const double one : metres) distances.push_back({"t", "weights", one});
    return suggested_threshold(distances);
  };
  EXPECT_DOUBLE_EQ(threshold({0.3, 0.2, 0.4}), 0.06);
  EXPECT_DOUBLE_EQ(threshold({0.035, 0.02, 0.05}), 0.017);
  EXPECT_DOUBLE_EQ(threshold({0.0001}), 0.001);
  EXPECT_DOUBLE_EQ(threshold({}), 0.06);
}

TEST_F(SimulatedMatching, IsTheSameEachTime) {
  EXPECT_EQ(matching_trials_csv(trials),
            matching_trials_csv(simulated_matching(manifest, motions, study)));
}

/// As the service takes records; and what it refuses.
TEST_F(SimulatedMatching, PassesTheChecksOfTheServiceAndChangedOnesDoNot) {
  LiveMotions live(study.bundle);
  const MatchingFacts facts = matching_facts(study.experiment.at("matching"));
  for (const MatchedTrial& one : trials) {
    EXPECT_NO_THROW(check_matching_record(facts, one.trial, one.match));
    EXPECT_NO_THROW(check_distances(live, one.trial, one.match));
    MatchingRecord better = one.match;
    better.first_guess_d -= 1e-6;
    EXPECT_THROW(check_distances(live, one.trial, better), RecordFault);
    MatchingRecord late = one.match;
    late.success = true;
    late.time_s = facts.limit_s + 1.0;
    EXPECT_THROW(check_matching_record(facts, one.trial, late), RecordFault);
    MatchingRecord foreign = one.match;
    foreign.last.sliders.front() = "nobody";
    EXPECT_THROW(check_matching_record(facts, one.trial, foreign), RecordFault);
    MatchingRecord backwards = one.match;
    backwards.changes.push_back({.seconds = 0.0, .step = "adjust", .action = "limit"});
    EXPECT_THROW(check_matching_record(facts, one.trial, backwards), RecordFault);
  }
}

}  // namespace
}  // namespace mien::pipeline
