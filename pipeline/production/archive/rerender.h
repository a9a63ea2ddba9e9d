#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/verify.h"

namespace mien::pipeline {

/// A film of a study for which frames or a video are still stored.
struct ComparableFilm {
  std::string id;
  int frames = 0;
  /// Path of its frames, if these are stored ("frames/a"), otherwise of a video ("videos/a.mp4").
  std::string kept;

  bool has_frames() const { return kept.starts_with("frames/"); }
};

/// Returns the comparable films of a manifest, in its order. If a film has several videos, the
/// first lossless one is used, otherwise the first.
std::vector<ComparableFilm> comparable_films(const Manifest& manifest,
                                             const StudyContents& contents);

/// The frames of a film that are to be rendered again, ascending.
struct FramesToRerender {
  ComparableFilm film;
  std::vector<int> frames;
};

/// Returns a uniform random sample of `count` distinct frames of all films, or all frames if there
/// are no more than `count`. The same films, count and seed give the same sample.
std::vector<FramesToRerender> sampled_frames(const std::vector<ComparableFilm>& films, int count,
                                             std::uint64_t seed);

/// The comparison of a re-rendered frame with the stored one.
struct RerenderedFrame {
  std::string film;
  int frame = 0;
  std::string against;  ///< "frames/a/00003.png", or "videos/a.mp4"
  bool agrees = false;
  std::string how;  ///< "identical"; "PSNR 44.10 dB and SSIM 0.9953; worst frame of the film 43.70
                    ///< and 0.9950"
};

/// Renders the frames as the manifest describes them and compares each
///
/// - with the stored frame, whose file must be identical;
/// - or with the corresponding decoded video frame: it must be equal in every pixel if the film's
///   record says that all frames were (VideoRecord::identical); otherwise PSNR and SSIM
///   (video_sketch.h) must reach the lowest values measured when the film was made, within 0.1 dB
///   and 0.001.
///
/// A film that now has another number of frames is not rendered: its only result states this.
/// `manifest` is the one that the study's provenance names. `done` receives the film's id as path.
/// Throws Interrupted after a stop request, and Error if a table of the equalized properties (such
/// as metrics/sizes.csv) is missing or incomplete.
std::vector<RerenderedFrame> rerender(const Manifest& manifest, const StudyContents& contents,
                                      const std::vector<FramesToRerender>& wanted, int threads,
                                      const std::stop_token& stop, const ShareDone& done);

}  // namespace mien::pipeline
