#pragma once

#include <string>
#include <string_view>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// The readable label of a parameter: one name, or the two ends of a scale.
struct ParameterLabel {
  std::string name;      ///< empty for a scale
  std::string japanese;  ///< may be empty
  std::string low;       ///< low end of a scale
  std::string high;
  std::string japanese_low;
  std::string japanese_high;
};

/// Returns the label of a scale or a group of scales; the id itself if it is not in the set.
ParameterLabel rating_label(std::string_view id, const ScaleSet& scales);

/// Returns the label of a feature or a group of features.
ParameterLabel feature_label(std::string_view id);

/// Returns the label of a parameter that a stimulus requests.
ParameterLabel label_of(std::string_view id, const Stimulus& stimulus,
                        const Repertoire& repertoire);

/// A name in the language of names, which is not NameLanguage::study: "step length", "歩幅", or
/// "step length 歩幅". In English if there is no Japanese name.
std::string name_in(NameLanguage language, const std::string& english, const std::string& japanese);

/// "quickness", "sad – happy".
std::string english_text(const ParameterLabel& label);
/// 速さ, 悲しい – 嬉しい; empty if there is no Japanese name.
std::string japanese_text(const ParameterLabel& label);

}  // namespace mien::pipeline
