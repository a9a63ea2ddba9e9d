#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "pipeline/manifest/people.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/report/tables.h"
#include "pipeline/production/synthesis/parameter_label.h"

namespace mien::pipeline {

namespace {

struct BlendedExample {
  std::string stimulus;
  std::string ratings;
  std::string example;
  double weight;
};

struct MadeClip {
  const Stimulus& stimulus;
  const Synthesis& made;
  std::string ratings;
  std::string method;
  int frames;  ///< of what is shown

  const motion::Clip& clip() const { return made.motion.clip; }
  double duration() const { return clip().duration_seconds(); }
  /// Way over the floor in one cycle, or of the whole clip.
  double way() const {
    const motion::Vec3 moved =
        clip().loops
            ? clip().cycle_displacement
            : motion::Vec3(clip().poses.back().root_position - clip().poses.front().root_position);
    return std::hypot(moved.x(), moved.z());
  }
  std::optional<double> of_cycle(double value) const {
    return clip().loops ? std::optional(value) : std::nullopt;
  }
};

/// Unset where nothing is known.
struct ParameterRow {
  std::string name;
  std::optional<double> requested;
  std::optional<double> held;
  double reached = 0.0;
  std::optional<motion::ParameterRange> possible = std::nullopt;
  std::string stimulus = {};
  std::string ratings = {};
  ParameterLabel label = {};
};

struct FoundFault {
  std::string stimulus;
  double fps;
  const motion::Finding& finding;
};

constexpr auto weights_columns = table_of<BlendedExample>(
    "metrics/weights.csv", "blended stimulus and example",
    {{"stimulus", "", "id of the stimulus or, of several people, of the person (greet.a)",
      [](auto& r) { return r.stimulus; }},
     ratings_column,
     {"example", "", "example label", [](auto& r) { return r.example; }},
     {"weight", "",
      "blend weight; the weights of a stimulus sum to 1 (those of a statistical model may be "
      "negative)",
      [](auto& r) { return r.weight; }}});

constexpr auto clips_columns = table_of<MadeClip>(
    "metrics/clips.csv", "stimulus or person",
    {{"stimulus", "", "id of the stimulus or, of several people, of the person (greet.a)",
      [](auto& r) { return r.stimulus.id; }},
     {"role", "", "target, created or reference", [](auto& r) { return name_of(r.stimulus.role); }},
     ratings_column,
     {"source", "", "source of the motion: adjectives, features, weights, clip or path",
      [](auto& r) { return source_of(r.stimulus); }},
     {"frames", "", "number of frames shown, over all cycles", [](auto& r) { return r.frames; }},
     {"duration_s", "s", "duration shown, over all cycles",
      [](auto& r) { return r.frames / r.clip().frames_per_second; }},
     {"fps", "1/s", "frames per second", [](auto& r) { return r.clip().frames_per_second; }},
     {"cycle_s", "s", "duration of one cycle; empty for motions that do not loop",
      [](auto& r) { return r.of_cycle(r.duration()); }},
     {"stride_m", "m",
      "stride length: distance travelled in one cycle; empty for motions that do not loop",
      [](auto& r) { return r.of_cycle(r.way()); }},
     {"speed_m_s", "m/s",
      "displacement over the floor divided by duration, of one cycle or of the whole clip",
      [](auto& r) { return r.way() / r.duration(); }},
     {"planted_drift_m", "m", "largest displacement of a planted foot",
      [](auto& r) { return shortest_measured(r.made.planted_drift_m); }},
     {"method", "",
      "interpolation method by which blend weights were found, or direct for given weights; empty "
      "for a file or a path",
      [](auto& r) { return r.method; }},
     {"expected_error_m", "m",
      "expected error of joint positions, where the method estimates it (kriging)",
      [](auto& r) { return r.made.expected_error_m; }},
     {"modified", "", "modifications applied to the motion; empty for none",
      [](auto& r) { return r.made.modified; }},
     {"modified_share", "0–1",
      "proportion of the requested modification strength that was applied; below 1 where on_fault "
      "reduced it, 0 where it left the motion unmodified; empty if no modification was requested",
      [](auto& r) { return r.made.modified.empty() ? NAN : r.made.modified_share; }}});

constexpr auto parameters_columns = table_of<ParameterRow>(
    "metrics/parameters.csv",
    "blended stimulus and parameter: first the requested ones, then those held, then all others",
    {{"stimulus", "", "id of the stimulus or, of several people, of the person (greet.a)",
      [](auto& r) { return r.stimulus; }},
     ratings_column,
     {"parameter", "", "scale, group of scales or motion feature", [](auto& r) { return r.name; }},
     {"requested", "0–1", "requested value; empty if none", [](auto& r) { return r.requested; }},
     {"held", "0–1", "value at which the parameter is held; empty if it is not held",
      [](auto& r) { return r.held; }},
     {"reached", "0–1",
      "value reached: 0 low end of the scale, 1 high end; for features 0 smallest and 1 largest of "
      "the examples; for a modified motion, before modification",
      [](auto& r) { return shortest_measured(r.reached); }},
     {"least", "0–1",
      "lower end of the feasible range: the lowest value among the blends that have (or come "
      "nearest to) the other requested values, and the held ones if the request is feasible with "
      "them; empty if not requested, for features, and for the method pca",
      [](auto& r) { return r.possible ? r.possible->least : NAN; }},
     {"most", "0–1", "upper end of that range",
      [](auto& r) { return r.possible ? r.possible->most : NAN; }},
     {"name", "", "English name: \"sad – happy\", low end first",
      [](auto& r) { return english_text(r.label); }},
     {"name_ja", "", "Japanese name", [](auto& r) { return japanese_text(r.label); }}});

constexpr auto findings_columns = table_of<FoundFault>(
    "metrics/findings.csv", "lint finding",
    {{"stimulus", "", "id of the stimulus or, of several people, of the person (greet.a)",
      [](auto& r) { return r.stimulus; }},
     {"check", "", "lint rule", [](auto& r) { return r.finding.check; }},
     {"severity", "", "error or warning",
      [](auto& r) { return motion::name_of(r.finding.severity); }},
     {"joint", "", "joint, or recorded point; empty if none is concerned",
      [](auto& r) { return r.finding.joint; }},
     {"first_frame", "",
      "first frame of the finding, counted from 0 within the clip (of a looping motion, one cycle)",
      [](auto& r) { return r.finding.first; }},
     {"last_frame", "", "last frame of the finding", [](auto& r) { return r.finding.last; }},
     {"first_s", "s", "time of the first frame", [](auto& r) { return r.finding.first / r.fps; }},
     {"last_s", "s", "time of the last frame", [](auto& r) { return r.finding.last / r.fps; }},
     {"measured", "see unit", "measured value", [](auto& r) { return r.finding.measured; }},
     {"threshold", "see unit", "limit of the rule", [](auto& r) { return r.finding.threshold; }},
     {"unit", "", "unit of the measured value and of the limit",
      [](auto& r) { return r.finding.unit; }},
     {"sentence", "", "description of the finding", [](auto& r) { return r.finding.sentence; }}});

std::vector<BlendedExample> blended_examples(const Manifest& manifest, Motions& motions) {
  std::vector<BlendedExample> rows;
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    if (!is_blend(*stimulus)) continue;
    const Eigen::VectorXd& shares = motions.of(stimulus->id).weights;
    for (Eigen::Index i = 0; i < shares.size(); ++i)
      rows.push_back({stimulus->id, ratings_of(stimulus, motions),
                      motions.repertoire().names[static_cast<std::size_t>(i)].name, shares[i]});
  }
  return rows;
}

std::vector<MadeClip> made_clips(const Manifest& manifest, Motions& motions) {
  std::vector<MadeClip> rows;
  for (const Stimulus* stimulus : motion_sources(manifest))
    rows.push_back({*stimulus, motions.of(stimulus->id), ratings_of(stimulus, motions),
                    method_of(*stimulus), motions.shown(*stimulus).frame_count()});
  return rows;
}

/// What the stimulus asks for, what it holds, and what comes along with the blend.
std::vector<ParameterRow> parameters_of(const Synthesis& made, const Repertoire& repertoire) {
  std::vector<ParameterRow> rows;
  for (std::size_t i = 0; i < made.requested.size(); ++i) {
    rows.push_back({made.requested[i].first, made.requested[i].second, {}, made.reached[i].second});
    if (i < made.feasible.size()) rows.back().possible = made.feasible[i].range;
  }
  for (std::size_t i = 0; i < made.held.size(); ++i)
    rows.push_back({made.held[i].first, {}, made.held[i].second, made.held_reached[i].second});
  const auto is_listed = [&](const std::string& name) {
    return std::ranges::find(rows, name, &ParameterRow::name) != rows.end();
  };
  const ParameterTable& known = repertoire.parameters;
  for (std::size_t r = 0; r < known.names.size(); ++r) {
    if (!is_listed(known.names[r]))
      rows.push_back({known.names[r],
                      {},
                      {},
                      known.values.row(static_cast<Eigen::Index>(r)).dot(made.weights)});
  }
  return rows;
}

std::vector<ParameterRow> parameters_of_stimuli(const Manifest& manifest, Motions& motions) {
  std::vector<ParameterRow> rows;
  for (const Stimulus* source : motion_sources(manifest)) {
    const Stimulus& stimulus = *source;
    const Synthesis& made = motions.of(stimulus.id);
    if (!is_blend(stimulus)) continue;
    const Repertoire& repertoire = motions.repertoire();
    for (ParameterRow& row : parameters_of(made, repertoire)) {
      row.stimulus = stimulus.id;
      row.ratings = row.requested ? ratings_of(&stimulus, motions)
                                  : origin_text(repertoire.parameters.simulated);
      row.label = row.requested ? label_of(row.name, stimulus, repertoire)
                                : rating_label(row.name, repertoire.scales);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<FoundFault> found_faults(const Manifest& manifest, Motions& motions) {
  std::vector<FoundFault> rows;
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    const Synthesis& made = motions.of(stimulus->id);
    for (const motion::Finding& finding : made.findings)
      rows.push_back({stimulus->id, made.motion.clip.frames_per_second, finding});
  }
  return rows;
}

}  // namespace

const StudyTable weights_table = study_table<weights_columns, blended_examples>;
const StudyTable clips_table = study_table<clips_columns, made_clips>;
const StudyTable parameters_table = study_table<parameters_columns, parameters_of_stimuli>;
const StudyTable findings_table = study_table<findings_columns, found_faults>;

}  // namespace mien::pipeline
