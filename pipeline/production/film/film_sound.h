#pragma once

#include <optional>
#include <string>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/film/film_record.h"
#include "render/sound/sound.h"

namespace mien::pipeline {

/// True peaks of sounds with equalized loudness stay below this level, dBTP (EBU R 128).
inline constexpr double most_true_peak_dbtp = -1.0;

/// The sound of a film's videos.
struct FilmSound {
  /// As long as the video. It begins with the film, after card, cross and blank.
  render::Sound sound;
  int held_frames = 0;  ///< by which the film's last picture is shown longer
  SoundRecord record;
};

/// Reads the sound of a stimulus and fits it to its film of `film_frames` frames (SoundLength).
/// With `target_lufs`, a gain gives it that integrated loudness.
///
/// Returns nothing for a stimulus without a sound. Throws Error when the file cannot be read, the
/// offset lies beyond its end, the lengths differ by more than half a frame and the stimulus does
/// not say what then, a sample exceeds full scale, or, with a target, loudness cannot be measured
/// or the true peak would reach most_true_peak_dbtp.
std::optional<FilmSound> film_sound(const Stimulus& stimulus,
                                    const std::optional<double>& target_lufs, int film_frames);

}  // namespace mien::pipeline
