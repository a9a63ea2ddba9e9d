#include "pipeline/study/chains/experiment/chain_answers.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "motion/text/as_number.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

using motion::in_quotes;

/// Apart from rounding in the browser.
bool is_within(double value, const DimensionRange& range) {
  constexpr double slack = 1e-9;
  return value >= range.low - slack && value <= range.high + slack;
}

/// Reads the rows of one table.
class AnswerReader {
 public:
  /// Adds failed attention checks to `failed_checks`: participant and trial.
  AnswerReader(const CsvTable& table, const ChainStudy& study, std::vector<Fault>& faults,
               std::set<std::pair<std::string, std::string>>& failed_checks)
      : table_(table), design_(study.design), faults_(faults), failed_checks_(failed_checks) {
    wanted_design_ = study.experiment.at("design");
    for (const Column& column : chain_steps_form.columns) {
      const std::string name(column.name);
      columns_[name] = require_column(table, name);
    }
  }

  /// Nullopt for practice, attention checks and after a fault.
  std::optional<ReadAnswer> read(const std::vector<CsvField>& row) {
    row_ = &row;
    const std::size_t before = faults_.size();
    // Answers to another experiment have this fault alone, once.
    if (!check_design()) return std::nullopt;
    ReadAnswer read{.place = place_of(table_, row.front())};
    ChainAnswer& of = read.of;
    of.participant = field("participant").text;
    of.session = field("session").text;
    of.design = field("design").text;
    of.simulated = truth("simulated");
    of.is_practice = truth("is_practice");
    if (truth("is_check")) {
      if (!truth("passed")) failed_checks_.emplace(of.participant, field("trial").text);
      return std::nullopt;
    }
    if (of.is_practice) return std::nullopt;
    of.answer.word = known("word", design_.words);
    of.answer.chain = count("chain", 1, design_.chains);
    of.answer.step = count("step", 0, design_.steps - 1);
    of.answer.person = count("person", 0, design_.people_per_step - 1);
    of.answer.point = point("point");
    if (design_.method == ChainMethod::gibbs)
      read_value(of.answer);
    else
      read_choice(of.answer);
    return faults_.size() == before ? std::optional(std::move(read)) : std::nullopt;
  }

 private:
  const CsvField& field(const std::string& column) const {
    return (*row_)[static_cast<std::size_t>(columns_.at(column))];
  }

  void add(const std::string& column, const std::string& wrong, const std::string& remedy) {
    faults_.push_back({place_of(table_, field(column)), "", wrong, remedy});
  }

  bool check_design() {
    const std::string& design = field("design").text;
    if (design == wanted_design_) return true;
    if (!has_other_design_)
      add("design", in_quotes(design) + " is not the design of this manifest",
          "pass the manifest, unchanged, with which the experiment was run");
    has_other_design_ = true;
    return false;
  }

  bool truth(const std::string& column) {
    const std::string& text = field(column).text;
    if (text != "0" && text != "1") add(column, in_quotes(text) + " is neither 0 nor 1", "");
    return text == "1";
  }

  std::string known(const std::string& column, const std::vector<std::string>& names) {
    const std::string& text = field(column).text;
    if (std::ranges::find(names, text) == names.end())
      add(column, fmt::format("the experiment has no {} {}", column, in_quotes(text)),
          fmt::format("one of {}", fmt::join(names, ", ")));
    return text;
  }

  int count(const std::string& column, int least, int most) {
    const std::optional<double> value = motion::as_written_number(field(column).text);
    if (value && *value >= least && *value <= most && *value == static_cast<int>(*value))
      return static_cast<int>(*value);
    add(column,
        fmt::format("{} is not a {} of the experiment", in_quotes(field(column).text), column),
        fmt::format("it has {} to {}", least, most));
    return least;
  }

  std::vector<double> point(const std::string& column) {
    std::vector<double> values;
    const std::string& text = field(column).text;
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(' ', from), text.size());
      const auto value = motion::as_written_number(text.substr(from, to - from));
      if (value) values.push_back(*value);
      from = to + 1;
    }
    bool is_inside = values.size() == design_.space.size();
    for (std::size_t i = 0; is_inside && i < values.size(); ++i)
      is_inside = is_within(values[i], design_.space[i]);
    if (!is_inside)
      add(column, in_quotes(text) + " is no point of the space",
          fmt::format("{} numbers within the ranges of the dimensions, separated by spaces",
                      design_.space.size()));
    return values;
  }

  void read_value(ChainRecord& answer) {
    const std::string name = known("dimension", design_.dimensions);
    const auto at = std::ranges::find(design_.dimensions, name) - design_.dimensions.begin();
    if (at == std::ssize(design_.dimensions)) return;
    answer.dimension = static_cast<std::size_t>(at);
    const DimensionRange& range = design_.space[answer.dimension];
    const std::optional<double> value = motion::as_written_number(field("value").text);
    if (!value || !is_within(*value, range))
      add("value", fmt::format("{} is no value of {}", in_quotes(field("value").text), name),
          fmt::format("its range is {:g} to {:g}", range.low, range.high));
    answer.value = value.value_or(range.low);
  }

  void read_choice(ChainRecord& answer) {
    answer.proposal = point("proposal");
    answer.chose_proposal = truth("chose_proposal");
  }

  const CsvTable& table_;
  const ChainDesign& design_;
  std::string wanted_design_;
  bool has_other_design_ = false;
  std::vector<Fault>& faults_;
  std::set<std::pair<std::string, std::string>>& failed_checks_;
  std::map<std::string, int> columns_;
  const std::vector<CsvField>* row_ = nullptr;
};

/// Equal for rows that say the same.
auto content_of(const ReadAnswer& answer) {
  const ChainAnswer& of = answer.of;
  const ChainRecord& record = of.answer;
  return std::tuple(of.participant, of.session, record.word, record.chain, record.step,
                    record.person, record.point, record.dimension, record.value, record.proposal,
                    record.chose_proposal);
}

/// Follows one chain.
class PathReplay {
 public:
  PathReplay(const ChainStudy& study, const ChainName& name, std::vector<Fault>& faults)
      : design_(study.design), faults_(faults), path_{.name = name} {
    // Participants of the open link follow the plans of others.
    starts_.push_back(chain_start(design_, study.dimensions.at_examples, name));
    for (const ChainSession& session : study.sessions)
      if (const auto start = session.starts.find(name.key()); start != session.starts.end())
        starts_.push_back(start->second);
  }

  ChainPath run(const std::vector<const ReadAnswer*>& answers) {
    point_ = answers.front()->of.answer.point;
    if (answers.front()->of.answer.step == 0 && std::ranges::find(starts_, point_) == starts_.end())
      add(*answers.front(), "no chain of the experiment starts at this point",
          "pass the answers unchanged");
    for (std::size_t i = 0; i < answers.size() && is_sound_;) {
      std::vector<const ReadAnswer*> of_step;
      const int step = static_cast<int>(path_.points.size());
      while (i < answers.size() && answers[i]->of.answer.step == step)
        of_step.push_back(answers[i++]);
      if (of_step.empty()) {
        add(*answers[i], fmt::format("step {} of this chain has no answer", step),
            "pass all files of the experiment");
        break;
      }
      take(of_step);
      if (std::ssize(of_step) < design_.people_per_step) {
        if (i < answers.size())
          add(*answers[i], fmt::format("step {} of this chain is incomplete", step),
              "pass all files of the experiment");
        break;
      }
    }
    path_.is_complete = std::ssize(path_.points) == design_.steps;
    return std::move(path_);
  }

 private:
  void add(const ReadAnswer& answer, const std::string& wrong, const std::string& remedy) {
    faults_.push_back({answer.place, "", wrong, remedy});
    is_sound_ = false;
  }

  void take(const std::vector<const ReadAnswer*>& of_step) {
    std::vector<double> values;
    const ChainRecord* before = nullptr;  // they are sorted by person
    for (const ReadAnswer* answer : of_step) {
      const ChainRecord& record = answer->of.answer;
      if (record.point != point_)
        return add(*answer, "the point is not the one that the answers before lead to",
                   "pass all answers, unchanged, of one experiment");
      if (!values.empty() && record.person == before->person)
        return add(*answer, "this step has been answered before", "keep one of the two answers");
      if (!values.empty() && record.dimension != before->dimension)
        return add(*answer, "the other people of this step had another dimension",
                   "pass the answers unchanged");
      values.push_back(record.value);
      before = &record;
    }
    if (std::ssize(values) < design_.people_per_step) return;
    const ChainRecord& last = of_step.back()->of.answer;
    if (design_.method == ChainMethod::gibbs)
      point_[last.dimension] = aggregated(std::move(values), design_.aggregate);
    else if (last.chose_proposal)
      point_ = last.proposal;
    path_.points.push_back(point_);
  }

  const ChainDesign& design_;
  std::vector<Fault>& faults_;
  std::vector<std::vector<double>> starts_;
  std::vector<double> point_;
  ChainPath path_;
  bool is_sound_ = true;
};

}  // namespace

ChainAnswers read_chain_answers(const std::vector<std::filesystem::path>& files,
                                const ChainStudy& study) {
  ChainAnswers read;
  std::vector<Fault> faults;
  std::set<decltype(content_of(ReadAnswer()))> known;
  std::optional<bool> are_simulated;
  std::set<std::pair<std::string, std::string>> failed_checks;
  for (const std::filesystem::path& file : files) {
    const CsvTable table = read_csv(file);
    AnswerReader reader(table, study, faults, failed_checks);
    for (const auto& row : table.rows) {
      std::optional<ReadAnswer> answer = reader.read(row);
      if (!answer) continue;
      if (are_simulated.value_or(answer->of.simulated) != answer->of.simulated)
        faults.push_back(
            {answer->place, "", "there are simulated and real answers", "analyse them separately"});
      are_simulated = answer->of.simulated;
      // A file that was saved twice; rows that contradict each other remain.
      if (!known.insert(content_of(*answer)).second && files.size() > 1) continue;
      read.answers.push_back(std::move(*answer));
    }
  }
  if (!faults.empty()) throw Faults(std::move(faults));
  if (read.answers.empty())
    throw Error({files.front().string()},
                "there are no answers apart from practice and attention checks",
                "pass the tables of steps that the pages saved");
  for (const auto& [participant, trial] : failed_checks) ++read.failed_checks[participant];
  read.simulated = are_simulated.value_or(false);
  return read;
}

std::vector<ChainPath> chain_paths(const ChainStudy& study, bool across_participants,
                                   const ChainAnswers& answers) {
  const auto place_of_word = [&](const std::string& word) {
    return std::ranges::find(study.design.words, word) - study.design.words.begin();
  };
  std::map<std::tuple<std::ptrdiff_t, std::string, int>, std::vector<const ReadAnswer*>> chains;
  for (const ReadAnswer& answer : answers.answers) {
    const ChainRecord& record = answer.of.answer;
    chains[{place_of_word(record.word), across_participants ? "" : answer.of.participant,
            record.chain}]
        .push_back(&answer);
  }
  std::vector<Fault> faults;
  std::vector<ChainPath> paths;
  for (auto& [key, of_chain] : chains) {
    std::ranges::stable_sort(of_chain, {}, [](const ReadAnswer* answer) {
      return std::pair(answer->of.answer.step, answer->of.answer.person);
    });
    const ChainName name{of_chain.front()->of.answer.word, std::get<2>(key), std::get<1>(key)};
    paths.push_back(PathReplay(study, name, faults).run(of_chain));
  }
  if (!faults.empty()) throw Faults(std::move(faults));
  return paths;
}

}  // namespace mien::pipeline
