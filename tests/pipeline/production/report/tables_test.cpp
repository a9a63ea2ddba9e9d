#include "pipeline/production/report/tables.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/math/rotation.h"
#include "motion/measures/distance/distance.h"
#include "motion/measures/distance/hands_distance.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/recording.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// A rated target, a blend by weights and their comparison.
Manifest small_study() {
  Manifest manifest;
  manifest.study = "small";
  manifest.seed = 7;
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  Stimulus target;
  target.id = "target";
  target.role = Role::target;
  target.adjectives = {{"quickness", 0.6}, {"largeness", 0.5}};
  Stimulus mix;
  mix.id = "mix, quoted";
  mix.weights = {{"normal", 3.0}, {"proud", 1.0}};
  manifest.stimuli = {target, mix};
  Sheet sheet;
  sheet.id = "target_mix";
  sheet.target = target.id;
  sheet.created = mix.id;
  manifest.sheets = {sheet};
  return manifest;
}

class Tables : public testing::Test {
 protected:
  Manifest manifest = small_study();
  Motions motions{manifest};

  CsvTable table(const StudyTable& one) {
    return parse_csv(one.csv(manifest, motions), "table.csv");
  }

  static std::string text(const CsvTable& table, std::size_t row, const char* column) {
    return table.rows.at(row)[static_cast<std::size_t>(require_column(table, column))].text;
  }

  static double number(const CsvTable& table, std::size_t row, const char* column) {
    return number_in(table,
                     table.rows.at(row)[static_cast<std::size_t>(require_column(table, column))]);
  }
};

TEST_F(Tables, WeightsOfEveryStimulusCoverAllExamplesAndSumToOne) {
  const CsvTable weights = table(weights_table);
  std::map<std::string, int> rows;
  std::map<std::string, double> sums;
  for (std::size_t r = 0; r < weights.rows.size(); ++r) {
    ++rows[text(weights, r, "stimulus")];
    sums[text(weights, r, "stimulus")] += number(weights, r, "weight");
  }
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& [stimulus, count] : rows) EXPECT_EQ(count, 10) << stimulus;
  for (const auto& [stimulus, sum] : sums) EXPECT_NEAR(sum, 1.0, 1e-9) << stimulus;
}

TEST_F(Tables, WeightsThatWereGivenAreTold) {
  const CsvTable weights = table(weights_table);
  for (std::size_t r = 0; r < weights.rows.size(); ++r) {
    if (text(weights, r, "stimulus") != "mix, quoted") continue;
    const std::string example = text(weights, r, "example");
    const double expected = example == "normal" ? 0.75 : example == "proud" ? 0.25 : 0.0;
    EXPECT_NEAR(number(weights, r, "weight"), expected, 1e-12) << example;
  }
}

TEST_F(Tables, MeanOfJointDistancesIsD) {
  const CsvTable distances = table(distances_table);
  const CsvTable joints = table(joint_distances_table);
  ASSERT_EQ(distances.rows.size(), 1u);
  ASSERT_EQ(joints.rows.size(), 20u * 11u);
  double sum = 0.0;
  for (std::size_t r = 0; r < joints.rows.size(); ++r) sum += number(joints, r, "distance_m");
  EXPECT_GT(sum, 0.0);
  EXPECT_NEAR(number(distances, 0, "d_m"), sum / 220.0, 1e-12);
  EXPECT_NEAR(number(distances, 0, "d_sum_m"), sum, 1e-9);
}

TEST_F(Tables, FingertipsAreComparedWhereBothMotionsHaveFingers) {
  EXPECT_EQ(text(table(distances_table), 0, "fingertips_m"), "");
  const test::TemporaryFolder folder;
  Manifest files = small_study();
  motion::Clip walk = motion::repeated(motion::builtin_examples("walks-10").examples[0].clip, 2);
  for (std::size_t s = 0; s < 2; ++s) {
    Stimulus& stimulus = files.stimuli[s];
    for (motion::Pose& pose : walk.poses) {
      pose.fingers = motion::relaxed_fingers();
      for (int joint = 0; joint < motion::finger_joint_count; ++joint)
        pose.fingers[static_cast<std::size_t>(joint)] =
            motion::exp(0.5 * static_cast<double>(s + 1) * motion::flexion_axis(joint));
    }
    const auto file = folder.path() / (std::to_string(s) + ".bvh");
    motion::write_motion(motion::to_recording(walk), file);
    stimulus.adjectives.clear();
    stimulus.weights.clear();
    stimulus.clip.emplace().file = file;
  }
  Motions handed(files);
  const CsvTable distances = parse_csv(distances_table.csv(files, handed), "distances.csv");
  EXPECT_EQ(number(distances, 0, "fingertips_m"),
            *motion::hands_distance(handed.of(files.sheets[0].target).motion,
                                    handed.of(files.sheets[0].created).motion));
  EXPECT_GT(number(distances, 0, "fingertips_m"), 0.03);
  EXPECT_LT(number(distances, 0, "d_m"), 1e-3);
}

TEST_F(Tables, VerdictFollowsTheThreshold) {
  const CsvTable distances = table(distances_table);
  const bool is_below = number(distances, 0, "d_m") < number(distances, 0, "threshold_m");
  EXPECT_EQ(text(distances, 0, "match"), is_below ? "1" : "0");
  EXPECT_EQ(number(distances, 0, "threshold_m"), 0.06);
}

TEST_F(Tables, SimulatedRatingsAreMarkedWhereTheyCount) {
  const CsvTable clips = table(clips_table);
  ASSERT_EQ(clips.rows.size(), 2u);
  EXPECT_EQ(text(clips, 0, "ratings"), "simulated");
  EXPECT_EQ(text(clips, 1, "ratings"), "none");
  EXPECT_EQ(text(table(distances_table), 0, "ratings"), "simulated");
}

TEST_F(Tables, ClipsTellLengthAndSpeedThatBelongTogether) {
  const CsvTable clips = table(clips_table);
  for (std::size_t r = 0; r < clips.rows.size(); ++r) {
    EXPECT_NEAR(number(clips, r, "duration_s"),
                number(clips, r, "frames") / number(clips, r, "fps"), 1e-12);
    EXPECT_NEAR(number(clips, r, "speed_m_s"),
                number(clips, r, "stride_m") / number(clips, r, "cycle_s"), 1e-12);
    EXPECT_LT(number(clips, r, "planted_drift_m"), 0.005);
  }
}

TEST_F(Tables, ClipsTellHowTheirWeightsWereFound) {
  const CsvTable clips = table(clips_table);
  EXPECT_EQ(text(clips, 0, "method"), "reach");
  EXPECT_EQ(text(clips, 0, "expected_error_m"), "");
  EXPECT_EQ(text(clips, 1, "method"), "direct");
  Manifest other = small_study();
  other.stimuli[0].interpolation.weights.method = motion::InterpolationMethod::kriging;
  Motions made(other);
  const CsvTable kriged = parse_csv(clips_table.csv(other, made), "clips.csv");
  EXPECT_EQ(text(kriged, 0, "method"), "kriging");
  EXPECT_GT(number(kriged, 0, "expected_error_m"), 0.0);
  EXPECT_LT(number(kriged, 0, "expected_error_m"), 0.5);
}

TEST_F(Tables, ParametersAreThoseAskedForAndThenAllOthers) {
  const CsvTable parameters = table(parameters_table);
  ASSERT_EQ(parameters.rows.size(), 2u * 45u);
  const ParameterTable& values = motions.repertoire().parameters;
  const Eigen::VectorXd& weights = motions.of("target").weights;
  for (std::size_t r = 2; r < 45; ++r) {
    EXPECT_EQ(text(parameters, r, "requested"), "");
    const int row = values.find(text(parameters, r, "parameter"));
    ASSERT_GE(row, 0);
    EXPECT_NEAR(number(parameters, r, "reached"), values.values.row(row).dot(weights), 1e-12);
  }
  EXPECT_EQ(text(parameters, 45, "stimulus"), "mix, quoted");
  EXPECT_EQ(text(parameters, 45, "requested"), "");
  EXPECT_EQ(text(parameters, 0, "parameter"), "quickness");
  EXPECT_EQ(number(parameters, 0, "requested"), 0.6);
  EXPECT_EQ(text(parameters, 1, "parameter"), "largeness");
  EXPECT_EQ(number(parameters, 1, "requested"), 0.5);
}

TEST_F(Tables, ImpressionsAreThoseOfEveryExampleOnEveryScale) {
  const CsvTable impressions = table(impressions_table);
  ASSERT_EQ(impressions.rows.size(), 41u * 10u);
  const Impressions& expected = *motions.repertoire().impressions;
  for (std::size_t r = 0; r < impressions.rows.size(); r += 37) {
    const auto scale = static_cast<Eigen::Index>(r / 10);
    const auto example = static_cast<Eigen::Index>(r % 10);
    EXPECT_EQ(number(impressions, r, "mean"), expected.mean(scale, example));
    EXPECT_EQ(number(impressions, r, "answers"), 14.0);
    EXPECT_EQ(text(impressions, r, "ratings"), "simulated");
  }
}

TEST_F(Tables, ImpressionsAreToldInTheUnitsOfTheScaleToo) {
  const CsvTable impressions = table(impressions_table);
  for (std::size_t r = 0; r < impressions.rows.size(); ++r) {  // −2 … 2
    EXPECT_NEAR(number(impressions, r, "mean_answer"), 4.0 * number(impressions, r, "mean") - 2.0,
                1e-9);
    EXPECT_NEAR(number(impressions, r, "sd_answer"), 4.0 * number(impressions, r, "sd"), 1e-9);
  }
  EXPECT_EQ(text(impressions, 0, "scale"),
            text(impressions, 0, "low") + "-" + text(impressions, 0, "high"));
}

TEST_F(Tables, BuiltinExamplesHaveKeytimesAndNoFile) {
  const CsvTable examples = table(examples_table);
  ASSERT_EQ(examples.rows.size(), 10u);
  EXPECT_EQ(text(examples, 0, "example"), "normal");
  EXPECT_EQ(text(examples, 0, "file"), "");
  EXPECT_EQ(text(examples, 0, "loops"), "1");
  const std::string keytimes = text(examples, 0, "keytimes_s");
  EXPECT_EQ(std::count(keytimes.begin(), keytimes.end(), ' '), 6);
  EXPECT_TRUE(keytimes.ends_with(" " + text(examples, 0, "duration_s")));
}

TEST(ExamplesTable, TellsWhichFramesOfAFileEachExampleIs) {
  const test::TemporaryFolder folder;
  const motion::ExampleSet walks = motion::builtin_examples("walks-10");
  for (const std::size_t i : {0u, 4u}) {
    const motion::Clip walk = motion::repeated(walks.examples[i].clip, 4);
    motion::write_motion(motion::to_recording(walk),
                         folder.path() / (walks.examples[i].name + ".bvh"));
  }
  Manifest manifest = small_study();
  manifest.examples.builtin.clear();
  manifest.examples.folder = folder.path();
  manifest.examples.labels = Examples::Labels::file_name;
  manifest.ratings.source = Ratings::Source::simulated;
  manifest.stimuli = {manifest.stimuli[1]};
  manifest.stimuli[0].weights = {{"normal", 1.0}};
  manifest.sheets.clear();
  Motions motions(manifest);
  const CsvTable examples = parse_csv(examples_table.csv(manifest, motions), "examples.csv");
  ASSERT_EQ(examples.rows.size(), 2u);
  const auto value = [&](std::size_t row, const char* column) {
    return examples.rows[row][static_cast<std::size_t>(require_column(examples, column))].text;
  };
  for (const std::size_t row : {0u, 1u}) {
    EXPECT_EQ(value(row, "file"), value(row, "example") + ".bvh");
    const double seconds = std::stod(value(row, "last_s")) - std::stod(value(row, "first_s"));
    EXPECT_NEAR(seconds, std::stod(value(row, "duration_s")), 1e-9);
    EXPECT_LT(std::stoi(value(row, "last_frame")), std::stoi(value(row, "take_frames")));
    EXPECT_EQ(value(row, "mirrored"), "0");
  }
}

}  // namespace
}  // namespace mien::pipeline
