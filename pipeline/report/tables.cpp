#include "pipeline/report/tables.h"

#include <algorithm>
#include <cmath>

#include "motion/interpolation/interpolation_options.h"
#include "motion/measures/distance.h"
#include "pipeline/documents/csv.h"
#include "pipeline/report/feature_changes.h"
#include "pipeline/synthesis/parameter_label.h"

namespace mien::pipeline {

namespace {

std::string ratings_of(const Stimulus* stimulus, Motions& motions) {
  if (stimulus == nullptr || stimulus->adjectives.empty()) return "none";
  return motions.repertoire().simulated_ratings ? "simulated" : "given";
}

/// Of a pair: simulated if either motion rests on simulated ratings.
std::string ratings_of(const MotionPair& pair, const Manifest& manifest, Motions& motions) {
  const std::string target = ratings_of(find_stimulus(manifest, pair.target), motions);
  const std::string created = ratings_of(find_stimulus(manifest, pair.created), motions);
  return target == "none" ? created : target;
}

motion::Distance distance_of(const MotionPair& pair, Motions& motions) {
  return motion::distance(motions.of(pair.target).motion, motions.of(pair.created).motion);
}

const char* name_of(Role role) {
  switch (role) {
    case Role::target:
      return "target";
    case Role::created:
      return "created";
    case Role::reference:
      break;
  }
  return "reference";
}

const char* source_of(const Stimulus& stimulus) {
  if (stimulus.clip) return "clip";
  if (!stimulus.features.empty()) return "features";
  return stimulus.adjectives.empty() ? "weights" : "adjectives";
}

/// How the weights were found; empty for a file shown as it is.
std::string method_of(const Stimulus& stimulus) {
  if (stimulus.clip) return "";
  return std::string(motion::name_of(stimulus.weights.empty()
                                         ? stimulus.interpolation.weights.method
                                         : motion::InterpolationMethod::direct));
}

/// Way over the floor in one cycle, or of the whole clip.
double way_of(const motion::Clip& clip) {
  const motion::Vec3 way =
      clip.loops ? clip.cycle_displacement
                 : motion::Vec3(clip.poses.back().root_position - clip.poses.front().root_position);
  return std::hypot(way.x(), way.z());
}

/// What people would say of a blend on the scales that nobody asked it for.
void add_parameters_that_come_along(const Stimulus& stimulus, const Synthesis& made,
                                    const Repertoire& repertoire, CsvWriter& table) {
  const auto is_asked = [&](const std::string& name) {
    return std::any_of(made.asked.begin(), made.asked.end(),
                       [&](const auto& asked) { return asked.first == name; });
  };
  const ParameterTable& parameters = repertoire.parameters;
  for (std::size_t r = 0; r < parameters.names.size(); ++r) {
    const std::string& name = parameters.names[r];
    if (is_asked(name)) continue;
    const ParameterLabel label = rating_label(name, repertoire.scales);
    const double value = parameters.values.row(static_cast<Eigen::Index>(r)).dot(made.weights);
    table.row({stimulus.id, parameters.simulated ? "simulated" : "given", name, "", shortest(value),
               english_text(label), japanese_text(label)});
  }
}

void add_joint_distances(const std::string& sheet, const MotionPair& pair,
                         const std::string& ratings, const motion::Distance& d, CsvWriter& table) {
  for (int j = 0; j < motion::distance_joints; ++j) {
    for (int t = 0; t < motion::distance_times; ++t) {
      table.row({sheet, pair.target, pair.created, ratings,
                 std::string(motion::name_of(motion::BodyJoint(j + 1))),
                 shortest(t / (motion::distance_times - 1.0)),
                 shortest(d.by_joint_and_time(j, t))});
    }
  }
}

}  // namespace

std::string distances_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"sheet", "target", "created", "ratings", "alignment", "d_m", "d_sum_m",
                   "mpjpe_m", "threshold_m", "match"});
  for (const Sheet& sheet : manifest.sheets) {
    for (const MotionPair& pair : pairs_on(sheet)) {
      const motion::Distance d = distance_of(pair, motions);
      table.row({sheet.id, pair.target, pair.created, ratings_of(pair, manifest, motions),
                 d.alignment == motion::Alignment::pelvis ? "pelvis" : "world", shortest(d.mean),
                 shortest(d.sum), shortest(d.mpjpe), shortest(motion::distance_threshold_m),
                 !sheet.gallery.empty() ? ""
                 : d.matches()          ? "1"
                                        : "0"});
    }
  }
  return table.text();
}

std::string joint_distances_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"sheet", "target", "created", "ratings", "joint", "time", "distance_m"});
  for (const Sheet& sheet : manifest.sheets) {
    for (const MotionPair& pair : pairs_on(sheet)) {
      add_joint_distances(sheet.id, pair, ratings_of(pair, manifest, motions),
                          distance_of(pair, motions), table);
    }
  }
  return table.text();
}

std::string weights_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"stimulus", "ratings", "example", "weight"});
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.clip) continue;
    const Eigen::VectorXd& weights = motions.of(stimulus.id).weights;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      table.row({stimulus.id, ratings_of(&stimulus, motions),
                 motions.repertoire().names[static_cast<std::size_t>(i)].name,
                 shortest(weights[i])});
    }
  }
  return table.text();
}

std::string clips_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"stimulus", "role", "ratings", "source", "frames", "duration_s", "fps",
                   "cycle_s", "stride_m", "speed_m_s", "planted_drift_m", "method",
                   "expected_error_m", "modified", "modified_share"});
  for (const Stimulus& stimulus : manifest.stimuli) {
    const Synthesis& made = motions.of(stimulus.id);
    const motion::Clip& clip = made.motion.clip;
    const int frames = motions.shown(stimulus).frame_count();
    const double duration = clip.duration_seconds();
    table.row({stimulus.id, name_of(stimulus.role), ratings_of(&stimulus, motions),
               source_of(stimulus), std::to_string(frames),
               shortest(frames / clip.frames_per_second), shortest(clip.frames_per_second),
               clip.loops ? shortest(duration) : "", clip.loops ? shortest(way_of(clip)) : "",
               duration > 0.0 ? shortest(way_of(clip) / duration) : "",
               shortest(made.planted_drift_m), method_of(stimulus),
               made.expected_error_m ? shortest(*made.expected_error_m) : "", made.modified,
               made.modified.empty() ? "" : shortest(made.modified_share)});
  }
  return table.text();
}

std::string parameters_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"stimulus", "ratings", "parameter", "asked", "reached", "name", "name_ja"});
  for (const Stimulus& stimulus : manifest.stimuli) {
    const Synthesis& made = motions.of(stimulus.id);
    if (stimulus.clip) continue;
    for (std::size_t i = 0; i < made.asked.size(); ++i) {
      const ParameterLabel label = label_of(made.asked[i].first, stimulus, motions.repertoire());
      table.row({stimulus.id, ratings_of(&stimulus, motions), made.asked[i].first,
                 shortest(made.asked[i].second), shortest(made.reached[i].second),
                 english_text(label), japanese_text(label)});
    }
    add_parameters_that_come_along(stimulus, made, motions.repertoire(), table);
  }
  return table.text();
}

std::string impressions_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"scale", "example", "ratings", "answers", "mean", "sd"});
  if (!blends_examples(manifest) || !motions.repertoire().impressions) return table.text();
  const Impressions& impressions = *motions.repertoire().impressions;
  const std::string ratings = impressions.simulated ? "simulated" : "given";
  for (Eigen::Index j = 0; j < impressions.mean.rows(); ++j) {
    for (Eigen::Index i = 0; i < impressions.mean.cols(); ++i) {
      const double sd = impressions.deviation(j, i);
      table.row({impressions.scales[static_cast<std::size_t>(j)],
                 impressions.examples[static_cast<std::size_t>(i)], ratings,
                 std::to_string(impressions.count(j, i)), shortest(impressions.mean(j, i)),
                 std::isnan(sd) ? "" : shortest(sd)});
    }
  }
  return table.text();
}

std::string findings_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"stimulus", "check", "severity", "joint", "first_frame", "last_frame", "first_s",
                   "last_s", "measured", "threshold", "unit", "sentence"});
  for (const Stimulus& stimulus : manifest.stimuli) {
    const Synthesis& made = motions.of(stimulus.id);
    for (const motion::Finding& f : made.findings) {
      const double fps = made.motion.clip.frames_per_second;
      table.row({stimulus.id, f.check, std::string(motion::name_of(f.severity)), f.joint,
                 std::to_string(f.first), std::to_string(f.last), shortest(f.first / fps),
                 shortest(f.last / fps), shortest(f.measured), shortest(f.threshold), f.unit,
                 f.sentence});
    }
  }
  return table.text();
}

std::string feature_changes_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table({"sheet", "reference", "target", "created", "ratings", "feature", "name",
                   "name_ja", "unit", "reference_value", "target_change", "created_change", "moved",
                   "agrees"});
  for (const Sheet& sheet : manifest.sheets) {
    for (const motion::FeatureChange& change : feature_changes(sheet, motions)) {
      const motion::MotionFeature& what =
          motion::motion_features()[static_cast<std::size_t>(change.feature)];
      table.row({sheet.id, sheet.reference, sheet.target, sheet.created,
                 ratings_of({sheet.target, sheet.created}, manifest, motions), std::string(what.id),
                 std::string(what.name), std::string(what.japanese),
                 std::string(motion::symbol_of(what.unit)), shortest(change.reference),
                 shortest(change.target_change()), shortest(change.created_change()),
                 change.moved() ? "1" : "0", change.moved() ? (change.agrees() ? "1" : "0") : ""});
    }
  }
  return table.text();
}

}  // namespace mien::pipeline
