#include "pipeline/production/synthesis/wish.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/production/synthesis/motions.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

namespace {

/// As near to a wish as counts for meeting it.
constexpr double met = 0.005;  // what two decimals show

/// Others that a sentence names before it only counts them.
constexpr std::size_t named_others = 4;

bool is_named(const std::string& name, const NamedValues& values) {
  return std::ranges::find(values, name, &NamedValues::value_type::first) != values.end();
}

bool is_group(const std::string& name, const ScaleSet& scales) {
  return std::ranges::find(scales.groups, name, &ScaleGroup::id) != scales.groups.end();
}

/// Groups when a group is asked for, and scales otherwise.
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

NamedValues held_by(const Stimulus& stimulus, const Repertoire& repertoire) {
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

void add(const NamedValues& values, Wish& wish) {
  for (const auto& [name, value] : values) {
    wish.sliders.sliders.push_back(name);
    wish.settings.conservativeResize(wish.settings.size() + 1);
    wish.settings[wish.settings.size() - 1] = value;
  }
}

/// Of wish `which` while the other wishes among the first `count` are met as far as they can be.
FeasibleParameter feasible_among(const Wish& wish, const Eigen::MatrixXd& places,
                                 Eigen::Index which) {
  FeasibleParameter parameter;
  const Eigen::RowVectorXd settings = wish.settings.leftCols(places.cols());
  parameter.range = motion::feasible_range(places, settings, which);
  parameter.alone = {.least = places.col(which).minCoeff(), .most = places.col(which).maxCoeff()};
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const std::string& name = wish.sliders.sliders[static_cast<std::size_t>(i)];
    if (i != which) parameter.others.emplace_back(name, settings[i]);
  }
  parameter.name = wish.sliders.sliders[static_cast<std::size_t>(which)];
  parameter.asked = settings[which];
  return parameter;
}

std::string listed(const NamedValues& others) {
  std::string text;
  const std::size_t shown = others.size() > named_others + 1 ? named_others : others.size();
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == others.size() ? " and " : ", ";
    text += fmt::format("{} is {:.2f}", others[i].first, others[i].second);
  }
  if (shown < others.size()) text += fmt::format(" and {} others are held", others.size() - shown);
  return text;
}

}  // namespace

const NamedValues& wishes_of(const Stimulus& stimulus) {
  return stimulus.features.empty() ? stimulus.adjectives : stimulus.features;
}

const ParameterTable& table_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  return stimulus.features.empty() ? repertoire.parameters : repertoire.features.table;
}

Wish wish_of(const Stimulus& stimulus, const Repertoire& repertoire) {
  Wish wish;
  wish.sliders.kind =
      stimulus.features.empty() ? InterfaceKind::adjectives : InterfaceKind::features;
  add(wishes_of(stimulus), wish);
  const NamedValues held = held_by(stimulus, repertoire);
  add(held, wish);
  wish.held = static_cast<Eigen::Index>(held.size());
  return wish;
}

bool FeasibleParameter::holds() const {
  return range.miss <= met && asked > range.least - met && asked < range.most + met;
}

std::vector<FeasibleParameter> feasible_parameters(const Wish& wish, const ParameterTable& table) {
  const Eigen::Index asked = wish.settings.size() - wish.held;
  const Eigen::MatrixXd all = places_of_examples(wish.sliders.sliders, table);
  std::vector<FeasibleParameter> parameters;
  for (Eigen::Index i = 0; i < asked; ++i) {
    FeasibleParameter parameter = feasible_among(wish, all, i);
    if (wish.held > 0 && !parameter.holds()) {
      parameter = feasible_among(wish, all.leftCols(asked), i);
      parameter.gives_up_held = true;
    }
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

std::string to_sentence(const FeasibleParameter& parameter) {
  const bool others_can_be = parameter.range.miss <= met;
  const motion::ParameterRange& range = others_can_be ? parameter.range : parameter.alone;
  std::string text = fmt::format("blends of these examples have {:.2f} to {:.2f} of {}",
                                 range.least, range.most, parameter.name);
  if (!parameter.others.empty()) {
    text += others_can_be ? " while " + listed(parameter.others)
                          : fmt::format(", but in none {}: the nearest is {:.2f} off",
                                        listed(parameter.others), parameter.range.miss);
  }
  if (parameter.gives_up_held) text += ", and what is held is given up";
  return text;
}

std::vector<std::string> feasible_ranges(const Manifest& manifest) {
  Motions motions(manifest);
  return feasible_ranges(manifest, motions);
}

std::vector<std::string> feasible_ranges(const Manifest& manifest, Motions& motions) {
  std::vector<std::string> lines;
  const auto asks = [](const Stimulus& stimulus) {
    return !stimulus.adjectives.empty() &&
           stimulus.interpolation.weights.method != motion::InterpolationMethod::pca;
  };
  if (!std::ranges::any_of(manifest.stimuli, asks)) return lines;
  const Repertoire& repertoire = motions.repertoire();
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!asks(stimulus)) continue;
    const Wish wish = wish_of(stimulus, repertoire);
    for (const FeasibleParameter& parameter : feasible_parameters(wish, repertoire.parameters)) {
      lines.push_back(fmt::format("{}: {} {:.2f} is asked for{}; {}", stimulus.id, parameter.name,
                                  parameter.asked, parameter.holds() ? "" : " and cannot be made",
                                  to_sentence(parameter)));
    }
  }
  return lines;
}

}  // namespace mien::pipeline
