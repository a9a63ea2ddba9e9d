#include "pipeline/manifest/ratings/answers/counted_answers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

namespace {

/// A column there, and its name here.
struct CarriedColumn {
  const char* name;
  const char* as;
};

constexpr std::array carried_columns = {CarriedColumn{"participant", "participant"},
                                        CarriedColumn{"stimulus", "stimulus"},
                                        CarriedColumn{"item", "scale"},
                                        CarriedColumn{"value", "value"},
                                        CarriedColumn{"rt_ms", "rt_ms"},
                                        CarriedColumn{"comment", "comment"},
                                        CarriedColumn{"simulated", "simulated"}};

std::set<std::string> note_excluded(const std::vector<AnswerRow>& rows,
                                    std::vector<std::string>& notes) {
  std::set<std::string> excluded;
  for (const Attention& own : attention_of(rows)) {
    if (!own.is_excluded) continue;
    excluded.insert(own.participant);
    notes.push_back(fmt::format("participant {} is excluded: {} of {} attention checks passed",
                                motion::in_quotes(own.participant), own.passed, own.checks));
  }
  return excluded;
}

constexpr int slider = 0;        ///< raw answers from 0 to 100
constexpr int most_points = 21;  ///< of a form that is tried

/// A raw answer and the share of the scale, from its left, that its value stands for.
struct RawAnswer {
  const AnswerRow* row = nullptr;
  double raw = 0.0;
  double share = 0.0;

  bool fits(int form) const {
    const double given = form == slider ? raw / 100.0 : (raw - 1.0) / (form - 1.0);
    return std::abs(given - share) <= 1e-6;
  }
};

std::vector<RawAnswer> raw_answers(const std::vector<AnswerRow>& rows, const ScaleSet& scales) {
  std::map<std::string, const Scale*> known;
  for (const Scale& scale : scales.scales) known.emplace(scale.id, &scale);
  std::vector<RawAnswer> answers;
  for (const AnswerRow& row : rows) {
    const auto scale = known.find(row.item);
    const auto raw = motion::as_finite_number(row.value_raw);
    const auto value = motion::as_finite_number(row.value);
    const bool is_usable = is_on_scale(row) && scale != known.end() && raw && value;
    if (!is_usable || row.pole_left.empty()) continue;
    const Scale& of = *scale->second;
    const double from_low = (*value - of.least) / (of.most - of.least);
    answers.push_back({&row, *raw, row.pole_left == "low" ? from_low : 1.0 - from_low});
  }
  return answers;
}

/// Nothing where not even half of the answers are of one form: the study's scales are then not
/// those of the questionnaire.
std::optional<int> form_of_most(const std::vector<RawAnswer>& answers) {
  int best = slider;
  std::ptrdiff_t most = -1;
  for (int form = slider; form <= most_points; ++form) {
    if (form == 1) continue;
    std::ptrdiff_t fitting = 0;
    for (const RawAnswer& answer : answers) fitting += answer.fits(form) ? 1 : 0;
    if (fitting > most) best = form;
    most = std::max(most, fitting);
  }
  if (2 * most < static_cast<std::ptrdiff_t>(answers.size())) return std::nullopt;
  return best;
}

}  // namespace

bool is_on_scale(const AnswerRow& row) {
  // A trial that asks which emotion is seen may ask scales too.
  const TrialForm* form = find_trial_form(row.kind);
  return form != nullptr && form->is_on_scale && row.item != form->item;
}

CountedAnswers counted_answers(const CsvTable& table, const ScaleSet& scales) {
  CountedAnswers counted;
  std::vector<AnswerRow> rows = answer_rows(table, DuplicateAnswers::refused, &counted.warnings);
  const std::vector<Fault> faults = contradicted_values(rows, scales);
  if (!faults.empty()) throw Faults(faults);
  counted.notes = separate_participants(rows);
  const std::set<std::string> excluded = note_excluded(rows, counted.notes);
  counted.table.file = table.file;
  std::vector<std::size_t> indices;
  for (const CarriedColumn& column : carried_columns) {
    indices.push_back(static_cast<std::size_t>(require_column(table, column.name)));
    const CsvField& head = table.header[indices.back()];
    counted.table.header.push_back({column.as, head.line, head.column});
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_rating = rows[i].counts() && is_on_scale(rows[i]);
    if (!is_rating || excluded.contains(rows[i].participant)) continue;
    std::vector<CsvField> fields;
    for (const std::size_t index : indices) fields.push_back(table.rows[i][index]);
    fields.front().text = rows[i].participant;
    counted.table.rows.push_back(std::move(fields));
  }
  if (counted.table.rows.empty())
    throw Error(Place{table.file, 1, 1}, "holds no ratings to analyse",
                "ratings in practice, warm-up and check trials and of participants who failed "
                "checks are ignored");
  return counted;
}

std::vector<Fault> contradicted_values(const std::vector<AnswerRow>& rows, const ScaleSet& scales) {
  const std::vector<RawAnswer> answers = raw_answers(rows, scales);
  const std::optional<int> form = form_of_most(answers);
  std::vector<Fault> faults;
  if (!form) return faults;
  for (const RawAnswer& answer : answers) {
    if (answer.fits(*form)) continue;
    faults.push_back(
        {answer.row->place, "",
         fmt::format(
             "the value {} does not correspond to the raw answer {} with the {} pole on the left",
             answer.row->value, answer.row->value_raw, answer.row->pole_left),
         "use the file as written by the questionnaire"});
  }
  return faults;
}

std::vector<Attention> attention_of(const std::vector<AnswerRow>& rows, const AttentionRule& rule) {
  std::vector<Attention> all;
  std::map<std::string, std::size_t> index;
  for (const AnswerRow& row : rows) {
    const auto [found, is_new] = index.emplace(row.participant, all.size());
    if (is_new) all.push_back({.participant = row.participant});
    if (!row.passed || row.is_practice) continue;
    Attention& own = all[found->second];
    ++own.checks;
    own.passed += *row.passed ? 1 : 0;
  }
  for (Attention& own : all) own.is_excluded = own.checks - own.passed > rule.max_failed_checks;
  return all;
}

std::string to_sentence(const AttentionRule& rule) {
  if (rule.max_failed_checks == 0)
    return "Participants who failed any attention check were excluded with all of their answers.";
  return fmt::format(
      "Participants who failed more than {} attention check{} were excluded with all of their "
      "answers.",
      rule.max_failed_checks, rule.max_failed_checks == 1 ? "" : "s");
}

}  // namespace mien::pipeline
