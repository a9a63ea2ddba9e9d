#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/verify.h"

namespace mien::pipeline {

/// A film of a study of which something is left to compare a frame with.
struct ComparableFilm {
  std::string id;
  int frames = 0;
  std::string kept;  ///< its frames ("frames/a"), or else a video ("videos/a.mp4")

  bool has_frames() const { return kept.starts_with("frames/"); }
};

/// The comparable films of a manifest, in its order. Of several videos the first lossless one is
/// taken.
std::vector<ComparableFilm> comparable_films(const Manifest& manifest,
                                             const StudyContents& contents);

/// A film's frames that are to be drawn again, ascending.
struct FramesToRerender {
  ComparableFilm film;
  std::vector<int> frames;
};

/// A uniform random sample of `count` different frames of all the films; all where there are no
/// more. The same seed chooses the same.
std::vector<FramesToRerender> sampled_frames(const std::vector<ComparableFilm>& films, int count,
                                             std::uint64_t seed);

/// The comparison of a re-rendered frame with the stored one.
struct RerenderedFrame {
  std::string film;
  int frame = 0;
  std::string against;  ///< "frames/a/00003.png", or "videos/a.mp4"
  bool agrees = false;
  std::string how;  ///< "the same bytes"; "a PSNR of 44.1 dB, in the film at least 43.7"
};

/// Draws the frames as the manifest says and compares each
///
/// - with the stored frame, whose file has to be the same to the last byte;
/// - or with the frame that the video decodes to: equal in every pixel where the film's record says
///   that the video shows the very frames; else as similar to it (PSNR and SSIM of video_sketch.h)
///   as the least similar frame was when the film was made, up to 0.1 dB and 0.001.
///
/// `manifest` is the one that the study's provenance names. Throws Interrupted after a stop
/// request, and Error when what equalizes the films is not there any more.
std::vector<RerenderedFrame> rerender(const Manifest& manifest, const StudyContents& contents,
                                      const std::vector<FramesToRerender>& wanted, int threads,
                                      const std::stop_token& stop, const ShareDone& done);

}  // namespace mien::pipeline
