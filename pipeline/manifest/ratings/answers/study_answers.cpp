#include "pipeline/manifest/ratings/answers/study_answers.h"

#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/manifest/ratings/answers/unknown_names.h"
#include "pipeline/manifest/ratings/answers/word_answers.h"

namespace mien::pipeline {

namespace {

/// The warning's sentence as a fault.
Fault fault_of(const Error& error) {
  const std::string place = to_string(error.place());
  return {error.place(), "", std::string(error.what()).substr(place.size() + 2), ""};
}

/// The fault without its place.
std::string sentence_of(Fault fault) {
  fault.place = {};
  return to_string(fault);
}

/// Reads the rows one by one; gathers faults and warnings.
class RowReader {
 public:
  RowReader(const CsvTable& table, const ScaleSet& scales,
            const std::vector<RatedExample>& examples, const AnswerRules& rules)
      : table_(table), rules_(rules), scales_(scales_by_id(scales)) {
    for (const Scale& scale : scales.scales) scale_ids_.push_back(scale.id);
    for (const RatedExample& example : examples) {
      stimulus_names_.push_back(example.name);
      examples_.emplace(example.name, example.name);
      if (!example.file_stem.empty()) examples_.emplace(example.file_stem, example.name);
    }
    stimulus_ = require_column(table, "stimulus");
    scale_ = require_column(table, "scale");
    value_ = require_column(table, "value");
    participant_ = find_column(table, "participant");
    simulated_ = find_column(table, "simulated");
    if (rules.plain) return;
    rt_ms_ = find_column(table, "rt_ms");
    order_ = find_column(table, "order");
    comment_ = find_column(table, "comment");
  }

  void read(const std::vector<CsvField>& row) {
    const CsvField& stimulus = row[static_cast<size_t>(stimulus_)];
    const CsvField& scale_name = row[static_cast<size_t>(scale_)];
    const std::string* example = example_named(stimulus.text);
    const Scale* scale = scale_named(scale_name.text);
    const bool is_left_out = rules_.left_out.contains(stimulus.text);
    if (example == nullptr && !is_left_out) unknown_stimuli_.note(stimulus);
    if (scale == nullptr) unknown_scales_.note(scale_name);
    if (example == nullptr || scale == nullptr) return;
    StudyAnswer answer;
    answer.participant = text_of(row, participant_);
    answer.stimulus = *example;
    answer.scale = scale->id;
    answer.comment = text_of(row, comment_);
    if (text_of(row, simulated_) != "" && text_of(row, simulated_) != "0") result.simulated = true;
    const CsvField& value = row[static_cast<size_t>(value_)];
    answer.place = place_of(table_, rules_.plain ? stimulus : value);
    try {
      add(std::move(answer), row, value, *scale);
    } catch (const Error& error) {
      faults.push_back(fault_of(error));
    }
  }

  void report_unknown() {
    unknown_stimuli_.report(table_, stimulus_names_, rules_, faults, result.warnings);
    unknown_scales_.report(table_, scale_ids_, rules_, faults, result.warnings);
  }

  StudyAnswers result;
  std::vector<StudyAnswer> left_empty;
  std::vector<Fault> faults;

 private:
  /// Null when there is none; without examples, answers are about whatever they name.
  const std::string* example_named(const std::string& text) const {
    if (examples_.empty()) return &text;
    const auto found = examples_.find(text);
    return found == examples_.end() ? nullptr : &found->second;
  }

  const Scale* scale_named(const std::string& text) const {
    const auto found = scales_.find(text);
    return found == scales_.end() ? nullptr : found->second;
  }

  void add(StudyAnswer answer, const std::vector<CsvField>& row, const CsvField& value,
           const Scale& scale) {
    answer.rt_ms = optional_number(row, rt_ms_);
    answer.order = optional_number(row, order_);
    check_time(row, answer);
    if (value.text.empty() || value.text == "NA") {
      left_empty.push_back(std::move(answer));
      return;
    }
    answer.value = value_in(value, scale);
    result.answers.push_back(std::move(answer));
  }

  static std::string text_of(const std::vector<CsvField>& row, int column) {
    return column < 0 ? std::string() : row[static_cast<size_t>(column)].text;
  }

  std::optional<double> optional_number(const std::vector<CsvField>& row, int column) const {
    const std::string text = text_of(row, column);
    if (text.empty() || text == "NA") return std::nullopt;
    return number_in(table_, row[static_cast<size_t>(column)]);
  }

  void check_time(const std::vector<CsvField>& row, const StudyAnswer& answer) const {
    if (!answer.rt_ms || *answer.rt_ms >= 0.0) return;
    throw Error(place_of(table_, row[static_cast<size_t>(rt_ms_)]),
                fmt::format("{} ms is not a valid response time", *answer.rt_ms),
                "write milliseconds from 0 up, or leave the field empty");
  }

  double value_in(const CsvField& field, const Scale& scale) const {
    const double value = number_in(table_, field);
    if (value >= scale.least && value <= scale.most) return value;
    throw Error(place_of(table_, field),
                fmt::format("{} is outside the range of {}", motion::excerpt(field.text),
                            motion::in_quotes(scale.id)),
                fmt::format("answers go from {} to {}; state another range in the scales file",
                            scale.least, scale.most));
  }

  const CsvTable& table_;
  const AnswerRules& rules_;
  std::unordered_map<std::string_view, const Scale*> scales_;
  std::vector<std::string> scale_ids_;
  std::vector<std::string> stimulus_names_;
  std::map<std::string, std::string> examples_;
  int stimulus_, scale_, value_, participant_, simulated_;
  int rt_ms_ = -1;
  int order_ = -1;
  int comment_ = -1;
  UnknownNames unknown_stimuli_{"stimulus", "stimuli"};
  UnknownNames unknown_scales_{"scale", "scales"};
};

}  // namespace

StudyAnswers study_answers(const CsvTable& table, const ScaleSet& scales,
                           const std::vector<RatedExample>& examples, const AnswerRules& rules) {
  if (holds_answer_rows(table)) {
    CountedAnswers counted = counted_answers(table, scales);
    StudyAnswers study = study_answers(counted.table, scales, examples, rules);
    for (const Fault& renamed : counted.warnings)
      study.warnings.push_back({"former-name", renamed.place, sentence_of(renamed)});
    for (std::string& sentence : counted.notes)
      study.warnings.push_back({"left-out", {}, std::move(sentence)});
    return study;
  }
  if (holds_words(table)) {
    throw Error(place_of(table, table.header.front()),
                "free-text answers instead of answers on scales",
                "convert them with mien study words");
  }
  RowReader reader(table, scales, examples, rules);
  for (const auto& row : table.rows) reader.read(row);
  reader.report_unknown();
  StudyAnswers study = std::move(reader.result);
  settle_repeated(study, rules, reader.faults);
  if (!rules.plain) {
    settle_missing(study, reader.left_empty, rules.missing, reader.faults);
    settle_constant(study, scales, rules.constant);
  }
  if (!reader.faults.empty()) throw Faults(reader.faults);
  return study;
}

StudyAnswers read_study_answers(const std::filesystem::path& file, const ScaleSet& scales,
                                const std::vector<RatedExample>& examples,
                                const AnswerRules& rules) {
  return study_answers(read_csv(file), scales, examples, rules);
}

}  // namespace mien::pipeline
