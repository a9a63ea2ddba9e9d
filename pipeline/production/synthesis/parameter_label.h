#pragma once

#include <string>
#include <string_view>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// What people read instead of a parameter's id: one name, or the two ends of a scale.
struct ParameterLabel {
  std::string name;      ///< empty for a scale
  std::string japanese;  ///< may be empty
  std::string low;       ///< ends of a scale
  std::string high;
  std::string japanese_low;
  std::string japanese_high;
};

/// The label of a scale or a group of scales; the id itself if the set does not have it.
ParameterLabel rating_label(std::string_view id, const ScaleSet& scales);

/// The label of a feature or a group of features.
ParameterLabel feature_label(std::string_view id);

/// The label of a parameter that a stimulus requests.
ParameterLabel label_of(std::string_view id, const Stimulus& stimulus,
                        const Repertoire& repertoire);

/// "quickness", "sad – happy".
std::string english_text(const ParameterLabel& label);
/// 速さ, 悲しい – 嬉しい; empty where there is no Japanese.
std::string japanese_text(const ParameterLabel& label);

}  // namespace mien::pipeline
