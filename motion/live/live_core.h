#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "motion/live/live_bundle.h"
#include "motion/live/made_motion.h"
#include "motion/live/slider_interface.h"
#include "motion/measures/distance/distance.h"

namespace mien::motion {

/// Where the sliders of an interface stand.
struct LiveSetting {
  InterfaceKind kind = InterfaceKind::adjectives;
  std::vector<std::string> sliders;  ///< weights that are not named are 0
  std::vector<double> values;        ///< 0 to 1, one a slider
};

/// A motion to be shown: one cycle of a loop.
struct LiveMotion {
  Example motion;
  Eigen::VectorXd weights;  ///< one an example; empty for what is no blend
  std::vector<FootPlant> plants;
};

/// Sliders in, motion out, as often as they are moved: what lies between sliders and examples is
/// fitted when it is first asked for. One at a time; no threads, no files.
class LiveCore {
 public:
  /// Keeps a reference to the bundle.
  explicit LiveCore(const LiveBundle& bundle) : bundle_(bundle) {}

  /// As a stimulus that names it alone would be. Throws Error when there is none of that name.
  LiveMotion example(std::string_view name) const;
  LiveMotion target(std::string_view name) const;

  /// As a stimulus that asks for the same would be. Throws Error: a slider that there is not or
  /// that stands twice, a value beyond 0 to 1, more parameters than the method takes.
  LiveMotion make(const LiveSetting& setting);

  /// What `mien motion compare` finds of the clips of both as they are written to files, the target
  /// first. Throws Error as `make` does, and when there is no such target.
  Distance distance(std::string_view target, const LiveSetting& setting);

 private:
  const FittedInterface& fitted(const SliderInterface& interface);
  Making making() const;
  const LiveTarget& find_target(std::string_view name) const;
  const Example& compared_target(std::string_view name);

  const LiveBundle& bundle_;
  std::map<std::vector<std::string>, FittedInterface> fitted_;  ///< by kind and sliders
  std::map<std::string, Example, std::less<>> compared_;        ///< targets as they are compared
};

}  // namespace mien::motion
