#pragma once

#include <filesystem>
#include <string>

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The motions of a manifest as those take them who show them and do not care how they are made.
/// May be used from several threads.
class FinishedMotions {
 public:
  virtual ~FinishedMotions() = default;

  /// The stimulus of that id, or nullptr. Quick, as the ids of the manifest are taken to stay.
  virtual const Stimulus* stimulus(const std::string& id) const = 0;

  /// The motion of a stimulus or, if no stimulus is called so, of an example: at the output's frame
  /// rate, one cycle of a loop, travelling. Throws Error.
  virtual const motion::Clip& clip(const std::string& name) = 0;

  /// The clip that is shown of a stimulus: a loop repeated, in place when asked for; where the
  /// study has durations equalized, only its beginning, as long as the shortest of all stimuli.
  /// Throws Error.
  virtual motion::Clip shown(const Stimulus& stimulus) = 0;

  /// Takes this for the shortest of all clips shown, as found before, so that one clip can be shown
  /// without making all motions. Without effect once it is known.
  virtual void know_shortest(double seconds) = 0;
};

/// What the video shows of a motion: a loop repeated `output.cycles` times, in place when asked
/// for.
motion::Clip playback_clip(const motion::Clip& motion, const Output& output);

inline constexpr char durations_task_id[] = "durations";

/// Holds how long all films are: a number of seconds in JSON, in the store's folder.
inline constexpr char duration_record_path[] = ".mien/equalized/duration.json";

/// Throws where the file holds no number.
double recorded_duration(const std::filesystem::path& file);

/// Tells the motions what was found, in the store's folder. Throws when there is nothing.
void know_durations(const std::filesystem::path& folder, FinishedMotions& motions);

}  // namespace mien::pipeline
