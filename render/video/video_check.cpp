#include "render/video/video_check.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "render/error.h"

namespace mien::render {

namespace {

constexpr double most_part_error = 12.0;         ///< mean luma of a tile
constexpr double coded_part_error = 1.0;         ///< likewise, more than coding makes of it
constexpr double neighbour_margin = 4.0;         ///< of squared errors
constexpr int rows_of_a_block = 4;               ///< of what codecs code as one, at the least
constexpr std::int64_t small_picture = 100'000;  ///< pixels

/// Upper bound of the relative error of a mean square estimated from few tiles, exceeded once in a
/// million. (Chi-square with a degree of freedom a tile: Wilson and Hilferty 1931.)
double largest_excess(int tiles) {
  constexpr double deviations = 4.75;
  const double part = 2.0 / (9.0 * tiles);
  return std::pow(1.0 - part + deviations * std::sqrt(part), 3.0);
}

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

/// Compares decoded frames with the film.
class Comparison {
 public:
  Comparison(const std::string& name, const VideoFormat& format, const VideoSketch& written)
      : name_(name), format_(format), written_(written), similarities_(written.frames.size()) {}

  /// A decoded picture, shown for the frames first … last; several at a time, of other frames.
  void take(int first, int last, const Image8& picture) {
    if (!has_size(picture))
      throw Error(name_ + ": the size differs in frame " + std::to_string(first));
    const FrameSketch sketch = written_.sketcher.sketch_of_rows(picture);
    const int count = static_cast<int>(written_.frames.size());
    for (int frame = first; frame <= std::min(last, count - 1); ++frame) {
      compare(frame, sketch);
    }
  }

  /// Whether a picture of the rows that are looked at has its size.
  bool has_size(const Image8& rows) const {
    const int step = written_.sketcher.row_step();
    return rows.width == format_.width && rows.height == (format_.height + step - 1) / step;
  }

  /// How like the frames that were shown are.
  void sum_up(VideoCheck& check) const {
    check.worst_psnr_db = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < similarities_.size(); ++i) {
      if (!similarities_[i]) continue;
      const FrameSimilarity& like = *similarities_[i];
      check.identical = check.identical && like.identical;
      if (like.psnr_db < check.worst_psnr_db) {
        check.worst_psnr_db = like.psnr_db;
        check.worst_psnr_frame = static_cast<int>(i);
      }
      if (like.ssim < check.worst_ssim) {
        check.worst_ssim = like.ssim;
        check.worst_ssim_frame = static_cast<int>(i);
      }
    }
  }

  void require_least(const VideoCheck& check) const {
    const VideoTraits& traits = traits_of(format_.kind);
    double least_psnr = traits.least_psnr_db;
    double least_ssim = traits.least_ssim;
    if (std::int64_t{format_.width} * format_.height < small_picture) {
      // Outlines are a larger part of them, where halved colours differ most.
      const bool halves_colours = traits.kind != VideoKind::gif;
      const double excess = largest_excess(written_.sketcher.tile_count());
      least_psnr -= (halves_colours ? 6.0 : 0.0) + 10.0 * std::log10(excess);
      least_ssim = 1.0 - (1.0 - least_ssim + (halves_colours ? 0.15 : 0.0)) * excess;
    }
    if (check.worst_psnr_db < least_psnr) {
      throw Error(name_ + ": frame " + std::to_string(check.worst_psnr_frame) + " has a PSNR of " +
                  fixed(check.worst_psnr_db, 1) + " dB against what was drawn, less than " +
                  fixed(least_psnr, 0));
    }
    if (check.worst_ssim < least_ssim) {
      throw Error(name_ + ": frame " + std::to_string(check.worst_ssim_frame) + " has an SSIM of " +
                  fixed(check.worst_ssim, 3) + " against what was drawn, less than " +
                  fixed(least_ssim, 2));
    }
  }

 private:
  void compare(int frame, const FrameSketch& sketch) {
    const FrameSimilarity like =
        written_.sketcher.similarity(sketch, written_.frames[static_cast<std::size_t>(frame)]);
    if (!like.identical && traits_of(format_.kind).lossless) {
      throw Error(name_ + ": frame " + std::to_string(frame) +
                  " is not the frame that was drawn, though the format is lossless");
    }
    if (like.worst_part > most_part_error) {
      throw Error(name_ + ": frame " + std::to_string(frame) + " differs from what was drawn by " +
                  fixed(like.worst_part, 0) + " of 255 in a part of " +
                  std::to_string(written_.sketcher.tile_edge()) + " pixels' width");
    }
    if (like.worst_part > coded_part_error) {
      refuse_neighbour(frame, frame - 1, sketch, like);
      refuse_neighbour(frame, frame + 1, sketch, like);
    }
    similarities_[static_cast<std::size_t>(frame)] = like;
  }

  /// Refuses a frame in the place of its neighbour, where the motion is too slow for other checks.
  void refuse_neighbour(int frame, int other, const FrameSketch& sketch,
                        const FrameSimilarity& like) {
    if (other < 0 || other >= static_cast<int>(written_.frames.size())) return;
    const FrameSimilarity likelier =
        written_.sketcher.similarity(sketch, written_.frames[static_cast<std::size_t>(other)]);
    if (neighbour_margin * likelier.parts_square >= like.parts_square) return;
    throw Error(name_ + ": frame " + std::to_string(frame) + " shows what was drawn for frame " +
                std::to_string(other));
  }

  const std::string& name_;
  const VideoFormat& format_;
  const VideoSketch& written_;
  std::vector<std::optional<FrameSimilarity>> similarities_;  // of the frames that were shown
};

void require(const std::string& name, const std::string& what, const std::string& found,
             const std::string& wanted) {
  if (found != wanted) {
    throw Error(name + ": " + what + " is \"" + found + "\" instead of \"" + wanted + "\"");
  }
}

/// That the film's frames went into the video, and that what came of them is in the file.
void check_receipt(const std::string& name, const VideoReceipt& receipt, const VideoSketch& sketch,
                   const VideoSummary& video) {
  const auto first_other = [](const auto& found, const auto& wanted) {
    return std::to_string(std::ranges::mismatch(found, wanted).in1 - found.begin());
  };
  if (receipt.frames != sketch.hashes) {
    throw Error(name + ": frame " + first_other(receipt.frames, sketch.hashes) +
                " that was encoded is not the one that was drawn");
  }
  if (!receipt.packet_hashes.empty() && video.packet_hashes != receipt.packet_hashes) {
    throw Error(name + ": frame " + first_other(video.packet_hashes, receipt.packet_hashes) +
                " is not in the bytes that it was encoded in");
  }
}

/// A picture alone is no animation: it has no times, and may be a plain picture of its kind.
bool is_still(const VideoFormat& format, int pictures) {
  return pictures == 1 && traits_of(format.kind).picture;
}

/// A film without movement, of which FFmpeg's WebP encoder keeps one picture.
bool stands_still(const VideoSketch& sketch) {
  return std::ranges::all_of(
      sketch.frames, [&](const FrameSketch& frame) { return frame.hash == sketch.frames[0].hash; });
}

void check_tags(const std::string& name, const VideoSummary& video, const VideoFormat& format) {
  const VideoTraits& traits = traits_of(format.kind);
  require(name, "the size", std::to_string(video.width) + " x " + std::to_string(video.height),
          std::to_string(format.width) + " x " + std::to_string(format.height));
  if (is_still(format, video.frames)) return;
  require(name, "the codec", video.codec, std::string(traits.codec));
  if (traits.picture || format.kind == VideoKind::mkv) return;
  require(name, "the matrix tag", video.matrix, traits.lossless ? "gbr" : "bt709");
  require(name, "the primaries tag", video.primaries, "bt709");
  require(name, "the transfer tag", video.transfer, traits.lossless ? "iec61966-2-1" : "bt709");
  require(name, "the range tag", video.range, traits.lossless ? "pc" : "tv");
  if (traits.codec == "h264" && !video.index_at_front) {
    throw Error(name + ": the index is not at the front");
  }
}

void check_times(const std::string& name, const VideoSummary& video, const VideoFormat& format,
                 int frames) {
  if (is_still(format, video.frames)) return;
  const double rate = format.rate.per_second();
  // FFmpeg's WebP encoder cuts times off to milliseconds; the others round.
  const double ticks = format.kind == VideoKind::webp ? 1.001 : 0.501;
  const double tolerance = ticks * video.tick_seconds + 1e-9;
  for (std::size_t i = 0; i < video.times.size(); ++i) {
    const double frame = std::round(video.times[i] * rate);
    const double nearest = frame / rate;
    const bool in_order = format.kind == VideoKind::webp || frame == static_cast<double>(i);
    const bool ascends = i == 0 ? video.times[0] == 0.0 : video.times[i] > video.times[i - 1];
    if (!in_order || !ascends || std::abs(video.times[i] - nearest) > tolerance) {
      throw Error(name + ": picture " + std::to_string(i) + " is shown at " +
                  fixed(video.times[i], 4) + " s, which is not the time of a frame");
    }
  }
  // Two roundings: of the last frame's time and of its length.
  if (std::abs(video.duration_seconds - frames / rate) > 2.0 * tolerance) {
    throw Error(name + ": lasts " + fixed(video.duration_seconds, 3) + " s instead of " +
                fixed(frames / rate, 3) + " s");
  }
}

}  // namespace

VideoCheck check_video(const std::filesystem::path& path, const VideoFormat& format,
                       const VideoSketch& written, const VideoReceipt* receipt, int threads) {
  if (receipt == nullptr && written.sketcher.row_step() > 1)
    throw std::invalid_argument("check_video: a few rows do not tell frames apart");
  const std::string name = path.string();
  const int step = written.sketcher.row_step();
  VideoCheck check;
  Comparison comparison(name, format, written);
  const double rate = format.rate.per_second();
  const int frames = static_cast<int>(written.frames.size());
  FrameSketch first;
  int shown = 0;  // frames that pictures stood for
  const auto take = [&](const TimedPicture& shot, int from, int last) {
    if (shot.index == 0 && comparison.has_size(shot.picture))
      first = written.sketcher.sketch_of_rows(shot.picture);
    comparison.take(from, last, shot.picture);
  };
  if (has_packet_per_frame(format.kind)) {
    const auto take_one = [&](const TimedPicture& shot) { take(shot, shot.index, shot.index); };
    check.summary = probe_in_parallel(path, take_one, step, threads);
    shown = check.summary.frames;
  } else {
    const auto take_next = [&](const TimedPicture& shot) {
      const bool lasts = format.kind == VideoKind::webp && shot.duration > 0.0;
      const int last =
          lasts ? static_cast<int>(std::lround((shot.seconds + shot.duration) * rate)) - 1 : shown;
      take(shot, shown, last);
      shown = last + 1;
    };
    check.summary = probe_timed(path, take_next, step);
  }
  if (format.kind == VideoKind::webp && check.summary.frames == 1 && stands_still(written))
    shown = frames;
  comparison.sum_up(check);
  check_tags(name, check.summary, format);
  if (shown != frames) {
    throw Error(name + ": has " + std::to_string(shown) + " frames instead of " +
                std::to_string(frames));
  }
  check.frames = shown;
  if (receipt != nullptr) check_receipt(name, *receipt, written, check.summary);
  check_times(name, check.summary, format, frames);
  comparison.require_least(check);
  if (written.sketcher.sketch(decode_first_picture(path)).hash != first.hash) {
    throw Error(name + ": the first frame does not decode alone");
  }
  return check;
}

int checked_row_step(const VideoFormat& format) {
  const VideoTraits& traits = traits_of(format.kind);
  const bool in_blocks = !traits.lossless && !traits.picture;
  const bool is_small = std::int64_t{format.width} * format.height < small_picture;
  return format.effort == VideoEffort::fast && in_blocks && !is_small ? rows_of_a_block : 1;
}

std::string similarity_text(const VideoCheck& check) {
  if (check.identical) return "identical to the frames";
  return "worst PSNR " + fixed(check.worst_psnr_db, 1) + " dB (frame " +
         std::to_string(check.worst_psnr_frame) + "), worst SSIM " + fixed(check.worst_ssim, 3) +
         " (frame " + std::to_string(check.worst_ssim_frame) + ")";
}

}  // namespace mien::render
