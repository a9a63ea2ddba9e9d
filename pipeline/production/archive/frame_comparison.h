#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pipeline/manifest/output.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_record.h"
#include "render/image/image.h"

namespace mien::pipeline {

/// The result of comparing a re-rendered picture with the stored one, and an explanation.
struct Comparison {
  bool agrees = false;
  std::string how;
};

/// Compares the contents of two files.
Comparison compare_files(const std::filesystem::path& drawn, const std::filesystem::path& kept);

/// Some of a film's frames as its videos show them, including fades.
class VideoFrames {
 public:
  /// `first_film_frame`: index of the film's first frame in a video, that is, the number of frames
  /// before it.
  VideoFrames(const Output& output, int film_frames, int eyes, int first_film_frame);

  /// Adds a re-rendered frame of the film. Must be called in ascending order of frames.
  void take(int frame, const render::Image8& picture);

  /// Decodes a video and compares each added frame with the corresponding frame of the video.
  /// Results are keyed by the frame's number in the film. Throws render::Error if the video cannot
  /// be decoded.
  std::map<int, Comparison> compare_with(const std::filesystem::path& folder,
                                         const VideoRecord& video) const;

 private:
  Output output_;
  int first_film_frame_;
  int next_ = 0;
  Presenter presenter_;
  std::map<int, render::Image8> shown_;  ///< by frame number in the film
};

}  // namespace mien::pipeline
