#include "motion/live/live_core.h"

#include <algorithm>

#include "motion/error.h"
#include "motion/examples/compared_example.h"
#include "motion/gait/contact.h"

namespace mien::motion {

namespace {

/// Interfaces that are kept: more than a page has, and few enough for a server.
constexpr std::size_t most_fitted = 64;

std::size_t index_of_example(std::string_view name, const ExampleSet& set) {
  for (std::size_t i = 0; i < set.examples.size(); ++i) {
    if (set.examples[i].name == name) return i;
  }
  throw Error("there is no example \"" + std::string(name) + "\"",
              "name one of the set's examples");
}

/// Whether there is a value for each slider, and each slider once.
void check_sliders(const LiveSetting& setting) {
  if (setting.sliders.size() != setting.values.size()) {
    throw Error("there are " + std::to_string(setting.sliders.size()) + " sliders and " +
                    std::to_string(setting.values.size()) + " values",
                "give one value per slider");
  }
  std::vector<std::string> names = setting.sliders;
  std::sort(names.begin(), names.end());
  const auto twin = std::adjacent_find(names.begin(), names.end());
  if (twin != names.end()) {
    throw Error("slider \"" + *twin + "\" appears twice", "give each slider once");
  }
}

void check_values(const LiveSetting& setting) {
  check_sliders(setting);
  for (std::size_t i = 0; i < setting.sliders.size(); ++i) {
    const double value = setting.values[i];
    if (value >= 0.0 && value <= 1.0) continue;
    throw Error("slider \"" + setting.sliders[i] + "\" is not between 0 and 1",
                "give a value from 0 to 1");
  }
}

/// The values of all dimensions.
std::vector<double> placed_modifications(const LiveSetting& setting, const LiveModification& by) {
  check_sliders(setting);
  std::vector<double> point;
  for (const ModificationDimension& dimension : by.dimensions)
    point.push_back(neutral_value(dimension.value));
  for (std::size_t i = 0; i < setting.sliders.size(); ++i) {
    const auto found =
        std::find_if(by.dimensions.begin(), by.dimensions.end(),
                     [&](const auto& dimension) { return dimension.name == setting.sliders[i]; });
    if (found == by.dimensions.end())
      throw Error("there is no modification \"" + setting.sliders[i] + "\"",
                  "name a dimension of the recipe");
    if (!(setting.values[i] >= found->low && setting.values[i] <= found->high))
      throw Error("slider \"" + setting.sliders[i] + "\" is not within its limits",
                  "give a value within them");
    point[static_cast<std::size_t>(found - by.dimensions.begin())] = setting.values[i];
  }
  return point;
}

/// An interface and where its sliders stand.
struct Placed {
  SliderInterface interface;
  Eigen::RowVectorXd settings;
};

Placed placed_weights(const LiveSetting& setting, const ExampleSet& set) {
  Placed placed{{InterfaceKind::weights, {}}, {}};
  for (const Example& example : set.examples) placed.interface.sliders.push_back(example.name);
  placed.settings.setZero(static_cast<Eigen::Index>(set.examples.size()));
  for (std::size_t i = 0; i < setting.sliders.size(); ++i) {
    placed.settings[static_cast<Eigen::Index>(index_of_example(setting.sliders[i], set))] =
        setting.values[i];
  }
  return placed;
}

Placed placed_sliders(const LiveSetting& setting, const ExampleSet& set) {
  check_values(setting);
  if (setting.kind == InterfaceKind::weights) return placed_weights(setting, set);
  if (setting.sliders.empty()) throw Error("there are no sliders", "give one at least");
  const auto count = static_cast<Eigen::Index>(setting.values.size());
  return {{setting.kind, setting.sliders},
          Eigen::RowVectorXd(Eigen::Map<const Eigen::RowVectorXd>(setting.values.data(), count))};
}

LiveMotion as_live(SynthesizedMotion made) {
  return {std::move(made.motion), std::move(made.found.weights), std::move(made.plants)};
}

}  // namespace

SynthesisContext LiveCore::context() const {
  return {bundle_.examples, bundle_.how, bundle_.frames_per_second};
}

LiveMotion LiveCore::example(std::string_view name) const {
  const std::size_t index = index_of_example(name, bundle_.examples);
  Eigen::VectorXd weights =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bundle_.examples.examples.size()));
  weights[static_cast<Eigen::Index>(index)] = 1.0;
  LiveMotion made = as_live(synthesize_from_weights(weights, context()));
  made.motion.name = name;
  return made;
}

const LiveTarget& LiveCore::find_target(std::string_view name) const {
  for (const LiveTarget& target : bundle_.targets) {
    if (target.name == name) return target;
  }
  throw Error("there is no target \"" + std::string(name) + "\"", "name one of the targets");
}

LiveMotion LiveCore::target(std::string_view name) const {
  const LiveTarget& target = find_target(name);
  return {target.motion, target.weights, foot_plants(target.motion.clip)};
}

const FittedInterface& LiveCore::fitted(const SliderInterface& interface) {
  std::vector<std::string> key = interface.sliders;
  key.emplace_back(name_of(interface.kind));
  const auto found = fitted_.find(key);
  if (found != fitted_.end()) return found->second;
  if (fitted_.size() >= most_fitted) fitted_.clear();
  const ParameterTable& table =
      interface.kind == InterfaceKind::features ? bundle_.features : bundle_.adjectives;
  FittedInterface made = fit_interface(interface, bundle_.how, bundle_.examples, table);
  return fitted_.emplace(std::move(key), std::move(made)).first->second;
}

LiveMotion LiveCore::modified(const LiveSetting& setting) {
  const LiveModification& by = bundle_.modification;
  const std::vector<double> point = placed_modifications(setting, by);
  if (by.empty()) throw Error("no motion is modified here", "use another interface");
  if (!original_) original_ = example(by.original).motion;
  LiveMotion made{modified_at(*original_, by, point), {}, {}};
  made.plants = foot_plants(made.motion.clip);
  return made;
}

LiveMotion LiveCore::make(const LiveSetting& setting) {
  if (setting.kind == InterfaceKind::modifications) return modified(setting);
  const Placed placed = placed_sliders(setting, bundle_.examples);
  const FittedInterface& interface = fitted(placed.interface);
  return as_live(synthesize_for(interface, placed.settings, context(),
                                {bundle_.feature_scale, bundle_.features}));
}

const Example& LiveCore::compared_target(std::string_view name) {
  const auto found = compared_.find(name);
  if (found != compared_.end()) return found->second;
  const LiveTarget& target = find_target(name);
  Clip shown = playback_clip(target.motion.clip, target.playback);
  const auto frames = static_cast<std::size_t>(target.shown_frames);
  if (frames > 0 && frames < shown.poses.size()) shown.poses.resize(frames);
  return compared_.emplace(name, compared_example_as_written(shown)).first->second;
}

Distance LiveCore::distance(std::string_view target, const LiveSetting& setting) {
  const Example& aim = compared_target(target);
  const Clip shown = playback_clip(make(setting).motion.clip, bundle_.playback);
  return motion::distance(aim, compared_example_as_written(shown));
}

}  // namespace mien::motion
