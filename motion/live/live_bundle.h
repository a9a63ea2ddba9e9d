#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/parameter_table.h"
#include "motion/interpolation/synthesis_options.h"
#include "motion/live/made_motion.h"
#include "motion/measures/features/feature_scale.h"
#include "motion/skeleton/example.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

/// A motion that is to be matched.
struct LiveTarget {
  std::string name;
  Example motion;
  Eigen::VectorXd weights;  ///< that it is a blend of; empty for what is none
  Showing showing;          ///< as its clip file holds it,
  int shown_frames = 0;     ///< of which only so many from the start; 0: all
};

/// All that sliders need to make motions where there are no files: in a browser.
struct LiveBundle {
  std::string info;           ///< JSON, for pages: what there is to choose from
  ExampleSet examples;        ///< that can be blended; with settled feet where feet are locked
  ParameterTable adjectives;  ///< may be empty
  ParameterTable features;
  FeatureScale feature_scale;
  SynthesisOptions how;
  double frames_per_second = 30.0;
  Showing showing;  ///< as clip files of what is made hold it
  std::vector<LiveTarget> targets;
};

/// Layout of the bytes. Raised with every change of it.
inline constexpr int live_bundle_version = 1;

/// "MIENLIVE", version, length and checksum of what follows, then the bundle: little endian,
/// doubles exact. The same bundle gives the same bytes.
std::string to_bytes(const LiveBundle& bundle);

/// Throws Error when the bytes are no bundle, are of another version, cut short or changed, or hold
/// what cannot be used: no examples, none or other joints than the body has, keytimes that do not
/// ascend, tables of another number of examples, …
LiveBundle parse_live_bundle(std::string_view bytes);

}  // namespace mien::motion
