#include "pipeline/production/film/shot_files.h"

#include <cstddef>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/film/film_recorder.h"
#include "render/image/image_io.h"
#include "render/tracer/tracer.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

std::string write_video(const ShotWork& work, const fs::path& file) {
  const int count = work.shot.frame_count();
  const render::VideoKind kind = work.settings.output.video.front();
  FilmRecorder recorder(work.settings, count);
  recorder.open(file, kind);
  const FrameSink take = [&](int, const render::Image8& picture) { recorder.take(picture); };
  draw_frames(work.shot, frames_between(0, count), work.settings, nullptr, take, work.stop,
              work.progress);
  recorder.close();
  return render::similarity_text(recorder.check(file, kind));
}

std::string write_contact_sheet(const ShotWork& work, const fs::path& file) {
  ContactSheetBuilder sheet(work.shot.frame_count());
  const FrameSink add = [&](int frame, const render::Image8& picture) {
    sheet.add(frame, picture);
  };
  draw_frames(work.shot, sheet.frames(), work.settings, nullptr, add, work.stop, work.progress);
  render::write_png(file, sheet.build());
  return fmt::format("{} on a sheet", sheet.frames().size());
}

void write_still(const ShotWork& work, int frame, render::Background background,
                 const fs::path& file) {
  const auto tracer = [&] {
    return render::Tracer({.threads = work.settings.threads, .instruction_set = ""});
  };
  render::Quality quality = quality_of(work.settings, work.shot);
  if (file.extension() == ".exr") {
    render::Tracer layers = tracer();
    return render::write_layers(file, layers_of(layers, work.shot, frame, quality));
  }
  if (background != render::Background::shown) {
    quality.background = background;
    return render::write_png(
        file,
        tracer().render_view({scene_at(work.shot, frame), camera_at(work.shot, frame), quality}),
        work.shot.tone);
  }
  const FrameSink write = [&](int, const render::Image8& picture) {
    render::write_png(file, picture);
  };
  draw_frames(work.shot, {frame}, work.settings, nullptr, write, work.stop, work.progress);
}

}  // namespace mien::pipeline
