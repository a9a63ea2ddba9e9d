#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/base/reading/field_values.h"
#include "pipeline/production/methods/prose.h"

namespace mien::pipeline {

/// Collects settings for a methods section. Each setting is stated once, with the stimuli to which
/// it applies: "a fade-in of 0.3 s; walking in place (a and b)". An option for which no wording is
/// defined is stated by its own name, so that none is omitted.
class StatedSettings {
 public:
  /// Adds the value of an option at a path of the manifest ("output.presentation.fade_in"), used by
  /// the stimulus `of`. Maps are added member by member.
  void add(const std::string& path, const OrderedJson& value, const std::string& of);

  bool empty() const { return settings_.empty(); }

  /// Returns all settings in the order in which they were added, those of the same stimuli
  /// together. Up to six stimuli are given by their ids; more are only counted ("7 of 20"). None
  /// are given for settings that apply to all stimuli of `everybody`.
  std::string text(const Names& everybody) const;

 private:
  std::vector<std::pair<std::string, Names>> settings_;  ///< wording and ids of the stimuli
};

/// Returns the wording of an option: "tempo × 0.8", "head-flexion 15°".
std::string words_of_option(std::string_view path, const OrderedJson& value);

}  // namespace mien::pipeline
