#include "pipeline/manifest/output_checks.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "pipeline/documents/fault_list.h"

namespace mien::pipeline {

namespace {

/// Largest picture of H.264 level 6.2: 139,264 macroblocks of 16 × 16 pixels.
constexpr std::int64_t most_video_pixels = 139'264LL * 256;

class OutputChecker : FaultList {
 public:
  using FaultList::FaultList;
  using FaultList::take;

  void check_output(const std::string& path, const Output& output) {
    const auto given = [&](const char* key) { return was_given(member_path(path, key)); };
    if (!given("size") && !given("scale") && !given("crop") && !given("video") && !given("fps")) {
      return;
    }
    check_crop(path, output);
    const auto [width, height] = output.shown_size();
    if (width <= 0 || height <= 0) return;
    const bool plain = !output.crop && output.scale == 1.0;
    const std::string size = member_path(path, plain ? "size" : output.crop ? "crop" : "scale");
    bool told = false;
    for (const render::VideoKind kind : output.video) {
      const render::VideoTraits& traits = render::traits_of(kind);
      const std::string name(traits.name);
      if (output.fps > traits.most_fps) {
        add(member_path(path, given("fps") ? "fps" : "video"),
            name + " shows at most " + std::to_string(static_cast<int>(traits.most_fps)) +
                " frames a second at their true speed",
            "use fewer, or another kind of video");
      }
      if (std::exchange(told, true)) continue;  // the size's faults once
      if (std::int64_t{width} * height > most_video_pixels) {
        add(size, "too large for a video", "use at most 35 million pixels, or video: []");
      }
    }
    const auto odd =
        std::find_if(output.video.begin(), output.video.end(),
                     [](render::VideoKind kind) { return render::traits_of(kind).even_size; });
    if (odd != output.video.end() && (width % 2 != 0 || height % 2 != 0)) {
      const std::string name(render::traits_of(*odd).name);
      const auto even = [](int pixels) { return std::to_string(pixels + pixels % 2); };
      if (plain) {
        add(size, name + " needs an even width and height",
            "use [" + even(width) + ", " + even(height) + "], or video: []");
      } else {
        add(size,
            name + " needs an even width and height, and these are " + std::to_string(width) +
                " × " + std::to_string(height),
            "change size, scale or crop until they are even, or video: []");
      }
    }
  }

  void check_crop(const std::string& path, const Output& output) {
    const auto [shown_width, shown_height] = output.shown_size();
    if (shown_width < least_picture_side || shown_height < least_picture_side) {
      add(member_path(path, output.crop ? "crop" : "scale"),
          "leaves a picture of " + std::to_string(shown_width) + " × " +
              std::to_string(shown_height) + " pixels",
          "leave at least " + std::to_string(least_picture_side) + " each way");
    }
    const auto [drawn_width, drawn_height] = output.whole_size();
    if (std::int64_t{drawn_width} * drawn_height > most_picture_pixels) {
      add(member_path(path, "scale"),
          "makes pictures of " + std::to_string(drawn_width) + " × " +
              std::to_string(drawn_height) + " pixels, too many to draw",
          "use a smaller scale or size");
    }
    if (!output.crop) return;
    const auto [left, top, width, height] = *output.crop;
    const auto [whole_width, whole_height] = output.size;
    if (left + width > whole_width || top + height > whole_height) {
      add(member_path(path, "crop"),
          "reaches beyond the picture of " + std::to_string(whole_width) + " × " +
              std::to_string(whole_height) + " pixels",
          "write [from the left, from the top, width, height] in pixels of size");
    }
  }

  void check_figure_size(const Stimulus& stimulus) {
    const std::optional<double>& figure_px = stimulus.look.camera.figure_px;
    if (!figure_px || *figure_px <= stimulus.output.size[1]) return;
    const std::string own = member_path(stimulus.path, "look.camera.figure_px");
    add(was_given(own) ? own : "look.camera.figure_px",
        "the figure would be taller than the picture of " +
            std::to_string(stimulus.output.size[1]) + " pixels",
        "use fewer pixels, or a larger size");
  }

  void check_stereo(const Stimulus& stimulus) {
    if (!stimulus.look.camera.stereo_separation_m) return;
    if (stimulus.output.frames == FrameFormat::layers) {
      const std::string frames = member_path(member_path(stimulus.path, "output"), "frames");
      add(was_given(frames) ? frames : "output.frames", "layers are of one eye",
          "choose frames: exr, or leave stereo out");
    }
    if (!stimulus.output.crop) return;
    const std::string own = member_path(member_path(stimulus.path, "output"), "crop");
    add(was_given(own) ? own : "output.crop", "a stereo pair cannot be cropped",
        "leave crop or stereo out");
  }

  void check_shutter(const Stimulus& stimulus) {
    if (stimulus.output.shutter == 0.0) return;
    const std::string own = member_path(member_path(stimulus.path, "output"), "shutter");
    const std::string path = was_given(own) ? own : "output.shutter";
    if (std::holds_alternative<scenes::PointLightOptions>(stimulus.look.figure)) {
      add(path, "point lights have no motion blur", "leave shutter out, or set it to 0");
    } else if (stimulus.output.frames == FrameFormat::layers) {
      add(path, "layers tell what stands still: they have no motion blur",
          "leave shutter out, or choose frames: exr");
    }
  }

  /// Where numbers say how large a figure is seen it cannot be made as small as the smallest.
  void check_size(const Stimulus& stimulus) {
    const scenes::CameraSettings& camera = stimulus.look.camera;
    if (!camera.screen && !camera.position && !camera.figure_px && camera.path.empty()) return;
    add("equalize",
        "the camera of \"" + stimulus.id + "\" says already how large its figure is seen",
        "leave size out, or give that camera a view alone");
  }

  /// A file may be named alike for two films: "a.lossless" as mp4 and "a" as mp4-lossless.
  void check_video_names(const Manifest& manifest) {
    std::map<std::string, std::string> taken;
    for (const Stimulus* film : films_of(manifest)) {
      for (const render::VideoKind kind : film->output.video) {
        const std::string file = render::with_ending(film->id, kind).string();
        const auto [first, is_new] = taken.emplace(file, film->id);
        if (is_new || first->second == film->id) continue;
        add(member_path(film->path, "id"),
            "its video " + file + " would be that of \"" + first->second + "\"",
            "give it another id");
      }
    }
  }
};

}  // namespace

std::vector<Fault> check_outputs(const Manifest& manifest) {
  OutputChecker checker(manifest.places);
  checker.check_output("output", manifest.output);
  for (const Stimulus* film : films_of(manifest)) {
    checker.check_output(member_path(film->path, "output"), film->output);
    checker.check_shutter(*film);
    checker.check_stereo(*film);
    checker.check_figure_size(*film);
  }
  if (manifest.equalize.size) {
    for (const Stimulus& stimulus : manifest.stimuli) checker.check_size(stimulus);
  }
  checker.check_video_names(manifest);
  return checker.take();
}

}  // namespace mien::pipeline
