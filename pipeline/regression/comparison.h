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

/// The cause of a difference.
enum class Cause {
  motion,        ///< settings of the motion, or a file that it is made from
  scene,         ///< figure, set, camera or picture size, or a file that they are made from
  drawing,       ///< samples, shutter or seed of the noise
  renderer,      ///< another version of the program renders the same scene differently
  synthesis,     ///< another version of the program synthesizes the motion differently
  presentation,  ///< what a video shows around the film, and which videos are made
  encoder,       ///< the same frames, encoded differently
  environment,   ///< a different library, instruction set or processor
  unknown,       ///< no known input has changed: nondeterminism or a damaged baseline
};

inline constexpr Words<Cause> cause_words = {
    {"motion", Cause::motion},       {"scene", Cause::scene},
    {"drawing", Cause::drawing},     {"renderer", Cause::renderer},
    {"synthesis", Cause::synthesis}, {"presentation", Cause::presentation},
    {"encoder", Cause::encoder},     {"environment", Cause::environment},
    {"unknown", Cause::unknown}};

inline std::string_view name_of(Cause cause) { return word_of(cause_words, cause); }

/// One cause of a difference.
struct Attribution {
  Cause cause = Cause::unknown;
  /// Origin of the change, worded identically for all stimuli so that differences can be grouped by
  /// it: "adjectives.quickness 0.6 → 0.61", "Embree 3.13.5 → 4.3.0".
  std::string root;
  std::string evidence;  ///< a sentence about what was exchanged and its effect
  /// Share of the mean squared error of the frame that differs most: a Shapley value, usually 0 …
  /// 1, below 0 if it reduces the effect of other causes. Unset if no frames of equal size differ,
  /// or if the approved state cannot be made again.
  std::optional<double> share;
};

/// The result of comparing a stimulus with its baseline.
enum class Verdict {
  same,   ///< the motion, every pixel of the key frames, and the videos are unchanged
  alike,  ///< changed within the limits, or no more than the renderer's noise
  differs,
  appeared,  ///< not in the baseline
  gone,      ///< not in the current manifest
};

inline constexpr Words<Verdict> verdict_words = {{"same", Verdict::same},
                                                 {"alike", Verdict::alike},
                                                 {"differs", Verdict::differs},
                                                 {"appeared", Verdict::appeared},
                                                 {"gone", Verdict::gone}};

inline std::string_view name_of(Verdict verdict) { return word_of(verdict_words, verdict); }

/// A changed number.
struct ValueChange {
  std::string name;
  double before = 0.0;
  double now = 0.0;
};

/// Returns the values that differ between the lists; a missing value counts as 0.
std::vector<ValueChange> value_changes(const NamedValues& before, const NamedValues& now);

/// A changed video.
struct VideoChange {
  std::string format;
  /// Descriptions of the changes: "114 frames → 113", "different content".
  std::vector<std::string> what;
  /// The number of frames, the frame rate and the sound are unchanged; false for a video that is no
  /// longer made, true for a new one.
  bool same_frames = true;
  /// Decrease of the lowest PSNR between the video and its frames, dB; 0 if the current video shows
  /// its frames exactly. A former video that did counts as 100 dB.
  double psnr_lost_db = 0.0;
  /// Whether the frames that were encoded are the same, with those around the film. Unset if it is
  /// not known: a baseline of a version up to 0.3 has no hash of them.
  std::optional<bool> same_pictures = {};
  bool is_made = true;  ///< false for a video that is no longer made
};

/// All differences between a stimulus and its approved state.
struct StimulusComparison {
  std::string id;
  Verdict verdict = Verdict::same;
  std::vector<SettingChange> settings;
  std::vector<ValueChange> weights;
  std::vector<ValueChange> parameters;             ///< changes of the values reached
  std::optional<motion::MotionDifference> motion;  ///< set if the motion has changed
  /// Rendered and compared key frames; for a stimulus that appeared or is gone, the one shown,
  /// without measures.
  std::vector<FrameComparison> frames;
  /// Number of key frames not rendered, because none of their inputs has changed.
  int frames_reused = 0;
  std::vector<VideoChange> videos;
  std::vector<Attribution> causes;  ///< causes, largest share first
  double interaction = 0.0;         ///< share that occurs only if causes are combined (CauseShares)
  std::vector<std::string>
      reasons;            ///< sentences that explain `differs` (judge), `appeared` or `gone`
  std::string former_id;  ///< for a renamed stimulus: the id under which it was approved
};

/// Sets the verdict and the reasons: a sentence for each exceeded limit and for a changed picture
/// size. Of several frames or body parts that exceed a limit, only the worst is named. Changed
/// videos are reasons only if there are no other reasons; a lower PSNR is not a reason if the
/// frames themselves differ and no video setting has changed. Other frames in a video are a reason
/// if the motion and the key frames are the same, or the presentation has changed; if it is not
/// known whether they are others, a changed presentation is a reason. Picture changes caused only
/// by a motion within its limits are not a reason. Neither is noise, unless the scene's settings
/// have changed: the approved noise statistics then belong to another scene.
void judge(StimulusComparison& comparison, const RegressionLimits& limits);

}  // namespace mien::pipeline
