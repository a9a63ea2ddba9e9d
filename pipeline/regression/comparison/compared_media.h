#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/regression/comparison/frame_comparison.h"
#include "render/video/video.h"

namespace mien::pipeline {

/// Whether a file is a picture or video, or a folder holds pictures.
bool is_media(const std::filesystem::path& file);

/// Two pictures, videos, or folders of pictures, whoever made them.
struct ComparedMedia {
  std::string before;  ///< files
  std::string now;
  int frames_before = 0;
  int frames_now = 0;
  /// Visible differences besides the pixels: frames that are missing or shown at another moment,
  /// pictures that are mirrored (and are compared after mirroring them back).
  std::vector<std::string> remarks;
  std::vector<std::string> notes;  ///< invisible differences of the files: the codec
  int frames_compared = 0;
  int frames_differing = 0;
  double least_psnr_db = 0.0;          ///< infinite when nothing differs
  double largest_share = 0.0;          ///< of full scale, of a channel of a pixel
  std::vector<FrameComparison> worst;  ///< at most five, by their RMS
  double perceptual_limit = 0.0;

  /// As many frames, at the same times to the unit of time of both files, and none that differs by
  /// more than the limit.
  bool are_alike() const;
};

/// Videos are compared frame by frame, each with the one that shows the same, so that a frame that
/// was dropped is reported as such. ꟻLIP and SSIM are worked out of the five frames that differ
/// most. Throws Error for what cannot be read, or compared.
ComparedMedia compared_media(const std::filesystem::path& before, const std::filesystem::path& now,
                             double perceptual_limit);

std::string as_text(const ComparedMedia& media);
nlohmann::ordered_json as_json(const ComparedMedia& media);

/// What two files of videos say beside their pixels. `remarks` gets what people see: frames at
/// other moments, another duration (both to the unit of time of the two containers: Matroska counts
/// milliseconds), colours that are shown differently. `notes` gets what nobody sees: codec and
/// pixel format.
void compare_containers(const render::VideoSummary& before, const render::VideoSummary& now,
                        std::vector<std::string>& remarks, std::vector<std::string>& notes);

}  // namespace mien::pipeline
