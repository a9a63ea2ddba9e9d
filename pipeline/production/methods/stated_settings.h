#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/base/reading/field_values.h"
#include "pipeline/production/methods/prose.h"

namespace mien::pipeline {

/// Options in the words of a methods section, each said once with those that have it: "a fade-in of
/// 0.3 s; walking on the spot (a and b)". An option without words here is stated by its own name,
/// so none is left out.
class StatedSettings {
 public:
  /// An option at a path of the manifest ("output.presentation.fade_in"); maps are taken apart.
  void add(const std::string& path, const OrderedJson& value, const std::string& of);

  bool empty() const { return settings_.empty(); }

  /// All of them, in the order in which they were added; Where a setting holds for
  /// `everybody`, no ids are listed.
  std::string text(const Names& everybody) const;

 private:
  std::vector<std::pair<std::string, Names>> settings_;  ///< words, who
};

/// An option in words: "tempo × 0.8", "head-flexion 15°".
std::string words_of_option(std::string_view path, const OrderedJson& value);

}  // namespace mien::pipeline
