#include "pipeline/production/film/film_shot.h"

#include <array>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/base/documents/environment.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_task.h"
#include "render/tracer/tracer.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr std::array all_roles = {Role::target, Role::created, Role::reference};

Stimulus of_role(Role role, Colours colours, const scenes::Figure& figure) {
  Stimulus stimulus;
  stimulus.id = "a";
  stimulus.role = role;
  stimulus.look.figure = figure;
  stimulus.look.colours = colours;
  stimulus.output.size = {32, 24};
  stimulus.output.fps = 4.0;
  stimulus.output.cycles = 1;
  return stimulus;
}

render::Framebuffer first_picture(const Stimulus& stimulus) {
  const motion::Clip clip = motion::builtin_examples("walks-10", 4.0).examples[0].clip;
  const scenes::Shot shot = shot_of(stimulus, motion::repeated(clip, 1), 7, {});
  const FilmSettings settings{.output = stimulus.output, .seed = 7};
  render::Quality quality = render::draft_quality();
  quality.samples_per_pixel = 1;
  render::Tracer tracer(tracer_options(settings, shot));
  return tracer.trace(scene_at(shot, 0), camera_at(shot, 0), quality);
}

/// How many different pictures the three roles make.
std::size_t pictures_of_roles(Colours colours, const scenes::Figure& figure) {
  std::set<std::string> pictures;
  for (const Role role : all_roles) {
    const render::Image8 picture =
        render::to_srgb8(first_picture(of_role(role, colours, figure)), render::Tone());
    pictures.emplace(picture.channels.begin(), picture.channels.end());
  }
  return pictures.size();
}

TEST(FilmColours, ShowNoRoleUnlessTheyAreAskedTo) {
  const scenes::Figure figures[] = {scenes::StickOptions{}, scenes::MannequinOptions{},
                                    scenes::TrailOptions{}};
  for (const scenes::Figure& figure : figures) {
    SCOPED_TRACE(scenes::kind_of(figure).name);
    EXPECT_EQ(pictures_of_roles(Colours::neutral, figure), 1u);
    EXPECT_EQ(pictures_of_roles(Colours::role, figure), all_roles.size());
  }
}

TEST(StagedLook, OfADraftHasMannequinsOfHalfTheTriangles) {
  const auto triangles = [](Quality quality) {
    Stimulus stimulus = of_role(Role::target, Colours::neutral, scenes::MannequinOptions());
    stimulus.output.quality = quality;
    const motion::Clip clip = motion::builtin_examples("walks-10", 4.0).examples[0].clip;
    const scenes::Shot shot = shot_of(stimulus, motion::repeated(clip, 1), 7, {});
    return scene_at(shot, 0).solids.meshes.at(0).triangles.size();
  };
  EXPECT_LT(triangles(Quality::draft), 0.65 * static_cast<double>(triangles(Quality::standard)));
  EXPECT_EQ(triangles(Quality::standard), triangles(Quality::reference));
}

TEST(FilmColours, OfAllManifestsThatComeAlongShowNoRole) {
  int films = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(MIEN_SOURCE_DIR) / "manifests")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".yaml") || name.find(".scales.") != std::string::npos ||
        name.find(".recipes.") != std::string::npos)
      continue;
    for (const Stimulus& stimulus :
         read_manifest(entry.path(), process_environment()).manifest.stimuli) {
      EXPECT_EQ(film_role(stimulus), scenes::Role::neutral) << name << ": " << stimulus.id;
      ++films;
    }
  }
  EXPECT_GT(films, 50);
}

}  // namespace
}  // namespace mien::pipeline
