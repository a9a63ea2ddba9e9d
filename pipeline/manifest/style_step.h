#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien::pipeline {

/// Older methods that give a motion the difference of two others (motion/classic).
enum class StyleMethod {
  amaya,         ///< timing and amplitude of joints
  unuma,         ///< Fourier series of the cycle
  hsu,           ///< linear time-invariant system
  witkin,        ///< motion warping through the styled example's keyframes
  waveshape,     ///< how widely joints swing about their means
  displacement,  ///< displacement map towards the styled mean posture
  shapiro,       ///< independent components
  neff,          ///< drives: places of hands, bend of torso and head, height of the pelvis
};

inline constexpr std::array<std::pair<const char*, StyleMethod>, 8> style_methods = {{
    {"amaya", StyleMethod::amaya},
    {"unuma", StyleMethod::unuma},
    {"hsu", StyleMethod::hsu},
    {"witkin", StyleMethod::witkin},
    {"waveshape", StyleMethod::waveshape},
    {"displacement", StyleMethod::displacement},
    {"shapiro", StyleMethod::shapiro},
    {"neff", StyleMethod::neff},
}};

/// As manifests call it.
inline std::string_view name_of(StyleMethod method) {
  return style_methods[static_cast<std::size_t>(method)].first;
}

/// A modification by an older method: `{method: unuma, neutral: normal, styled: sad}`.
struct StyleStep {
  StyleMethod method = StyleMethod::amaya;
  std::string neutral;     ///< example
  std::string styled;      ///< example
  int harmonics = 7;       ///< unuma
  int order = 10;          ///< hsu
  int inputs = 3;          ///< hsu
  int components = 6;      ///< shapiro
  std::vector<int> swap;   ///< shapiro; empty: the two most different ones
  std::uint64_t seed = 0;  ///< shapiro
  bool feet = true;        ///< lock the feet afterwards
};

}  // namespace mien::pipeline
