#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_pairs.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/manifest/ratings/simulated_raters/simulated_raters.h"
#include "pipeline/production/run/shown_moods.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/questionnaire/trial_subjects.h"

namespace mien::pipeline {

namespace {

std::vector<std::string> rated_stimuli(const Manifest& manifest) {
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  };
  for (const auto& stimuli : trial_subjects(manifest).stimuli) std::ranges::for_each(stimuli, add);
  std::ranges::for_each(questionnaire_of(manifest).practice, add);
  return ids;
}

/// Reads a table of assumed ratings and collects its faults.
class TruthReader {
 public:
  TruthReader(const Manifest& manifest, const CsvTable& table)
      : table_(table),
        scales_(questionnaire_scales(manifest)),
        stimuli_(rated_stimuli(manifest)),
        is_continuous_(questionnaire_of(manifest).trials->is_continuous) {
    for (const Scale& scale : scales_.scales) names_.push_back(scale.id);
    const TrialForm& form = *questionnaire_of(manifest).trials;
    if (form.is_detection) names_.emplace_back(form.item);
  }

  AssumedTruth read() {
    const auto column = [&](const char* name) {
      return static_cast<std::size_t>(require_column(table_, name));
    };
    const std::size_t stimulus = column("stimulus"), scale = column("scale"),
                      value = column("value");
    const int from = find_column(table_, "from_s");
    AssumedTruth truth;
    std::map<std::pair<std::string, std::string>, std::map<double, double>> steps;
    for (const std::vector<CsvField>& row : table_.rows) {
      check_known_name(row[stimulus], "stimulus", stimuli_);
      check_known_name(row[scale], "scale", names_);
      const double rating = number(row[value], row[scale].text);
      const std::pair named = {row[stimulus].text, row[scale].text};
      truth.ratings[named] = rating;
      if (from >= 0) add_step(row[static_cast<std::size_t>(from)], rating, steps[named]);
    }
    if (!faults_.empty()) throw Faults(std::move(faults_));
    for (const auto& [named, course] : steps) {
      truth.ratings[named] = course.begin()->second;
      for (auto step = std::next(course.begin()); step != course.end(); ++step)
        truth.courses[named].push_back({step->first, step->second});
    }
    return truth;
  }

 private:
  /// The rating from a time of the video on; an empty field is its beginning.
  void add_step(const CsvField& field, double rating, std::map<double, double>& course) {
    double from_s = 0.0;
    if (!field.text.empty()) {
      const auto given = motion::as_finite_number(field.text);
      if (!given || *given < 0.0 || *given > longest_trace_seconds)
        add(field, fmt::format("{} is no time of a video", motion::in_quotes(field.text)),
            fmt::format("write seconds from 0 to {:g}", longest_trace_seconds));
      else if (*given > 0.0 && !is_continuous_)
        add(field, "ratings change while a video plays in continuous trials only",
            "omit the column from_s");
      from_s = given.value_or(0.0);
    }
    if (!course.emplace(from_s, rating).second)
      add(field, fmt::format("a second rating from {:g} s on", from_s), "state each time once");
  }

  void add(const CsvField& field, std::string wrong, std::string remedy) {
    faults_.push_back({place_of(table_, field), "", std::move(wrong), std::move(remedy)});
  }

  void check_known_name(const CsvField& field, const char* what,
                        const std::vector<std::string>& known) {
    if (std::ranges::find(known, field.text) != known.end()) return;
    add(field, fmt::format("the questionnaire has no {} {}", what, motion::in_quotes(field.text)),
        motion::did_you_mean(field.text, known));
  }

  double number(const CsvField& field, const std::string& scale) {
    double value = 0.0;
    try {
      value = number_in(table_, field);
    } catch (const Error& error) {
      faults_.push_back({{}, "", error.what(), ""});
      return value;
    }
    const Scale* range = find_scale(scales_, scale);
    if (range != nullptr && (value < range->least || value > range->most))
      add(field, fmt::format("{} is outside the scale", field.text),
          fmt::format("write a number from {:g} to {:g}", range->least, range->most));
    return value;
  }

  const CsvTable& table_;
  ScaleSet scales_;
  std::vector<std::string> stimuli_;
  std::vector<std::string> names_;
  bool is_continuous_;
  std::vector<Fault> faults_;
};

StatedTruth signal_truth(const Manifest& manifest) {
  StatedTruth truth;
  for (const std::string& id : signal_stimuli(manifest))
    truth[{id, std::string(questionnaire_of(manifest).trials->item)}] = 1.0;
  return truth;
}

/// The mean answer of simulated raters (simulated_raters.cpp).
double rating_of(const Scale& scale, const StyleProfile& profile) {
  const StyleProfile loadings = loadings_of(scale);
  double impression = 0.0;
  for (std::size_t i = 0; i < loadings.size(); ++i) impression += loadings[i] * profile[i];
  return 0.5 * (scale.least + scale.most) +
         0.5 * (scale.most - scale.least) * std::tanh(1.2 * impression);
}

/// A table of all stimuli on all scales, or the first of them, with values across each scale.
std::string example_of_truth(const Manifest& manifest) {
  constexpr std::size_t most_rows = 40;
  const std::vector<std::string> stimuli = rated_stimuli(manifest);
  std::string table = "  stimulus,scale,value\n";
  std::size_t rows = 0;
  for (const Scale& scale : questionnaire_scales(manifest).scales) {
    for (std::size_t i = 0; i < stimuli.size() && rows < most_rows; ++i, ++rows) {
      const double share = static_cast<double>(i + 1) / static_cast<double>(stimuli.size() + 1);
      const double value = scale.least + share * (scale.most - scale.least);
      table +=
          fmt::format("  {},{},{:g}\n", stimuli[i], scale.id, std::round(100.0 * value) / 100.0);
    }
  }
  return table;
}

/// Horizontal speeds of the root over half a second around each frame, metres per second.
std::vector<double> walking_speeds(const motion::Clip& walk) {
  const int half = std::max(1, static_cast<int>(std::lround(0.25 * walk.frames_per_second)));
  std::vector<double> speeds;
  for (int frame = 0; frame < walk.frame_count(); ++frame) {
    const int from = std::max(0, frame - half);
    const int to = std::min(walk.frame_count() - 1, frame + half);
    motion::Vec3 way = walk.poses[static_cast<std::size_t>(to)].root_position -
                       walk.poses[static_cast<std::size_t>(from)].root_position;
    way.y() = 0.0;
    speeds.push_back(way.norm() * walk.frames_per_second / std::max(1, to - from));
  }
  return speeds;
}

/// Keeps the part of a walk that shows its mood wherever it comes on the way: without standing at
/// its ends and, after a change of mood, without the second in which the walker changes over. A
/// walk of which less than a second would remain is left as it is.
void keep_steady_part(motion::Example& walk, bool is_after_change) {
  const motion::Clip& clip = walk.clip;
  if (clip.loops || clip.frame_count() < 2) return;
  const std::vector<double> speeds = walking_speeds(clip);
  std::vector<double> sorted = speeds;
  std::ranges::sort(sorted);
  const double walking = 0.5 * sorted[sorted.size() / 2];
  const auto second = static_cast<int>(std::lround(clip.frames_per_second));
  int first = is_after_change ? std::min(second, clip.frame_count() - 1) : 0;
  int last = clip.frame_count() - 1;
  while (first < last && speeds[static_cast<std::size_t>(first)] < walking) ++first;
  while (last > first && speeds[static_cast<std::size_t>(last)] < walking) --last;
  if (last - first < second) return;
  walk.clip = motion::cut(clip, first, last);
  walk.keytimes = {0.0, walk.clip.duration_seconds()};
}

}  // namespace

AssumedTruth read_truth(const Manifest& manifest, const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  return TruthReader(manifest, table).read();
}

void refuse_scales_without_model(const Manifest& manifest) {
  const TrialForm& form = *questionnaire_of(manifest).trials;
  if (form.has_key("signal")) return;
  std::vector<std::string> unknown;
  for (const Scale& scale : questionnaire_scales(manifest).scales)
    if (!has_loadings(scale)) unknown.push_back(motion::in_quotes(scale.id));
  if (unknown.empty()) return;
  throw Error(fmt::format("simulated raters have no model of {}", fmt::join(unknown, ", ")),
              fmt::format("state the true mean ratings with --truth truth.csv, a table such as\n{}"
                          "(stimuli that are not in it have the middle of the scale), or add "
                          "`loadings:` to the scales, for example {{activeness: 0.6}}",
                          example_of_truth(manifest)));
}

AssumedTruth measured_truth(const Manifest& manifest) {
  const TrialForm& form = *questionnaire_of(manifest).trials;
  if (form.has_key("signal")) return {.ratings = signal_truth(manifest), .courses = {}};
  const ScaleSet scales = questionnaire_scales(manifest);
  Motions motions(manifest);
  motion::ExampleSet set;
  std::vector<double> starts;  // of the motions, seconds of their videos
  for (const std::string& id : rated_stimuli(manifest)) {
    const Stimulus* stimulus = form.is_continuous ? motions.stimulus(id) : nullptr;
    if (stimulus != nullptr) {
      for (MoodStretch& stretch : mood_stretches(motions, *stimulus)) {
        keep_steady_part(stretch.motion, stretch.from_s > 0.0);
        set.examples.push_back(std::move(stretch.motion));
        starts.push_back(stretch.from_s);
      }
    }
    if (!set.examples.empty() && set.examples.back().name == id) continue;
    for (const Stimulus* motion : motions_in(*motions.stimulus(id))) {
      set.examples.push_back(motions.of(motion->id).motion);
      set.examples.back().name = id;
      if (stimulus != nullptr && stimulus->walk) keep_steady_part(set.examples.back(), false);
      starts.push_back(0.0);
    }
  }
  AssumedTruth truth;
  const std::vector<StyledStimulus> profiles = measured_profiles(set);
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const StyledStimulus& stimulus = profiles[i];
    // Several people are rated by their mean.
    const Stimulus* shown = motions.stimulus(stimulus.name);
    const auto people = shown == nullptr ? 1.0 : static_cast<double>(motions_in(*shown).size());
    if (form.is_detection)
      truth.ratings[{stimulus.name, std::string(form.item)}] +=
          std::accumulate(stimulus.profile.begin(), stimulus.profile.end(), 0.0) / people;
    for (const Scale& scale : scales.scales) {
      const double rating = rating_of(scale, stimulus.profile);
      if (starts[i] == 0.0)
        truth.ratings[{stimulus.name, scale.id}] += rating / people;
      else
        truth.courses[{stimulus.name, scale.id}].push_back({starts[i], rating});
    }
  }
  return truth;
}

}  // namespace mien::pipeline
