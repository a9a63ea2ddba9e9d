#include "pipeline/production/sheets/stills.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "pipeline/manifest/look/set_file.h"
#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"
#include "render/image/image_io.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

render::Image8 plain(int width, int height, std::uint8_t grey) {
  render::Image8 picture(width, height);
  for (std::uint8_t& channel : picture.channels) channel = grey;
  return picture;
}

render::Image8 page_of(const StillsContent& content) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "page.png";
  std::ofstream(file, std::ios::binary) << stills_as_png(content);
  return render::read_png8(file);
}

int pixels_like(const render::Image8& page, const render::Image8& part) {
  int like = 0;
  for (int y = 0; y < page.height; ++y) {
    for (int x = 0; x < page.width; ++x) {
      like += std::equal(page.at(x, y), page.at(x, y) + 3, part.at(0, 0));
    }
  }
  return like;
}

/// Whether the picture stands somewhere on the page, pixel by pixel.
bool holds(const render::Image8& page, const render::Image8& picture) {
  const auto is_at = [&](int left, int top) {
    for (int y = 0; y < picture.height; ++y) {
      const std::uint8_t* row = page.at(left, top + y);
      if (!std::equal(picture.at(0, y), picture.at(0, y) + 3 * picture.width, row)) return false;
    }
    return true;
  };
  for (int top = 0; top + picture.height <= page.height; ++top) {
    for (int left = 0; left + picture.width <= page.width; ++left) {
      if (is_at(left, top)) return true;
    }
  }
  return false;
}

Stimulus stimulus(const std::string& id, const std::string& view) {
  Stimulus result;
  result.id = id;
  result.weights = {{"normal", 1.0}};
  result.look.camera.view = view;
  result.output.size = {64, 36};
  result.output.fps = 10.0;
  result.output.cycles = 1;
  result.output.quality = Quality::draft;
  result.output.video = {};
  result.look.set = read_set("studio", {});
  return result;
}

Manifest study() {
  Manifest manifest;
  manifest.study = "looks";
  manifest.file = MIEN_SOURCE_DIR "/manifests/quickstart.yaml";
  manifest.examples.builtin = "walks-10";
  manifest.stimuli = {stimulus("side", "side"), stimulus("front", "front")};
  Sheet sheet;
  sheet.id = "both";
  sheet.stills = {"front", "side"};
  manifest.sheets = {sheet};
  return manifest;
}

TEST(Stills, ShowsEveryPictureWholeInRowsOfTheColumnsAskedFor) {
  StillsContent content;
  content.title = "greys";
  for (const std::uint8_t grey : {40, 80, 120, 160, 200}) {
    content.stills.push_back({"grey", plain(150, 100, grey)});
  }
  content.columns = 2;
  const render::Image8 tall = page_of(content);
  content.columns = 12;
  const render::Image8 wide = page_of(content);
  EXPECT_GT(wide.width, 5 * 150);
  EXPECT_GT(tall.height, 3 * 100);
  EXPECT_LT(tall.width, wide.width);
  EXPECT_LT(wide.height, tall.height);
  for (const Still& still : content.stills) {
    EXPECT_TRUE(holds(wide, still.picture));
    EXPECT_TRUE(holds(tall, still.picture));
  }
}

TEST(Stills, AreAllAsWideAsTheNarrowestAndKeepTheirShape) {
  StillsContent content;
  content.stills = {{"stereo", plain(400, 100, 60)}, {"one", plain(200, 120, 90)}};
  const render::Image8 page = page_of(content);
  EXPECT_EQ(pixels_like(page, content.stills[0].picture), 200 * 50);
  EXPECT_EQ(pixels_like(page, content.stills[1].picture), 200 * 120);
  content.stills = {{"large", plain(1920, 1080, 60)}};
  EXPECT_EQ(pixels_like(page_of(content), content.stills[0].picture),
            still_width * still_width * 9 / 16);
}

TEST(Stills, AreTheSameBytesEachTime) {
  StillsContent content;
  content.stills = {{"one", plain(160, 90, 60)}};
  EXPECT_EQ(stills_as_png(content), stills_as_png(content));
  const std::string pdf = stills_as_pdf(content);
  EXPECT_EQ(pdf, stills_as_pdf(content));
  EXPECT_TRUE(pdf.starts_with("%PDF-1."));
  EXPECT_EQ(pdf.find("Date"), std::string::npos);
}

TEST(Stills, AreTheMiddleFramesOfTheFilms) {
  const test::TemporaryFolder folder;
  for (const bool alike : {false, true}) {
    Manifest manifest = study();
    manifest.equalize = {.luminance = alike ? std::optional(EqualizeGroup::study) : std::nullopt,
                         .duration = alike};
    const fs::path out = folder.path() / (alike ? "alike" : "plain");
    Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
    const RunResult result = run(production, out, 1, {}, {});
    for (const TaskOutcome& outcome : result.outcomes) EXPECT_EQ(outcome.error, "");
    ASSERT_TRUE(result.is_complete());
    const render::Image8 page = render::read_png8(out / "sheets/both.png");
    EXPECT_TRUE(fs::exists(out / "sheets/both.pdf"));
    for (const char* id : {"side", "front"}) {
      const fs::path frames = out / "frames" / id;
      const auto count = std::distance(fs::directory_iterator(frames), {});
      char name[16];
      std::snprintf(name, sizeof name, "%05d.png", static_cast<int>(count) / 2);
      EXPECT_TRUE(holds(page, render::read_png8(frames / name))) << id << " " << alike;
    }
  }
}

TEST(Stills, NeedNoFilms) {
  Production production(study(), {.quality = {}, .only = {"both"}, .jobs = 1});
  for (const Task& task : production.graph().tasks) EXPECT_NE(task.kind, "film");
  EXPECT_EQ(production.graph().task("sheet:both").inputs,
            (std::vector<std::string>{"motion:front", "motion:side"}));
}

TEST(Stills, AreMadeAgainWhenTheirLookChanges) {
  const auto key_of = [](const Manifest& manifest) {
    const Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
    return production.graph().task("sheet:both").determinants.key();
  };
  const Manifest manifest = study();
  EXPECT_EQ(key_of(manifest), key_of(study()));
  Manifest other = study();
  other.stimuli[1].look.camera.view = "orbit";
  EXPECT_NE(key_of(manifest), key_of(other));
  other = study();
  other.stimuli[0].output.quality = Quality::standard;
  EXPECT_NE(key_of(manifest), key_of(other));
  other = study();
  other.sheets[0].columns = 1;
  EXPECT_NE(key_of(manifest), key_of(other));
  other = study();
  other.seed = 8;
  EXPECT_NE(key_of(manifest), key_of(other));
}

}  // namespace
}  // namespace mien::pipeline
