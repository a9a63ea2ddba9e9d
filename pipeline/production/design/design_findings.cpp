#include "pipeline/production/design/design_findings.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/production/clips/people_clips.h"

namespace mien::pipeline {

namespace {

/// One warning of all films that are cut by more than half; it names the one that loses most.
std::optional<DesignWarning> cut_films(const Manifest& manifest, Motions& motions) {
  if (!manifest.equalize.duration || manifest.stimuli.empty()) return std::nullopt;
  std::vector<double> seconds;
  for (const Stimulus& one : manifest.stimuli)
    seconds.push_back(own_frames(one, motions) / one.output.fps);
  const auto least = std::ranges::min_element(seconds), most = std::ranges::max_element(seconds);
  const auto cut = std::ranges::count_if(seconds, [&](double one) { return one > 2.0 * *least; });
  if (cut == 0) return std::nullopt;
  const auto id_at = [&](auto at) {
    return motion::in_quotes(manifest.stimuli[static_cast<std::size_t>(at - seconds.begin())].id);
  };
  std::string wrong =
      fmt::format("equalizing durations cuts {} from {:.3g} s to {:.3g} s, the duration of {}",
                  id_at(most), *most, *least, id_at(least));
  if (cut > 1)
    wrong += fmt::format(", and {} more {} by more than half", cut - 1, cut > 2 ? "films" : "film");
  return DesignWarning{"equalize", std::move(wrong),
                       fmt::format("leave out {}, or do not equalize durations", id_at(least))};
}

}  // namespace

DesignFindings planned_design(const Manifest& manifest, Motions& motions) {
  DesignFindings findings{.properties = {}, .close = {}, .cut = cut_films(manifest, motions)};
  if (studied_factors(manifest).empty()) return findings;
  findings.properties = factor_properties(manifest, planned_properties(manifest, motions));
  findings.close = close_levels(manifest, motions);
  return findings;
}

DesignFindings filmed_design(const Manifest& manifest, Motions& motions,
                             const std::filesystem::path& folder) {
  DesignFindings findings{.properties = {}, .close = {}, .cut = cut_films(manifest, motions)};
  if (studied_factors(manifest).empty()) return findings;
  findings.properties = factor_properties(manifest, filmed_properties(manifest, motions, folder));
  findings.close = close_levels(manifest, motions);
  return findings;
}

std::vector<DesignWarning> design_warnings(const Manifest& manifest,
                                           const DesignFindings& findings) {
  std::vector<DesignWarning> warnings = confound_warnings(manifest, findings.properties);
  for (DesignWarning& warning : close_level_warnings(manifest, findings.close))
    warnings.push_back(std::move(warning));
  if (findings.cut) warnings.push_back(*findings.cut);
  return warnings;
}

std::string to_sentence(const DesignWarning& warning) {
  return warning.wrong + "; " + warning.remedy;
}

Fault design_fault(const DesignWarning& warning, const Places& places) {
  return {place_of(places, warning.path), warning.path, warning.wrong, warning.remedy};
}

}  // namespace mien::pipeline
