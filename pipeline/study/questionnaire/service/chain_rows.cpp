#include "pipeline/study/questionnaire/service/chain_rows.h"

namespace mien::pipeline {

namespace {

struct Row {
  const ChainDesign& design;
  const ChainAnswer& of;

  std::optional<bool> passed() const {
    if (of.expected.empty()) return std::nullopt;
    return passes_check(design, of.expected, of.answer);
  }
  bool is_gibbs() const { return design.method == ChainMethod::gibbs; }
  template <class Value>
  std::optional<Value> of_gibbs(Value value) const {
    return is_gibbs() ? std::optional<Value>(std::move(value)) : std::nullopt;
  }
  template <class Value>
  std::optional<Value> of_choices(Value value) const {
    return is_gibbs() ? std::nullopt : std::optional<Value>(std::move(value));
  }
};

constexpr auto columns = table_of<Row>(
    "steps.csv", "answer to a step of a chain, practice and attention checks included",
    {{"participant", "",
      "participant id: position in the design, not a name; empty of an answer "
      "whose participant has withdrawn",
      [](auto& r) { return r.of.participant; }},
     {"session", "", "random id of the browser session", [](auto& r) { return r.of.session; }},
     {"design", "", "hash of the experiment", [](auto& r) { return r.of.design; }},
     {"simulated", "0/1", "1: simulated answer", [](auto& r) { return r.of.simulated; }},
     {"trial", "", "number of the trial, from 1", [](auto& r) { return r.of.trial; }},
     {"is_practice", "0/1", "1: practice trial, not part of a chain",
      [](auto& r) { return r.of.is_practice; }},
     {"is_check", "0/1", "1: attention check, not part of a chain",
      [](auto& r) { return !r.of.expected.empty(); }},
     {"passed", "0/1", "1: the attention check was passed, 0: failed; otherwise empty",
      [](auto& r) { return r.passed(); }},
     {"attempt", "", "attempt at the trial, from 1; above 1 after a reload",
      [](auto& r) { return r.of.answer.attempt; }},
     {"word", "", "id of the word that the motion was to look like; check in attention checks",
      [](auto& r) { return r.of.answer.word; }},
     {"chain", "",
      "number of the chain, from 1: of the word or, if each participant has chains of "
      "their own, of word and participant",
      [](auto& r) { return r.of.answer.chain; }},
     {"step", "", "step of the chain, from 0", [](auto& r) { return r.of.answer.step; }},
     {"person", "", "person, from 0, among those who answer this step",
      [](auto& r) { return r.of.answer.person; }},
     {"point", "of the dimension",
      "values of all dimensions before the answer, separated by spaces",
      [](auto& r) { return point_text(r.of.answer.point); }},
     {"dimension", "", "the dimension that the slider changed; empty if motions were chosen",
      [](auto& r) { return r.of_gibbs(r.design.dimensions[r.of.answer.dimension]); }},
     {"value", "of the dimension", "value of that dimension, as chosen",
      [](auto& r) { return r.of_gibbs(r.of.answer.value); }},
     {"slider_start", "0–1", "where the slider stood at first, as a share of the range",
      [](auto& r) { return r.of_gibbs(r.of.answer.slider.start); }},
     {"is_reversed", "0/1", "1: the high end of the slider was at the left",
      [](auto& r) { return r.of_gibbs(r.of.answer.slider.is_reversed); }},
     {"proposal", "of the dimension",
      "values of all dimensions of the motion shown beside that of the point",
      [](auto& r) { return r.of_choices(point_text(r.of.answer.proposal)); }},
     {"is_proposal_first", "0/1", "1: the proposal was at the left",
      [](auto& r) { return r.of_choices(r.of.answer.is_proposal_first); }},
     {"chose_proposal", "0/1", "1: the proposal was chosen, and is the next point",
      [](auto& r) { return r.of_choices(r.of.answer.chose_proposal); }},
     {"moves", "", "number of times that the slider changed",
      [](auto& r) { return r.of.answer.moves; }},
     {"trial_ms", "ms", "duration of the trial", [](auto& r) { return r.of.trial_ms; }},
     {"started_at", "", "ISO 8601 time at which the trial began, by the participant's clock",
      [](auto& r) { return r.of.started_at; }}});

}  // namespace

const TableForm chain_steps_form = columns.form();

std::string point_text(const std::vector<double>& point) {
  std::string text;
  for (const double value : point) text += (text.empty() ? "" : " ") + field_text(value);
  return text;
}

std::string chain_steps_csv(const std::vector<ChainAnswer>& answers, const ChainDesign& design) {
  return columns.of_parts(design, answers).csv;
}

}  // namespace mien::pipeline
