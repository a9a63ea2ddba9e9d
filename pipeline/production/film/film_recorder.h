#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_sound.h"
#include "pipeline/tasks/hash.h"
#include "render/video/video.h"
#include "render/video/video_check.h"

namespace mien::pipeline {

/// Encodes the frames of a film into several videos at once, including the presentation around the
/// film, and checks the files against the pictures before encoding.
///
///   FilmRecorder recorder(settings, shot.frame_count(), sound);
///   recorder.open(file, render::VideoKind::webm);
///   draw_frames(…, [&](int, const render::Image8& picture) { recorder.take(picture); }, …);
///   recorder.close();
///   recorder.check(file, render::VideoKind::webm);
class FilmRecorder {
 public:
  /// `sound` is what is heard in the videos, if anything. `settings` must outlive the object.
  FilmRecorder(const FilmSettings& settings, int film_frames,
               std::optional<FilmSound> sound = std::nullopt);

  /// Adds a file to be written. Its encoder starts with the first frame. Must be called before the
  /// first `take`.
  void open(const std::filesystem::path& file, render::VideoKind kind);

  /// Adds the film's next frame. Throws render::Error.
  void take(const render::Image8& picture);

  /// Completes all files. Throws render::Error, also if frames are missing.
  void close();

  /// Decodes a completed file. Throws render::Error if it differs from what was recorded by more
  /// than its format's lossy encoding allows.
  const render::VideoCheck& check(const std::filesystem::path& file, render::VideoKind kind);

  /// The result of checking the sound of a file that was checked; nothing without a sound.
  std::optional<render::SoundCheck> sound_check(render::VideoKind kind) const;

  /// Hash of all frames that were written so far, with those around the film.
  Hash frames_hash() const;

  const std::optional<FilmSound>& sound() const { return sound_; }

  /// Returns the results of the checks.
  const std::map<render::VideoKind, render::VideoCheck>& checks() const { return checks_; }

  const PresentationFrames& frames() const { return presenter_.frames(); }

 private:
  render::VideoFormat format_of(render::VideoKind kind) const;
  void begin_files();
  int row_step() const;  ///< step between checked rows: the smallest that a format requires

  const FilmSettings& settings_;
  std::optional<FilmSound> sound_;
  Presenter presenter_;
  render::VideoSketch sketch_;
  // Files whose encoders have not started.
  std::map<render::VideoKind, std::filesystem::path> files_;
  std::map<render::VideoKind, render::VideoWriter> writers_;
  std::map<render::VideoKind, render::VideoReceipt> receipts_;
  std::map<render::VideoKind, render::VideoCheck> checks_;
  std::map<render::VideoKind, render::SoundCheck> sound_checks_;
};

}  // namespace mien::pipeline
