#include "pipeline/matching/matching_results.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "pipeline/documents/fault.h"

namespace mien::pipeline {

namespace {

class TrialReader {
 public:
  TrialReader(const CsvTable& table, double limit_s)
      : table_(table),
        participant_(require_column(table, "participant")),
        target_(require_column(table, "target")),
        interface_(require_column(table, "interface")),
        first_guess_d_(require_column(table, "first_guess_d")),
        time_s_(require_column(table, "time_s")),
        success_(require_column(table, "success")),
        simulated_(find_column(table, "simulated")) {
    results.limit_s = limit_s;
  }

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
    if (!seen_.emplace(trial.participant, trial.target, trial.interface).second) {
      add(field(participant_),
          fmt::format("participant \"{}\" has matched \"{}\" with \"{}\" before", trial.participant,
                      trial.target, trial.interface),
          "keep one of the two trials");
    }
    if (simulated_ >= 0 && field(simulated_).text != "0") results.simulated = true;
    note(trial.interface, results.interfaces);
    note(trial.target, results.targets);
    results.trials.push_back(std::move(trial));
  }

  MatchingResults results;
  std::vector<Fault> faults;

 private:
  void add(const CsvField& field, const std::string& wrong, const std::string& remedy) {
    faults.push_back({place_of(table_, field), "", wrong, remedy});
  }

  std::string name_in(const CsvField& field, const std::string& what) {
    if (field.text.empty()) add(field, "no " + what, "name it");
    return field.text;
  }

  std::optional<double> number(const CsvField& field) {
    if (field.text.empty() || field.text == "NA") return std::nullopt;
    try {
      const double value = number_in(table_, field);
      if (value >= 0.0) return value;
    } catch (const Error&) {
    }
    add(field, "\"" + field.text + "\" is no number from 0 up",
        "write a decimal number, or leave the field empty");
    return std::nullopt;
  }

  bool success_in(const CsvField& field) {
    if (field.text == "1" || field.text == "0") return field.text == "1";
    add(field, "\"" + field.text + "\" is neither 1 nor 0",
        "write 1 for a match within the limit and 0 for none");
    return false;
  }

  void check_time(MatchingTrial& trial, const CsvField& field) {
    if (!trial.success) {
      trial.time_s = results.limit_s;
    } else if (trial.time_s && *trial.time_s > results.limit_s) {
      add(field,
          fmt::format("a success after {} s, but the limit is {} s", *trial.time_s,
                      results.limit_s),
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
  std::set<std::tuple<std::string, std::string, std::string>> seen_;
};

}  // namespace

MatchingResults matching_results(const CsvTable& table, double limit_s) {
  TrialReader reader(table, limit_s);
  for (const auto& row : table.rows) reader.read(row);
  if (!reader.faults.empty()) throw Faults(reader.faults);
  if (reader.results.trials.empty()) {
    throw Error({table.file, 0, 0}, "there are no trials", "add a row for each trial");
  }
  return std::move(reader.results);
}

MatchingResults read_matching_results(const std::filesystem::path& file, double limit_s) {
  return matching_results(read_csv(file), limit_s);
}

}  // namespace mien::pipeline
