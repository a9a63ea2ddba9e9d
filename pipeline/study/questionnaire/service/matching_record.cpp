#include "pipeline/study/questionnaire/service/matching_record.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/study/questionnaire/service/record_reader.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t max_sliders = 4000;
constexpr std::size_t max_changes = 30'000;
constexpr double longest_s = max_ms / 1000.0;
constexpr double farthest_m = 1000.0;

/// A clock that ticks is read twice where a trial ends.
constexpr double clock_slack_s = 1.0;

constexpr std::array<std::string_view, 3> slider_actions = {"move", "add", "remove"};
constexpr std::array<std::string_view, 3> moments = {"guess", "match", "limit"};

const nlohmann::json& list_of(RecordReader& reader, const char* name, std::size_t most) {
  const nlohmann::json& list = reader.required(name);
  if (!list.is_array() || list.size() > most)
    throw RecordFault(fmt::format("{} is not a list, or is too long", motion::in_quotes(name)));
  return list;
}

SliderSetting read_setting(const nlohmann::json& text) {
  RecordReader reader(text, "a setting");
  SliderSetting setting;
  for (const nlohmann::json& slider : list_of(reader, "sliders", max_sliders)) {
    if (!slider.is_string()) throw RecordFault("a slider has no name");
    setting.sliders.push_back(slider.get<std::string>());
  }
  for (const nlohmann::json& value : list_of(reader, "values", max_sliders)) {
    const double number = value.is_number() ? value.get<double>() : -1.0;
    if (!(number >= 0.0 && number <= 1.0)) throw RecordFault("a slider is outside 0 to 1");
    setting.values.push_back(number);
  }
  reader.finish();
  if (setting.sliders.size() != setting.values.size())
    throw RecordFault("the numbers of sliders and values of a setting differ");
  return setting;
}

template <std::size_t N>
bool is_one_of(const std::string& word, const std::array<std::string_view, N>& words) {
  return std::ranges::find(words, word) != words.end();
}

MatchingChange read_change(const nlohmann::json& text) {
  RecordReader reader(text, "a change");
  MatchingChange change;
  change.seconds = reader.required_amount("s", longest_s);
  change.step = reader.name("step");
  change.action = reader.name("action");
  change.slider = reader.text("slider", 4 * max_name_characters);
  change.value = reader.amount("value", 1.0);
  change.d = reader.amount("d", farthest_m);
  reader.finish();
  const bool is_of_slider = is_one_of(change.action, slider_actions);
  if (change.step != "guess" && change.step != "adjust")
    throw RecordFault("a change does not belong to any step of a trial");
  if (is_of_slider ? change.slider.empty() : !is_one_of(change.action, moments))
    throw RecordFault("a change refers to an unknown slider or event");
  if (is_of_slider && !change.value) throw RecordFault("a change has no value");
  return change;
}

void check_setting(const std::vector<std::string>& known, const SliderSetting& setting) {
  std::set<std::string> taken;
  for (const std::string& slider : setting.sliders)
    if (std::ranges::find(known, slider) == known.end() || !taken.insert(slider).second)
      throw RecordFault("a slider does not belong to this interface, or appears twice");
}

void check_changes(const std::vector<std::string>& known,
                   const std::vector<MatchingChange>& changes) {
  double last = 0.0;
  for (const MatchingChange& change : changes) {
    if (change.seconds < last) throw RecordFault("times of changes are not in ascending order");
    last = change.seconds;
    if (!change.slider.empty() && std::ranges::find(known, change.slider) == known.end())
      throw RecordFault("a change refers to a slider that this interface does not have");
  }
}

}  // namespace

MatchingFacts matching_facts(const nlohmann::ordered_json& matching) {
  MatchingFacts facts;
  facts.limit_s = matching.at("limit_s");
  facts.threshold_m = matching.at("threshold_m");
  for (const auto& [interface, sliders] : matching.at("sliders").items())
    for (const char* part : {"shown", "offered"})
      for (const auto& slider : sliders.at(part)) facts.sliders[interface].push_back(slider);
  return facts;
}

MatchingRecord read_matching_record(const nlohmann::json& text) {
  RecordReader reader(text, "a match");
  MatchingRecord record;
  record.first = read_setting(reader.required("first"));
  record.last = read_setting(reader.required("last"));
  record.first_guess_d = reader.required_amount("first_guess_d", farthest_m);
  record.guess_s = reader.required_amount("guess_s", longest_s);
  record.d = reader.required_amount("d", farthest_m);
  record.time_s = reader.required_amount("time_s", longest_s);
  record.success = reader.boolean("success");
  reader.required("attempt");
  record.attempt = *reader.count("attempt");
  for (const nlohmann::json& change : list_of(reader, "changes", max_changes))
    record.changes.push_back(read_change(change));
  reader.finish();
  return record;
}

void check_matching_record(const MatchingFacts& facts, const Trial& trial,
                           const MatchingRecord& record) {
  const std::vector<std::string>& known = facts.sliders.at(trial.items.front().item);
  check_setting(known, record.first);
  check_setting(known, record.last);
  check_changes(known, record.changes);
  if (record.attempt < 1) throw RecordFault("a trial was never started");
  if (record.success && (record.d >= facts.threshold_m || record.time_s > facts.limit_s))
    throw RecordFault("a recorded match exceeds the threshold or the time limit");
  if (!record.success && record.time_s < facts.limit_s - clock_slack_s)
    throw RecordFault("a trial without a match ended before the limit");
}

}  // namespace mien::pipeline
