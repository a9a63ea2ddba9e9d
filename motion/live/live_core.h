#pragma once

#include <map>
#include <optional>
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
  /// Names of sliders; weights that are not named are 0, and modifications are as the motion is.
  std::vector<std::string> sliders;
  /// One per slider: 0 to 1; of modifications within the limits of their dimensions.
  std::vector<double> values;
};

/// A motion to be shown; of a loop, one cycle.
struct LiveMotion {
  Example motion;
  Eigen::VectorXd weights;  ///< one per example; empty if it is not a blend
  std::vector<FootPlant> plants;
};

/// Synthesizes motions from slider values interactively. The interpolation of an interface is
/// fitted on first use. Not thread-safe; uses no threads or files.
class LiveCore {
 public:
  /// Keeps a reference to the bundle.
  explicit LiveCore(const LiveBundle& bundle) : bundle_(bundle) {}

  /// An example or a target, as a stimulus that specifies nothing but its name would show it.
  /// Throws Error if the name is unknown.
  LiveMotion example(std::string_view name) const;
  LiveMotion target(std::string_view name) const;

  /// The motion for a setting, as for a stimulus with the same request. Throws Error for an unknown
  /// or repeated slider, a value outside its limits, or more parameters than the method supports.
  LiveMotion make(const LiveSetting& setting);

  /// The distance between a target and the motion for a setting, as measured by `mien motion
  /// compare` for their clip files. Throws Error as `make` does, and for an unknown target.
  Distance distance(std::string_view target, const LiveSetting& setting);

 private:
  const FittedInterface& fitted(const SliderInterface& interface);
  SynthesisContext context() const;
  LiveMotion modified(const LiveSetting& setting);
  const LiveTarget& find_target(std::string_view name) const;
  const Example& compared_target(std::string_view name);

  const LiveBundle& bundle_;
  std::map<std::vector<std::string>, FittedInterface> fitted_;  ///< by kind and sliders
  std::optional<Example> original_;                             ///< of modifications
  std::map<std::string, Example, std::less<>> compared_;        ///< targets prepared for comparison
};

}  // namespace mien::motion
