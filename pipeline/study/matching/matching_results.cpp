#include "pipeline/study/matching/matching_results.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {

namespace {

/// The trials read so far.
struct ReadTrials {
  MatchingResults results;
  std::vector<Fault> faults;
  std::set<std::tuple<std::string, std::string, std::string>> seen;
};

class TrialReader {
 public:
  TrialReader(const CsvTable& table, ReadTrials& read)
      : table_(table),
        participant_(require_column(table, "participant")),
        target_(require_column(table, "target")),
        interface_(require_column(table, "interface")),
        first_guess_d_(require_column(table, "first_guess_d")),
        time_s_(require_column(table, "time_s")),
        success_(require_column(table, "success")),
        simulated_(find_column(table, "simulated")),
        read_(read) {}

  void read(const std::vector<CsvField>& row) {
    const auto field = [&](int column) -> const CsvField& {
      return row[static_cast<size_t>(column)];
    };
    MatchingTrial trial;
    trial.participant = name_in(field(participant_), "participant");
    trial.target = name_in(field(target_), "target");
    trial.interface = name_in(field(interface_), "interface");
    trial.first_guess_d = number(field(first_guess_d_));
    trial.time_s = number(field(time_s_));
    trial.success = success_in(field(success_));
    check_time(trial, field(time_s_));
    if (!read_.seen.emplace(trial.participant, trial.target, trial.interface).second)
      add(field(participant_),
          fmt::format("participant {} has already matched {} with {}",
                      motion::in_quotes(trial.participant), motion::in_quotes(trial.target),
                      motion::in_quotes(trial.interface)),
          "keep one of the two trials");
    MatchingResults& results = read_.results;
    if (simulated_ >= 0 && field(simulated_).text != "0") results.simulated = true;
    note(trial.interface, results.interfaces);
    note(trial.target, results.targets);
    results.trials.push_back(std::move(trial));
  }

 private:
  void add(const CsvField& field, const std::string& wrong, const std::string& remedy) {
    read_.faults.push_back({place_of(table_, field), "", wrong, remedy});
  }

  std::string name_in(const CsvField& field, const std::string& what) {
    if (field.text.empty()) add(field, "no " + what, "give a name");
    return field.text;
  }

  std::optional<double> number(const CsvField& field) {
    if (field.text.empty() || field.text == "NA") return std::nullopt;
    const std::optional<double> value = motion::as_written_number(field.text);
    if (value >= 0.0) return value;
    add(field, motion::in_quotes(field.text) + " is not a number of at least 0",
        "write a decimal number, or leave the field empty");
    return std::nullopt;
  }

  bool success_in(const CsvField& field) {
    if (field.text == "1" || field.text == "0") return field.text == "1";
    add(field, motion::in_quotes(field.text) + " is neither 1 nor 0",
        "write 1 for a match within the limit, otherwise 0");
    return false;
  }

  void check_time(MatchingTrial& trial, const CsvField& field) {
    const double limit_s = read_.results.limit_s;
    if (!trial.success) {
      trial.time_s = limit_s;
    } else if (trial.time_s && *trial.time_s > limit_s) {
      add(field,
          fmt::format("a success after {} s exceeds the limit of {} s", *trial.time_s, limit_s),
          "correct it, or state the limit with --limit");
    } else if (!trial.time_s && field.text.empty()) {
      add(field, "a success without a time", "write the seconds that it took");
    }
  }

  static void note(const std::string& name, std::vector<std::string>& names) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }

  const CsvTable& table_;
  int participant_, target_, interface_, first_guess_d_, time_s_, success_, simulated_;
  ReadTrials& read_;
};

/// The common value of all rows of a column; nullopt without one. Throws Error at the first other
/// value.
std::optional<std::string> common_value(const std::vector<CsvTable>& tables,
                                        const std::string& column, const std::string& remedy) {
  std::optional<std::string> common;
  for (const CsvTable& table : tables) {
    const int index = find_column(table, column);
    if (index < 0) continue;
    for (const auto& row : table.rows) {
      const CsvField& field = row[static_cast<size_t>(index)];
      if (!common) common = field.text;
      if (field.text == *common) continue;
      throw Error(place_of(table, field),
                  fmt::format("{} is {}, but {} before", column, motion::in_quotes(field.text),
                              motion::in_quotes(*common)),
                  remedy);
    }
  }
  return common;
}

/// The common number in a column for a setting of the experiment, if any.
std::optional<double> common_number(const std::vector<CsvTable>& tables,
                                    const std::string& column) {
  if (!common_value(tables, column, "evaluate the sessions of each experiment separately"))
    return std::nullopt;
  for (const CsvTable& table : tables) {
    const int index = find_column(table, column);
    if (index < 0 || table.rows.empty()) continue;
    const CsvField& field = table.rows.front()[static_cast<size_t>(index)];
    const double value = number_in(table, field);
    if (value > 0.0) return value;
    throw Error(place_of(table, field), column + " is not positive", "correct it");
  }
  return std::nullopt;
}

/// Baseline interfaces come first, so that differences are what the later one saves.
int place_of_interface(const std::string& interface) {
  constexpr std::array<std::string_view, 3> order = {"weights", "features", "adjectives"};
  return static_cast<int>(std::ranges::find(order, interface) - order.begin());
}

/// Failures count with the limit, so that it must be the one that the sessions had.
double limit_of(const std::vector<CsvTable>& tables, const MatchingSettings& settings,
                double usual) {
  const std::optional<double> told = common_number(tables, "limit_s");
  if (told && settings.limit_s && *told != *settings.limit_s)
    throw Error(
        fmt::format("--limit says {:g} s, but these sessions had {:g} s", *settings.limit_s, *told),
        "omit --limit");
  return told ? *told : settings.limit_s.value_or(usual);
}

}  // namespace

MatchingResults matching_results(const std::vector<CsvTable>& tables,
                                 const MatchingSettings& settings) {
  common_value(tables, "simulated", "evaluate sessions of real participants separately");
  common_value(tables, "design", "evaluate the sessions of each design separately");
  ReadTrials read;
  MatchingResults& results = read.results;
  results.limit_s = limit_of(tables, settings, results.limit_s);
  results.threshold_m = settings.threshold_m.value_or(
      common_number(tables, "threshold_m").value_or(results.threshold_m));
  for (const CsvTable& table : tables) {
    const size_t before = results.trials.size();
    TrialReader reader(table, read);
    for (const auto& row : table.rows) reader.read(row);
    if (read.faults.empty() && results.trials.size() == before)
      throw Error({table.file, 0, 0}, "there are no trials", "add a row for each trial");
  }
  if (!read.faults.empty()) throw Faults(read.faults);
  std::ranges::stable_sort(results.interfaces, {}, place_of_interface);
  return std::move(read.results);
}

MatchingResults read_matching_results(const std::vector<std::filesystem::path>& files,
                                      const MatchingSettings& settings) {
  std::vector<CsvTable> tables;
  for (const auto& file : files) tables.push_back(read_csv(file));
  return matching_results(tables, settings);
}

}  // namespace mien::pipeline
