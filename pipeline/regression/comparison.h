#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/measures/differences/motion_difference.h"
#include "motion/text/words.h"
#include "pipeline/manifest/regression_limits.h"
#include "pipeline/regression/comparison/frame_comparison.h"
#include "pipeline/regression/settings.h"

namespace mien::pipeline {

/// What made something look different.
enum class Cause {
  motion,       ///< what the manifest says of the motion, or a file that it is made from
  scene,        ///< figure, set, camera, size of the picture; a file that they are made from
  drawing,      ///< samples, shutter, seed
  renderer,     ///< the same scene is drawn otherwise by another program
  synthesis,    ///< the same motion is made otherwise by another program
  encoder,      ///< the same frames in another file
  environment,  ///< another library, instruction set or processor
  unknown,      ///< nothing that is known of has changed: chance, or a damaged baseline
};

inline constexpr Words<Cause> cause_words = {
    {"motion", Cause::motion},           {"scene", Cause::scene},
    {"drawing", Cause::drawing},         {"renderer", Cause::renderer},
    {"synthesis", Cause::synthesis},     {"encoder", Cause::encoder},
    {"environment", Cause::environment}, {"unknown", Cause::unknown}};

inline std::string_view name_of(Cause cause) { return word_of(cause_words, cause); }

/// One cause of a difference.
struct Attribution {
  Cause cause = Cause::unknown;
  std::string root;  ///< what it comes from, the same words for all stimuli: differences are
                     ///< grouped by it: "adjectives.quickness 0.6 → 0.61", "Embree 3.13.5 → 4.3.0"
  std::string evidence;  ///< a sentence: what was exchanged, and what became of it
  /// Of the mean squared error of the pictures, 0 … 1 (a Shapley value: below 0 where it hides what
  /// others do); nothing where no picture differs.
  std::optional<double> share;
};

/// The result of comparing a stimulus with its baseline.
enum class Verdict {
  same,   ///< every number and pixel is as it was
  alike,  ///< within the limits, or no more than the renderer's noise
  differs,
  appeared,  ///< is new
  gone,
};

inline constexpr Words<Verdict> verdict_words = {{"same", Verdict::same},
                                                 {"alike", Verdict::alike},
                                                 {"differs", Verdict::differs},
                                                 {"appeared", Verdict::appeared},
                                                 {"gone", Verdict::gone}};

inline std::string_view name_of(Verdict verdict) { return word_of(verdict_words, verdict); }

/// A number that has changed.
struct ValueChange {
  std::string name;
  double before = 0.0;
  double now = 0.0;
};

/// The values that differ between the lists; 0 where one is missing.
std::vector<ValueChange> value_changes(const NamedValues& before, const NamedValues& now);

/// A video that is not as it was.
struct VideoChange {
  std::string format;
  std::vector<std::string> what;  ///< "114 frames → 113"; "other bytes"
  bool same_frames = true;        ///< as many, at the same times
  double psnr_lost_db = 0.0;      ///< that it is less like its frames than before
};

/// Everything that is known of how a stimulus differs from what was approved.
struct StimulusComparison {
  std::string id;
  Verdict verdict = Verdict::same;
  std::vector<SettingChange> settings;
  std::vector<ValueChange> weights;
  std::vector<ValueChange> parameters;             ///< as they were reached
  std::optional<motion::MotionDifference> motion;  ///< when it has changed
  std::vector<FrameComparison> frames;             ///< key frames that were drawn and compared
  int frames_reused = 0;                           ///< that cannot have changed
  std::vector<VideoChange> videos;
  std::vector<Attribution> causes;   ///< the largest share first
  double interaction = 0.0;          ///< share that no cause has alone
  std::vector<std::string> reasons;  ///< for `differs`: limits that are passed
  std::string former_id;             ///< of one that appeared: it was approved under another name
};

/// Says whether a stimulus counts as another, and for each limit that is passed a sentence. What a
/// picture changes by because of a motion that is within its limits is no reason; nor is noise,
/// unless the scene's settings have changed: its pictures have the noise of the old one.
void judge(StimulusComparison& comparison, const RegressionLimits& limits);

}  // namespace mien::pipeline
