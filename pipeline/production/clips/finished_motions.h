#pragma once

#include <filesystem>
#include <string>

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Access to the finished motions of a manifest for code that shows them and does not depend on how
/// they are made. May be used from several threads.
class FinishedMotions {
 public:
  virtual ~FinishedMotions() = default;

  /// Returns the stimulus with that id, or that of a person's motion, or nullptr. A fast look-up,
  /// which assumes that the manifest's ids do not change.
  virtual const Stimulus* stimulus(const std::string& id) const = 0;

  /// Returns the motion of a stimulus, of a person ("greet.a") or, if there is neither, of an
  /// example: at the output's frame rate, one cycle of a loop, including travel. Throws Error, also
  /// for a stimulus with several people.
  virtual const motion::Clip& clip(const std::string& name) = 0;

  /// Returns the clip that is shown for a stimulus with one motion: repeated if it loops, in place
  /// if requested, and cut to the shortest duration of all stimuli if the study equalizes
  /// durations. Throws Error.
  virtual motion::Clip shown(const Stimulus& stimulus) = 0;

  /// Returns the number of frames of a stimulus's film, whether of its own motion or of several
  /// people's; cut if the study equalizes durations. Throws Error.
  virtual int shown_frames(const Stimulus& stimulus) = 0;

  /// Sets the known duration of the shortest of all clips shown, in seconds, so that one clip can
  /// be shown without making all motions. No effect once the duration is known.
  virtual void know_shortest(double seconds) = 0;
};

/// Returns the clip that the video shows for a motion: a loop repeated `output.cycles` times, in
/// place if requested, and not yet cut to an equalized duration.
motion::Clip playback_clip(const motion::Clip& motion, const Output& output);

inline constexpr char durations_task_id[] = "durations";

/// Path in the store's folder of a JSON file with the duration, in seconds, to which every film is
/// cut.
inline constexpr char duration_record_path[] = ".mien/equalized/duration.json";

/// Reads the duration to which every film is cut, in seconds, from such a file. Throws if it does
/// not contain a number.
double recorded_duration(const std::filesystem::path& file);

/// Passes the recorded duration in the store's folder to `motions`. Throws if there is none.
void know_durations(const std::filesystem::path& folder, FinishedMotions& motions);

}  // namespace mien::pipeline
