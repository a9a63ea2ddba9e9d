#include "pipeline/manifest/questionnaire_forms.h"

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/factors.h"

namespace mien::pipeline {

namespace {

using OrderKind = TrialOrder::Kind;

constexpr Words<OrderKind> order_words = {
    {"full", OrderKind::full}, {"fixed", OrderKind::fixed}, {"latin", OrderKind::latin}};

/// A member of a map, if it is there.
void read_member(const DocumentValue& given, const char* key, auto& value) {
  const nlohmann::json* found = member(given.value, key);
  if (found != nullptr) read({*found, member_path(given.path, key), given.context}, value);
}

}  // namespace

void StimulusChoiceForm::read(const DocumentValue& given, StimulusChoice& choice) {
  pipeline::read(given, choice.ids);
  if (!given.value.is_object()) return;
  choice.levels.clear();
  for (const std::string& factor : written_order(given.value, given.path, given.context.places)) {
    std::vector<std::string>& levels =
        choice.levels.emplace_back(factor, std::vector<std::string>()).second;
    if (!given.value[factor].is_array()) continue;
    for (const nlohmann::json& level : given.value[factor])
      if (level.is_primitive() && !level.is_null()) levels.push_back(level_text(level));
  }
}

OrderedJson StimulusChoiceForm::write(const StimulusChoice& choice, const WritingOptions& how) {
  return choice.levels.empty() ? written(choice.ids, how) : written(choice.levels, how);
}

void ScaleChoiceForm::read(const DocumentValue& given, ScaleChoice& choice) {
  choice.all = given.value == "all";
  choice.emotions = given.value == "emotions";
  pipeline::read(given, choice.ids);
  read_member(given, "ask", choice.ids);
  read_member(given, "file", choice.file);
  if (!choice.file.empty() && choice.ids.empty()) choice.all = true;
}

OrderedJson ScaleChoiceForm::write(const ScaleChoice& choice, const WritingOptions& how) {
  if (!choice.file.empty()) {
    OrderedJson map = {{"file", written(choice.file, how)}};
    if (!choice.all) map["ask"] = written(choice.ids, how);
    return map;
  }
  if (choice.all) return "all";
  return choice.emotions ? OrderedJson("emotions") : written(choice.ids, how);
}

void ChoicesForm::read(const DocumentValue& given, DisplayedChoices& choices) {
  choices.clear();
  if (given.value.is_object()) {
    for (const std::string& id : written_order(given.value, given.path, given.context.places)) {
      choices.emplace_back(id, LocalText());
      LocalTextForm::read({given.value[id], member_path(given.path, id), given.context},
                          choices.back().second);
    }
    return;
  }
  std::vector<std::string> ids;
  pipeline::read(given, ids);
  for (const std::string& id : ids) choices.emplace_back(id, LocalText{id});
}

OrderedJson ChoicesForm::write(const DisplayedChoices& choices, const WritingOptions& how) {
  std::vector<std::string> ids;
  OrderedJson map = OrderedJson::object();
  for (const auto& [id, shown] : choices) {
    if (shown == LocalText{id}) ids.push_back(id);
    map[id] = LocalTextForm::write(shown, how);
  }
  return ids.size() == choices.size() ? written(ids, how) : map;
}

void AnswerChoiceForm::read(const DocumentValue& given, AnswerChoice& answer) {
  answer.is_number = given.value == "number";
  LocalWordsForm::read(given, answer.choices);
}

OrderedJson AnswerChoiceForm::write(const AnswerChoice& answer, const WritingOptions& how) {
  if (!answer.choices.empty()) return LocalWordsForm::write(answer.choices, how);
  return answer.is_number ? "number" : "text";
}

void TrialOrderForm::read(const DocumentValue& given, TrialOrder& order) {
  order = {};
  assign(&given.value, order.kind, order_words);
  assign(member(given.value, "blocked"), order.factor);
  if (given.value.is_object()) order.kind = OrderKind::blocked;
}

OrderedJson TrialOrderForm::write(const TrialOrder& order, const WritingOptions&) {
  if (order.kind == OrderKind::blocked) return {{"blocked", order.factor}};
  return word_of(order_words, order.kind);
}

void DisplaySizeForm::read(const DocumentValue& given, DisplaySize& size) {
  using Kind = DisplaySize::Kind;
  size = {};
  if (given.value == "native") size.kind = Kind::native;
  for (const auto& [key, kind] : {std::pair("cm", Kind::cm), std::pair("degrees", Kind::degrees)}) {
    const nlohmann::json* amount = member(given.value, key);
    if (amount == nullptr) continue;
    size.kind = kind;
    assign(amount, size.amount);
  }
}

OrderedJson DisplaySizeForm::write(const DisplaySize& size, const WritingOptions&) {
  switch (size.kind) {
    case DisplaySize::Kind::cm:
      return {{"cm", size.amount}};
    case DisplaySize::Kind::degrees:
      return {{"degrees", size.amount}};
    case DisplaySize::Kind::native:
      return "native";
    default:
      return "window";
  }
}

void ReplaysForm::read(const DocumentValue& given, Replays& replays) {
  replays.most.reset();
  if (given.value == "none") replays.most = 0;
  if (given.value.is_number_integer()) assign(&given.value, replays.most);
}

OrderedJson ReplaysForm::write(const Replays& replays, const WritingOptions&) {
  if (!replays.most) return "counted";
  return *replays.most == 0 ? OrderedJson("none") : OrderedJson(*replays.most);
}

}  // namespace mien::pipeline
