#include "pipeline/regression/mutations.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using test::ChangedStudy;
using test::Mutation;

/// What was found, in words for a test's message.
std::string told(const StimulusComparison& comparison) {
  std::string text(name_of(comparison.verdict));
  for (const Attribution& cause : comparison.causes) {
    text += "\n  " + std::string(name_of(cause.cause)) + " " +
            (cause.share ? std::to_string(*cause.share) : "-") + ": " + cause.root.substr(0, 300);
  }
  for (const std::string& reason : comparison.reasons) text += "\n  because " + reason;
  return text;
}

bool is_attributed(const StimulusComparison& comparison, const Mutation& mutation) {
  if (comparison.causes.empty()) return false;
  const Attribution& first = comparison.causes.front();
  return first.cause == mutation.cause && first.root.find(mutation.root) != std::string::npos;
}

ChangedStudy mutated(const Mutation& mutation, const test::TemporaryFolder& scratch) {
  ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  mutation.change(study);
  return study;
}

/// Tries one of so many.
void expect_attributed(std::size_t step) {
  const std::vector<Mutation> mutations = test::all_mutations();
  EXPECT_GE(mutations.size(), 40u);
  int tried = 0, right = 0;
  for (std::size_t i = 0; i < mutations.size(); i += step, ++tried) {
    const Mutation& mutation = mutations[i];
    SCOPED_TRACE(mutation.name);
    const test::TemporaryFolder scratch;
    const Regression regression = test::regressed(mutated(mutation, scratch));
    const StimulusComparison& comparison = test::comparison_of(regression, mutation.stimulus);
    const bool is_right = is_attributed(comparison, mutation);
    EXPECT_TRUE(is_right) << mutation.name << ": " << told(comparison);
    if (mutation.verdict) {
      EXPECT_EQ(comparison.verdict, *mutation.verdict) << mutation.name << ": " << told(comparison);
    }
    EXPECT_TRUE(regression.gate.holds()) << regression.gate.motion_defect;
    right += int{is_right};
  }
  std::cout << right << " of " << tried << " mutations attributed to their causes\n";
}

TEST(Mutations, OfEachKindAreAttributedToTheirCauses) { expect_attributed(6); }

TEST(Mutations, AreAttributedToTheirCauses) { expect_attributed(1); }

/// The sum of all shares; interaction is a part of them.
double sum_of_shares(const StimulusComparison& comparison) {
  double sum = 0.0;
  for (const Attribution& cause : comparison.causes) sum += cause.share.value_or(0.0);
  return sum;
}

/// Two changes of a stimulus.
struct Pair {
  const char* stimulus;
  const char* first;
  const char* second;
  std::set<Cause> causes;
};

const std::vector<Pair>& pairs() {
  static const std::vector<Pair> known = {
      {"blend",
       R"({"weights": {"normal": 0.1, "proud": 0.9}})",
       R"({"look": {"camera": {"view": "three-quarter", "fov": 35}}})",
       {Cause::motion, Cause::scene}},
      {"styled",
       R"({"modify": {"emotion": "angry", "strength": 0.5}})",
       R"({"output": {"quality": "standard"}})",
       {Cause::motion, Cause::drawing}},
      {"tinted",
       R"({"look": {"camera": "side"}})",
       R"({"output": {"shutter": 180}})",
       {Cause::scene, Cause::drawing}},
      {"wish",
       R"({"adjectives": {"quickness": 0.9}, "look": {"scene": "corridor"}})",
       R"({"output": {"quality": "standard"}})",
       {Cause::motion, Cause::scene, Cause::drawing}},
  };
  return known;
}

void expect_shares(const Pair& pair) {
  SCOPED_TRACE(pair.first);
  const test::TemporaryFolder scratch;
  ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  for (const char* patch : {pair.first, pair.second})
    study.stimulus(pair.stimulus).merge_patch(nlohmann::json::parse(patch));
  const Regression regression = test::regressed(study);
  const StimulusComparison& comparison = test::comparison_of(regression, pair.stimulus);
  std::set<Cause> causes;
  for (const Attribution& cause : comparison.causes) causes.insert(cause.cause);
  EXPECT_EQ(causes, pair.causes) << told(comparison);
  EXPECT_NEAR(sum_of_shares(comparison), 1.0, 1e-9) << told(comparison);
  EXPECT_LE(std::abs(comparison.interaction), 1.0);
  EXPECT_EQ(comparison.verdict, Verdict::differs);
}

TEST(Mutations, OfTwoThingsHaveTwoCausesThatShareAll) { expect_shares(pairs().front()); }

TEST(Mutations, OfAnyTwoThingsHaveCausesThatShareAll) {
  for (const Pair& pair : pairs()) expect_shares(pair);
}

/// Ways of doing the same once more.
ChangedStudy unchanged(int k, const test::TemporaryFolder& scratch) {
  const char* const folders[] = {"study", "another folder", "Ä ö"};
  ChangedStudy study = test::approved_study().copied(scratch.path() / folders[k % 3]);
  study.threads = 1 + k % 4;
  study.audits = k % 5 == 4 ? 0.0 : 1.0;
  if (k % 2 == 1) {
    // Said, and not as the default; maps have no order anyway.
    study.manifest["output"]["scale"] = 1.0;
    study.stimulus("blend")["output"]["cycles"] = 1;
    study.stimulus("tinted")["look"]["camera"] = "three-quarter";
  }
  if (k % 7 == 3) std::ranges::reverse(study.manifest["stimuli"]);
  if (k % 4 == 2) {
    for (auto& facts : study.baseline.stimuli) facts.origin.libraries["Pango"] = "0.0.1";
  }
  if (k % 6 == 5) {
    std::filesystem::rename(study.folder / "my.set.yaml", study.folder / "other.set.yaml");
    study.stimulus("tinted")["look"]["scene"] = "other.set.yaml";
  }
  if (k % 8 == 6) study.manifest["stimuli"][0]["factors"] = {{"speed", "slow"}};
  return study;
}

TEST(Unchanged, StudiesAreTheSameHoweverTheyAreMadeAgain) {
  const char* asked = std::getenv("MIEN_UNCHANGED_RERUNS");
  const int reruns = asked != nullptr ? std::atoi(asked) : 10;
  int alarms = 0;
  for (int k = 0; k < reruns; ++k) {
    const test::TemporaryFolder scratch;
    const Regression regression = test::regressed(unchanged(k, scratch));
    EXPECT_TRUE(regression.passes());
    for (const StimulusComparison& comparison : regression.stimuli) {
      EXPECT_EQ(comparison.verdict, Verdict::same) << k << " " << comparison.id << told(comparison);
      EXPECT_TRUE(comparison.causes.empty()) << k << " " << comparison.id << told(comparison);
    }
    alarms += int{!regression.passes()};
  }
  std::cout << alarms << " false alarms in " << reruns << " reruns\n";
}

TEST(Unchanged, ReseededStudiesAreAlike) {
  const char* asked = std::getenv("MIEN_UNCHANGED_RERUNS");
  const int reruns = asked != nullptr ? std::atoi(asked) / 2 : 3;
  for (int k = 0; k < reruns; ++k) {
    const test::TemporaryFolder scratch;
    ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
    study.manifest["seed"] = 1000 + k;
    const Regression regression = test::regressed(study);
    for (const StimulusComparison& comparison : regression.stimuli) {
      if (comparison.id == "wish") continue;  // its ratings are simulated with the seed
      EXPECT_EQ(comparison.verdict, Verdict::alike)
          << k << " " << comparison.id << told(comparison);
    }
  }
}

// A capture or a character that is gone does not hide what has changed.
TEST(Regress, GoesByTheManifestWhereWhatWasApprovedCannotBeMadeAgain) {
  const test::TemporaryFolder scratch;
  ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  study.stimulus("blend")["weights"]["normal"] = 0.9;
  std::filesystem::remove_all(study.baseline.folder / "editions");
  const Regression regression = test::regressed(study);
  const StimulusComparison& blend = test::comparison_of(regression, "blend");
  EXPECT_EQ(blend.verdict, Verdict::differs);
  ASSERT_EQ(blend.causes.size(), 1U) << told(blend);
  EXPECT_EQ(blend.causes[0].cause, Cause::motion);
  EXPECT_NE(blend.causes[0].root.find("weights.normal"), std::string::npos) << told(blend);
  EXPECT_NE(blend.causes[0].evidence.find("as-run.yaml"), std::string::npos);
  EXPECT_FALSE(blend.causes[0].share);
  EXPECT_EQ(test::comparison_of(regression, "tinted").verdict, Verdict::same);
}

}  // namespace
}  // namespace mien::pipeline
