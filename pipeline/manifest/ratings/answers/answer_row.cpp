#include "pipeline/manifest/ratings/answers/answer_row.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

namespace {

constexpr std::array answer_row_columns = {
    Column{"participant", "", "who answered: the place in the design, no name"},
    Column{"session", "", "random name of the browser session in which the answer was given"},
    Column{"trial", "", "number of the trial in the participant's order, from 1"},
    Column{"block", "", "practice, main, or the level of the factor that the order is blocked by"},
    Column{"kind", "", "rating, emotion (which of a list), pair (which of two) or attention"},
    Column{"stimulus", "", "the stimulus that was rated; of a pair the one at the left"},
    Column{"stimulus_sha256", "", "SHA-256 of the media that was shown"},
    Column{"against", "", "the reference that was shown beside, or the other stimulus of a pair"},
    Column{"item", "", "the scale that was answered on; emotion where one of a list was chosen"},
    Column{"value_raw", "",
           "the answer as given: place from the left from 1 (points) or 0–100 (slider), the word "
           "that was chosen or written, left or right"},
    Column{"value", "",
           "the answer re-oriented into the scale's own range, its high pole being the most; or "
           "the emotion or stimulus that was chosen"},
    Column{"pole_left", "", "which pole was at the left: low or high"},
    Column{"rt_ms", "ms", "time from when the answer could be given until it was"},
    Column{"is_practice", "", "1 for practice trials, which are not analysed"},
    Column{"is_warmup", "", "1 for the first trials of the main part that are not analysed"},
    Column{"is_catch", "", "1 for attention checks and repeated stimuli"},
    Column{"expected", "", "the raw answer that passes the check"},
    Column{"passed", "", "1 when the check was passed, 0 when not; empty without a check"},
    Column{"replays", "", "how often the video was played again"},
    Column{"trial_ms", "ms", "time from the beginning of the trial to its end"},
    Column{"play_start_ms", "ms", "time from the beginning of the trial until the video played"},
    Column{"ended_ms", "ms", "time from the beginning of the trial until the video had ended"},
    Column{"stalls", "", "how often the video stopped for want of data"},
    Column{"stall_ms", "ms", "how long it stood still"},
    Column{"dropped_frames", "", "frames that the browser did not show"},
    Column{"blurs", "", "how often the window was left during the trial"},
    Column{"viewport_width", "px", "width of the browser's page"},
    Column{"viewport_height", "px", "height of the browser's page"},
    Column{"refresh_hz", "Hz", "measured refresh rate of the screen"},
    Column{"comment", "", "what the participant wrote about the video; on a trial's first row"},
    Column{"seed", "", "seed of the participant's order"},
    Column{"design", "", "hash of the questionnaire that was run"},
    Column{"simulated", "", "1 for answers that nobody gave"},
};

template <class Number>
std::string text_or_empty(const std::optional<Number>& number) {
  return number ? shortest(static_cast<double>(*number)) : "";
}

/// Fills rows from fields and gathers what is wrong with them.
class AnswerRowReader {
 public:
  explicit AnswerRowReader(const CsvTable& table) : table_(table) {
    for (const Column& column : answer_row_columns) {
      const int index = find_column(table, column.name);
      if (index < 0) {
        faults.push_back({place_of(table, table.header.front()), "",
                          fmt::format("there is no column {}", motion::in_quotes(column.name)),
                          "give the file that the questionnaire wrote, with all of its columns"});
      }
      index_.emplace(column.name, index);
    }
    if (faults.empty() && table.rows.empty())
      faults.push_back({Place{table.file, 1, 1}, "", "holds no answers",
                        "give the file once somebody has answered"});
  }

  AnswerRow row(const std::vector<CsvField>& fields) {
    fields_ = &fields;
    AnswerRow row;
    row.participant = needed("participant");
    row.session = text("session");
    row.trial = whole("trial").value_or(0);
    if (row.trial < 1 && !text("trial").empty() && is_number("trial"))
      fault("trial", fmt::format("there is no trial {}", motion::excerpt(text("trial"))),
            "trials count from 1");
    if (text("trial").empty()) needed("trial");
    row.block = text("block");
    row.kind = one_of("kind", answer_kinds);
    row.stimulus = row.kind == "attention" ? text("stimulus") : needed("stimulus");
    row.stimulus_sha256 = text("stimulus_sha256");
    row.against = text("against");
    row.item = row.kind == "attention" ? text("item") : needed("item");
    row.value_raw = text("value_raw");
    row.value = text("value");
    row.pole_left = text("pole_left");
    if (!row.pole_left.empty()) one_of("pole_left", std::array<std::string_view, 2>{"low", "high"});
    row.is_practice = truth("is_practice").value_or(false);
    row.is_warmup = truth("is_warmup").value_or(false);
    row.is_catch = truth("is_catch").value_or(false);
    row.expected = text("expected");
    row.passed = truth("passed");
    row.comment = text("comment");
    row.seed = seed();
    row.design = text("design");
    row.simulated = truth("simulated").value_or(false);
    row.place = place_of(table_, field("value"));
    read_measurements(row);
    return row;
  }

  std::vector<Fault> faults;

 private:
  void read_measurements(AnswerRow& row) {
    row.rt_ms = amount("rt_ms");
    row.replays = whole("replays");
    row.trial_ms = amount("trial_ms");
    row.play_start_ms = amount("play_start_ms");
    row.ended_ms = amount("ended_ms");
    row.stalls = whole("stalls");
    row.stall_ms = amount("stall_ms");
    row.dropped_frames = whole("dropped_frames");
    row.blurs = whole("blurs");
    row.viewport_width = whole("viewport_width");
    row.viewport_height = whole("viewport_height");
    row.refresh_hz = amount("refresh_hz");
  }

  const CsvField& field(std::string_view column) const {
    return (*fields_)[static_cast<std::size_t>(index_.at(column))];
  }
  const std::string& text(std::string_view column) const { return field(column).text; }

  void fault(std::string_view column, std::string wrong, std::string remedy) {
    faults.push_back({place_of(table_, field(column)), "", std::move(wrong), std::move(remedy)});
  }

  std::string needed(std::string_view column) {
    if (text(column).empty())
      fault(column, fmt::format("the {} is not told", column),
            "give the file as the questionnaire wrote it");
    return text(column);
  }

  template <std::size_t count>
  std::string one_of(std::string_view column, const std::array<std::string_view, count>& words) {
    if (std::ranges::find(words, text(column)) == words.end())
      fault(column, fmt::format("{} is no {}", motion::in_quotes(text(column)), column),
            fmt::format("there are {}", fmt::join(words, ", ")));
    return text(column);
  }

  bool is_number(std::string_view column) const {
    try {
      number_in(table_, field(column));
      return true;
    } catch (const Error&) {
      return false;
    }
  }

  /// From 0 up; empty and "NA" are nothing.
  std::optional<double> amount(std::string_view column) {
    if (text(column).empty() || text(column) == "NA") return std::nullopt;
    if (!is_number(column)) {
      fault(column, fmt::format("{} is not a number", motion::in_quotes(text(column))),
            "write a finite decimal number, or leave the field empty");
      return std::nullopt;
    }
    const double value = number_in(table_, field(column));
    if (value >= 0.0) return value;
    fault(column, fmt::format("{} is below 0", motion::excerpt(text(column))),
          "leave the field empty");
    return std::nullopt;
  }

  std::optional<int> whole(std::string_view column) {
    const std::optional<double> value = amount(column);
    if (!value) return std::nullopt;
    if (*value == std::floor(*value) && *value <= 2e9) return static_cast<int>(*value);
    fault(column, fmt::format("{} is no whole number", motion::excerpt(text(column))),
          "write a count");
    return std::nullopt;
  }

  std::optional<bool> truth(std::string_view column) {
    if (text(column).empty()) return std::nullopt;
    if (text(column) == "1") return true;
    if (text(column) != "0")
      fault(column, fmt::format("{} is neither 0 nor 1", motion::in_quotes(text(column))),
            "write 0 or 1");
    return false;
  }

  std::uint64_t seed() {
    const std::string& digits = text("seed");
    const auto value = motion::as_number<std::uint64_t>(digits);
    if (!digits.empty() && !value)
      fault("seed", motion::in_quotes(digits) + " is no seed", "write a whole number from 0 up");
    return value.value_or(0);
  }

  const CsvTable& table_;
  std::map<std::string_view, int> index_;
  const std::vector<CsvField>* fields_ = nullptr;
};

}  // namespace

const TableForm answer_form = {"answers.csv", "an answer", answer_row_columns};

bool AnswerRow::counts() const {
  return !is_practice && !is_warmup && !is_catch && kind != "attention" && !value.empty() &&
         value != "NA";
}

bool holds_answer_rows(const CsvTable& table) {
  return std::ranges::all_of(std::array{"item", "value_raw", "is_practice"},
                             [&](const char* name) { return find_column(table, name) >= 0; });
}

std::vector<std::string> fields_of_row(const AnswerRow& row) {
  const auto truth = [](bool value) { return std::string(value ? "1" : "0"); };
  return {row.participant,
          row.session,
          std::to_string(row.trial),
          row.block,
          row.kind,
          row.stimulus,
          row.stimulus_sha256,
          row.against,
          row.item,
          row.value_raw,
          row.value,
          row.pole_left,
          text_or_empty(row.rt_ms),
          truth(row.is_practice),
          truth(row.is_warmup),
          truth(row.is_catch),
          row.expected,
          row.passed ? truth(*row.passed) : "",
          text_or_empty(row.replays),
          text_or_empty(row.trial_ms),
          text_or_empty(row.play_start_ms),
          text_or_empty(row.ended_ms),
          text_or_empty(row.stalls),
          text_or_empty(row.stall_ms),
          text_or_empty(row.dropped_frames),
          text_or_empty(row.blurs),
          text_or_empty(row.viewport_width),
          text_or_empty(row.viewport_height),
          text_or_empty(row.refresh_hz),
          row.comment,
          std::to_string(row.seed),
          row.design,
          truth(row.simulated)};
}

std::string to_csv(const std::vector<AnswerRow>& rows) {
  CsvWriter writer = table_of(answer_form);
  for (const AnswerRow& row : rows) writer.row(fields_of_row(row));
  return writer.text();
}

std::vector<Fault> doubled_answers(const std::vector<AnswerRow>& rows) {
  std::vector<Fault> faults;
  using Key = std::tuple<std::string, std::string, int, std::string, std::string>;
  std::map<Key, const AnswerRow*> met;
  for (const AnswerRow& row : rows) {
    const auto [first, is_new] =
        met.emplace(Key(row.participant, row.session, row.trial, row.stimulus, row.item), &row);
    if (is_new) continue;
    faults.push_back({row.place, "",
                      fmt::format("participant {} answers trial {} on {} a second time "
                                  "(the first: {})",
                                  motion::in_quotes(row.participant), row.trial,
                                  motion::in_quotes(row.item), to_string(first->second->place)),
                      "keep one of them"});
  }
  return faults;
}

std::vector<AnswerRow> answer_rows(const CsvTable& table, Doubled doubled) {
  AnswerRowReader reader(table);
  if (!reader.faults.empty()) throw Faults(reader.faults);
  std::vector<AnswerRow> rows;
  rows.reserve(table.rows.size());
  for (const auto& fields : table.rows) rows.push_back(reader.row(fields));
  if (doubled == Doubled::refused)
    std::ranges::move(doubled_answers(rows), std::back_inserter(reader.faults));
  if (!reader.faults.empty()) throw Faults(reader.faults);
  return rows;
}

std::vector<std::string> tell_people_apart(std::vector<AnswerRow>& rows) {
  using Trial = std::tuple<std::string, int, std::string, std::string>;
  std::map<Trial, std::set<std::string>> sessions;
  for (const AnswerRow& row : rows)
    sessions[{row.participant, row.trial, row.stimulus, row.item}].insert(row.session);
  std::map<std::string, std::set<std::string>> doubled;
  for (const auto& [trial, of] : sessions)
    if (of.size() > 1) doubled[std::get<0>(trial)].insert(of.begin(), of.end());
  for (AnswerRow& row : rows)
    if (doubled.contains(row.participant)) row.participant += "/" + row.session;
  std::vector<std::string> told;
  for (const auto& [participant, of] : doubled)
    told.push_back(fmt::format("participant {} is {} people: sessions {}",
                               motion::in_quotes(participant), of.size(), fmt::join(of, ", ")));
  return told;
}

}  // namespace mien::pipeline
