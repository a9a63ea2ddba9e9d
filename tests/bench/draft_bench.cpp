// Where the time of a draft film goes, at 1280 x 720: processor time a frame of staging, tracing,
// development, the sketch for the check, conversion and encoding, decoding, and comparing, each by
// itself; then the whole film, overlapped, with its frames a second.
//
//   draft_bench [THREADS]    one a processor without

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <stdlib.h>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/manifest/look/set_file.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/shot_files.h"
#include "render/image/tone.h"
#include "render/video/video_check.h"

#include "processor_time.h"

namespace {

using namespace mien;
using bench::processor_seconds;
using Clock = std::chrono::steady_clock;

constexpr int cycles = 3;

/// Prints what `work` takes a frame.
double measured(const char* what, int frames, const std::function<void()>& work) {
  const double before = processor_seconds();
  work();
  const double milliseconds = 1e3 * (processor_seconds() - before) / frames;
  std::printf("%-28s %7.2f ms\n", what, milliseconds);
  return milliseconds;
}

pipeline::FilmSettings settings(int threads) {
  pipeline::FilmSettings result;
  result.output.size = {1280, 720};
  result.output.quality = pipeline::Quality::draft;
  result.output.video = {render::VideoKind::mp4};
  result.threads = threads;
  return result;
}

std::filesystem::path scratch_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "mien-draft-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) std::exit(1);
  return name;
}

}  // namespace

int main(int argc, char** argv) {
  const int threads =
      argc > 1 ? std::atoi(argv[1]) : static_cast<int>(std::thread::hardware_concurrency());
  const motion::Clip clip = motion::builtin_examples("walks-10", 30.0).examples[0].clip;
  scenes::Look look;
  look.set = pipeline::read_set("studio", {});
  look.size = {1280, 720};
  const scenes::Shot shot = scenes::stage(motion::repeated(clip, cycles), look);
  const int frames = shot.frame_count();
  const std::filesystem::path folder = scratch_folder();
  const std::filesystem::path file = folder / "film.mp4";
  const pipeline::FilmSettings how = settings(threads);
  const render::VideoFormat format{
      .width = 1280, .height = 720, .effort = render::VideoEffort::fast};

  std::printf("%d frames of %d x %d, %d threads\n", frames, 1280, 720, threads);
  std::vector<render::Scene> scenes;
  measured("staging", frames, [&] {
    for (int f = 0; f < frames; ++f) scenes.push_back(scene_at(shot, f));
  });
  render::Tracer tracer({.threads = threads});
  const render::Quality quality = pipeline::quality_of(how, shot);
  measured("standing set, once", 1, [&] { tracer.trace(scenes[0], camera_at(shot, 0), quality); });
  const render::Framebuffer film = tracer.trace(scenes[0], camera_at(shot, 0), quality);
  std::vector<render::Image8> pictures;

  const double tracing = measured("tracing", frames, [&] {
    for (int f = 0; f < frames; ++f)
      tracer.draw(
          tracer.prepare({scenes[static_cast<std::size_t>(f)], camera_at(shot, f), quality}),
          [](const render::RenderedRegion&) {});
  });
  measured("development", frames, [&] {
    for (int f = 0; f < frames; ++f) render::to_srgb8(film, shot.tone);
  });
  for (int f = 0; f < frames; ++f)
    pictures.push_back(to_srgb8(
        tracer.trace(scenes[static_cast<std::size_t>(f)], camera_at(shot, f), quality), shot.tone));
  render::VideoSketch sketch(1280, 720, render::checked_row_step(format));
  measured("sketch", frames, [&] {
    for (const render::Image8& picture : pictures) sketch.add(picture);
  });
  render::VideoReceipt receipt;
  measured("conversion and encoding", frames, [&] {
    render::VideoWriter video(file, format);
    for (const render::Image8& picture : pictures) video.write(picture);
    video.finish();
    receipt = video.receipt();
  });
  measured("decoding alone", frames, [&] { render::probe(file); });
  measured("decoding and comparing", frames,
           [&] { render::check_video(file, format, sketch, &receipt); });

  const auto begin = Clock::now();
  const double whole = measured("whole film", frames, [&] {
    pipeline::write_video({.shot = shot, .settings = how, .stop = {}, .progress = [](double) {}},
                          file);
  });
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  std::printf("%.1f frames/s; %.1f where nothing else runs and nothing waits; tracing is %.0f %%\n",
              frames / seconds, 1e3 * threads / whole, 100.0 * tracing / whole);
  std::filesystem::remove_all(folder);
}
