#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/parameter_table.h"
#include "motion/interpolation/synthesis_options.h"
#include "motion/live/live_modification.h"
#include "motion/live/synthesis.h"
#include "motion/measures/features/feature_scale.h"
#include "motion/skeleton/example.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

/// A target of a matching trial.
struct LiveTarget {
  std::string name;
  Example motion;
  Eigen::VectorXd weights;  ///< blend weights; empty if it is not a blend
  Playback playback;        ///< as for its clip file
  int shown_frames = 0;     ///< number of leading frames that are shown; 0: all
};

/// All data for motion synthesis by sliders without files, in a browser.
struct LiveBundle {
  std::string info;           ///< JSON for pages: the available choices
  ExampleSet examples;        ///< examples for blending; with settled feet if feet are locked
  ParameterTable adjectives;  ///< may be empty
  ParameterTable features;
  FeatureScale feature_scale;
  SynthesisOptions how;
  double frames_per_second = 30.0;
  Playback playback;  ///< as for the clip files of synthesized motions
  std::vector<LiveTarget> targets;
  LiveModification modification;  ///< may be empty
};

/// Version of the binary layout.
inline constexpr int live_bundle_version = 1;

/// The binary form of a bundle: "MIENLIVE", the version of the layout, the length and checksum of
/// the bytes that follow, and these bytes; little endian, doubles exact. The same bundle always
/// produces the same bytes. Recipes must not have a pose difference.
std::string to_bytes(const LiveBundle& bundle);

/// Parses a bundle. Throws Error if the bytes are not a bundle, are of another version, truncated
/// or corrupt, or contain invalid data: no examples, joints that are not those of the body,
/// keytimes that do not ascend, tables for a different number of examples, …
LiveBundle parse_live_bundle(std::string_view bytes);

}  // namespace mien::motion
