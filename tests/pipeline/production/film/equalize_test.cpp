#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/look/set_file.h"
#include "pipeline/production/film/film_dots.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/film/film_exposure.h"
#include "pipeline/production/film/film_framing.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"
#include "scenes/cameras/figure_place.h"

namespace mien::pipeline {
namespace {

Stimulus stimulus(const std::string& id, const std::string& example, int cycles) {
  Stimulus result;
  result.path = "stimuli[0]";
  result.id = id;
  result.weights = {{example, 1.0}};
  result.output.size = {48, 32};
  result.output.fps = 10.0;
  result.output.cycles = cycles;
  result.output.quality = Quality::draft;
  result.output.frames = FrameFormat::none;
  result.look.set = read_set("studio", {});
  return result;
}

Manifest study() {
  Manifest manifest;
  manifest.study = "alike";
  manifest.file = MIEN_SOURCE_DIR "/manifests/quickstart.yaml";
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  manifest.stimuli = {stimulus("short", "normal", 1), stimulus("long", "normal", 3)};
  manifest.stimuli[1].look.camera.view = "front";
  manifest.equalize = {.luminance = EqualizeGroup::study, .duration = true};
  return manifest;
}

TEST(Equalize, MakesFilmsOfAStudyAlikeInLuminanceAndDuration) {
  const test::TemporaryFolder folder;
  Production production(study(), {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) EXPECT_EQ(outcome.error, "");
  ASSERT_TRUE(result.is_complete());

  const CsvTable luminance = read_csv(folder.path() / "out/metrics/luminance.csv");
  const auto column = [](const CsvTable& table, const char* name) {
    return static_cast<std::size_t>(require_column(table, name));
  };
  const auto number = [&](const CsvTable& table, std::size_t row, const char* name) {
    return number_in(table, table.rows[row][column(table, name)]);
  };
  ASSERT_EQ(luminance.rows.size(), 2u);
  const double mean = number(luminance, 0, "mean_luminance");
  EXPECT_NEAR(number(luminance, 1, "mean_luminance"), mean, 0.01 * mean);
  EXPECT_NE(number(luminance, 0, "exposure_stops"), 0.0);

  const CsvTable videos = read_csv(folder.path() / "out/metrics/videos.csv");
  ASSERT_EQ(videos.rows.size(), 2u);
  EXPECT_EQ(number(videos, 0, "frames"), number(videos, 1, "frames"));
  EXPECT_GT(number(videos, 0, "worst_psnr_db"), 30.0);
}

/// A walk as dots, and dots that differ from it in one option.
Manifest dots_study() {
  Manifest manifest = study();
  manifest.equalize = {.luminance = EqualizeGroup::study};
  manifest.stimuli.clear();
  for (const char* id : {"original", "scrambled", "inverted", "noisy", "tinted"}) {
    manifest.stimuli.push_back(stimulus(id, "normal", 1));
    manifest.stimuli.back().output.size = {96, 72};
    manifest.stimuli.back().look.figure = scenes::PointLightOptions{};
    manifest.stimuli.back().look.set = read_set("void", {});
  }
  const auto dots = [&](std::size_t i) -> scenes::PointLightOptions& {
    return std::get<scenes::PointLightOptions>(manifest.stimuli[i].look.figure);
  };
  dots(1).scrambled = true;
  dots(2).inverted = true;
  dots(3).noise = 10;
  dots(4).colour = "#80a0ff";
  return manifest;
}

std::map<std::string, double> stops_in(const Manifest& manifest) {
  const test::TemporaryFolder folder;
  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) EXPECT_EQ(outcome.error, "");
  std::map<std::string, double> stops;
  for (const Stimulus& one : manifest.stimuli)
    stops[one.id] =
        stimulus_numbers(folder.path() / "out/metrics/exposure.csv", "exposure_stops").at(one.id);
  return stops;
}

// Scrambling moves dots: those of a control must not be told by their luminance.
TEST(Equalize, LeavesDotsThatAreOnlyMovedAsLightAsTheirOriginals) {
  Manifest manifest = dots_study();
  std::map<std::string, double> stops = stops_in(manifest);
  EXPECT_EQ(stops.at("scrambled"), stops.at("original"));
  EXPECT_EQ(stops.at("inverted"), stops.at("original"));
  // More dots, and dots of another colour, are films to be made alike.
  EXPECT_LT(stops.at("noisy"), stops.at("original"));
  EXPECT_NE(stops.at("tinted"), stops.at("original"));

  manifest.stimuli.resize(3);  // nothing but those
  stops = stops_in(manifest);
  for (const Stimulus& one : manifest.stimuli) EXPECT_EQ(stops.at(one.id), 0.0) << one.id;
}

TEST(Equalize, MakesFiguresAsTallAsTheSmallest) {
  const test::TemporaryFolder folder;
  Manifest manifest = study();
  manifest.equalize = {.size = EqualizeGroup::study};
  // Another height and width of the picture, twice the pixels, a point-light figure.
  manifest.stimuli[0].output.scale = 2.0;
  manifest.stimuli.push_back(stimulus("dots", "normal", 1));
  manifest.stimuli[2].output.size = {64, 64};
  manifest.stimuli[2].look.figure = scenes::PointLightOptions{};
  manifest.stimuli[2].look.set = read_set("void", {});
  Motions motions(manifest);
  std::vector<double> framed;
  for (const Stimulus& one : manifest.stimuli)
    framed.push_back(scenes::figure_pixels(shot_of(one, motions, 0).cameras));
  const double least = *std::min_element(framed.begin(), framed.end());
  EXPECT_GT(*std::max_element(framed.begin(), framed.end()), 1.2 * least);

  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) EXPECT_EQ(outcome.error, "");
  ASSERT_TRUE(result.is_complete());
  for (const Stimulus& one : manifest.stimuli) {
    EXPECT_NEAR(stimulus_numbers(folder.path() / "out/metrics/views.csv", "figure_px").at(one.id),
                least, 0.02)
        << one.id;
  }
  // The dots are where their table says, in the picture of that size.
  const double figure_px =
      stimulus_numbers(folder.path() / "out/metrics/sizes.csv", "figure_px").at("dots");
  EXPECT_EQ(read_file(folder.path() / "out/clips/dots.dots.csv"),
            dots_csv(shot_of(manifest.stimuli[2], motions, 0, {.figure_px = figure_px})));
}

/// Figures that their cameras show at another height of the picture each.
Manifest differently_framed() {
  Manifest manifest = study();
  manifest.stimuli[0].output.scale = 2.0;
  manifest.stimuli.push_back(stimulus("followed", "sad", 2));
  manifest.stimuli[2].look.camera.view = "follow";
  manifest.stimuli.push_back(stimulus("dots", "normal", 3));
  manifest.stimuli[3].look.figure = scenes::PointLightOptions{};
  manifest.stimuli[3].look.set = read_set("void", {});
  manifest.stimuli[3].look.camera.view = "side";
  return manifest;
}

TEST(Equalize, MakesFiguresStandAtOnePlaceWhereAllAreSeenWhole) {
  const test::TemporaryFolder folder;
  Manifest manifest = differently_framed();
  manifest.equalize = {.size = EqualizeGroup::study, .place = EqualizeGroup::study};
  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) EXPECT_EQ(outcome.error, "");
  ASSERT_TRUE(result.is_complete());
  const auto found = [&](const char* table, const char* column, const Stimulus& of) {
    return stimulus_numbers(folder.path() / "out/metrics" / table, column).at(of.id);
  };
  const EqualizedFilms alike =
      equalized_films(manifest.equalize, folder.path() / "out", production.motions());
  const Stimulus& first = manifest.stimuli.front();
  for (const Stimulus& one : manifest.stimuli) {
    for (const auto& [seen, common] : {std::pair("figure_x_px", "x_px"), {"figure_y_px", "y_px"}}) {
      EXPECT_NEAR(found("views.csv", seen, one), found("places.csv", common, first), 0.02)
          << one.id;
    }
    const scenes::Shot shot = shot_of(one, production.motions(), 0, alike.of(one.id).framing);
    const Eigen::AlignedBox2d taken = scenes::action_bounds(shot.cameras, shot.action);
    const Eigen::Vector2d half = 0.5 * Eigen::Vector2d(shot.size[0], shot.size[1]);
    EXPECT_TRUE(Eigen::AlignedBox2d(-half, half).contains(taken)) << one.id;
  }
  // The cameras would have shown them elsewhere, which is what this is for.
  EXPECT_GT(std::abs(found("places.csv", "framed_y_px", manifest.stimuli[0]) -
                     found("places.csv", "framed_y_px", manifest.stimuli[1])),
            1.0);
  EXPECT_EQ(
      read_file(folder.path() / "out/clips/dots.dots.csv"),
      dots_csv(shot_of(manifest.stimuli[3], production.motions(), 0, alike.of("dots").framing)));
}

TEST(Equalize, RecordsForFilmsWhatItsTablesTell) {
  const test::TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  Manifest manifest = differently_framed();
  manifest.equalize = {.luminance = EqualizeGroup::figure,
                       .size = EqualizeGroup::study,
                       .place = EqualizeGroup::study,
                       .duration = true};
  const auto made = [&] {
    Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
    const RunResult result = run(production, out, 1, {}, {});
    std::map<std::string, TaskState> states;
    for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
      EXPECT_EQ(result.outcomes[i].error, "");
      states[production.graph().tasks[i].id] = result.outcomes[i].state;
    }
    return states;
  };
  made();
  Motions motions(manifest);
  const EqualizedFilms alike = equalized_films(manifest.equalize, out, motions);
  EXPECT_EQ(alike.exposure_stops, stimulus_numbers(out / "metrics/exposure.csv", "exposure_stops"));
  EXPECT_EQ(alike.figure_px, stimulus_numbers(out / "metrics/sizes.csv", "figure_px"));
  for (const auto& [id, right] : stimulus_numbers(out / "metrics/places.csv", "x_px"))
    EXPECT_EQ(alike.figure_place.at(id)[0], right) << id;
  for (const auto& [id, seconds] : stimulus_numbers(out / "metrics/durations.csv", "duration_s"))
    EXPECT_EQ(motions.shortest_seconds(), seconds) << id;

  // What was taken away or altered is found anew, and films that rest on it are what they were.
  std::filesystem::remove(out / ".mien/equalized/sizes.json");
  write_file(out / ".mien/equalized/exposure.json", "{}");
  std::map<std::string, TaskState> states = made();
  EXPECT_EQ(states.at("sizes"), TaskState::made);
  EXPECT_EQ(states.at("places"), TaskState::cached);
  EXPECT_EQ(states.at("exposure"), TaskState::made);
  EXPECT_EQ(states.at("film:short"), TaskState::cached);
  EXPECT_EQ(equalized_films(manifest.equalize, out, motions).exposure_stops, alike.exposure_stops);
}

TEST(Equalize, FindsNoPlaceForFiguresOfWhichEachFillsItsPictureElsewhere) {
  Manifest manifest = differently_framed();
  manifest.equalize = {.place = EqualizeGroup::study};
  Motions motions(manifest);
  try {
    check_places(manifest, motions);
    FAIL() << "a place was found";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be at the same position"), std::string::npos)
        << error.what();
  }
  manifest.equalize = {.size = EqualizeGroup::study, .place = EqualizeGroup::study};
  EXPECT_NO_THROW(check_places(manifest, motions));
}

TEST(Equalize, TellsInARunTooWhereOnePlaceIsAskedFor) {
  const test::TemporaryFolder folder;
  Manifest manifest = differently_framed();
  manifest.equalize = {.place = EqualizeGroup::study};
  manifest.places.values["equalize"] = {"m.yaml", 5, 11};
  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  const std::string& error = result.outcomes[production.graph().index_of("places")].error;
  EXPECT_TRUE(error.starts_with("m.yaml:5:11: equalize: \"")) << error;
}

TEST(Equalize, MakesThoseWithTheSameKindOfFigureAlike) {
  const test::TemporaryFolder folder;
  Manifest manifest = study();
  manifest.stimuli = {stimulus("near", "normal", 1), stimulus("far", "normal", 3),
                      stimulus("dots", "normal", 1), stimulus("more-dots", "sad", 3)};
  for (Stimulus& each : manifest.stimuli) each.output.video = {};
  for (const std::size_t dotted : {2U, 3U}) {
    manifest.stimuli[dotted].look.figure = scenes::PointLightOptions{.size_px = 3.0};
    manifest.stimuli[dotted].look.set = read_set("void", {});
    manifest.stimuli[dotted].look.camera.view = "side";
  }
  manifest.equalize = {.luminance = EqualizeGroup::figure, .size = EqualizeGroup::figure};
  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  for (const TaskOutcome& outcome : run(production, folder.path() / "out", 1, {}, {}).outcomes)
    EXPECT_EQ(outcome.error, "");
  const auto found = [&](const char* table, const char* column, const char* of) {
    return stimulus_numbers(folder.path() / "out/metrics" / table, column).at(of);
  };
  for (const auto& [table, column] :
       {std::pair("sizes.csv", "figure_px"), std::pair("exposure.csv", "wanted_luminance")}) {
    EXPECT_EQ(found(table, column, "near"), found(table, column, "far"));
    EXPECT_EQ(found(table, column, "dots"), found(table, column, "more-dots"));
    EXPECT_NE(found(table, column, "near"), found(table, column, "dots"));
  }
  EXPECT_TRUE(faults_in_light(manifest, production.motions()).empty());
  manifest.equalize = {.luminance = EqualizeGroup::study};
  EXPECT_FALSE(faults_in_light(manifest, production.motions()).empty());
}

// With nothing but its own table left behind: clips of a study whose films cannot be made are of no
// use, and would look as if they were.
TEST(Equalize, MakesNoClipWhereNoExposureReachesTheOthersLuminance) {
  const test::TemporaryFolder folder;
  Manifest manifest = study();
  manifest.equalize = {.luminance = EqualizeGroup::study};
  // However bright they are, a few dots on black are dark.
  manifest.stimuli[1].look.figure = scenes::PointLightOptions{.size_px = 1.0};
  manifest.stimuli[1].look.set = read_set("void", {});
  for (Stimulus& each : manifest.stimuli) each.output.clips = {"bvh"};
  manifest.places.values["equalize"] = {"m.yaml", 5, 11};
  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  EXPECT_FALSE(result.is_complete());
  const auto outcome_of = [&](const std::string& task) {
    return result.outcomes[production.graph().index_of(task)];
  };
  EXPECT_TRUE(outcome_of("exposure")
                  .error.starts_with("m.yaml:5:11: equalize: no exposure makes \"long\" as bright "
                                     "as the others: the nearest mean luminance is 0.0"))
      << outcome_of("exposure").error;
  EXPECT_TRUE(outcome_of("exposure").is_bad_input);
  EXPECT_EQ(outcome_of("clip:short").state, TaskState::skipped);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/clips"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/metrics/exposure.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/videos/long.mp4"));
}

struct DotRow {
  double x_px;
  double y_px;
  bool visible;
  std::string eye;
};

std::vector<DotRow> dot_rows(const scenes::Shot& shot, const std::filesystem::path& folder) {
  write_file(folder / "dots.csv", dots_csv(shot));
  const CsvTable table = read_csv(folder / "dots.csv");
  const auto field = [&](std::size_t row, const char* name) {
    return table.rows[row][static_cast<std::size_t>(require_column(table, name))];
  };
  std::vector<DotRow> rows;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    rows.push_back({number_in(table, field(row, "x_px")), number_in(table, field(row, "y_px")),
                    field(row, "visible").text == "1", field(row, "eye").text});
  }
  return rows;
}

TEST(DotTables, HaveALayoutOfTheirOwnForEachStimulusUnlessTheSeedIsGiven) {
  Manifest manifest = study();
  manifest.equalize = {};
  manifest.stimuli = {stimulus("one", "normal", 1), stimulus("two", "normal", 1)};
  Motions motions(manifest);
  const auto first_dot = [&](Stimulus of, std::optional<std::uint64_t> seed) {
    of.look.figure = scenes::PointLightOptions{.scrambled = true, .seed = seed};
    return shot_of(of, motions, manifest.seed).actors[0].dots[0].path[0];
  };
  const Stimulus &one = manifest.stimuli[0], &two = manifest.stimuli[1];
  EXPECT_EQ(first_dot(one, {}), first_dot(one, {}));
  EXPECT_NE(first_dot(one, {}), first_dot(two, {}));
  EXPECT_EQ(first_dot(one, 3), first_dot(two, 3));
  EXPECT_NE(first_dot(one, 3), first_dot(one, 4));
}

TEST(DotTables, CountFromTheCornerOfTheCropAndTellWhatItShows) {
  const test::TemporaryFolder folder;
  Manifest manifest = study();
  Stimulus& dots = manifest.stimuli[0];
  dots.look.figure = scenes::PointLightOptions{};
  dots.look.set = read_set("void", {});
  Motions motions(manifest);
  const std::vector<DotRow> whole = dot_rows(shot_of(dots, motions, 0), folder.path());
  dots.output.crop = {{20, 4, 16, 12}};
  const std::vector<DotRow> part = dot_rows(shot_of(dots, motions, 0), folder.path());
  ASSERT_EQ(part.size(), whole.size());
  int inside = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    EXPECT_EQ(part[i].eye, "both");
    EXPECT_NEAR(part[i].x_px, whole[i].x_px - 20.0, 1e-4);
    EXPECT_NEAR(part[i].y_px, whole[i].y_px - 4.0, 1e-4);
    EXPECT_EQ(part[i].visible,
              part[i].x_px >= 0 && part[i].x_px < 16 && part[i].y_px >= 0 && part[i].y_px < 12);
    inside += part[i].visible ? 1 : 0;
  }
  EXPECT_GT(inside, 0);
  EXPECT_LT(inside, static_cast<int>(part.size()));
}

TEST(DotTables, HaveEachDotOnceForEachEye) {
  const test::TemporaryFolder folder;
  Manifest manifest = study();
  Stimulus& dots = manifest.stimuli[0];
  dots.look.figure = scenes::PointLightOptions{};
  dots.look.set = read_set("void", {});
  dots.look.camera.stereo_separation_m = 0.065;
  Motions motions(manifest);
  const scenes::Shot shot = shot_of(dots, motions, 0);
  const std::vector<DotRow> rows = dot_rows(shot, folder.path());
  const std::size_t count = shot.actors[0].dots.size();
  ASSERT_EQ(rows.size(), 2 * count * static_cast<std::size_t>(shot.frame_count()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool right = i / count % 2 == 1;
    EXPECT_EQ(rows[i].eye, right ? "right" : "left");
    // The picture is 48 pixels wide, a half for each eye.
    EXPECT_EQ(rows[i].visible, rows[i].x_px >= (right ? 24 : 0) &&
                                   rows[i].x_px < (right ? 48 : 24) && rows[i].y_px >= 0 &&
                                   rows[i].y_px < 32);
    if (right) {
      EXPECT_LT(std::abs(rows[i].x_px - 24.0 - rows[i - count].x_px), 3.0);
      EXPECT_NEAR(rows[i].y_px, rows[i - count].y_px, 0.2);
    }
  }
}

TEST(Equalize, CannotChangeASizeThatIsGivenInNumbers) {
  Manifest manifest = study();
  manifest.equalize = {.size = EqualizeGroup::study};
  const auto is_told = [&] {
    const std::vector<Fault> faults = check_meaning({.manifest = manifest});
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
      return fault.wrong == "the camera of \"long\" already determines the size of its figure";
    });
  };
  EXPECT_FALSE(is_told());
  manifest.stimuli[1].look.camera.screen = scenes::ScreenSettings{};
  EXPECT_TRUE(is_told());
}

TEST(Equalize, CannotMoveAPictureWhoseCameraIsGivenInNumbers) {
  Manifest manifest = study();
  manifest.equalize = {.place = EqualizeGroup::study};
  const auto is_told = [&] {
    const std::vector<Fault> faults = check_meaning({.manifest = manifest});
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
      return fault.wrong == "the camera of \"long\" already determines the position of its figure";
    });
  };
  EXPECT_FALSE(is_told());
  manifest.stimuli[1].look.camera.position = {0.0, 1.0, 5.0};
  manifest.stimuli[1].look.camera.target = {0.0, 1.0, 0.0};
  EXPECT_TRUE(is_told());
}

TEST(Overlays, ShowTheirMotionsTogetherInOneFilm) {
  const test::TemporaryFolder folder;
  Manifest manifest = study();
  manifest.equalize = {};
  manifest.stimuli[0].role = Role::target;
  Overlay overlay;
  overlay.film = stimulus("both", "", 2);
  overlay.film.weights.clear();
  overlay.film.path = "overlays[0]";
  overlay.target = "short";
  overlay.created = "long";
  overlay.reference = "sad";  // an example
  manifest.overlays = {overlay};
  Motions motions(manifest);
  const scenes::Shot shot = shot_of(manifest.overlays[0], motions, 0);
  ASSERT_EQ(shot.actors.size(), 3u);
  EXPECT_EQ(shot.actors[0].name, "short");
  EXPECT_EQ(shot.actors[2].name, "sad");
  EXPECT_EQ(shot.actors[1].opacity, 0.75f);
  // Roles are told apart, though films of stimuli do not tell them.
  const scenes::Role roles[] = {scenes::Role::target, scenes::Role::created,
                                scenes::Role::reference};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(shot.actors[i].colours.middle.isApprox(scenes::colours_of(roles[i]).middle)) << i;
  }
  for (const scenes::Actor& actor : shot.actors)
    EXPECT_EQ(actor.clip.frames_per_second, overlay.film.output.fps);
  // Each as the overlay's own output shows it: two cycles.
  const int frames = motions.of("short").motion.clip.frame_count();
  EXPECT_EQ(shot.actors[0].clip.frame_count(), 2 * frames);
  EXPECT_EQ(shot.actors[1].clip.frame_count(), 2 * frames);

  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) EXPECT_EQ(outcome.error, "");
  ASSERT_TRUE(result.is_complete());
  EXPECT_EQ(stimulus_numbers(folder.path() / "out/metrics/videos.csv", "frames").at("both"),
            shot.frame_count());
  // Its own layout is its own film; the films of its motions stay.
  manifest.overlays[0].layout = scenes::Layout::side_by_side;
  Production other(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult again = run(other, folder.path() / "out", 1, {}, {});
  const auto state_of = [&](const std::string& task) {
    return again.outcomes[other.graph().index_of(task)].state;
  };
  EXPECT_EQ(state_of("film:both"), TaskState::made);
  EXPECT_EQ(state_of("film:short"), TaskState::cached);
}

TEST(Overlays, AreAskedForByNameOrByTheirMotions) {
  Manifest manifest = study();
  Overlay overlay;
  overlay.film = stimulus("both", "", 1);
  overlay.target = "short";
  overlay.created = "normal";
  manifest.overlays = {overlay};
  const auto is_made = [&](const std::vector<std::string>& only) {
    const Production production(manifest, {.quality = {}, .only = only, .jobs = 1});
    const auto& tasks = production.graph().tasks;
    return std::any_of(tasks.begin(), tasks.end(),
                       [](const Task& task) { return task.id == "film:both"; });
  };
  EXPECT_TRUE(is_made({}));
  EXPECT_TRUE(is_made({"both"}));
  EXPECT_TRUE(is_made({"short"}));
  EXPECT_FALSE(is_made({"long"}));
}

TEST(Films, AreNotMadeWithFadesLongerThanThey) {
  const test::TemporaryFolder folder;
  Manifest manifest = study();
  manifest.equalize = {};
  manifest.stimuli[0].output.presentation.fade_in = 3.0;
  Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  const auto error_of = [&](const std::string& task) {
    return result.outcomes[production.graph().index_of(task)].error;
  };
  EXPECT_NE(error_of("film:short").find("the fades last 3 s, but the film of \"short\""),
            std::string::npos)
      << error_of("film:short");
  EXPECT_EQ(error_of("film:long"), "");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/videos/short.mp4"));
}

TEST(Equalize, LeavesFilmsAloneOtherwise) {
  Manifest manifest = study();
  manifest.equalize = {};
  Motions motions(manifest);
  EXPECT_EQ(3 * motions.shown(manifest.stimuli[0]).frame_count(),
            motions.shown(manifest.stimuli[1]).frame_count());
}

TEST(VideoNames, OfTwoStimuliMustDiffer) {
  Manifest manifest = study();
  manifest.stimuli[0].id = "a.lossless";
  manifest.stimuli[1].id = "a";
  const auto is_told = [&] {
    const std::vector<Fault> faults = check_meaning({.manifest = manifest});
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
      return fault.wrong == "its video a.lossless.mp4 would be that of \"a.lossless\"";
    });
  };
  EXPECT_FALSE(is_told());
  manifest.stimuli[1].output.video = {render::VideoKind::mp4_lossless};
  EXPECT_TRUE(is_told());
}

TEST(ClipNames, OfTwoStimuliMustDiffer) {
  Manifest manifest = study();
  manifest.stimuli[0].id = "a.dots";
  manifest.stimuli[1].id = "a";
  manifest.stimuli[1].look.figure = scenes::PointLightOptions();
  const auto is_told = [&] {
    const std::vector<Fault> faults = check_meaning({.manifest = manifest});
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
      return fault.wrong == "its clip a.dots.csv would be that of \"a.dots\"";
    });
  };
  EXPECT_FALSE(is_told());
  manifest.stimuli[0].output.clips = {"bvh", "csv"};
  EXPECT_TRUE(is_told());
}

}  // namespace
}  // namespace mien::pipeline
