#include "pipeline/regression/comparison/compared_media.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <thread>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/text/file_contents.h"
#include "pipeline/regression/comparison/compared_sounds.h"
#include "pipeline/regression/comparison/frame_alignment.h"
#include "pipeline/tasks/bounded_queue.h"
#include "render/image/channels.h"
#include "render/image/tone.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using Visit = std::function<void(int, const render::Image8&)>;

constexpr std::size_t most_worst = 5;
constexpr std::size_t waiting_pictures = 4;

bool has_ending(const fs::path& file, std::initializer_list<std::string_view> endings) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(endings, ending) != endings.end();
}

bool is_picture(const fs::path& file) {
  return has_ending(file, {".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff"});
}

bool is_video(const fs::path& file) {
  return has_ending(file, {".mp4", ".webm", ".mkv", ".mov", ".avi", ".gif", ".webp"});
}

/// Numbers in names count by their value: "frame9.png" comes before "frame10.png".
bool is_numbered_before(const fs::path& first, const fs::path& second) {
  const std::string a = first.filename().string(), b = second.filename().string();
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const auto number = [&](const std::string& name, std::size_t& at) {
      const std::size_t zeros_end = std::min(name.find_first_not_of('0', at), name.size());
      std::size_t end = zeros_end;
      while (end < name.size() && is_digit(name[end])) ++end;
      at = end;
      return name.substr(zeros_end, end - zeros_end);
    };
    const std::string m = number(a, i), n = number(b, j);
    if (m.size() != n.size()) return m.size() < n.size();
    if (m != n) return m < n;
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool is_hidden = entry.path().filename().string().starts_with('.');  // "._1.png" of macOS
    if (!is_hidden && entry.is_regular_file() && is_picture(entry.path()))
      pictures.push_back(entry.path());
  }
  std::ranges::sort(pictures, is_numbered_before);
  return pictures;
}

/// What git keeps in place of a large file shows nothing.
void refuse_pointer(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string beginning(64, '\0');
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  if (!motion::is_lfs_pointer(beginning)) return;
  throw Error({file.string()}, "is a git LFS pointer; the file itself has not been fetched",
              "run: git lfs pull");
}

/// Red, green and blue; a grey picture has one channel for all. Light (EXR) is shown as sRGB.
render::Image8 read_picture(const fs::path& file) {
  refuse_pointer(file);
  const render::Channels channels = render::read_channels(file);
  const std::size_t count = channels.names.size();
  if (count == 0) throw Error({file.string()}, "has no channels", "compare images");
  const bool is_grey = count < 3;
  render::Framebuffer film(channels.width, channels.height);
  for (std::size_t i = 0; i < film.channels.size(); ++i)
    film.channels[i] = channels.values[i / 3 * count + (is_grey ? 0 : i % 3)];
  if (has_ending(file, {".exr"})) return render::to_srgb8(film);
  render::Image8 picture(film.width, film.height);
  std::ranges::transform(film.channels, picture.channels.begin(), [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  });
  return picture;
}

/// Throws Error for a picture of another size than the first.
void visit_pictures(const std::vector<fs::path>& files, const Visit& visit) {
  int width = 0, height = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const render::Image8 picture = read_picture(files[i]);
    if (i == 0) std::tie(width, height) = std::tie(picture.width, picture.height);
    if (picture.width != width || picture.height != height)
      throw Error({files[i].string()},
                  fmt::format("has {} x {} pixels, but {} has {} x {}", picture.width,
                              picture.height, files[0].filename().string(), width, height),
                  "keep images of one size in a folder");
    visit(static_cast<int>(i), picture);
  }
}

/// What is looked at, one picture after the other.
void visit_frames_of(const fs::path& media, const Visit& visit) {
  if (fs::is_directory(media)) {
    visit_pictures(pictures_in(media), visit);
  } else if (is_picture(media)) {
    visit(0, read_picture(media));
  } else {
    refuse_pointer(media);
    render::probe(media, visit);
  }
}

/// A sequence as it is looked through.
struct ThumbnailSequence {
  std::vector<Thumbnail> frames;
  int width = 0;
  int height = 0;
  std::vector<std::string> names;  ///< of a folder's pictures

  int thumbnail_width() const { return std::min(width, pipeline::thumbnail_width); }
  int thumbnail_height() const { return std::min(height, pipeline::thumbnail_height); }
};

ThumbnailSequence thumbnails_of(const fs::path& media) {
  ThumbnailSequence sequence;
  visit_frames_of(media, [&](int frame, const render::Image8& picture) {
    sequence.frames.push_back(thumbnail_of(picture));
    if (frame == 0)
      std::tie(sequence.width, sequence.height) = std::tie(picture.width, picture.height);
  });
  if (sequence.frames.empty())
    throw Error({media.string()}, "contains no image",
                "name an image, a video or a folder of images");
  if (fs::is_directory(media))
    for (const fs::path& picture : pictures_in(media))
      sequence.names.push_back(picture.filename().string());
  return sequence;
}

void refuse_other_size(const ThumbnailSequence& before, const ThumbnailSequence& now,
                       const ComparedMedia& media) {
  if (before.width == now.width && before.height == now.height) return;
  throw Error({media.now},
              fmt::format("has {} x {} pixels, but {} has {} x {}", now.width, now.height,
                          media.before, before.width, before.height),
              "compare images of one size");
}

/// Decodes in a thread of its own.
class FrameStream {
 public:
  explicit FrameStream(const fs::path& media) : queue_(waiting_pictures) {
    thread_ = std::thread([this, media] {
      try {
        visit_frames_of(media, [&](int frame, const render::Image8& picture) {
          if (!queue_.push({frame, picture})) throw Closed{};
        });
      } catch (const Closed&) {
      } catch (...) {
        failure_ = std::current_exception();
      }
      queue_.close();
    });
  }
  ~FrameStream() {
    queue_.close();
    thread_.join();
  }
  FrameStream(const FrameStream&) = delete;
  FrameStream& operator=(const FrameStream&) = delete;

  /// That frame; those before it are passed over.
  render::Image8 frame(int wanted) {
    std::pair<int, render::Image8> next;
    while (queue_.pop(next))
      if (next.first == wanted) return std::move(next.second);
    if (failure_) std::rethrow_exception(failure_);
    throw std::runtime_error("a frame disappeared during the comparison");
  }

 private:
  struct Closed {};
  BoundedQueue<std::pair<int, render::Image8>> queue_;
  std::exception_ptr failure_;
  std::thread thread_;
};

/// Keeps the pictures that differ most.
struct Worst {
  double rms = 0.0;
  int frame = 0;
  render::Image8 before, now;
};

void keep(std::vector<Worst>& worst, Worst one) {
  const auto place =
      std::ranges::find_if(worst, [&](const Worst& other) { return other.rms < one.rms; });
  worst.insert(place, std::move(one));
  if (worst.size() > most_worst) worst.pop_back();
}

void compare_pairs(ComparedMedia& media, const FrameAlignment& alignment, const FrameNames& names,
                   Mirroring mirroring) {
  FrameStream before(media.before), now(media.now);
  std::vector<Worst> worst;
  for (const FrameAlignment::Pair& pair : alignment.pairs) {
    render::Image8 a = before.frame(pair.before), b = now.frame(pair.now);
    if (mirroring != Mirroring::none) b = mirrored(b, mirroring);
    ++media.frames_compared;
    const render::PictureDifference difference = render::picture_difference(a, b);
    if (difference.differing_pixels == 0) continue;
    ++media.frames_differing;
    media.least_psnr_db = std::min(media.least_psnr_db, difference.psnr_db);
    media.largest_share = std::max(media.largest_share, difference.largest);
    keep(worst, {difference.rms, pair.before, std::move(a), std::move(b)});
  }
  for (const Worst& one : worst) {
    media.worst.push_back(compare_pictures(one.frame, one.before, one.now));
    media.worst.back().perceived_map = {};
    if (const auto i = static_cast<std::size_t>(one.frame); i < names.before.size())
      media.worst.back().name = names.before[i];
  }
}

}  // namespace

bool is_media(const fs::path& file) {
  std::error_code unknown;
  if (fs::is_directory(file, unknown)) return !pictures_in(file).empty();
  return is_picture(file) || is_video(file);
}

bool ComparedMedia::are_alike() const {
  return remarks.empty() && std::ranges::all_of(worst, [&](const FrameComparison& frame) {
           return frame.same || frame.perceived.mean <= perceptual_limit;
         });
}

ComparedMedia compared_media(const fs::path& before, const fs::path& now, double perceptual_limit) {
  ComparedMedia media{.before = before.string(), .now = now.string()};
  media.perceptual_limit = perceptual_limit;
  media.least_psnr_db = std::numeric_limits<double>::infinity();
  const ThumbnailSequence then = thumbnails_of(before);
  ThumbnailSequence today = thumbnails_of(now);
  refuse_other_size(then, today, media);
  media.frames_before = static_cast<int>(then.frames.size());
  media.frames_now = static_cast<int>(today.frames.size());
  const Mirroring mirroring =
      mirroring_of(then.frames, today.frames, then.thumbnail_width(), then.thumbnail_height());
  if (mirroring != Mirroring::none) {
    media.remarks.push_back(
        fmt::format("{} (the following applies after undoing this)", name_of(mirroring)));
    for (Thumbnail& frame : today.frames) {
      render::Image8 picture(today.thumbnail_width(), today.thumbnail_height());
      picture.channels = std::move(frame);
      frame = mirrored(picture, mirroring).channels;
    }
  }
  const FrameNames names{then.names, today.names};
  const FrameAlignment alignment = align(then.frames, today.frames, names);
  media.remarks.insert(media.remarks.end(), alignment.remarks.begin(), alignment.remarks.end());
  if (!fs::is_directory(before) && !fs::is_directory(now) && is_video(before) && is_video(now)) {
    compare_containers(render::probe(before), render::probe(now), media.remarks, media.notes);
    compare_sounds(before, now, media.remarks, media.notes);
  }
  compare_pairs(media, alignment, names, mirroring);
  return media;
}

}  // namespace mien::pipeline
