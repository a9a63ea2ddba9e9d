#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "motion/live/live_bundle.h"
#include "motion/live/slider_interface.h"
#include "motion/live/synthesis.h"
#include "motion/measures/distance/distance.h"

namespace mien::motion {

/// The slider values of an interface.
struct LiveSetting {
  InterfaceKind kind = InterfaceKind::adjectives;
  std::vector<std::string> sliders;  ///< weights that are not named are 0
  std::vector<double> values;        ///< 0 to 1, one a slider
};

/// A motion to be shown: one cycle of a loop.
struct LiveMotion {
  Example motion;
  Eigen::VectorXd weights;  ///< one for each example; empty if it is not a blend
  std::vector<FootPlant> plants;
};

/// Synthesizes motions from slider values interactively. The interpolation of an interface is
/// fitted when it is first used. Not thread-safe; needs no threads or files.
class LiveCore {
 public:
  /// Keeps a reference to the bundle.
  explicit LiveCore(const LiveBundle& bundle) : bundle_(bundle) {}

  /// An example or target as a stimulus of that name alone would be. Throws Error when there is
  /// none of that name.
  LiveMotion example(std::string_view name) const;
  LiveMotion target(std::string_view name) const;

  /// The motion of a setting, as a stimulus with the same request would be. Throws Error for an
  /// unknown or repeated slider, a value outside 0 to 1, or more parameters than the method takes.
  LiveMotion make(const LiveSetting& setting);

  /// Distance as `mien motion compare` measures it for the clip files of both, the target first.
  /// Throws Error as `make` does, and when there is no such target.
  Distance distance(std::string_view target, const LiveSetting& setting);

 private:
  const FittedInterface& fitted(const SliderInterface& interface);
  SynthesisContext context() const;
  const LiveTarget& find_target(std::string_view name) const;
  const Example& compared_target(std::string_view name);

  const LiveBundle& bundle_;
  std::map<std::vector<std::string>, FittedInterface> fitted_;  ///< by kind and sliders
  std::map<std::string, Example, std::less<>> compared_;        ///< targets as they are compared
};

}  // namespace mien::motion
