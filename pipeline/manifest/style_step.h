#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// Older style transfer methods, which apply the difference of two examples to a motion
/// (motion/style_transfer).
enum class StyleMethod {
  amaya,         ///< timing and amplitude of joints
  unuma,         ///< Fourier series of the gait cycle
  hsu,           ///< linear time-invariant system
  witkin,        ///< motion warping through the styled example's keyframes
  waveshape,     ///< amplitude of joint rotations about their means
  displacement,  ///< displacement map towards the mean posture of the styled example
  shapiro,       ///< independent component analysis
  neff,          ///< drives: positions of the hands, bend of torso and head, height of the pelvis
};

inline constexpr Words<StyleMethod> style_methods = {{"amaya", StyleMethod::amaya},
                                                     {"unuma", StyleMethod::unuma},
                                                     {"hsu", StyleMethod::hsu},
                                                     {"witkin", StyleMethod::witkin},
                                                     {"waveshape", StyleMethod::waveshape},
                                                     {"displacement", StyleMethod::displacement},
                                                     {"shapiro", StyleMethod::shapiro},
                                                     {"neff", StyleMethod::neff}};

inline std::string_view name_of(StyleMethod method) { return word_of(style_methods, method); }

/// A modification by an older method: `{method: unuma, neutral: normal, styled: sad}`.
struct StyleStep {
  StyleMethod method = StyleMethod::amaya;
  std::string neutral;  ///< name of the neutral example
  std::string styled;   ///< name of the styled example
  int harmonics = 7;    ///< unuma: harmonics of the cycle, ≥ 1
  int order = 10;       ///< hsu: states of the model, 1 … 10
  int inputs = 3;       ///< hsu: principal components of the neutral motion as inputs, ≥ 1
  int components = 6;   ///< shapiro: independent components, ≥ 1
  /// shapiro: indices of the exchanged components, from 0 (the strongest); empty: the two that
  /// differ most.
  std::vector<int> swap;
  std::uint64_t seed = 0;  ///< shapiro: seed of the analysis
  bool feet = true;        ///< lock the feet after the transfer
};

/// `repair:`; `none` disables foot locking.
struct StyleRepairForm {
  static void read(const DocumentValue& given, bool& feet);
  static nlohmann::ordered_json write(bool feet, const WritingOptions&);
};

void fields_of(auto&& field, MaybeConst<StyleStep> auto& style) {
  field("method", style.method, concerns::motion | concerns::required, style_methods);
  field("neutral", style.neutral, concerns::motion);
  field("styled", style.styled, concerns::motion);
  field("harmonics", style.harmonics, concerns::motion);
  field("order", style.order, concerns::motion);
  field("inputs", style.inputs, concerns::motion);
  field("components", style.components, concerns::motion);
  field("swap", style.swap, concerns::motion);
  field("seed", style.seed, concerns::motion);
  field.by("repair", style.feet, concerns::motion, StyleRepairForm());
}

}  // namespace mien::pipeline
