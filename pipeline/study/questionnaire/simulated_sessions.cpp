#include "pipeline/study/questionnaire/simulated_sessions.h"

#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/ratings/answers/best_worst_item.h"
#include "pipeline/manifest/ratings/answers/grid_item.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/manifest/study_texts.h"
#include "pipeline/study/questionnaire/adaptive_part.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/trials/trial_kind.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

/// Range of the scales whose standard deviations usual_spread states.
constexpr double usual_range = 4.0;

/// The session of a simulated participant.
class SimulatedSession {
 public:
  SimulatedSession(const Manifest& manifest, const SessionPlan& plan, const StatedTruth& truth,
                   const SimulatedParticipants& people, const TruthCourses& courses,
                   const ResponseScales& scales)
      : manifest_(manifest),
        plan_(plan),
        truth_(truth),
        people_(people),
        courses_(courses),
        scales_(scales) {}

  void add_rows(std::vector<AnswerRow>& rows) const {
    for (const Trial& trial : plan_.trials)
      for (const TrialItem& item : trial.items) rows.push_back(row_of(trial, item));
  }

  /// The rows of a session with adaptive trials, without those of tracks that have ended.
  void add_adaptive_rows(const TrackProcedure& procedure, const TrackLevels& levels,
                         std::vector<AnswerRow>& rows) const {
    const PsychometricFunction observer =
        simulated_observer(manifest_, procedure, people_.observers, plan_.seed);
    std::map<int, std::vector<TrackAnswer>> answers;
    for (const Trial& trial : plan_.trials) {
      if (trial.adaptive.positive.empty()) {
        for (const TrialItem& item : trial.items) rows.push_back(row_of(trial, item));
        continue;
      }
      const double chance = uniform(plan_.seed, fmt::format("observer/{}", trial.number));
      if (!trial.is_adaptive()) {
        rows.push_back(adaptive_row(trial, chance < observer.guess));
        continue;
      }
      std::vector<TrackAnswer>& own = answers[trial.adaptive.track];
      const auto place = levels.next(own);
      if (!place) continue;
      const double positive = answer_probability(observer, procedure.ease[*place]).positive;
      own.push_back({*place, chance < positive});
      rows.push_back(adaptive_row(shown_at(trial, *place, procedure.levels), chance < positive));
    }
  }

 private:
  AnswerRow row_of(const Trial& trial, const TrialItem& item) const {
    AnswerRow row = empty_row(trial, item);
    answer(trial, item, row);
    return row;
  }

  AnswerRow adaptive_row(const Trial& trial, bool is_positive) const {
    const TrialItem& item = trial.items.front();
    AnswerRow row = empty_row(trial, item);
    const Question question = {trial, item, nullptr, plan_.choices};
    row.value_raw = trial.adaptive.positive;
    for (const std::string& other : trial.kind->attention_answers(question))
      if (!is_positive && other != trial.adaptive.positive) row.value_raw = other;
    trial.kind->complete(question, row);
    return row;
  }

  AnswerRow empty_row(const Trial& trial, const TrialItem& item) const {
    AnswerRow row;
    row.participant = plan_.participant;
    row.session = "simulated";
    set_trial_columns(trial, row);
    row.item = item.item;
    row.rt_ms = std::round(1000.0 * people_.answer_seconds *
                           std::exp(0.4 * normal(plan_.seed, name("time", trial, item))));
    row.seed = plan_.seed;
    row.simulated = true;
    return row;
  }

  static std::string name(const char* what, const Trial& trial, const TrialItem& item) {
    return fmt::format("{}/{}/{}", what, trial.number, item.item);
  }

  void answer(const Trial& trial, const TrialItem& item, AnswerRow& row) const {
    const ResponseScale* scale = find_scale(scales_, item.item);
    const Question question = {trial, item, scale, plan_.choices};
    if (trial.is_attention_check()) {
      row.passed =
          uniform(plan_.seed, name("attention", trial, item)) < people_.attention_pass_rate;
      row.value_raw = *row.passed ? trial.expected : missed(question);
      row.value = row.value_raw;
      return;
    }
    row.value_raw = trial.kind->simulated(question, view_of(question));
    trial.kind->complete(question, row);
    if (scale == nullptr || scale->words || !trial.kind->form->is_on_scale) return;
    if (trial.kind->form->is_continuous) return;
    row.pole_left = item.flipped ? "high" : "low";
    row.value = shortest(written_value_of_raw(*scale, std::stod(row.value_raw), item.flipped));
  }

  SimulatedView view_of(const Question& question) const {
    const auto& [trial, item, scale, choices] = question;
    const double rate =
        trial.kind->form->is_grid ? people_.reference_recognition_rate : people_.recognition_rate;
    SimulatedView view = {
        .opinion = [this, question](std::size_t which) { return opinion(question, which); },
        .shown = level_of(manifest_, trial.stimuli[0], item.item),
        .is_recognised = uniform(plan_.seed, name("seen", trial, item)) < rate,
        .chance = uniform(plan_.seed, name("chosen", trial, item))};
    if (trial.kind->form->is_continuous) add_trace_view(trial, item, view);
    return view;
  }

  /// Deviations are a first-order autoregressive process.
  void add_trace_view(const Trial& trial, const TrialItem& item, SimulatedView& view) const {
    constexpr double correlation_seconds = 1.0, share_of_residual = 0.5;
    const auto film = people_.film_seconds.find(trial.stimuli[0]);
    view.film_seconds = film == people_.film_seconds.end() ? usual_video_seconds : film->second;
    view.reaction_lag_s = people_.reaction_lag_s;
    if (const auto course = courses_.find({trial.stimuli[0], item.item});
        course != courses_.end()) {
      const auto first = truth_.find(course->first);
      double before = first == truth_.end() ? 0.0 : first->second;
      for (const TruthStep& step : course->second) {
        view.changes.push_back({step.from_s, step.value - before});
        before = step.value;
      }
    }
    const double kept = std::exp(-1.0 / (trace_rate_hz * correlation_seconds));
    const double deviation = share_of_residual * spread_on(find_scale(scales_, item.item)).residual;
    const std::uint64_t stream = hashed_seed(plan_.seed, name("wander", trial, item));
    double now = deviation * normal_number(stream, 0);
    for (std::size_t k = 0; k < trace_samples(view.film_seconds); ++k) {
      view.wander.push_back(now);
      now = kept * now + deviation * std::sqrt(1.0 - kept * kept) * normal_number(stream, k + 1);
    }
  }

  /// The participant's opinion of a stimulus of the trial, in the scale's own range; without scale
  /// an observation with a standard deviation of 1.
  double opinion(const Question& question, std::size_t which) const {
    const Trial& trial = question.trial;
    // Best and worst are chosen by the same opinions, and grids ask one scale in every place.
    TrialItem item = question.item;
    if (const auto part = best_worst_item(item.item); part && trial.kind->form->is_set)
      item.item = part->scale;
    if (const auto part = grid_item(item.item); part && trial.kind->form->is_grid)
      item.item = part->scale;
    const ResponseScale* scale = find_scale(scales_, item.item);
    const std::string& stimulus = trial.stimuli[which];
    const auto known = truth_.find({stimulus, item.item});
    const double middle = scale == nullptr ? 0.0 : 0.5 * (scale->least + scale->most);
    const double mean = known != truth_.end() ? known->second : middle;
    const RatingSpread spread = spread_on(scale);
    const double response_bias = spread.participant * normal(plan_.seed, "lean/" + item.item);
    // The same stimulus is observed anew when it is shown a second time in a trial.
    const bool is_again = which > 0 && stimulus == trial.stimuli[0];
    const std::string rest_name =
        name("rest", trial, item) + "/" + stimulus + (is_again ? "/again" : "");
    const double deviation = scale == nullptr ? 1.0 : spread.residual;
    return mean + response_bias + deviation * normal(plan_.seed, rest_name);
  }

  /// Detection has no scale; its observations have standard deviations of 1.
  RatingSpread spread_on(const ResponseScale* scale) const {
    if (people_.spread) return *people_.spread;
    return usual_spread(scale == nullptr ? usual_range : scale->most - scale->least);
  }

  /// A wrong answer to an attention check.
  static std::string missed(const Question& question) {
    for (const std::string& answer : question.trial.kind->attention_answers(question))
      if (answer != question.trial.expected) return answer;
    return "no";
  }

  const Manifest& manifest_;
  const SessionPlan& plan_;
  const StatedTruth& truth_;
  const SimulatedParticipants& people_;
  const TruthCourses& courses_;
  const ResponseScales& scales_;
};

/// A questionnaire with the names that its keys had at first, as the column `is_check` of plans has
/// in design_hash: renaming a key must not change the hash of a study in progress.
OrderedJson with_former_keys(const OrderedJson& questionnaire) {
  OrderedJson former = OrderedJson::object();
  for (const auto& [key, value] : questionnaire.items())
    former[key == "retest" ? "catch" : key == "no_repeats" ? "apart" : key] = value;
  return former;
}

/// The names of the ends of all scales in a language.
std::string words_of_scales(const Manifest& manifest, const std::string& language) {
  std::string words = language + "\n";
  for (const Scale& scale : questionnaire_scales(manifest).scales)
    if (const auto ends = ends_in(scale, language))
      words += fmt::format("{}|{}\n", (*ends)[0], (*ends)[1]);
  return words;
}

}  // namespace

RatingSpread usual_spread(double range) {
  const double ranges = range / usual_range;
  return {.participant = 0.3 * ranges, .stimulus = 0.0, .residual = 0.7 * ranges};
}

std::vector<AnswerRow> simulated_sessions(const Manifest& manifest,
                                          const std::vector<SessionPlan>& plans,
                                          const StatedTruth& truth,
                                          const SimulatedParticipants& people,
                                          const TruthCourses& courses) {
  const ResponseScales scales = response_scales_by_item(manifest);
  // The hash of the study as planned, whatever the number of plans: further participants change
  // nothing for earlier ones.
  const std::string design = design_hash(manifest, plan_sessions(manifest));
  std::vector<AnswerRow> rows;
  std::optional<TrackProcedure> procedure;
  std::optional<TrackLevels> levels;
  if (!questionnaire_of(manifest).adaptive.empty())
    levels.emplace(procedure.emplace(track_procedure(manifest)));
  for (const SessionPlan& plan : plans) {
    const SimulatedSession session(manifest, plan, truth, people, courses, scales);
    if (levels)
      session.add_adaptive_rows(*procedure, *levels, rows);
    else
      session.add_rows(rows);
  }
  for (AnswerRow& row : rows) row.design = design;
  return rows;
}

std::string design_hash(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  Questionnaire questionnaire = questionnaire_of(manifest);
  // None of these affects a session. Texts count by content, not by the file that they were read
  // from.
  questionnaire.pace = {};
  questionnaire.screening.quotas = {};
  questionnaire.analysis = {};
  const Recruitment recruitment = std::exchange(questionnaire.recruitment, {});
  visit_texts(questionnaire, [](const std::string&, auto& text) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(text)>, TextSource>) {
      text.file.clear();
      for (auto& [language, translated] : text.by_language) translated.file.clear();
    }
  });
  const OwnTexts own = std::exchange(questionnaire.texts, {});
  questionnaire.scales.file.clear();
  std::string all = title_of(manifest) + "\n" +
                    with_former_keys(written(questionnaire, WritingOptions{})).dump() + "\n";
  // What is kept of participants counts, but not where they are sent to.
  if (const auto kept = kept_parameters(recruitment); !kept.empty())
    all += fmt::format("{}|{}\n", fmt::join(kept, "|"), recruitment.pseudonymise);
  for (const Scale& scale : questionnaire_scales(manifest).scales)
    all +=
        fmt::format("{}|{}|{}|{}|{}|{}|{}\n", scale.id, scale.low, scale.high, scale.japanese_low,
                    scale.japanese_high, shortest(scale.least), shortest(scale.most));
  for (const PageTexts& texts : own.texts) all += texts.language + texts.texts.dump() + "\n";
  for (const std::string& language : questionnaire.language.offered)
    if (questionnaire.language.by_browser) all += words_of_scales(manifest, language);
  for (const SessionPlan& plan : plans) all += fmt::format("{}\n", fmt::join(plan.choices, "|"));
  // Plans had no column `track` at first, the last one now. It is empty without adaptive trials.
  std::string plans_text = plans_csv(plans);
  for (std::size_t end = plans_text.find(",track\n"); end != std::string::npos;
       end = plans_text.find(",\n", end))
    plans_text.erase(end, plans_text.find('\n', end) - end);
  constexpr std::string_view check_column = "is_check";
  plans_text.replace(plans_text.find(check_column), check_column.size(), "is_catch");
  return hash_of(all + plans_text);
}

}  // namespace mien::pipeline
