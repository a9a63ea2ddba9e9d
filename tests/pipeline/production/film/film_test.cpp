#include "pipeline/production/film/film.h"

#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/production/film/drawn_frames.h"
#include "pipeline/production/film/film_frames.h"
#include "pipeline/production/film/film_recorder.h"
#include "pipeline/tasks/task_graph.h"
#include "pipeline/temporary_folder.h"
#include "render/error.h"
#include "render/image/tone.h"
#include "render/video/video.h"

namespace mien::pipeline {
namespace {

constexpr std::array<int, 2> size = {48, 32};

scenes::Shot walk() {
  motion::Clip clip = motion::builtin_examples("walks-10", 10.0).examples[0].clip;
  scenes::Look look;
  look.size = size;
  return scenes::stage(motion::repeated(clip, 1), look);
}

FilmSettings settings(FrameFormat format = FrameFormat::png) {
  FilmSettings result;
  result.output.size = size;
  result.output.fps = 10.0;
  result.output.frames = format;
  result.output.quality = Quality::draft;
  return result;
}

std::vector<int> frames_of(const scenes::Shot& shot) {
  std::vector<int> frames(static_cast<std::size_t>(shot.frame_count()));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

using test::Pictures;

class Film : public testing::Test {
 protected:
  scenes::Shot shot = walk();
  test::TemporaryFolder temporary;
  std::filesystem::path folder = temporary.path() / "study";
  std::stop_source stop;

  Pictures draw(const FilmSettings& how, FrameStore* store) {
    Pictures pictures;
    int expected = 0;
    draw_frames(
        shot, frames_of(shot), how, store,
        [&](int frame, const render::Image8& picture) {
          EXPECT_EQ(frame, expected++);
          pictures[frame] = picture;
        },
        stop.get_token(), [](double) {});
    return pictures;
  }
};

TEST(FilmQuality, SpendsManySamplesOnASetThatStandsForTheWholeFilm) {
  const motion::Clip clip = motion::builtin_examples("walks-10", 10.0).examples[0].clip;
  scenes::Look look;
  look.size = size;
  const auto samples = [&] { return quality_of(settings(), scenes::stage(clip, look)); };
  const int many = quality_of(settings()).static_samples;
  const int few = quality_of(settings()).samples_per_pixel;
  ASSERT_LT(few, many);
  EXPECT_EQ(samples().static_samples, many);
  look.in_place = true;  // the figure alone
  EXPECT_EQ(samples().static_samples, many);
  look.set.in_place = true;
  look.set.ground.emplace();
  look.set.ground->line_spacing = 0.0f;
  EXPECT_EQ(samples().static_samples, many);
  look.set.ground->line_spacing = 0.5f;  // lines go under the figure
  EXPECT_EQ(samples().static_samples, few);
  look.set.in_place = look.in_place = false;
  look.camera.view = "follow";
  EXPECT_EQ(samples().static_samples, few);
}

TEST_F(Film, DeliversEveryFrameInOrderWhateverTheThreads) {
  const Pictures one = draw(settings(), nullptr);
  EXPECT_EQ(static_cast<int>(one.size()), shot.frame_count());
  FilmSettings more = settings();
  more.threads = 2;
  EXPECT_EQ(one, draw(more, nullptr));
  EXPECT_NE(one.at(0), one.at(4));
}

TEST_F(Film, WithoutFramesIsKeptOnceDrawingHasTakenLong) {
  Store store(folder);
  FilmSettings without = settings(FrameFormat::none);
  const Pictures expected = draw(without, store.frames("frames/a", "k").get());
  EXPECT_FALSE(store.frames("frames/a", "k")->find("00001.png")) << "it is drawn again";
  without.kept_after_seconds = 0.05;
  Pictures pictures;
  draw_frames(
      shot, frames_of(shot), without, store.frames("frames/a", "k").get(),
      [&](int frame, const render::Image8& picture) {
        pictures[frame] = picture;
        std::this_thread::sleep_for(std::chrono::milliseconds(frame == 0 ? 60 : 0));
      },
      stop.get_token(), [](double) {});
  EXPECT_EQ(pictures, expected);
  const auto kept = store.frames("frames/a", "k");
  for (int frame = 1; frame < shot.frame_count(); ++frame)
    EXPECT_TRUE(kept->find(frame_name(FrameFormat::none, frame))) << frame;
}

TEST_F(Film, StoresWhatItDeliversAndDeliversItAgain) {
  for (const FrameFormat format : {FrameFormat::png, FrameFormat::png16, FrameFormat::exr}) {
    const std::string path = "frames/" + std::to_string(static_cast<int>(format));
    Store store(folder);
    const Pictures first = draw(settings(format), store.frames(path, "k").get());
    // Another shot under the same key: what comes out can only be what was stored.
    const scenes::Shot kept = shot;
    shot.actors[0].colours = scenes::colours_of(scenes::Role::reference);
    const auto frames = store.frames(path, "k");
    EXPECT_EQ(first, draw(settings(format), frames.get()));
    shot = kept;
    EXPECT_TRUE(store.nondeterminism().empty());
    EXPECT_TRUE(frames->find(frame_name(format, 0)));
  }
}

TEST_F(Film, GoesOnAfterAStopWithTheSamePictures) {
  const Pictures whole = draw(settings(), nullptr);
  Store store(folder);
  int taken = 0;
  const auto stop_at_third = [&](int, const render::Image8&) {
    if (++taken == 3) stop.request_stop();
  };
  EXPECT_THROW(draw_frames(shot, frames_of(shot), settings(), store.frames("f", "k").get(),
                           stop_at_third, stop.get_token(), [](double) {}),
               Interrupted);
  stop = {};
  const auto frames = store.frames("f", "k");
  EXPECT_TRUE(frames->find("00000.png"));
  EXPECT_EQ(whole, draw(settings(), frames.get()));
}

TEST_F(Film, EndsWithWhatTheSinkThrows) {
  const auto full = [](int frame, const render::Image8&) {
    if (frame == 2) throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(draw_frames(shot, frames_of(shot), settings(), nullptr, full, stop.get_token(),
                           [](double) {}),
               std::runtime_error);
}

TEST_F(Film, DrawsOnlyTheFramesAskedFor) {
  std::vector<int> drawn;
  draw_frames(
      shot, {1, 5}, settings(), nullptr,
      [&](int frame, const render::Image8&) { drawn.push_back(frame); }, stop.get_token(),
      [](double) {});
  EXPECT_EQ(drawn, (std::vector<int>{1, 5}));
}

// Before a camera that stands, that follows, before two, and while a shutter is open.
TEST_F(Film, DrawsAFrameTheSameWhateverIsDrawnBeforeAndAfter) {
  for (const bool follows : {false, true}) {
    for (const double separation : {0.0, 0.065}) {
      for (const double shutter : {0.0, 180.0}) {
        scenes::Look look;
        look.size = size;
        if (follows) look.camera.view = "follow";
        if (separation > 0.0) look.camera.stereo_separation_m = separation;
        shot = scenes::stage(motion::builtin_examples("walks-10", 10.0).examples[0].clip, look);
        FilmSettings how = settings();
        how.output.shutter = shutter;
        how.threads = 2;
        const Pictures together = test::drawn_frames(shot, {3, 1, 2}, how);
        EXPECT_EQ(together.size(), 3u);
        for (const auto& [frame, picture] : together)
          EXPECT_EQ(test::drawn_frames(shot, {frame}, how).at(frame), picture)
              << "frame " << frame << ", follows " << follows << ", separation " << separation
              << ", shutter " << shutter;
        EXPECT_NE(together.at(1), together.at(3));
      }
    }
  }
}

// Where its pixels are dithered, too: the pattern begins at the corner of what is shown.
TEST_F(Film, ShowsAPartOfThePictureAlone) {
  const render::Window part{5, 9, 23, 17};
  scenes::Look look;
  look.size = size;
  for (const std::string view : {"side", "follow"}) {
    for (const bool dither : {false, true}) {
      look.camera.view = view;
      look.window.reset();
      const motion::Clip clip = motion::builtin_examples("walks-10", 10.0).examples[0].clip;
      scenes::Shot whole = scenes::stage(clip, look);
      look.window = part;
      scenes::Shot shown = scenes::stage(clip, look);
      whole.tone.dither = shown.tone.dither = dither;
      const Pictures found = test::drawn_frames(shown, {3, 4}, settings());
      for (const int frame : {3, 4}) {
        render::Tracer tracer;
        const render::Framebuffer film = tracer.trace(
            scene_at(whole, frame), camera_at(whole, frame), quality_of(settings(), whole));
        EXPECT_EQ(found.at(frame), render::to_srgb8(crop(film, part), whole.tone))
            << "frame " << frame << ", " << view << ", dither " << dither;
      }
    }
  }
}

// Of what the store has nothing is made ready.
TEST_F(Film, DrawsWhatIsMissingBetweenStoredFrames) {
  const Pictures whole = draw(settings(), nullptr);
  Store store(folder);
  const auto frames = store.frames("f", "k");
  draw(settings(), frames.get());
  for (const int frame : {0, 2, 3, 6}) frames->discard(frame_name(FrameFormat::png, frame));
  EXPECT_EQ(draw(settings(), frames.get()), whole);
}

TEST_F(Film, BecomesAVideoThatIsWhatWasAskedFor) {
  const std::filesystem::path file = temporary.path() / "walk.mp4";
  const std::filesystem::path other = temporary.path() / "walk.mkv";
  FilmSettings how = settings();
  how.output.presentation = {.fixation_seconds = 0.5, .fixation_size = 9, .blank_after = 0.3};
  FilmRecorder recorder(how, shot.frame_count());
  recorder.open(file, render::VideoKind::mp4);
  recorder.open(other, render::VideoKind::mkv);
  draw_frames(
      shot, frames_of(shot), how, nullptr,
      [&](int, const render::Image8& picture) { recorder.take(picture); }, stop.get_token(),
      [](double) {});
  recorder.close();
  EXPECT_EQ(recorder.check(file, render::VideoKind::mp4).summary.frames, shot.frame_count() + 8);
  EXPECT_TRUE(recorder.check(other, render::VideoKind::mkv).identical);
  EXPECT_THROW(recorder.check(file, render::VideoKind::mkv), render::Error);
}

// The pictures around a film are part of what a video shows, and no picture of the film shows them.
TEST_F(Film, HasTheHashOfAllFramesThatItsVideosShow) {
  const auto hash_with = [&](double grey, std::uint8_t level) {
    FilmSettings how = settings();
    how.output.presentation = {.blank_after = 0.3};
    how.output.presentation.background = grey;
    FilmRecorder recorder(how, 2);
    render::Image8 picture(size[0], size[1]);
    std::ranges::fill(picture.channels, level);
    for (int frame = 0; frame < 2; ++frame) recorder.take(picture);
    return recorder.frames_hash();
  };
  EXPECT_EQ(hash_with(0.5, 9), hash_with(0.5, 9));
  EXPECT_NE(hash_with(0.5, 9), hash_with(0.6, 9));
  EXPECT_NE(hash_with(0.5, 9), hash_with(0.5, 10));
}

TEST_F(Film, CutShortBecomesNoVideo) {
  const FilmSettings how = settings();
  FilmRecorder recorder(how, shot.frame_count());
  recorder.open(temporary.path() / "walk.mp4", render::VideoKind::mp4);
  recorder.take(render::Image8(size[0], size[1]));
  EXPECT_THROW(recorder.close(), render::Error);
}

TEST_F(Film, IsShownOnAContactSheetOfTwelveFrames) {
  ContactSheetBuilder sheet(shot.frame_count());
  const Pictures pictures = draw(settings(), nullptr);
  for (const auto& [frame, picture] : pictures) sheet.add(frame, picture);
  EXPECT_LE(sheet.frames().size(), 12u);
  EXPECT_EQ(sheet.frames().front(), 0);
  EXPECT_EQ(sheet.frames().back(), shot.frame_count() - 1);
  EXPECT_GT(sheet.build().width, 4 * size[0]);
}

TEST(FilmFrames, HaveNamesThatSort) {
  EXPECT_EQ(frame_name(FrameFormat::png, 7), "00007.png");
  EXPECT_EQ(frame_name(FrameFormat::png16, 12345), "12345.png");
  EXPECT_EQ(frame_name(FrameFormat::exr, 0), "00000.exr");
}

TEST(FilmFrames, OfAnotherSizeAreRefused) {
  const test::TemporaryFolder folder;
  const render::Framebuffer film(8, 4);
  write_frame(folder.path() / "a.png", render::to_srgb8(film));
  EXPECT_NO_THROW(read_frame(folder.path() / "a.png", FrameFormat::png, {8, 4}));
  EXPECT_THROW(read_frame(folder.path() / "a.png", FrameFormat::png, {8, 5}), render::Error);
  EXPECT_THROW(read_frame(folder.path() / "a.png", FrameFormat::png16, {8, 4}), render::Error);
}

}  // namespace
}  // namespace mien::pipeline
