#include "pipeline/regression/approved_frames.h"

#include <algorithm>
#include <filesystem>

#include "motion/formats/motion_file.h"
#include "motion/skeleton/clip_markers.h"
#include "pipeline/base/documents/fault.h"
#include "render/image/image_io.h"

namespace mien::pipeline {

namespace {

[[noreturn]] void throw_damage(const std::filesystem::path& file, const std::string& what) {
  throw Error({file.string()}, what,
              "restore it from version control (git checkout, git lfs pull), or approve the "
              "stimulus again");
}

template <class Read>
auto read_with_remedy(const std::filesystem::path& file, const Read& read) {
  try {
    return read(file);
  } catch (const std::exception& error) {
    throw_damage(file, std::string("cannot be read: ") + error.what());
  }
}

}  // namespace

motion::Clip approved_clip(const Baseline& baseline, const std::string& id,
                           const motion::Clip& like) {
  const auto recording = read_with_remedy(
      baseline.motion_file(id), [](const auto& file) { return motion::read_motion(file); });
  motion::Clip clip = like;
  clip.frames_per_second = recording.frames_per_second;
  clip.body = recording.skeleton;
  clip.poses = recording.poses;
  // A baseline has no markers: those of now are shown, so that what differs is the scene.
  const motion::Markers* markers = motion::markers_of(like);
  if (markers != nullptr && clip.frame_count() == like.frame_count()) attach(clip, *markers);
  return clip;
}

render::Image8 approved_picture(const Baseline& baseline, const std::string& id, int frame) {
  const std::filesystem::path file = baseline.picture_file(id, frame);
  render::Image8 picture =
      read_with_remedy(file, [](const auto& path) { return render::read_png8(path); });
  const auto& frames = baseline.find(id)->key_frames;
  const auto key = std::ranges::find(frames, frame, &KeyFrame::frame);
  if (key == frames.end() || key->pixels != hash_of_pixels(picture))
    throw_damage(file, "differs from the approved image");
  return picture;
}

BlockStatistics approved_blocks(const Baseline& baseline, const std::string& id, int frame) {
  return read_with_remedy(baseline.blocks_file(id, frame),
                          [](const auto& file) { return read_blocks(file); });
}

Hash hash_of_pixels(const render::Image8& picture) {
  const std::string size = std::to_string(picture.width) + "x" + std::to_string(picture.height);
  const auto* bytes = reinterpret_cast<const char*>(picture.channels.data());
  return hash_of(size + std::string(bytes, picture.channels.size()));
}

}  // namespace mien::pipeline
