#include "pipeline/manifest/checks/film_checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/documents/fault_list.h"

namespace mien::pipeline {

namespace {

/// Largest picture of H.264 level 6.2: 139,264 macroblocks of 16 × 16 pixels.
constexpr std::int64_t most_video_pixels = 139'264LL * 256;

/// An output, and where it was written.
struct WrittenOutput {
  const Output& output;
  const std::string& path;
  FaultList& list;

  std::string at(const char* key) const { return member_path(path, key); }
  bool says(const char* key) const { return list.was_given(at(key)); }
  /// What made the pictures as large as they are.
  std::string size_at() const {
    return at(output.crop ? "crop" : output.scale != 1.0 ? "scale" : "size");
  }
};

void check_crop(const WrittenOutput& written) {
  const Output& output = written.output;
  if (!output.crop) return;
  const auto [left, top, width, height] = *output.crop;
  const auto [whole_width, whole_height] = output.size;
  if (left + width <= whole_width && top + height <= whole_height) return;
  written.list.add(
      written.at("crop"),
      fmt::format("extends beyond the image of {} × {} pixels", whole_width, whole_height),
      "write [from the left, from the top, width, height] in pixels before scaling");
}

void check_picture_size(const WrittenOutput& written) {
  const auto [width, height] = written.output.shown_size();
  if (width < least_picture_side || height < least_picture_side) {
    written.list.add(written.size_at(),
                     fmt::format("leaves an image of {} × {} pixels", width, height),
                     fmt::format("leave at least {} in each dimension", least_picture_side));
  }
  const auto [drawn_width, drawn_height] = written.output.whole_size();
  if (std::int64_t{drawn_width} * drawn_height > most_picture_pixels) {
    written.list.add(written.at(written.says("scale") ? "scale" : "size"),
                     fmt::format("gives images of {} × {} pixels, which are too large to render",
                                 drawn_width, drawn_height),
                     "use a smaller scale or size");
  }
}

void check_samples(const WrittenOutput& written) {
  if (written.output.quality == Quality::reference || !written.says("samples")) return;
  written.list.add(written.at("samples"), "applies to quality reference only",
                   "omit it, or set quality: reference");
}

void check_rates(const WrittenOutput& written) {
  for (const render::VideoKind kind : written.output.video) {
    const render::VideoTraits& traits = render::traits_of(kind);
    if (written.output.fps <= traits.most_fps) continue;
    written.list.add(written.at(written.says("fps") ? "fps" : "video"),
                     fmt::format("{} plays at most {} frames per second at the correct speed",
                                 traits.name, traits.most_fps),
                     "use fewer, or another video format");
  }
}

void check_video_size(const WrittenOutput& written) {
  const auto [width, height] = written.output.shown_size();
  if (written.output.video.empty() || width <= 0 || height <= 0) return;
  if (std::int64_t{width} * height > most_video_pixels) {
    written.list.add(written.size_at(), "too large for a video",
                     "use at most 35 million pixels, or no video");
  }
  const auto odd = std::ranges::find_if(written.output.video, [](render::VideoKind kind) {
    return render::traits_of(kind).even_size;
  });
  if (odd == written.output.video.end() || (width % 2 == 0 && height % 2 == 0)) return;
  const std::string_view name = render::traits_of(*odd).name;
  if (written.size_at() == written.at("size")) {
    written.list.add(
        written.at("size"), fmt::format("{} needs an even width and height", name),
        fmt::format("use {} × {}, or no video", width + width % 2, height + height % 2));
  } else {
    written.list.add(written.size_at(),
                     fmt::format("{} needs an even width and height, but these are {} × {}", name,
                                 width, height),
                     "change size, scale or crop until they are even, or use no video");
  }
}

/// A film, and where its look and output were written.
struct WrittenFilm {
  const Stimulus& film;
  const FilmPaths& paths;
  FaultList& list;

  std::string output_at(const char* key) const {
    return nearest(member_path(paths.own_output, key), member_path(paths.output, key));
  }
  std::string look_at(const char* key) const {
    return nearest(member_path(paths.own_look, key), member_path(paths.look, key));
  }

 private:
  std::string nearest(const std::string& own, const std::string& shared) const {
    return list.was_given(own) ? own : shared;
  }
};

void check_figure_size(const WrittenFilm& written) {
  const std::optional<double>& figure_px = written.film.look.camera.figure_px;
  const int height = written.film.output.size[1];
  if (!figure_px || *figure_px <= height) return;
  written.list.add(written.look_at("camera.figure_px"),
                   fmt::format("the figure would be taller than the image of {} pixels", height),
                   "use fewer pixels, or a larger size");
}

void check_stereo(const WrittenFilm& written) {
  if (!written.film.look.camera.stereo_separation_m) return;
  if (written.film.output.frames == FrameFormat::layers) {
    written.list.add(written.output_at("frames"), "layers cannot be stereo pairs",
                     "choose another format, or omit stereo");
  }
  if (written.film.output.crop) {
    written.list.add(written.output_at("crop"), "a stereo pair cannot be cropped",
                     "omit crop or stereo");
  }
}

void check_shutter(const WrittenFilm& written) {
  if (written.film.output.shutter == 0.0) return;
  const std::string path = written.output_at("shutter");
  if (scenes::kind_of(written.film.look.figure).has_dots) {
    written.list.add(path,
                     fmt::format("motion blur is not available for {} figures",
                                 scenes::kind_of(written.film.look.figure).name),
                     "omit it, or set it to 0");
  } else if (written.film.output.frames == FrameFormat::layers) {
    written.list.add(path, "layers cannot have motion blur",
                     "omit it, or choose a format other than layers");
  }
}

}  // namespace

FilmPaths paths_of(const Stimulus& film) {
  return {member_path(film.path, "look"), "look", member_path(film.path, "output"), "output"};
}

std::vector<Fault> check_output(const Output& output, const std::string& path,
                                const Places& places) {
  FaultList list(places);
  const WrittenOutput written{output, path, list};
  const auto says = [&](const char* key) { return written.says(key); };
  if (std::ranges::none_of(std::array{"size", "scale", "crop", "samples", "video", "fps"}, says))
    return {};
  check_crop(written);
  check_picture_size(written);
  check_samples(written);
  check_rates(written);
  check_video_size(written);
  return list.take();
}

std::vector<Fault> check_film(const Stimulus& film, const FilmPaths& paths, const Places& places) {
  FaultList list(places);
  const WrittenFilm written{film, paths, list};
  check_figure_size(written);
  check_stereo(written);
  check_shutter(written);
  return list.take();
}

}  // namespace mien::pipeline
