#include "pipeline/production/report/tables.h"

#include <algorithm>
#include <cmath>

#include "motion/measures/distance/distance.h"
#include "pipeline/manifest/ratings/answers/impression_table.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/report/feature_changes.h"
#include "pipeline/production/report/table_forms.h"
#include "pipeline/production/synthesis/parameter_label.h"

namespace mien::pipeline {

namespace {

/// Of a pair: simulated if either motion rests on simulated ratings.
std::string ratings_of(const MotionPair& pair, Motions& motions) {
  const std::string target = ratings_of(motions.stimulus(pair.target), motions);
  const std::string created = ratings_of(motions.stimulus(pair.created), motions);
  return target == "none" ? created : target;
}

/// Way over the floor in one cycle, or of the whole clip.
double way_of(const motion::Clip& clip) {
  const motion::Vec3 way =
      clip.loops ? clip.cycle_displacement
                 : motion::Vec3(clip.poses.back().root_position - clip.poses.front().root_position);
  return std::hypot(way.x(), way.z());
}

/// A row of the table of parameters; empty where nothing is known.
struct ParameterRow {
  std::string name;
  std::string asked;
  std::string held;
  double reached = 0.0;
  std::optional<motion::ParameterRange> possible = std::nullopt;
};

/// What the stimulus asks for, what it holds, and what comes along with the blend.
std::vector<ParameterRow> parameter_rows(const Synthesis& made, const Repertoire& repertoire) {
  std::vector<ParameterRow> rows;
  for (std::size_t i = 0; i < made.asked.size(); ++i) {
    rows.push_back(
        {made.asked[i].first, shortest(made.asked[i].second), "", made.reached[i].second});
    if (i < made.feasible.size()) rows.back().possible = made.feasible[i].range;
  }
  for (std::size_t i = 0; i < made.held.size(); ++i)
    rows.push_back(
        {made.held[i].first, "", shortest(made.held[i].second), made.held_reached[i].second});
  const auto is_listed = [&](const std::string& name) {
    return std::ranges::find(rows, name, &ParameterRow::name) != rows.end();
  };
  const ParameterTable& parameters = repertoire.parameters;
  for (std::size_t r = 0; r < parameters.names.size(); ++r) {
    const std::string& name = parameters.names[r];
    if (!is_listed(name))
      rows.push_back(
          {name, "", "", parameters.values.row(static_cast<Eigen::Index>(r)).dot(made.weights)});
  }
  return rows;
}

/// What a number says; empty of what is not known.
std::string text_of(const ExpectedStep& step, double value) {
  return step.people == 0 || std::isnan(value) ? "" : shortest(value);
}

std::string joined(const std::vector<double>& seconds) {
  std::string text;
  for (const double value : seconds) text += (text.empty() ? "" : " ") + shortest(value);
  return text;
}

/// From `file` to `last_s`.
std::vector<std::string> origin_fields(const motion::ExampleOrigin& origin) {
  const double fps = origin.frames_per_second;
  return {origin.file.filename().string(),    shortest(fps),
          std::to_string(origin.file_frames), std::to_string(origin.frames.first),
          std::to_string(origin.frames.last), shortest(origin.frames.first / fps),
          shortest(origin.frames.last / fps)};
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
  CsvWriter table = table_of(distances_form);
  for (const Sheet& sheet : manifest.sheets) {
    for (const MotionPair& pair : pairs_on(sheet)) {
      const motion::Distance d = motions.distance(pair.target, pair.created);
      table.row({sheet.id, pair.target, pair.created, ratings_of(pair, motions),
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
  CsvWriter table = table_of(joint_distances_form);
  for (const Sheet& sheet : manifest.sheets) {
    for (const MotionPair& pair : pairs_on(sheet)) {
      add_joint_distances(sheet.id, pair, ratings_of(pair, motions),
                          motions.distance(pair.target, pair.created), table);
    }
  }
  return table.text();
}

std::string weights_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(weights_form);
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!is_blend(stimulus)) continue;
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
  CsvWriter table = table_of(clips_form);
  for (const Stimulus& stimulus : manifest.stimuli) {
    const Synthesis& made = motions.of(stimulus.id);
    const motion::Clip& clip = made.motion.clip;
    const int frames = motions.shown(stimulus).frame_count();
    const double duration = clip.duration_seconds();
    table.row({stimulus.id, std::string(name_of(stimulus.role)), ratings_of(&stimulus, motions),
               std::string(source_of(stimulus)), std::to_string(frames),
               shortest(frames / clip.frames_per_second), shortest(clip.frames_per_second),
               clip.loops ? shortest(duration) : "", clip.loops ? shortest(way_of(clip)) : "",
               duration > 0.0 ? shortest(way_of(clip) / duration) : "",
               shortest_measured(made.planted_drift_m), method_of(stimulus),
               made.expected_error_m ? shortest(*made.expected_error_m) : "", made.modified,
               made.modified.empty() ? "" : shortest(made.modified_share)});
  }
  return table.text();
}

std::string parameters_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(parameters_form);
  for (const Stimulus& stimulus : manifest.stimuli) {
    const Synthesis& made = motions.of(stimulus.id);
    if (!is_blend(stimulus)) continue;
    const Repertoire& repertoire = motions.repertoire();
    for (const ParameterRow& row : parameter_rows(made, repertoire)) {
      const bool is_wish = !row.asked.empty();
      const ParameterLabel label = is_wish ? label_of(row.name, stimulus, repertoire)
                                           : rating_label(row.name, repertoire.scales);
      const std::string ratings = is_wish                           ? ratings_of(&stimulus, motions)
                                  : repertoire.parameters.simulated ? "simulated"
                                                                    : "given";
      table.row({stimulus.id, ratings, row.name, row.asked, row.held,
                 shortest_measured(row.reached), row.possible ? shortest(row.possible->least) : "",
                 row.possible ? shortest(row.possible->most) : "", english_text(label),
                 japanese_text(label)});
    }
  }
  return table.text();
}

std::string impressions_csv(const Manifest& manifest, Motions& motions) {
  if (!blends_examples(manifest)) return no_impressions_csv();
  const Repertoire& repertoire = motions.repertoire();
  if (!repertoire.impressions) return no_impressions_csv();
  return impressions_csv(*repertoire.impressions, repertoire.scales);
}

std::string examples_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(examples_form);
  if (!uses_examples(manifest)) return table.text();
  const Repertoire& repertoire = motions.repertoire();
  for (std::size_t i = 0; i < repertoire.names.size(); ++i) {
    const motion::Example& example = repertoire.examples.examples[i];
    std::vector<std::string> row = {repertoire.names[i].name};
    const std::vector<std::string> origin = i < repertoire.origins.size()
                                                ? origin_fields(repertoire.origins[i])
                                                : std::vector<std::string>(7);
    row.insert(row.end(), origin.begin(), origin.end());
    const bool is_mirrored = i < repertoire.origins.size() && repertoire.origins[i].is_mirrored;
    row.insert(row.end(), {example.clip.loops ? "1" : "0", is_mirrored ? "1" : "0",
                           shortest(example.clip.duration_seconds()), joined(example.keytimes)});
    table.row(row);
  }
  return table.text();
}

std::string expectations_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(expectations_form);
  if (manifest.ratings.expected.empty() || !uses_examples(manifest)) return table.text();
  const Repertoire& repertoire = motions.repertoire();
  const std::string ratings = repertoire.simulated_ratings ? "simulated" : "given";
  for (const ExpectationCheck& check : expectation_checks(manifest, repertoire)) {
    for (std::size_t i = 0; i < check.order.size(); ++i) {
      const bool is_violated = i > 0 && std::ranges::count(check.violated, i - 1) > 0;
      const ExpectedStep step = i == 0 ? ExpectedStep() : check.steps[i - 1];
      table.row({check.parameter, ratings, std::to_string(i + 1), check.order[i].example,
                 shortest(check.order[i].value), i == 0 ? "" : (is_violated ? "0" : "1"),
                 text_of(step, step.people), text_of(step, step.difference),
                 text_of(step, step.low), text_of(step, step.high), check.holds() ? "1" : "0",
                 check.is_certain() ? "1" : "0"});
    }
  }
  return table.text();
}

std::string findings_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(findings_form);
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
  CsvWriter table = table_of(feature_changes_form);
  for (const Sheet& sheet : manifest.sheets) {
    for (const motion::FeatureChange& change : feature_changes(sheet, motions)) {
      const motion::MotionFeature& what =
          motion::motion_features()[static_cast<std::size_t>(change.feature)];
      table.row({sheet.id, sheet.reference, sheet.target, sheet.created,
                 ratings_of({sheet.target, sheet.created}, motions), std::string(what.id),
                 std::string(what.name), std::string(what.japanese),
                 std::string(motion::symbol_of(what.unit)), shortest(change.reference),
                 shortest(change.target_change()), shortest(change.created_change()),
                 change.moved() ? "1" : "0", change.moved() ? (change.agrees() ? "1" : "0") : ""});
    }
  }
  return table.text();
}

}  // namespace mien::pipeline
