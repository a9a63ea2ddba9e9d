#include <optional>
#include <vector>

#include "motion/measures/distance/distance.h"
#include "motion/measures/distance/hands_distance.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/report/report_tables.h"
#include "pipeline/production/report/tables.h"

namespace mien::pipeline {

namespace {

struct ComparedPair {
  const Sheet& sheet;
  MotionPair pair;
  std::string ratings;
  motion::Distance d;
  std::optional<double> fingertips_m;
};

struct ComparedJoint {
  const Sheet& sheet;
  MotionPair pair;
  std::string ratings;
  motion::BodyJoint joint;
  double time;  ///< share of the duration
  double distance_m;
};

struct ComparedFeature {
  const Sheet& sheet;
  std::string ratings;
  motion::FeatureChange change;

  const motion::MotionFeature& feature() const {
    return motion::motion_features()[static_cast<std::size_t>(change.feature)];
  }
};

constexpr SharedColumn sheet_column{"sheet", "", "id of the sheet",
                                    [](auto& r) { return r.sheet.id; }};
constexpr SharedColumn target_column{"target", "",
                                     "target stimulus or example; in a gallery, the first one",
                                     [](auto& r) { return r.pair.target; }};
constexpr SharedColumn created_column{"created", "", "stimulus or example compared with it",
                                      [](auto& r) { return r.pair.created; }};
constexpr SharedColumn pair_ratings_column{
    "ratings", "",
    "ratings on which either motion is based: given (by people), simulated or none (features, "
    "weights, files, paths)",
    [](auto& r) { return r.ratings; }};

constexpr auto distances_columns = table_of<ComparedPair>(
    "metrics/distances.csv", "compared pair",
    {sheet_column,
     target_column,
     created_column,
     pair_ratings_column,
     {"alignment", "",
      "pelvis: horizontal position and heading of the pelvis removed in every frame (height "
      "kept); world: in the first frame only",
      [](auto& r) { return r.d.alignment == motion::Alignment::pelvis ? "pelvis" : "world"; }},
     {"d_m", "m",
      "D: mean distance over 20 joints and 11 corresponding moments; planted feet of motion files "
      "are locked to the floor first, as in blends",
      [](auto& r) { return r.d.mean; }},
     {"d_sum_m", "m", "sum of the same distances, as in the published formula",
      [](auto& r) { return r.d.sum; }},
     {"mpjpe_m", "m", "mean joint distance over all frames (MPJPE)",
      [](auto& r) { return r.d.mpjpe; }},
     {"fingertips_m", "m",
      "mean distance of the ten fingertips from their positions in the target, as seen from their "
      "wrists, at the same moments; empty unless both motions have fingers",
      [](auto& r) { return r.fingertips_m; }},
     {"threshold_m", "m",
      "threshold of D at which a trial of the adjective paper's matching task ends",
      [](auto&) { return motion::distance_threshold_m; }},
     {"match", "0/1",
      "1: D is below threshold_m, whatever the distances of single joints and the durations; not a "
      "measure of perceptibility; empty for gallery sheets",
      [](auto& r) {
        return r.sheet.gallery.empty() ? std::optional(r.d.matches()) : std::nullopt;
      }}});

constexpr auto joint_distances_columns = table_of<ComparedJoint>(
    "metrics/joint_distances.csv", "compared pair, joint and time",
    {sheet_column,
     target_column,
     created_column,
     pair_ratings_column,
     {"joint", "", "joint", [](auto& r) { return motion::name_of(r.joint); }},
     {"time", "0–1",
      "corresponding moment, as a fraction of the duration: 0, 0.1, … 1; matched by keytimes where "
      "both motions have the same number of keytimes",
      [](auto& r) { return r.time; }},
     {"distance_m", "m", "distance of the joint from its position in the target",
      [](auto& r) { return r.distance_m; }}});

constexpr auto feature_changes_columns = table_of<ComparedFeature>(
    "metrics/feature_changes.csv", "motion feature of each comparison with a reference",
    {sheet_column,
     {"reference", "", "reference stimulus or example", [](auto& r) { return r.sheet.reference; }},
     {"target", "", "target stimulus or example", [](auto& r) { return r.sheet.target; }},
     {"created", "", "stimulus or example that should change in the same direction",
      [](auto& r) { return r.sheet.created; }},
     pair_ratings_column,
     {"feature", "", "id of the motion feature", [](auto& r) { return r.feature().id; }},
     {"name", "", "English name", [](auto& r) { return r.feature().name; }},
     {"name_ja", "", "Japanese name", [](auto& r) { return r.feature().japanese; }},
     {"unit", "", "unit of the following three values",
      [](auto& r) { return motion::symbol_of(r.feature().unit); }},
     {"reference_value", "see unit", "value of the reference",
      [](auto& r) { return r.change.reference; }},
     {"target_change", "see unit", "target minus reference",
      [](auto& r) { return r.change.target_change(); }},
     {"created_change", "see unit", "created motion minus reference",
      [](auto& r) { return r.change.created_change(); }},
     {"moved", "0/1", "1: the target differs measurably from the reference",
      [](auto& r) { return r.change.moved(); }},
     {"agrees", "0/1",
      "1: the created motion changed in the same direction, by at least a tenth of the target's "
      "change; empty if the target did not change measurably",
      [](auto& r) { return r.change.moved() ? std::optional(r.change.agrees()) : std::nullopt; }}});

/// The ratings behind a pair: simulated if either motion is based on simulated ratings.
std::string ratings_of(const MotionPair& pair, Motions& motions) {
  const std::string target = ratings_of(motions.stimulus(pair.target), motions);
  const std::string created = ratings_of(motions.stimulus(pair.created), motions);
  return target == "none" ? created : target;
}

std::vector<ComparedPair> compared_pairs(const Manifest& manifest, Motions& motions) {
  std::vector<ComparedPair> rows;
  for (const Sheet& sheet : manifest.sheets)
    for (const MotionPair& pair : pairs_on(sheet))
      rows.push_back({sheet, pair, ratings_of(pair, motions),
                      motions.distance(pair.target, pair.created),
                      motion::hands_distance(motions.of(pair.target).motion,
                                             motions.of(pair.created).motion)});
  return rows;
}

std::vector<ComparedJoint> compared_joints(const Manifest& manifest, Motions& motions) {
  std::vector<ComparedJoint> rows;
  for (const auto& [sheet, pair, ratings, d, fingertips] : compared_pairs(manifest, motions))
    for (int joint = 0; joint < motion::distance_joints; ++joint)
      for (int time = 0; time < motion::distance_times; ++time)
        rows.push_back({sheet, pair, ratings, motion::BodyJoint(joint + 1),
                        time / (motion::distance_times - 1.0), d.by_joint_and_time(joint, time)});
  return rows;
}

std::vector<ComparedFeature> compared_features(const Manifest& manifest, Motions& motions) {
  std::vector<ComparedFeature> rows;
  for (const Sheet& sheet : manifest.sheets)
    for (const motion::FeatureChange& change : feature_changes(sheet, motions))
      rows.push_back({sheet, ratings_of({sheet.target, sheet.created}, motions), change});
  return rows;
}

}  // namespace

const StudyTable distances_table = study_table<distances_columns, compared_pairs>;
const StudyTable joint_distances_table = study_table<joint_distances_columns, compared_joints>;
const StudyTable feature_changes_table = study_table<feature_changes_columns, compared_features>;

}  // namespace mien::pipeline
