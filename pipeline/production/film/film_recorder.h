#pragma once

#include <filesystem>
#include <map>

#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_presentation.h"
#include "render/video/video.h"
#include "render/video/video_check.h"

namespace mien::pipeline {

/// Turns the frames of a film into videos, all of them at once, with what the presentation shows
/// around them, and checks the files against what went into them.
///
///   FilmRecorder recorder(settings, shot.frame_count());
///   recorder.open(file, render::VideoKind::webm);
///   draw_frames(…, [&](int, const render::Image8& picture) { recorder.take(picture); }, …);
///   recorder.close();
///   recorder.check(file, render::VideoKind::webm);
class FilmRecorder {
 public:
  FilmRecorder(const FilmSettings& settings, int film_frames);

  /// A file that is to be written, which begins with the first frame. To be called before the first
  /// `take`.
  void open(const std::filesystem::path& file, render::VideoKind kind);

  /// The film's next frame. Throws render::Error.
  void take(const render::Image8& picture);

  /// Completes all files. Throws render::Error, also when frames are missing.
  void close();

  /// Decodes a completed file and throws render::Error unless it is what was recorded.
  const render::VideoCheck& check(const std::filesystem::path& file, render::VideoKind kind);

  /// What the checks found.
  const std::map<render::VideoKind, render::VideoCheck>& checks() const { return checks_; }

  const PresentationFrames& frames() const { return presenter_.frames(); }

 private:
  render::VideoFormat format_of(render::VideoKind kind) const;
  void begin_files();
  int row_step() const;  ///< of the kind that is looked at most closely

  const FilmSettings& settings_;
  Presenter presenter_;
  render::VideoSketch sketch_;
  std::map<render::VideoKind, std::filesystem::path> files_;  // that have not begun
  std::map<render::VideoKind, render::VideoWriter> writers_;
  std::map<render::VideoKind, render::VideoReceipt> receipts_;
  std::map<render::VideoKind, render::VideoCheck> checks_;
};

}  // namespace mien::pipeline
