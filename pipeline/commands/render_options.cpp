#include "pipeline/commands/render_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <thread>
#include <variant>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/manifest/output_checks.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

namespace {

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::array<int, 2> parse_size(const std::string& text) {
  const std::size_t times = text.find('x');
  const auto width = whole_number(std::string_view(text).substr(0, times));
  const auto height = times == std::string::npos
                          ? std::nullopt
                          : whole_number(std::string_view(text).substr(times + 1));
  const auto fits = [](std::optional<int> n) { return n && *n >= 16 && *n <= 8192; };
  if (fits(width) && fits(height)) return {*width, *height};
  throw Error("--size: \"" + text + "\" is no size of a video",
              "write <width>x<height>, each from 16 to 8192, for example 960x540");
}

std::optional<std::array<int, 4>> crop_of(const RenderOptions& options,
                                          const std::array<int, 2>& size) {
  if (options.crop.empty()) return std::nullopt;
  const auto& crop = options.crop;
  const auto within = [](int first, int length, int all) {
    return first >= 0 && length >= 1 && first <= all - length;
  };
  if (!within(crop[0], crop[2], size[0]) || !within(crop[1], crop[3], size[1])) {
    throw Error(
        fmt::format("--crop: is not within the picture of {} x {} pixels", size[0], size[1]),
        "write <from the left>,<from the top>,<width>,<height> in pixels of --size");
  }
  return std::array{crop[0], crop[1], crop[2], crop[3]};
}

}  // namespace

FilmSettings settings_of(const RenderOptions& options) {
  FilmSettings settings;
  settings.output.size = parse_size(options.size);
  settings.output.scale = options.scale;
  settings.output.crop = crop_of(options, settings.output.size);
  settings.output.fps = options.fps;
  settings.output.frames = FrameFormat::none;
  settings.output.shutter = options.shutter;
  settings.loops = options.repeat;
  settings.output.quality = options.quality == "draft"   ? Quality::draft
                            : options.quality == "final" ? Quality::final
                                                         : Quality::standard;
  settings.threads = options.jobs > 0
                         ? options.jobs
                         : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return settings;
}

bool is_picture(const fs::path& out) {
  return out.extension() == ".png" || out.extension() == ".exr";
}

std::string video_endings() {
  std::string endings;
  for (const render::VideoTraits& traits : render::video_kinds()) {
    endings += (endings.empty() ? "" : ", ") + std::string(traits.ending);
  }
  return endings;
}

fs::path output_of(const RenderOptions& options) {
  if (options.out.empty()) return fs::path(options.files.front()).stem().concat(".mp4");
  if (fs::path(options.out).extension() == ".exr" && !options.still) {
    throw Error("--output: only a still has layers", "add --still, or end it in .png");
  }
  if (is_picture(options.out) || render::video_kind_of(options.out)) return options.out;
  throw Error("--output: \"" + options.out + "\" is neither a video nor a picture",
              "end it in " + video_endings() + " (video) or .png (contact sheet)");
}

void check_size(const fs::path& out, const Output& output) {
  const auto [width, height] = output.shown_size();
  const auto [whole_width, whole_height] = output.whole_size();
  if (width < least_picture_side || height < least_picture_side) {
    throw Error(fmt::format("--size: leaves a picture of {} x {} pixels", width, height),
                fmt::format("leave at least {} each way", least_picture_side));
  }
  if (std::int64_t{whole_width} * whole_height > most_picture_pixels) {
    throw Error(
        fmt::format("--size: {} x {} pixels are too many to draw", whole_width, whole_height),
        "use a smaller --size or --scale");
  }
  for (const render::VideoKind kind : output.video) {
    const render::VideoTraits& traits = render::traits_of(kind);
    if (traits.even_size && (width % 2 != 0 || height % 2 != 0)) {
      throw Error(fmt::format("--size: {} needs an even width and height, and these are {} x {}",
                              traits.name, width, height),
                  "change --size, --scale or --crop until they are even");
    }
    if (output.fps > traits.most_fps) {
      throw Error(fmt::format("--fps: {} shows at most {} frames a second at their true speed",
                              out.filename().string(), traits.most_fps),
                  "use fewer, or another kind of video");
    }
  }
}

void check_kind(const RenderOptions& options, const Look& look, const fs::path& out,
                bool is_still) {
  const bool is_layers = out.extension() == ".exr";
  const bool is_cut_out = options.background != "shown";
  if (options.still && !is_picture(out)) {
    throw Error("--still: a still is a picture", "end --output in .png, or in .exr for its layers");
  }
  if (is_cut_out && (!is_still || is_layers)) {
    throw Error("--background: only a still can be cut out", "add --still, and --output in .png");
  }
  if (options.shutter > 0.0 && (is_layers || is_cut_out)) {
    throw Error("--shutter: layers and cut-outs have no motion blur", "leave it out");
  }
  if (options.shutter > 0.0 && std::holds_alternative<scenes::PointLightOptions>(look.figure)) {
    throw Error("--shutter: point lights have no motion blur", "leave it out");
  }
  if (!look.camera.stereo_separation_m) return;
  if (is_layers || is_cut_out) {
    throw Error("--camera: layers and cut-outs are of one eye", "leave stereo out");
  }
  if (!options.crop.empty()) {
    throw Error("--crop: a stereo pair cannot be cropped", "leave --crop or stereo out");
  }
}

scenes::Layout layout_of(const RenderOptions& options) {
  return options.layout == "side-by-side" ? scenes::Layout::side_by_side
                                          : scenes::Layout::superimposed;
}

}  // namespace mien::pipeline
