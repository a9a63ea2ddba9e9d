#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/regression/comparison/frame_comparison.h"
#include "render/video/video.h"

namespace mien::pipeline {

/// Whether a path is a picture, a video, or a folder of pictures.
bool is_media(const std::filesystem::path& file);

/// The comparison of two pictures, videos, or folders of pictures from any source.
struct ComparedMedia {
  std::string before;  ///< path of the file or folder
  std::string now;
  int frames_before = 0;
  int frames_now = 0;
  /// Visible differences other than in pixels: frames that are missing, added or shown at a
  /// different time, mirrored pictures (which are mirrored back before comparison), and those of
  /// the containers (compare_containers).
  std::vector<std::string> remarks;
  std::vector<std::string> notes;  ///< invisible differences between the files, such as the codec
  int frames_compared = 0;
  int frames_differing = 0;
  double least_psnr_db = 0.0;  ///< lowest PSNR; infinite if nothing differs
  /// Largest difference of a pixel's channel, as a share of full scale.
  double largest_share = 0.0;
  std::vector<FrameComparison> worst;  ///< frames with the largest RMS, at most five
  double perceptual_limit = 0.0;       ///< largest permitted mean ꟻLIP error of a frame, 0 … 1

  /// Whether `remarks` is empty and no frame of `worst` exceeds `perceptual_limit`.
  bool are_alike() const;
};

/// Compares two media. Videos are aligned frame by frame, so that a dropped frame is reported as
/// such. ꟻLIP and SSIM are computed for the five frames that differ most. Throws Error for files
/// that cannot be read or compared.
ComparedMedia compared_media(const std::filesystem::path& before, const std::filesystem::path& now,
                             double perceptual_limit);

std::string as_text(const ComparedMedia& media);
nlohmann::ordered_json as_json(const ComparedMedia& media);

/// Compares the containers of two videos. `remarks` receives visible differences: of the frame
/// rate, of frame times and duration, and of the colour tags. Times count as different if they
/// differ by more than the sum of the units in which both containers store times (Matroska:
/// milliseconds). `notes` receives invisible differences: of codec and pixel format.
void compare_containers(const render::VideoSummary& before, const render::VideoSummary& now,
                        std::vector<std::string>& remarks, std::vector<std::string>& notes);

}  // namespace mien::pipeline
