// What a frame costs before each set, seen by a camera that stands and by one that follows the
// figure, at 640 x 360 in standard quality: processor time of what is worked out once, and of each
// frame after it. The last column holds a moving camera against a standing one.
//
//   sets_bench [FRAMES [SET …]]    8 frames of all sets without

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/manifest/look/set_file.h"
#include "pipeline/production/film/film.h"
#include "render/tracer/tracer.h"

#include "processor_time.h"

namespace {

using namespace mien;
using bench::processor_seconds;

struct Cost {
  double first = 0.0;    ///< seconds of the first frame, with what is worked out once
  double another = 0.0;  ///< and of one after it
};

Cost cost_of(const std::string& set, const std::string& view, int frames) {
  const motion::Clip clip = motion::builtin_examples("walks-10", 30.0).examples[0].clip;
  scenes::Look look;
  look.set = pipeline::read_set(set, {});
  look.size = {640, 360};
  look.camera.view = view;
  const scenes::Shot shot = scenes::stage(motion::repeated(clip, 1), look);
  pipeline::FilmSettings settings;
  settings.output.quality = pipeline::Quality::standard;
  const render::Quality quality = pipeline::quality_of(settings, shot);
  render::Tracer tracer;
  double before = processor_seconds();
  Cost cost;
  for (int i = 0; i <= frames; ++i) {
    const int frame = i * (shot.frame_count() - 1) / frames;
    tracer.trace(scene_at(shot, frame), camera_at(shot, frame), quality);
    const double now = processor_seconds();
    (i == 0 ? cost.first : cost.another) += (now - before) / (i == 0 ? 1 : frames);
    before = now;
  }
  return cost;
}

}  // namespace

int main(int argc, char** argv) {
  const int frames = argc > 1 ? std::atoi(argv[1]) : 8;
  std::printf("%-10s %12s %12s %12s %8s\n", "set", "once, s", "standing, s", "moving, s", "times");
  std::vector<std::string> sets(argv + std::min(argc, 2), argv + argc);
  if (sets.empty()) sets = {"studio", "void", "lab-grid", "treadmill", "corridor"};
  for (const std::string& set : sets) {
    const Cost standing = cost_of(set, "three-quarter", frames);
    const Cost moving = cost_of(set, "follow", frames);
    std::printf("%-10s %12.3f %12.3f %12.3f %8.1f\n", set.c_str(),
                standing.first - standing.another, standing.another, moving.another,
                moving.another / standing.another);
  }
}
