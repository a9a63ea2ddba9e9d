#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/live/live_core.h"
#include "motion/measures/distance/distance.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/matching/experiment/matching_study.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// As the page rounds it (page/src/matching/slider_panel.ts).
double starting_value(const ordered_json& sliders, const std::string& name) {
  for (const ordered_json& slider : sliders)
    if (slider.at("name") == name)
      return std::round(100.0 * std::clamp(slider.at("mean").get<double>(), 0.0, 1.0)) / 100.0;
  return 0.0;
}

motion::LiveSetting starting_setting(const MatchingStudy& study, const std::string& interface) {
  const ordered_json info = ordered_json::parse(study.bundle.info).at("sliders");
  const ordered_json& shown =
      study.experiment.at("matching").at("sliders").at(interface).at("shown");
  motion::LiveSetting setting{.kind = meaning_of(motion::interface_kinds, interface).value(),
                              .sliders = shown.get<std::vector<std::string>>()};
  const bool has_means = info.contains(interface);
  for (const std::string& slider : setting.sliders)
    setting.values.push_back(has_means ? starting_value(info.at(interface), slider) : 0.0);
  return setting;
}

}  // namespace

std::vector<StartingDistance> starting_distances(const Manifest& manifest,
                                                 const MatchingStudy& study) {
  motion::LiveCore core(study.bundle);
  std::vector<StartingDistance> distances;
  for (const std::string& interface : matching_of(manifest).interfaces) {
    const motion::LiveSetting setting = starting_setting(study, interface);
    for (const std::string& target : matching_targets(manifest))
      distances.push_back({target, interface, core.distance(target, setting).mean});
  }
  return distances;
}

double suggested_threshold(const std::vector<StartingDistance>& distances) {
  if (distances.empty()) return motion::distance_threshold_m;
  std::vector<double> metres;
  for (const StartingDistance& one : distances) metres.push_back(one.metres);
  std::ranges::sort(metres);
  const double median = metres[metres.size() / 2];
  const double half = std::floor(500.0 * median) / 1000.0;
  return std::clamp(half, 0.001, motion::distance_threshold_m);
}

std::string starting_match_warning(const Manifest& manifest, const MatchingStudy& study) {
  const std::vector<StartingDistance> distances = starting_distances(manifest, study);
  const double threshold = matching_of(manifest).threshold_m;
  std::vector<StartingDistance> near;
  std::ranges::copy_if(distances, std::back_inserter(near),
                       [&](const StartingDistance& one) { return one.metres < threshold; });
  if (near.empty()) return {};
  const auto& nearest = *std::ranges::min_element(near, {}, &StartingDistance::metres);
  const double fitting = suggested_threshold(distances);
  const std::string lower = fitting < threshold
                                ? fmt::format(
                                      "use a lower threshold ({:.3f} m is half of the median "
                                      "starting distance), or other targets",
                                      fitting)
                                : "use other targets there, or remove these trials";
  return fmt::format(
      "{}: matching.threshold_m: {} of {} pairs of target and interface start closer than {} m "
      "(closest: {} with {}, {:.3f} m); {}",
      manifest.file.string(), near.size(), distances.size(), threshold, nearest.target,
      nearest.interface, nearest.metres, lower);
}

}  // namespace mien::pipeline
