#include "pipeline/ratings/answers.h"

#include <set>
#include <tuple>

#include <fmt/format.h>

#include "motion/text/nearest_word.h"
#include "pipeline/documents/csv.h"
#include "pipeline/ratings/word_answers.h"

namespace mien::pipeline {

namespace {

std::vector<std::string> scale_ids(const ScaleSet& scales) {
  std::vector<std::string> ids;
  for (const Scale& scale : scales.scales) ids.push_back(scale.id);
  return ids;
}

const Scale& scale_in(const CsvTable& table, const CsvField& field, const ScaleSet& scales) {
  const Scale* scale = find_scale(scales, field.text);
  if (scale) return *scale;
  throw Error(place_of(table, field), fmt::format("unknown scale \"{}\"", field.text),
              motion::did_you_mean(field.text, scale_ids(scales)));
}

double value_in(const CsvTable& table, const CsvField& field, const Scale& scale) {
  const double value = number_in(table, field);
  if (value >= scale.least && value <= scale.most) return value;
  throw Error(place_of(table, field),
              fmt::format("{} is outside the range of \"{}\"", field.text, scale.id),
              fmt::format("answers go from {} to {}; state another range in the scales file",
                          scale.least, scale.most));
}

Answers answers_of(const CsvTable& table, const ScaleSet& scales) {
  if (table.rows.empty()) {
    throw Error(Place{table.file}, "holds no answers", "add rows below the header");
  }
  if (holds_words(table)) return answers_from_words(table, scales, Unmentioned::neutral).answers;
  const auto stimulus = static_cast<size_t>(require_column(table, "stimulus"));
  const auto scale_column = static_cast<size_t>(require_column(table, "scale"));
  const auto value = static_cast<size_t>(require_column(table, "value"));
  const int participant = find_column(table, "participant");
  const int simulated = find_column(table, "simulated");
  Answers result;
  std::set<std::tuple<std::string, std::string, std::string>> seen;
  for (const auto& row : table.rows) {
    const Scale& scale = scale_in(table, row[scale_column], scales);
    Answer answer;
    if (participant >= 0) answer.participant = row[static_cast<size_t>(participant)].text;
    answer.stimulus = row[stimulus].text;
    answer.scale = scale.id;
    answer.value = value_in(table, row[value], scale);
    if (simulated >= 0 && row[static_cast<size_t>(simulated)].text != "0") result.simulated = true;
    if (!seen.emplace(answer.participant, answer.stimulus, answer.scale).second) {
      throw Error(place_of(table, row[stimulus]),
                  fmt::format("a second answer{} about \"{}\" on \"{}\"",
                              answer.participant.empty()
                                  ? std::string()
                                  : fmt::format(" of participant \"{}\"", answer.participant),
                              answer.stimulus, answer.scale),
                  "keep one of them");
    }
    result.answers.push_back(std::move(answer));
  }
  return result;
}

}  // namespace

Answers read_answers(const std::filesystem::path& file, const ScaleSet& scales) {
  return answers_of(read_csv(file), scales);
}

Answers parse_answers(std::string_view csv, const std::string& file, const ScaleSet& scales) {
  return answers_of(parse_csv(csv, file), scales);
}

std::string to_csv(const Answers& answers) {
  std::vector<std::string> header = {"participant", "stimulus", "scale", "value"};
  if (answers.simulated) header.emplace_back("simulated");
  CsvWriter writer(header);
  for (const Answer& answer : answers.answers) {
    std::vector<std::string> row = {answer.participant, answer.stimulus, answer.scale,
                                    shortest(answer.value)};
    if (answers.simulated) row.emplace_back("1");
    writer.row(row);
  }
  return writer.text();
}

}  // namespace mien::pipeline
