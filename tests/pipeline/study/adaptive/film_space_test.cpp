#include "pipeline/study/adaptive/film_space.h"

#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/study/adaptive/film_tables.h"

namespace mien::pipeline {
namespace {

Manifest walks(const std::string& more = "") {
  const ManifestReading reading = check_manifest_text(
      "mien: 1\nstudy: walks\nseed: 3\nexamples: {set: builtin:walks-10, ratings: builtin}\n"
      "stimuli:\n"
      "  - {id: sad, weights: {sad: 1}}\n"
      "  - {id: mixed, weights: {sad: 1, happy: 3}}\n"
      "  - {id: quick, features: {step-length: 0.8}}\n"
      "  - {id: warped, weights: {sad: 1}, modify: {tempo: 0.9}}\n"
      "  - {id: strolls, path: [{walk: 3}]}\n"
      "questionnaire: {participants: 4, scales: [sad-happy, slow-fast]}\n" +
          more,
      "walks.yaml", {});
  EXPECT_TRUE(reading.faults.empty());
  return reading.manifest;
}

Answers answers(std::vector<Answer> list) { return {.answers = std::move(list)}; }

class FilmSpaceTest : public testing::Test {
 protected:
  const Manifest manifest = walks();
  const Repertoire repertoire = load_repertoire(manifest);
  const FilmSpace space = film_space(repertoire);
};

TEST_F(FilmSpaceTest, HasTheExamplesAtTheirFeatures) {
  EXPECT_EQ(space.parameters.size(), motion::feature_group_count);
  ASSERT_EQ(space.examples.size(), 10u);
  EXPECT_EQ(space.places.rows(), 10);
  EXPECT_GE(space.places.minCoeff(), -1e-9);
  EXPECT_LE(space.places.maxCoeff(), 1.0 + 1e-9);
  const FilmSpace one = film_space(repertoire, {space.parameters[1]});
  EXPECT_EQ(one.places, space.places.col(1));
  EXPECT_THROW(film_space(repertoire, {"niceness"}), Error);
}

TEST_F(FilmSpaceTest, AveragesAnswersOfAllRoundsAboutBlends) {
  const RatedStudy study = rated_study(manifest, repertoire, space,
                                       {answers({{"p1", "sad", "sad-happy", -2},
                                                 {"p2", "sad", "sad-happy", 0},
                                                 {"p1", "mixed", "sad-happy", 1},
                                                 {"p1", "warped", "sad-happy", 2},
                                                 {"p1", "sad", "dull-quick", 2}}),
                                        answers({{"p3", "sad", "sad-happy", -1},
                                                 {"p3", "quick", "sad-happy", 2},
                                                 {"p3", "strolls", "sad-happy", 2},
                                                 {"p3", "strolls", "slow-fast", 2},
                                                 {"p3", "gone", "sad-happy", 2}})},
                                       {"sad-happy", "slow-fast"});
  ASSERT_EQ(study.scales.size(), 1u);  // nothing remains of slow-fast
  const RatedFilms& films = study.scales[0];
  EXPECT_EQ(films.scale, "sad-happy");
  ASSERT_EQ(films.mean.size(), 3);  // mixed, quick, sad
  EXPECT_EQ(films.mean, Eigen::Vector3d(1.0, 2.0, -1.0));
  EXPECT_EQ(films.answers, Eigen::Vector3i(1, 1, 3));
  EXPECT_EQ(films.ids, (std::vector<std::string>{"mixed", "quick", "sad"}));
  EXPECT_EQ(films.rounds, (std::vector<int>{1, 1, 1}));  // both files have answers about sad
  EXPECT_NEAR(films.answer_variance, 1.0, 1e-12);        // (−2, 0, −1): 2 / 2
  EXPECT_EQ(study.answers_per_film, 1);
  const auto row = [&](const std::string& name) {
    return space.places.row(std::ranges::find(space.examples, name) - space.examples.begin());
  };
  EXPECT_TRUE(films.places.row(0).isApprox(0.25 * row("sad") + 0.75 * row("happy"), 1e-12));
  EXPECT_TRUE(films.places.row(2).isApprox(row("sad"), 1e-12));
  EXPECT_EQ(study.left_out, (std::vector<std::string>{
                                "1 answer is left out: gone, which is no stimulus of the manifest",
                                "2 answers are left out: strolls, which walks along a path",
                                "1 answer is left out: warped, which is modified"}));
}

TEST_F(FilmSpaceTest, RefusesAnswersOfWhichNothingRemains) {
  try {
    rated_study(manifest, repertoire, space, {answers({{"p1", "warped", "sad-happy", 2}})},
                {"sad-happy"});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none of the answers are ratings"), std::string::npos);
  }
}

TEST_F(FilmSpaceTest, NextRoundHasTheNewFilmsAndShowsThemAlone) {
  const auto candidates = film_candidates(space.places, 40, true, 1);
  NextFilms next;
  next.films = {{.candidate = 2}, {.candidate = 30}};
  const Manifest round = next_round(manifest, space, candidates, next, "walks-2");
  const ManifestReading read = check_manifest_text(manifest_yaml(round, "."), "next.yaml", {});
  ASSERT_TRUE(read.faults.empty()) << to_string(read.faults.front());
  EXPECT_EQ(read.manifest.study, "walks-2");
  ASSERT_EQ(read.manifest.stimuli.size(), 7u);
  EXPECT_EQ(read.manifest.stimuli[0].id, "sad");
  EXPECT_EQ(read.manifest.questionnaire->stimuli.ids,
            (std::vector<std::string>{"round2-01", "round2-02"}));
  for (std::size_t f = 0; f < 2; ++f) {
    const Eigen::VectorXd weights = weights_of(read.manifest.stimuli[5 + f], repertoire);
    EXPECT_TRUE(weights.isApprox(candidates[next.films[f].candidate].weights, 1e-12));
  }
  const Manifest third = next_round(round, space, candidates, next, "walks-3");
  EXPECT_EQ(third.questionnaire->stimuli.ids, (std::vector<std::string>{"round3-01", "round3-02"}));
  EXPECT_EQ(third.stimuli.size(), 9u);
  const Manifest first = next_round(manifest, space, candidates, next, "walks-1", 1);
  EXPECT_EQ(first.questionnaire->stimuli.ids, (std::vector<std::string>{"round1-01", "round1-02"}));
}

TEST(NameOfNextRound, CountsOn) {
  EXPECT_EQ(name_of_first_round("walks"), "walks-1");
  EXPECT_EQ(name_of_first_round("walks-1"), "walks-2");
  EXPECT_EQ(name_of_next_round("walks"), "walks-2");
  EXPECT_EQ(name_of_next_round("walks-2"), "walks-3");
  EXPECT_EQ(name_of_next_round("walks-9"), "walks-10");
  EXPECT_EQ(name_of_next_round("walks-"), "walks--2");
  EXPECT_EQ(name_of_next_round("walks-2b"), "walks-2b-2");
  EXPECT_EQ(name_of_next_round("walks-20261129"), "walks-20261129-2");  // a date
}

}  // namespace
}  // namespace mien::pipeline
