#include "pipeline/study/questionnaire/service/chain_record.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/study/questionnaire/service/record_reader.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t max_dimensions = 64;

/// Tolerance between the browser's and our arithmetic.
constexpr double slack = 1e-9;

/// Of the slider in attention checks, as a share of its range.
constexpr double check_tolerance = 0.05;

std::vector<double> read_point(RecordReader& reader, const char* name) {
  const nlohmann::json& list = reader.required(name);
  if (!list.is_array() || list.size() > max_dimensions)
    throw RecordFault(fmt::format("\"{}\" is not a point", name));
  std::vector<double> point;
  for (const nlohmann::json& one : list) {
    if (!one.is_number() || !std::isfinite(one.get<double>()))
      throw RecordFault(fmt::format("\"{}\" is not a point", name));
    point.push_back(one.get<double>());
  }
  return point;
}

int read_count(RecordReader& reader, const char* name) {
  reader.required(name);
  return *reader.count(name);
}

/// A value of a dimension.
double read_value(RecordReader& reader, const char* name) {
  const nlohmann::json& value = reader.required(name);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw RecordFault(fmt::format("\"{}\" is not a number", name));
  return value.get<double>();
}

/// A place of the slider, from 0 to 1.
double read_share(RecordReader& reader, const char* name) {
  return reader.required_amount(name, 1.0);
}

bool is_within(double value, const DimensionRange& range) {
  return value >= range.low - slack && value <= range.high + slack;
}

void check_point(const ChainDesign& design, const std::vector<double>& point) {
  bool is_inside = point.size() == design.space.size();
  for (std::size_t i = 0; is_inside && i < point.size(); ++i)
    is_inside = is_within(point[i], design.space[i]);
  if (!is_inside) throw RecordFault("a point is outside the space");
}

bool is_near(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= slack; });
}

void check_slider(const ChainDesign& design, const StepView& view, const ChainRecord& record) {
  if (record.dimension != view.dimension || record.slider.start != view.slider.start ||
      record.slider.is_reversed != view.slider.is_reversed)
    throw RecordFault("the slider was not the one of this step");
  if (!is_within(record.value, design.space[record.dimension]))
    throw RecordFault("a value is outside the range of its dimension");
}

void check_proposal(const ChainDesign& design, const StepView& view, const ChainRecord& record) {
  std::vector<double> proposal;
  for (std::size_t i = 0; i < design.space.size(); ++i) {
    const DimensionRange& range = design.space[i];
    const double by = design.deviation * (range.high - range.low) * view.normals[i];
    proposal.push_back(reflected(record.point[i] + by, range));
  }
  if (record.is_proposal_first != view.is_proposal_first || !is_near(proposal, record.proposal))
    throw RecordFault("the proposal was not the one of this step");
  check_point(design, record.proposal);
}

PlannedStep read_step(const nlohmann::ordered_json& trial, const std::string& participant) {
  PlannedStep step;
  if (!trial.contains("word")) return step;
  step.name = {trial.at("word"), trial.at("chain"), participant};
  step.step = trial.at("step");
  if (const auto slider = trial.find("slider"); slider != trial.end()) {
    step.view.dimension = trial.at("dimension");
    step.view.slider = {slider->at("start"), slider->at("reversed")};
  } else {
    step.view.normals = trial.at("normals").get<std::vector<double>>();
    step.view.is_proposal_first = trial.at("proposal_first");
  }
  return step;
}

ChainDesign read_design(const nlohmann::ordered_json& chains) {
  ChainDesign design{
      .method = meaning_of(chain_method_words, chains.at("method").get<std::string>()).value(),
      .chains = chains.at("chains"),
      .steps = chains.at("steps"),
      .people_per_step = chains.at("people_per_step"),
      .aggregate = chains.at("aggregate") == word_of(step_aggregate_words, StepAggregate::mean)
                       ? SliderAggregate::mean
                       : SliderAggregate::median,
      .deviation = chains.at("deviation"),
      .seed = std::stoull(chains.at("seed").get<std::string>())};
  for (const auto& dimension : chains.at("dimensions")) {
    design.dimensions.push_back(dimension.at("name"));
    design.space.push_back({dimension.at("low"), dimension.at("high")});
  }
  for (const auto& [word, shown] : chains.at("words").items()) design.words.push_back(word);
  design.has_relative_values = chains.at("kind") == motion::name_of(motion::InterfaceKind::weights);
  if (const auto until = chains.find("until"); until != chains.end())
    design.until = ChainEnd{.r_hat = until->at("r_hat"),
                            .at_least = until->at("at_least"),
                            .at_most = until->at("at_most")};
  return design;
}

}  // namespace

ChainFacts chain_facts(const nlohmann::ordered_json& experiment) {
  const nlohmann::ordered_json& chains = experiment.at("chains");
  ChainFacts facts{.design = read_design(chains),
                   .across_participants = chains.at("across_participants"),
                   .answer_within_s = chains.value("answer_within_s", 0.0),
                   .max_failed_checks = chains.value("max_failed_checks", 0)};
  if (const auto starts = chains.find("starts"); starts != chains.end())
    for (const auto& [key, point] : starts->items())
      facts.starts[key] = point.get<std::vector<double>>();
  for (const auto& session : experiment.at("sessions")) {
    std::vector<PlannedStep>& steps = facts.sessions.emplace_back();
    for (const auto& trial : session.at("trials"))
      steps.push_back(read_step(trial, session.at("participant")));
  }
  return facts;
}

ChainRecord read_chain_record(const nlohmann::json& text) {
  RecordReader reader(text, "a step of a chain");
  ChainRecord record;
  record.word = reader.name("word");
  record.chain = read_count(reader, "chain");
  record.step = read_count(reader, "step");
  record.person = read_count(reader, "person");
  record.point = read_point(reader, "point");
  record.moves = read_count(reader, "moves");
  record.attempt = read_count(reader, "attempt");
  if (reader.find("proposal") == nullptr) {
    record.dimension = static_cast<std::size_t>(read_count(reader, "dimension"));
    record.slider = {read_share(reader, "start"), reader.boolean("reversed")};
    record.value = read_value(reader, "value");
  } else {
    record.proposal = read_point(reader, "proposal");
    record.is_proposal_first = reader.boolean("proposal_first");
    record.chose_proposal = reader.boolean("chose_proposal");
  }
  reader.finish();
  return record;
}

nlohmann::ordered_json chain_json(const ChainRecord& record) {
  nlohmann::ordered_json json = {{"word", record.word},      {"chain", record.chain},
                                 {"step", record.step},      {"person", record.person},
                                 {"point", record.point},    {"moves", record.moves},
                                 {"attempt", record.attempt}};
  if (record.proposal.empty()) {
    json["dimension"] = record.dimension;
    json["start"] = record.slider.start;
    json["reversed"] = record.slider.is_reversed;
    json["value"] = record.value;
  } else {
    json["proposal"] = record.proposal;
    json["proposal_first"] = record.is_proposal_first;
    json["chose_proposal"] = record.chose_proposal;
  }
  return json;
}

bool passes_check(const ChainDesign& design, const std::string& expected,
                  const ChainRecord& record) {
  const bool is_left = expected == word_of(check_side_words, CheckSide::left);
  if (design.method == ChainMethod::mcmc)
    return (record.chose_proposal == record.is_proposal_first) == is_left;
  const DimensionRange& range = design.space[record.dimension];
  const double share = (record.value - range.low) / (range.high - range.low);
  const double from_left = record.slider.is_reversed ? 1.0 - share : share;
  return (is_left ? from_left : 1.0 - from_left) <= check_tolerance;
}

void check_chain_record(const ChainFacts& facts, const SessionPlan& plan, const Trial& trial,
                        const ChainRecord& record) {
  const ChainDesign& design = facts.design;
  PlannedStep planned = facts.sessions.at(static_cast<std::size_t>(plan.index))
                            .at(static_cast<std::size_t>(trial.number) - 1);
  const bool is_assigned = planned.name.word.empty();
  if (is_assigned) {
    const bool is_known = std::ranges::find(design.words, record.word) != design.words.end() &&
                          record.chain >= 1 && record.chain <= design.chains &&
                          record.step < design.steps && record.person < design.people_per_step;
    if (!is_known) throw RecordFault("the experiment has no such step");
    planned.name = {record.word, record.chain, ""};
    planned.step = record.step;
    planned.view = step_view(design, planned.name, record.step, record.person);
  }
  if (record.word != planned.name.word || record.chain != planned.name.chain ||
      record.step != planned.step || (!is_assigned && record.person != 0))
    throw RecordFault("the record is of a different step");
  if (record.attempt < 1) throw RecordFault("a trial was never started");
  check_point(design, record.point);
  if (record.proposal.empty() != (design.method == ChainMethod::gibbs))
    throw RecordFault("the record is of a different method");
  if (design.method == ChainMethod::gibbs)
    check_slider(design, planned.view, record);
  else
    check_proposal(design, planned.view, record);
}

}  // namespace mien::pipeline
