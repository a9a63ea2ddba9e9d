#include "pipeline/film_task.h"

#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "pipeline/code_identity.h"
#include "pipeline/determinants.h"
#include "pipeline/film.h"
#include "pipeline/film_frames.h"
#include "pipeline/look_checks.h"
#include "pipeline/synthesis.h"
#include "render/image_io.h"
#include "render/quality.h"

namespace mien::pipeline {

namespace {

scenes::Role role_of(Role role) {
  switch (role) {
    case Role::target:
      return scenes::Role::target;
    case Role::reference:
      return scenes::Role::reference;
    default:
      return scenes::Role::created;
  }
}

scenes::Shot shot_of(const Stimulus& stimulus, Motions& motions) {
  const scenes::SetPlan set = set_of(stimulus.look);
  Output shown = stimulus.output;
  // A set that goes under the figure needs to know how fast it goes.
  if (set.in_place) shown.in_place = false;
  return scenes::stage(shown_clip(motions.of(stimulus.id), shown), {.set = set,
                                                                    .figure = stimulus.look.figure,
                                                                    .camera = stimulus.look.camera,
                                                                    .role = role_of(stimulus.role),
                                                                    .size = stimulus.output.size});
}

int samples_of(Quality quality) {
  return (quality == Quality::draft   ? render::draft_quality()
          : quality == Quality::final ? render::final_quality()
                                      : render::standard_quality())
      .samples_per_pixel;
}

/// Fitted to measured times of one core; only ratios matter. Cycles of 1.1 s are assumed where the
/// length is not known before the motion is made.
double cost_of(const Output& output) {
  const double frames = 1.1 * output.cycles * output.fps;
  const double pixels = static_cast<double>(output.size[0]) * output.size[1];
  return frames * pixels * (9e-8 * samples_of(output.quality) + 4e-7);
}

std::vector<int> all_frames(int count) {
  std::vector<int> frames(static_cast<std::size_t>(count));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

std::vector<std::string> names_of(const std::vector<int>& frames, FrameFormat format) {
  std::vector<std::string> names;
  for (const int frame : frames) names.push_back(frame_name(format, frame));
  return names;
}

/// Makes one film; lives as long as the task runs.
class FilmMaker {
 public:
  FilmMaker(const Stimulus& stimulus, Motions& motions, const FilmSettings& settings, TaskRun& run)
      : output_(stimulus.output),
        settings_(settings),
        run_(run),
        shot_(shot_of(stimulus, motions)),
        contact_(shot_.frame_count()) {}

  void make() {
    std::size_t next = 0;
    std::unique_ptr<FrameStore> frames;
    if (output_.frames != FrameFormat::none) frames = open_frames(next++);
    if (output_.video) {
      make_video(next++, frames.get());
    } else {
      draw(frames.get(), output_.frames == FrameFormat::none ? contact_.frames() : every_frame(),
           {});
    }
    if (frames) frames->publish(names_of(every_frame(), output_.frames));
    put_contact_sheet(next);
  }

 private:
  std::unique_ptr<FrameStore> open_frames(std::size_t product) {
    return run_.store.frames(run_.task.products[product].path, run_.keys[product]);
  }

  std::vector<int> every_frame() const { return all_frames(shot_.frame_count()); }

  /// Draws frames for the sink and the contact sheet.
  void draw(FrameStore* store, const std::vector<int>& frames, const FrameSink& sink) {
    const FrameSink both = [&](int frame, const render::Image8& picture) {
      contact_.add(frame, picture);
      if (sink) sink(frame, picture);
    };
    draw_frames(shot_, frames, settings_, store, both, run_.stop, run_.progress);
  }

  void make_video(std::size_t product, FrameStore* store) {
    run_.store.put(
        run_.task.products[product].path, run_.keys[product],
        [&](const std::filesystem::path& file) {
          write_video(file, settings_,
                      [&](const FrameSink& encode) { draw(store, every_frame(), encode); });
        },
        [&](const std::filesystem::path& file) {
          verify_video(file, output_, shot_.frame_count());
        });
  }

  void put_contact_sheet(std::size_t product) {
    run_.store.put(
        run_.task.products[product].path, run_.keys[product],
        [&](const std::filesystem::path& file) { render::write_png(file, contact_.build()); },
        [](const std::filesystem::path& file) { render::read_png8(file); });
  }

  const Output& output_;
  const FilmSettings& settings_;
  TaskRun& run_;
  scenes::Shot shot_;
  ContactSheetBuilder contact_;
};

}  // namespace

Task film_task(const Stimulus& stimulus, const FilmSettings& settings,
               const SharedDeterminants& shared, Motions& motions) {
  const Output& output = stimulus.output;
  Task task;
  task.id = "film:" + stimulus.id;
  task.kind = "film";
  task.inputs = {"motion:" + stimulus.id};
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", film_code()).add("seed", static_cast<std::int64_t>(settings.seed));
  add_film(task.determinants, stimulus);
  // A video shows the stored frames, so how they were stored concerns it too.
  KeyBuilder stored;
  stored.add("frames", static_cast<std::int64_t>(output.frames));
  if (output.frames != FrameFormat::none)
    task.products.push_back({"frames/" + stimulus.id, stored});
  if (output.video) task.products.push_back({"videos/" + stimulus.id + ".mp4", stored});
  task.products.push_back({"sheets/contact/" + stimulus.id + ".png", stored});
  task.cost_seconds = cost_of(output);
  task.make = [&stimulus, &motions, settings](TaskRun& run) {
    FilmMaker(stimulus, motions, settings, run).make();
  };
  return task;
}

}  // namespace mien::pipeline
