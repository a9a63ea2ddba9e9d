#include "pipeline/manifest/ratings/answers/answer_row.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/manifest/ratings/answers/trial_form.h"

namespace mien::pipeline {

namespace {

using Row = AnswerRow;

/// A column, and what it holds of a row.
struct AnswerColumn {
  Column column;
  std::variant<std::string Row::*, int Row::*, std::uint64_t Row::*, bool Row::*,
               std::optional<bool> Row::*, std::optional<int> Row::*, std::optional<double> Row::*>
      member;
};

constexpr auto answer_columns = std::to_array<AnswerColumn>({
    {{"participant", "", "participant id: position in the design, not a name"}, &Row::participant},
    {{"session", "", "random id of the browser session"}, &Row::session},
    {{"trial", "", "trial number in the participant's order, from 1"}, &Row::trial},
    {{"block", "", "practice, main, or the level of the blocking factor"}, &Row::block},
    {{"kind", "", trial_forms_meaning}, &Row::kind},
    {{"stimulus", "", "stimulus rated; for a pair or set, the one on the left, or shown first"},
     &Row::stimulus},
    {{"stimulus_sha256", "", "SHA-256 of the media shown"}, &Row::stimulus_sha256},
    {{"against", "",
      "reference shown beside it, the other stimulus of a pair, or the others of a set, separated "
      "by spaces"},
     &Row::against},
    {{"level", "",
      "in adaptive trials, the level of the factor that was shown, chosen by the answers so far; "
      "otherwise empty"},
     &Row::level},
    {{"track", "",
      "in adaptive trials, the track whose answers chose the level, from 1; empty in other trials "
      "and in those without the signal"},
     &Row::track},
    {{"item", "",
      "scale id; emotion for a choice from a list; same_different, yes_no or two_interval in "
      "trials "
      "of that kind; for a set, scale id with /best or /worst"},
     &Row::item},
    {{"value_raw", "",
      "raw answer: position from the left, from 1 (points) or 0–100 (slider); the word chosen or "
      "written; for a pair left, right or tie, or left_much, left_slightly, … (shown in turn: left "
      "is the first, right the second); same or different; "
      "yes "
      "or no; first or second (of two intervals); place from the left, from 1 (of a set); in "
      "continuous trials the trace: positions 0–100 from the left, ten in each second of the film, "
      "separated by spaces"},
     &Row::value_raw},
    {{"value", "",
      "answer converted to the scale's range, increasing towards the high pole; or the emotion or "
      "stimulus chosen (tie: neither), or the text written; same or different, yes or no; in "
      "continuous "
      "trials the mean of the trace after the lead; of an attention check the raw answer, not "
      "converted"},
     &Row::value},
    {{"pole_left", "", "pole on the left: low or high; empty for attention checks"},
     &Row::pole_left},
    {{"rt_ms", "ms",
      "response time, from when answering became possible; in continuous trials, from the "
      "beginning of "
      "the film to the first movement of the marker"},
     &Row::rt_ms},
    {{"is_practice", "", "1 for practice trials, which are not analysed"}, &Row::is_practice},
    {{"is_warmup", "",
      "1 for warm-up trials at the start of the main part, which are not analysed"},
     &Row::is_warmup},
    {{"is_check", "", "1 for attention checks (see `expected`) and repeated stimuli"},
     &Row::is_check},
    {{"expected", "", "raw answer that passes the attention check; otherwise empty"},
     &Row::expected},
    {{"passed", "", "1 if the attention check was passed, 0 if failed; otherwise empty"},
     &Row::passed},
    {{"replays", "", "number of replays, including those before a reload of the page"},
     &Row::replays},
    {{"attempt", "", "how often the page of this trial was opened: 1, or more if it was reloaded"},
     &Row::attempt},
    {{"plays_before", "", "playings that began before the last reload"}, &Row::plays_before},
    {{"watched_before_ms", "ms", "duration of the longest playing before the last reload"},
     &Row::watched_before_ms},
    {{"play_fault", "",
      "why the stimulus could not be played, so that the trial has no answer: not_loaded, "
      "not_decoded or stalled; otherwise empty"},
     &Row::play_fault},
    {{"trial_ms", "ms", "trial duration"}, &Row::trial_ms},
    {{"play_start_ms", "ms", "time from trial onset to the start of the video"},
     &Row::play_start_ms},
    {{"ended_ms", "ms", "time from trial onset to the end of the video"}, &Row::ended_ms},
    {{"stalls", "", "buffering interruptions"}, &Row::stalls},
    {{"stall_ms", "ms", "total duration of buffering interruptions"}, &Row::stall_ms},
    {{"dropped_frames", "", "video frames dropped by the browser"}, &Row::dropped_frames},
    {{"volume_events", "",
      "changes of the volume of videos with sound: milliseconds from trial onset, a colon, and the "
      "volume from 0 (muted) to 1; separated by spaces"},
     &Row::volume_events},
    {{"blurs", "", "tab switches during the trial"}, &Row::blurs},
    {{"blur_ms", "ms", "total time for which the window was left during the trial"}, &Row::blur_ms},
    {{"viewport_width", "px", "width of the browser viewport"}, &Row::viewport_width},
    {{"viewport_height", "px", "height of the browser viewport"}, &Row::viewport_height},
    {{"refresh_hz", "Hz", "measured refresh rate of the screen"}, &Row::refresh_hz},
    {{"shown_width", "px", "width of each stimulus on the screen, CSS pixels"}, &Row::shown_width},
    {{"shown_height", "px", "height of each stimulus on the screen, CSS pixels"},
     &Row::shown_height},
    {{"pixel_ratio", "", "device pixels per CSS pixel"}, &Row::pixel_ratio},
    {{"shown_cm", "cm", "width of each stimulus on a screen calibrated with a card"},
     &Row::shown_cm},
    {{"shown_degrees", "°",
      "width of each stimulus as visual angle at the measured viewing distance or, without one, at "
      "the stated distance"},
     &Row::shown_degrees},
    {{"viewing_cm", "cm",
      "viewing distance measured with the blind spot; empty if it was not measured"},
     &Row::viewing_cm},
    {{"comment", "", "participant's comment on the video; in the first row of a trial"},
     &Row::comment},
    {{"seed", "", "seed of the participant's order"}, &Row::seed},
    {{"design", "", "hash of the questionnaire design"}, &Row::design},
    {{"simulated", "", "1 for simulated answers"}, &Row::simulated},
});

constexpr auto answer_row_columns = [] {
  std::array<Column, answer_columns.size()> columns;
  std::ranges::transform(answer_columns, columns.begin(), &AnswerColumn::column);
  return columns;
}();

/// Columns that tables of earlier versions do not have.
bool is_later_column(std::string_view name) {
  constexpr auto later = std::to_array<std::string_view>(
      {"blur_ms", "volume_events", "pixel_ratio", "attempt", "plays_before", "watched_before_ms",
       "play_fault", "viewing_cm", "level", "track"});
  return std::ranges::find(later, name) != later.end() || name.starts_with("shown_");
}

/// Fills rows from fields and gathers what is wrong with them.
class AnswerRowReader {
 public:
  explicit AnswerRowReader(const CsvTable& table) : table_(table) {
    for (const Column& column : answer_row_columns) {
      const int index = find_column(table, column.name);
      if (index < 0 && !is_later_column(column.name)) {
        faults.push_back({place_of(table, table.header.front()), "",
                          fmt::format("there is no column {}", motion::in_quotes(column.name)),
                          "use the questionnaire's own file, with all its columns"});
      }
      index_.emplace(column.name, index);
    }
    if (faults.empty() && table.rows.empty())
      faults.push_back(
          {Place{table.file, 1, 1}, "", "holds no answers", "use the file once there are answers"});
  }

  AnswerRow row(const std::vector<CsvField>& fields) {
    fields_ = &fields;
    AnswerRow row;
    for (const AnswerColumn& one : answer_columns)
      std::visit([&](auto member) { read(one.column.name, row.*member); }, one.member);
    row.place = place_of(table_, field("value"));
    refuse_empty("participant");
    refuse_empty("trial");
    if (row.trial < 1 && !text("trial").empty() && motion::as_written_number(text("trial")))
      fault("trial", fmt::format("there is no trial {}", motion::excerpt(text("trial"))),
            "trials count from 1");
    refuse_other("kind", kinds_);
    if (row.kind != attention_kind) refuse_empty("stimulus");
    if (row.kind != attention_kind) refuse_empty("item");
    if (!row.pole_left.empty())
      refuse_other("pole_left", std::array<std::string_view, 2>{"low", "high"});
    return row;
  }

  std::vector<Fault> faults;

 private:
  void read(std::string_view column, std::string& value) { value = text(column); }
  void read(std::string_view column, int& value) { value = whole(column).value_or(0); }
  void read(std::string_view column, bool& value) { value = truth(column).value_or(false); }
  void read(std::string_view column, std::optional<bool>& value) { value = truth(column); }
  void read(std::string_view column, std::optional<int>& value) { value = whole(column); }
  void read(std::string_view column, std::optional<double>& value) { value = amount(column); }
  void read(std::string_view column, std::uint64_t& value) {
    const auto number = motion::as_number<std::uint64_t>(text(column));
    if (!number && !text(column).empty())
      fault(column, fmt::format("{} is not a valid {}", motion::in_quotes(text(column)), column),
            "write a whole number from 0 up");
    value = number.value_or(0);
  }

  const CsvField& field(std::string_view column) const {
    static const CsvField missing;
    const int index = index_.at(column);
    return index < 0 ? missing : (*fields_)[static_cast<std::size_t>(index)];
  }
  const std::string& text(std::string_view column) const { return field(column).text; }

  void fault(std::string_view column, std::string wrong, std::string remedy) {
    faults.push_back({place_of(table_, field(column)), "", std::move(wrong), std::move(remedy)});
  }

  void refuse_empty(std::string_view column) {
    if (text(column).empty())
      fault(column, fmt::format("the {} is missing", column),
            "use the file as written by the questionnaire");
  }

  void refuse_other(std::string_view column, std::span<const std::string_view> words) {
    if (std::ranges::find(words, text(column)) == words.end())
      fault(column, fmt::format("{} is not a valid {}", motion::in_quotes(text(column)), column),
            fmt::format("there are {}", fmt::join(words, ", ")));
  }

  /// From 0 up; empty and "NA" are nothing.
  std::optional<double> amount(std::string_view column) {
    if (text(column).empty() || text(column) == "NA") return std::nullopt;
    const std::optional<double> value = motion::as_written_number(text(column));
    if (value >= 0.0) return value;
    if (value)
      fault(column, fmt::format("{} is below 0", motion::excerpt(text(column))),
            "leave the field empty");
    else
      fault(column, fmt::format("{} is not a number", motion::in_quotes(text(column))),
            "write a finite decimal number, or leave the field empty");
    return std::nullopt;
  }

  std::optional<int> whole(std::string_view column) {
    const std::optional<double> value = amount(column);
    if (!value) return std::nullopt;
    if (*value == std::floor(*value) && *value <= 2e9) return static_cast<int>(*value);
    fault(column, fmt::format("{} is not a whole number", motion::excerpt(text(column))),
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

  const CsvTable& table_;
  const std::vector<std::string_view> kinds_ = answer_kinds();
  std::map<std::string_view, int> index_;
  const std::vector<CsvField>* fields_ = nullptr;
};

}  // namespace

const TableForm answer_form = {"answers.csv", "answer", answer_row_columns};

bool AnswerRow::counts() const {
  return !is_practice && !is_warmup && !is_check && kind != attention_kind && !value.empty() &&
         value != "NA";
}

bool holds_answer_rows(const CsvTable& table) {
  return std::ranges::all_of(std::array{"item", "value_raw", "is_practice"},
                             [&](const char* name) { return find_column(table, name) >= 0; });
}

std::vector<std::string> fields_of_row(const AnswerRow& row) {
  std::vector<std::string> fields;
  for (const AnswerColumn& one : answer_columns)
    fields.push_back(std::visit([&](auto member) { return field_text(row.*member); }, one.member));
  return fields;
}

std::string parameter_column(const std::string& parameter) { return "url_" + parameter; }

bool is_parameter_column(std::string_view column) {
  return column.starts_with("url_") || column.starts_with("jatos_");
}

std::string to_csv(const std::vector<AnswerRow>& rows,
                   const std::vector<std::string>& url_parameters) {
  std::vector<std::string> header = header_of(answer_form);
  for (const std::string& name : url_parameters) header.push_back(parameter_column(name));
  CsvWriter writer(header);
  for (const AnswerRow& row : rows) {
    std::vector<std::string> fields = fields_of_row(row);
    fields.insert(fields.end(), row.url_parameters.begin(), row.url_parameters.end());
    writer.row(fields);
  }
  return writer.text();
}

std::vector<Fault> duplicate_answer_faults(const std::vector<AnswerRow>& rows) {
  std::vector<Fault> faults;
  using Key = std::tuple<std::string, std::string, int, std::string, std::string>;
  std::map<Key, const AnswerRow*> first_answers;
  for (const AnswerRow& row : rows) {
    const auto [first, is_new] = first_answers.emplace(
        Key(row.participant, row.session, row.trial, row.stimulus, row.item), &row);
    if (is_new) continue;
    faults.push_back({row.place, "",
                      fmt::format("participant {} answers trial {} on {} a second time (first: {})",
                                  motion::in_quotes(row.participant), row.trial,
                                  motion::in_quotes(row.item), to_string(first->second->place)),
                      "keep one of them"});
  }
  return faults;
}

std::vector<AnswerRow> answer_rows(CsvTable table, DuplicateAnswers duplicates,
                                   std::vector<Fault>* warnings) {
  std::optional<Fault> warning = rename_column(table, "is_catch", "is_check");
  if (warning && warnings != nullptr) warnings->push_back(*std::move(warning));
  AnswerRowReader reader(table);
  if (!reader.faults.empty()) throw Faults(reader.faults);
  std::vector<AnswerRow> rows;
  rows.reserve(table.rows.size());
  for (const auto& fields : table.rows) rows.push_back(reader.row(fields));
  if (duplicates == DuplicateAnswers::refused)
    std::ranges::move(duplicate_answer_faults(rows), std::back_inserter(reader.faults));
  if (!reader.faults.empty()) throw Faults(reader.faults);
  return rows;
}

std::vector<std::string> separate_participants(std::vector<AnswerRow>& rows) {
  using Trial = std::tuple<std::string, int, std::string, std::string>;
  std::map<Trial, std::set<std::string>> sessions;
  for (const AnswerRow& row : rows)
    sessions[{row.participant, row.trial, row.stimulus, row.item}].insert(row.session);
  std::map<std::string, std::set<std::string>> duplicates;
  for (const auto& [trial, of] : sessions)
    if (of.size() > 1) duplicates[std::get<0>(trial)].insert(of.begin(), of.end());
  for (AnswerRow& row : rows)
    if (duplicates.contains(row.participant)) row.participant += "/" + row.session;
  std::vector<std::string> notes;
  for (const auto& [participant, of] : duplicates)
    notes.push_back(
        fmt::format("participant {} has {} different sessions, treated as different people: {}",
                    motion::in_quotes(participant), of.size(), fmt::join(of, ", ")));
  return notes;
}

}  // namespace mien::pipeline
