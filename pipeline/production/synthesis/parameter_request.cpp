#include "pipeline/production/synthesis/parameter_request.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "pipeline/manifest/people.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

namespace {

/// Largest deviation from a requested value that counts as reaching it.
constexpr double met_tolerance = 0.005;  // what two decimals show

/// Others that a sentence names before it only counts them.
constexpr std::size_t named_others = 4;

const std::string held_may_vary = "held parameters free";

using TableLine = std::array<std::string, 5>;

bool is_named(const std::string& name, const NamedValues& values) {
  return std::ranges::find(values, name, &NamedValues::value_type::first) != values.end();
}

bool is_group(const std::string& name, const ScaleSet& scales) {
  return std::ranges::find(scales.groups, name, &ScaleGroup::id) != scales.groups.end();
}

/// Groups when a group is requested, and scales otherwise.
std::vector<std::string> others_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  const auto is_a_group = [&](const std::string& name) {
    return is_group(name, repertoire.scales);
  };
  const bool by_groups =
      std::ranges::any_of(stimulus.adjectives, is_a_group, &NamedValues::value_type::first);
  std::vector<std::string> others;
  for (const std::string& name : repertoire.parameters.names) {
    if (is_a_group(name) == by_groups && !is_named(name, stimulus.adjectives))
      others.push_back(name);
  }
  return others;
}

/// The shares of the examples in the motion that held parameters are those of.
Eigen::VectorXd reference_weights(const Hold& hold, const Repertoire& repertoire) {
  if (!hold.reference.empty()) return weights_of(hold.reference[0], repertoire);
  const auto count = static_cast<Eigen::Index>(repertoire.names.size());
  return Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count));
}

NamedValues held_values(const Stimulus& stimulus, const Repertoire& repertoire) {
  const Hold& hold = stimulus.hold;
  const std::vector<std::string> names = hold.others ? others_of(stimulus, repertoire) : hold.names;
  NamedValues held = hold.values;
  if (names.empty()) return held;
  const Eigen::VectorXd weights = reference_weights(hold, repertoire);
  for (const std::string& name : names) {
    const Eigen::Index row = parameter_row(name, repertoire.parameters);
    held.emplace_back(name, repertoire.parameters.values.row(row).dot(weights));
  }
  return held;
}

void add(const NamedValues& values, ParameterRequest& request) {
  for (const auto& [name, value] : values) {
    request.sliders.sliders.push_back(name);
    request.settings.conservativeResize(request.settings.size() + 1);
    request.settings[request.settings.size() - 1] = value;
  }
}

/// The feasible range of parameter `which` while the others of the columns of `places` are as
/// requested, or as near to it as possible.
FeasibleParameter feasible_parameter(const ParameterRequest& request, const Eigen::MatrixXd& places,
                                     Eigen::Index which) {
  FeasibleParameter parameter;
  const Eigen::RowVectorXd settings = request.settings.leftCols(places.cols());
  parameter.range = motion::feasible_range(places, settings, which);
  parameter.alone = {.least = places.col(which).minCoeff(), .most = places.col(which).maxCoeff()};
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const std::string& name = request.sliders.sliders[static_cast<std::size_t>(i)];
    if (i != which) parameter.others.emplace_back(name, settings[i]);
  }
  parameter.name = request.sliders.sliders[static_cast<std::size_t>(which)];
  parameter.requested = settings[which];
  return parameter;
}

/// "clearness 0.60, activeness 0.70".
std::string listed(const NamedValues& others) {
  std::string text;
  const std::size_t shown = others.size() > named_others + 1 ? named_others : others.size();
  for (std::size_t i = 0; i < shown; ++i)
    text += fmt::format("{}{} {:.2f}", i > 0 ? ", " : "", others[i].first, others[i].second);
  if (shown < others.size()) text += fmt::format(" and {} more", others.size() - shown);
  return text;
}

bool others_can_be(const FeasibleParameter& parameter) {
  return parameter.range.miss <= met_tolerance;
}

/// "0.66 to 0.72"; that of all blends where none has the other parameters.
std::string range_words(const FeasibleParameter& parameter) {
  const motion::ParameterRange& range =
      others_can_be(parameter) ? parameter.range : parameter.alone;
  return fmt::format("{:.2f} to {:.2f}", range.least, range.most);
}

/// A line of the table of requested parameters, with columns of such widths.
std::string table_line(const TableLine& line, const std::array<std::size_t, 4>& widths) {
  std::string text = fmt::format("{:<{}}  {:<{}}  {:>{}}  {:<{}}  {}", line[0], widths[0], line[1],
                                 widths[1], line[2], widths[2], line[3], widths[3], line[4]);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

/// On what the range of the line depends.
std::string condition_words(const FeasibleParameter& parameter) {
  std::string text = listed(parameter.others);
  if (!others_can_be(parameter)) {
    text = fmt::format("no blend has {} (nearest: {:.2f} off)", text, parameter.range.miss);
  } else if (!text.empty()) {
    text = "others as requested: " + text;
  }
  if (parameter.ignores_held) text += (text.empty() ? "" : "; ") + held_may_vary;
  return text;
}

}  // namespace

const NamedValues& requested_values(const Stimulus& stimulus) {
  return stimulus.features.empty() ? stimulus.adjectives : stimulus.features;
}

const ParameterTable& table_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  return stimulus.features.empty() ? repertoire.parameters : repertoire.features.table;
}

ParameterRequest request_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  ParameterRequest request;
  request.sliders.kind =
      stimulus.features.empty() ? InterfaceKind::adjectives : InterfaceKind::features;
  add(requested_values(stimulus), request);
  const NamedValues held = held_values(stimulus, repertoire);
  add(held, request);
  request.held = static_cast<Eigen::Index>(held.size());
  return request;
}

bool FeasibleParameter::is_feasible() const {
  return range.miss <= met_tolerance && requested > range.least - met_tolerance &&
         requested < range.most + met_tolerance;
}

std::vector<FeasibleParameter> feasible_parameters(const ParameterRequest& request,
                                                   const ParameterTable& table) {
  const Eigen::Index requested = request.settings.size() - request.held;
  const Eigen::MatrixXd all = places_of_examples(request.sliders.sliders, table);
  std::vector<FeasibleParameter> parameters;
  for (Eigen::Index i = 0; i < requested; ++i) {
    FeasibleParameter parameter = feasible_parameter(request, all, i);
    if (request.held > 0 && !parameter.is_feasible()) {
      parameter = feasible_parameter(request, all.leftCols(requested), i);
      parameter.ignores_held = true;
    }
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

std::string to_sentence(const FeasibleParameter& parameter) {
  std::string text = "feasible range " + range_words(parameter);
  if (!others_can_be(parameter)) {
    text += fmt::format("; no blend has {}: the nearest deviates by {:.2f}",
                        listed(parameter.others), parameter.range.miss);
  } else if (!parameter.others.empty()) {
    text += " with " + listed(parameter.others);
  }
  if (parameter.ignores_held) text += " with " + held_may_vary;
  return text;
}

std::string to_sentence(const RequestedParameter& requested) {
  const FeasibleParameter& parameter = requested.parameter;
  return fmt::format("{}: {} {:.2f} requested{}; {}", requested.stimulus, parameter.name,
                     parameter.requested, parameter.is_feasible() ? "" : " but not feasible",
                     to_sentence(parameter));
}

std::string feasibility_table(const std::vector<RequestedParameter>& requested) {
  if (requested.empty()) return "";
  std::vector<TableLine> lines = {
      {"stimulus", "parameter", "requested", "feasible range", "condition"}};
  for (const auto& [stimulus, parameter] : requested) {
    lines.push_back(
        {stimulus, parameter.name,
         fmt::format("{}{:.2f}", parameter.is_feasible() ? "" : "! ", parameter.requested),
         range_words(parameter), condition_words(parameter)});
  }
  std::array<std::size_t, 4> widths{};
  for (const TableLine& line : lines) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const TableLine& line : lines) text += table_line(line, widths);
  if (!std::ranges::all_of(requested, [](const auto& one) { return one.parameter.is_feasible(); }))
    text += "! requested value outside the feasible range\n";
  return text;
}

std::vector<RequestedParameter> requested_parameters(const Manifest& manifest) {
  Motions motions(manifest);
  return requested_parameters(manifest, motions);
}

std::vector<RequestedParameter> requested_parameters(const Manifest& manifest, Motions& motions) {
  std::vector<RequestedParameter> requested;
  const auto asks = [](const Stimulus* motion) {
    return !motion->adjectives.empty() &&
           motion->interpolation.weights.method != motion::InterpolationMethod::pca;
  };
  const std::vector<const Stimulus*> sources = motion_sources(manifest);
  if (!std::ranges::any_of(sources, asks)) return requested;
  const Repertoire& repertoire = motions.repertoire();
  for (const Stimulus* motion : sources) {
    if (!asks(motion)) continue;
    const ParameterRequest request = request_of(*motion, repertoire);
    for (FeasibleParameter& parameter : feasible_parameters(request, repertoire.parameters))
      requested.push_back({motion->id, std::move(parameter)});
  }
  return requested;
}

}  // namespace mien::pipeline
