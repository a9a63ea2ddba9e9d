#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pipeline/manifest/output.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_record.h"
#include "render/image/image.h"

namespace mien::pipeline {

/// Whether what was drawn again is what was kept, and in words how.
struct Comparison {
  bool agrees = false;
  std::string how;
};

/// Byte by byte.
Comparison compare_files(const std::filesystem::path& drawn, const std::filesystem::path& kept);

/// Some of a film's frames as its videos show them: faded, where they fade.
class VideoFrames {
 public:
  /// `first_film_frame`: pictures of a video before the film begins.
  VideoFrames(const Output& output, int film_frames, int eyes, int first_film_frame);

  /// A frame of the film as it was drawn; ascending.
  void take(int frame, const render::Image8& picture);

  /// Decodes a video and compares each frame that was taken with the one that it shows, by the
  /// frame's number in the film. Throws render::Error when it does not decode.
  std::map<int, Comparison> compare_with(const std::filesystem::path& folder,
                                         const VideoRecord& video) const;

 private:
  Output output_;
  int first_film_frame_;
  int next_ = 0;
  Presenter presenter_;
  std::map<int, render::Image8> shown_;  ///< by the frame's number in the film
};

}  // namespace mien::pipeline
