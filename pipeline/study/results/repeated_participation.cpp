#include "pipeline/study/results/repeated_participation.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

namespace {

/// Whether a text has the form 2026-03-01T09:30:00Z, with or without decimals of the second.
bool is_time_in_utc(std::string_view text) {
  constexpr std::string_view form = "0000-00-00T00:00:00";
  if (text.size() <= form.size() || text.back() != 'Z') return false;
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 0; i < form.size(); ++i)
    if (form[i] == '0' ? !is_digit(text[i]) : text[i] != form[i]) return false;
  const std::string_view rest = text.substr(form.size(), text.size() - form.size() - 1);
  return rest.empty() || (rest.front() == '.' && std::ranges::all_of(rest.substr(1), is_digit));
}

/// Reads tables, numbering people in the order in which their values occur.
class SessionPeopleReader {
 public:
  explicit SessionPeopleReader(const std::string& parameter)
      : column_(parameter_column(parameter)) {}

  void read_people(const CsvTable& table) {
    const int value = find_column(table, column_);
    if (value < 0) return;
    result.is_known = true;
    for (const auto& row : table.rows) {
      const std::string& text = row[static_cast<std::size_t>(value)].text;
      if (text.empty() || text == "NA") continue;
      const int person = numbers_.emplace(text, static_cast<int>(numbers_.size())).first->second;
      result.person.emplace(session_of(table, row), person);
    }
  }

  void read_times(const CsvTable& table) {
    const int column = find_column(table, "consented_at");
    if (column < 0 || find_column(table, "session") < 0) return;
    for (const auto& row : table.rows) {
      const CsvField& time = row[static_cast<std::size_t>(column)];
      if (time.text.empty() || time.text == "NA") continue;
      if (!is_time_in_utc(time.text))
        faults.push_back({place_of(table, time), "",
                          fmt::format("{} is not a time of consent", motion::in_quotes(time.text)),
                          "write it as 2026-03-01T09:30:00.000Z, as the questionnaire does"});
      // Without the Z, times with and without decimals of the second sort as texts.
      result.consented_at.emplace(session_of(table, row),
                                  time.text.substr(0, time.text.size() - 1));
    }
  }

  SessionPeople result;
  std::vector<Fault> faults;

 private:
  static SessionName session_of(const CsvTable& table, const std::vector<CsvField>& row) {
    return {row[static_cast<std::size_t>(require_column(table, "participant"))].text,
            row[static_cast<std::size_t>(require_column(table, "session"))].text};
  }

  std::string column_;
  std::map<std::string, int> numbers_;
};

/// A participant as analysed, with the person behind it.
struct Participation {
  std::string participant;
  int person = -1;           ///< −1: unknown
  std::string consented_at;  ///< empty: unknown
};

/// One for each participant, in the order of the rows.
std::vector<Participation> participations(const std::vector<SessionStart>& sessions,
                                          const std::vector<AnswerRow>& rows,
                                          const SessionPeople& people) {
  std::vector<Participation> all;
  std::map<std::string, std::size_t> index;
  for (const SessionStart& session : sessions) {
    const std::string& participant = rows[session.row].participant;
    const auto [found, is_new] = index.emplace(participant, all.size());
    if (is_new) all.push_back({.participant = participant});
    Participation& own = all[found->second];
    const auto person = people.person.find(session.name);
    if (own.person < 0 && person != people.person.end()) own.person = person->second;
    const auto time = people.consented_at.find(session.name);
    if (time == people.consented_at.end()) continue;
    if (own.consented_at.empty() || time->second < own.consented_at)
      own.consented_at = time->second;
  }
  return all;
}

}  // namespace

SessionPeople session_people(const std::vector<CsvTable>& answers,
                             const std::vector<CsvTable>& participants,
                             const std::string& parameter) {
  SessionPeopleReader reader(parameter);
  for (const CsvTable& table : answers) reader.read_people(table);
  for (const CsvTable& table : participants) reader.read_people(table);
  for (const CsvTable& table : participants) reader.read_times(table);
  if (!reader.faults.empty()) throw Faults(reader.faults);
  return std::move(reader.result);
}

std::vector<SessionStart> session_starts(const std::vector<AnswerRow>& rows) {
  std::vector<SessionStart> starts;
  std::set<SessionName> met;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SessionName name = {rows[i].participant, rows[i].session};
    if (met.insert(name).second) starts.push_back({name, i});
  }
  return starts;
}

std::map<std::string, std::string> repeated_participants(const std::vector<SessionStart>& sessions,
                                                         const std::vector<AnswerRow>& rows,
                                                         const SessionPeople& people) {
  std::map<int, std::vector<Participation>> of_person;
  for (Participation& one : participations(sessions, rows, people))
    if (one.person >= 0) of_person[one.person].push_back(std::move(one));
  std::map<std::string, std::string> repeated;
  for (auto& [person, own] : of_person) {
    const bool by_time = std::ranges::none_of(
        own, [](const Participation& one) { return one.consented_at.empty(); });
    if (by_time) std::ranges::stable_sort(own, {}, &Participation::consented_at);
    for (std::size_t i = 1; i < own.size(); ++i)
      repeated.emplace(
          own[i].participant,
          fmt::format("participation number {} of a person who first took part as {} ({})", i + 1,
                      own.front().participant,
                      by_time ? "by time of consent" : "by order in the files"));
  }
  return repeated;
}

}  // namespace mien::pipeline
