#include "pipeline/manifest/ratings/answers/answer_rules.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

/// What an answer is about, in words.
std::string subject_of(const StudyAnswer& answer) {
  const std::string subject =
      fmt::format("{} on {}", motion::in_quotes(answer.stimulus), motion::in_quotes(answer.scale));
  return answer.participant.empty() ? subject
                                    : fmt::format("participant {} about {}",
                                                  motion::in_quotes(answer.participant), subject);
}

/// Of a repeated answer: whose it is and what it is about.
std::string whose(const StudyAnswer& answer) {
  return (answer.participant.empty() ? "about " : "of ") + subject_of(answer);
}

std::string remedy_of_repeated(const AnswerRules& rules) {
  return rules.plain ? "keep one of them"
                     : "keep one of them, or choose with --repeated first, last or mean";
}

bool earlier(const StudyAnswer& a, const StudyAnswer& b) {
  const bool ordered = a.order && b.order && *a.order != *b.order;
  return ordered ? *a.order < *b.order : a.place.line < b.place.line;
}

StudyAnswer one_of(std::vector<StudyAnswer> repeated, AnswerRules::Repeated rule) {
  std::stable_sort(repeated.begin(), repeated.end(), earlier);
  if (rule == AnswerRules::Repeated::first) return repeated.front();
  if (rule == AnswerRules::Repeated::last) return repeated.back();
  StudyAnswer mean = repeated.front();
  double sum = 0.0;
  for (const StudyAnswer& answer : repeated) sum += answer.value;
  mean.value = sum / static_cast<double>(repeated.size());
  return mean;
}

const char* words_for(AnswerRules::Repeated rule) {
  if (rule == AnswerRules::Repeated::first) return "the first is used";
  return rule == AnswerRules::Repeated::last ? "the last is used" : "their mean is used";
}

/// Who saw what, from the answers.
struct Attendance {
  std::map<std::string, std::set<std::string>> scales_about;  // by stimulus: asked at all
  std::set<std::string> stimuli;
  std::map<std::string, std::map<std::string, std::set<std::string>>> answered;
  std::map<std::string, Place> first_place;
  std::map<std::pair<std::string, std::string>, Place> first_place_about;
  std::unordered_set<std::string> met;  // many answers, few names: hashing is quicker than order

  void add(const StudyAnswer& answer) {
    scales_about[answer.stimulus].insert(answer.scale);
    if (met.insert("stimulus " + answer.stimulus).second) stimuli.insert(answer.stimulus);
    if (answer.participant.empty()) return;
    auto& about = answered[answer.participant];
    if (about.empty()) first_place.emplace(answer.participant, answer.place);
    auto& on = about[answer.stimulus];
    if (on.empty()) {
      first_place_about.emplace(std::pair(answer.participant, answer.stimulus), answer.place);
    }
    on.insert(answer.scale);
  }

  /// Whether every participant should have rated every stimulus.
  bool complete_design() const {
    size_t complete = 0;
    for (const auto& [participant, seen] : answered) complete += seen.size() == stimuli.size();
    return 2 * complete >= answered.size();
  }
};

std::string joined(const std::set<std::string>& all, const auto& present) {
  std::vector<std::string> absent;
  for (const std::string& name : all) {
    if (!present.contains(name)) absent.push_back(motion::in_quotes(name));
  }
  return fmt::format("{}", fmt::join(absent, ", "));
}

void add_absent(const Attendance& attendance, std::vector<StudyWarning>& missing) {
  const bool complete_design = attendance.complete_design();
  for (const auto& [participant, seen] : attendance.answered) {
    if (complete_design && seen.size() < attendance.stimuli.size()) {
      missing.push_back(
          {"missing", attendance.first_place.at(participant),
           fmt::format("participant {} did not answer about {}", motion::in_quotes(participant),
                       joined(attendance.stimuli, seen))});
    }
    for (const auto& [stimulus, scales] : seen) {
      const std::set<std::string>& asked = attendance.scales_about.at(stimulus);
      if (scales.size() == asked.size()) continue;
      missing.push_back({"missing", attendance.first_place_about.at({participant, stimulus}),
                         fmt::format("participant {} did not answer about {} on {}",
                                     motion::in_quotes(participant), motion::in_quotes(stimulus),
                                     joined(asked, scales))});
    }
  }
}

bool holds_repeated(const StudyAnswers& study) {
  std::unordered_set<std::string> seen;
  seen.reserve(study.answers.size());
  return std::any_of(study.answers.begin(), study.answers.end(), [&](const StudyAnswer& answer) {
    const char apart = '\0';  // which no text holds
    return !seen.insert(answer.participant + apart + answer.stimulus + apart + answer.scale).second;
  });
}

}  // namespace

Answers StudyAnswers::plain() const {
  Answers result;
  result.simulated = simulated;
  for (const StudyAnswer& answer : answers) {
    result.answers.push_back({answer.participant, answer.stimulus, answer.scale, answer.value});
  }
  return result;
}

void settle_repeated(StudyAnswers& study, const AnswerRules& rules, std::vector<Fault>& faults) {
  if (!holds_repeated(study)) return;
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, std::vector<StudyAnswer>> by_key;
  for (const StudyAnswer& answer : study.answers) {
    by_key[{answer.participant, answer.stimulus, answer.scale}].push_back(answer);
  }
  std::vector<StudyAnswer> settled;
  for (const StudyAnswer& answer : study.answers) {
    const auto& same = by_key.at({answer.participant, answer.stimulus, answer.scale});
    const bool is_first = same.front().place.line == answer.place.line;
    if (is_first && same.size() == 1) settled.push_back(answer);
    if (is_first && same.size() > 1) settled.push_back(one_of(same, rules.repeated));
    if (is_first) continue;
    const std::string wrong = "a second answer " + whose(answer);
    if (rules.repeated == AnswerRules::Repeated::refuse) {
      faults.push_back({answer.place, "", wrong, remedy_of_repeated(rules)});
    } else {
      study.warnings.push_back({"repeated", answer.place,
                                fmt::format("{} (the other in line {}): {}", wrong,
                                            same.front().place.line, words_for(rules.repeated))});
    }
  }
  study.answers = std::move(settled);
}

void settle_constant(StudyAnswers& study, const ScaleSet& scales, AnswerRules::Constant rule) {
  struct Spread {
    Place place;
    int count = 0;
    double least = 2.0;
    double most = -1.0;
  };
  std::map<std::string, Spread> spreads;
  const auto known = scales_by_id(scales);
  for (const StudyAnswer& answer : study.answers) {
    Spread& spread = spreads[answer.participant];
    const double share = share_of(*known.at(answer.scale), answer.value);
    if (spread.count++ == 0) spread.place = answer.place;
    spread.least = std::min(spread.least, share);
    spread.most = std::max(spread.most, share);
  }
  std::set<std::string> constant;
  for (const auto& [participant, spread] : spreads) {
    if (participant.empty() || spread.count < 3 || spread.most - spread.least > 1e-12) continue;
    constant.insert(participant);
    study.warnings.push_back(
        {"constant-participant", spread.place,
         fmt::format("participant {} gave the same answer {} times: {}",
                     motion::in_quotes(participant), spread.count,
                     rule == AnswerRules::Constant::drop ? "excluded" : "kept")});
  }
  if (rule == AnswerRules::Constant::keep) return;
  std::erase_if(study.answers,
                [&](const StudyAnswer& answer) { return constant.contains(answer.participant); });
}

void settle_missing(StudyAnswers& study, const std::vector<StudyAnswer>& left_empty,
                    AnswerRules::Missing rule, std::vector<Fault>& faults) {
  Attendance attendance;
  std::vector<StudyWarning> missing;
  for (const StudyAnswer& answer : study.answers) attendance.add(answer);
  for (const StudyAnswer& answer : left_empty) {
    attendance.add(answer);
    missing.push_back({"missing", answer.place, "no value of " + subject_of(answer)});
  }
  add_absent(attendance, missing);
  for (StudyWarning& warning : missing) {
    if (rule == AnswerRules::Missing::refuse) {
      faults.push_back({warning.place, "", warning.text, "complete it, or use --missing ignore"});
    } else {
      study.warnings.push_back(std::move(warning));
    }
  }
}

}  // namespace mien::pipeline
