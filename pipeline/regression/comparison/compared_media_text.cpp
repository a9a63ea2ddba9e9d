#include <cmath>

#include <fmt/format.h>

#include "pipeline/regression/comparison/compared_media.h"

namespace mien::pipeline {

namespace {

std::string counted_frames(int count) {
  return fmt::format("{} {}", count, count == 1 ? "frame" : "frames");
}

/// Frames that are missing, new or exchanged have none beside them to be compared with.
std::string comparison_count_text(const ComparedMedia& media) {
  const int compared = media.frames_compared;
  if (compared == media.frames_before && compared == media.frames_now)
    return media.frames_differing == 0 ? "all are identical"
                                       : fmt::format("{} of them differ", media.frames_differing);
  return media.frames_differing == 0
             ? fmt::format("the {} common to both are identical", compared)
             : fmt::format("of the {} common to both, {} differ", compared, media.frames_differing);
}

/// "frame 36 (f37.png)"
std::string frame_measures_text(const FrameComparison& frame) {
  return fmt::format("frame {}{}", frame.frame, frame.name.empty() ? "" : " (" + frame.name + ")");
}

}  // namespace

std::string as_text(const ComparedMedia& media) {
  const bool is_same = media.remarks.empty() && media.frames_differing == 0;
  std::string text = fmt::format("{}: {} and {}\n",
                                 is_same             ? "the same"
                                 : media.are_alike() ? "alike"
                                                     : "differ",
                                 media.before, media.now);
  for (const std::string& remark : media.remarks) text += "  " + remark + "\n";
  for (const std::string& note : media.notes) text += "  stored differently: " + note + "\n";
  text += fmt::format("  {} before, {} now; {}\n", counted_frames(media.frames_before),
                      counted_frames(media.frames_now), comparison_count_text(media));
  if (media.frames_differing == 0) return text;
  text += fmt::format("  largest difference {:.0f} of 255, lowest PSNR {:.2f} dB\n",
                      255.0 * media.largest_share, media.least_psnr_db);
  for (const FrameComparison& frame : media.worst) {
    const render::Window& window = frame.difference.changed;
    text += fmt::format(
        "  {}: mean ꟻLIP {:.4f} (limit {:g}), SSIM {:.4f}, within {} x {} pixels at {}, {}\n",
        frame_measures_text(frame), frame.perceived.mean, media.perceptual_limit, frame.similarity,
        window.width, window.height, window.x, window.y);
  }
  return text;
}

nlohmann::ordered_json as_json(const ComparedMedia& media) {
  nlohmann::ordered_json worst = nlohmann::ordered_json::array();
  for (const FrameComparison& frame : media.worst)
    worst.push_back({{"frame", frame.frame},
                     {"name", frame.name},
                     {"rms", frame.difference.rms},
                     {"largest", frame.difference.largest},
                     {"flip_mean", frame.perceived.mean},
                     {"flip_max", frame.perceived.largest},
                     {"ssim", frame.similarity}});
  nlohmann::ordered_json json = {{"before", media.before},
                                 {"now", media.now},
                                 {"alike", media.are_alike()},
                                 {"frames_before", media.frames_before},
                                 {"frames_now", media.frames_now},
                                 {"frames_compared", media.frames_compared},
                                 {"frames_differing", media.frames_differing},
                                 {"remarks", media.remarks},
                                 {"notes", media.notes},
                                 {"worst", worst}};
  if (std::isfinite(media.least_psnr_db)) json["least_psnr_db"] = media.least_psnr_db;
  return json;
}

}  // namespace mien::pipeline
