#include "pipeline/production/synthesis/parameter_label.h"

#include "motion/measures/features/motion_features.h"

namespace mien::pipeline {

ParameterLabel rating_label(std::string_view id, const ScaleSet& scales) {
  ParameterLabel label;
  if (const Scale* scale = find_scale(scales, id)) {
    label.low = scale->low;
    label.high = scale->high;
    label.japanese_low = scale->japanese_low;
    label.japanese_high = scale->japanese_high;
    return label;
  }
  label.name = id;
  for (const ScaleGroup& group : scales.groups) {
    if (group.id == id) label.japanese = group.japanese;
  }
  return label;
}

ParameterLabel feature_label(std::string_view id) {
  ParameterLabel label;
  label.name = id;
  for (int g = 0; g < motion::feature_group_count; ++g) {
    const auto group = static_cast<motion::FeatureGroup>(g);
    if (motion::id_of(group) != id) continue;
    label.name = motion::name_of(group);
    label.japanese = motion::japanese_name_of(group);
  }
  if (const int index = motion::find_motion_feature(id); index >= 0) {
    const motion::MotionFeature& feature = motion::motion_features()[static_cast<size_t>(index)];
    label.name = feature.name;
    label.japanese = feature.japanese;
  }
  return label;
}

ParameterLabel label_of(std::string_view id, const Stimulus& stimulus,
                        const Repertoire& repertoire) {
  return stimulus.features.empty() ? rating_label(id, repertoire.scales) : feature_label(id);
}

std::string name_in(NameLanguage language, const std::string& english,
                    const std::string& japanese) {
  if (japanese.empty() || language == NameLanguage::english) return english;
  return language == NameLanguage::japanese ? japanese : english + " " + japanese;
}

std::string english_text(const ParameterLabel& label) {
  return label.name.empty() ? label.low + " – " + label.high : label.name;
}

std::string japanese_text(const ParameterLabel& label) {
  if (!label.name.empty()) return label.japanese;
  if (label.japanese_low.empty() && label.japanese_high.empty()) return "";
  return label.japanese_low + " – " + label.japanese_high;
}

}  // namespace mien::pipeline
