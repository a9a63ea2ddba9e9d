#include "pipeline/production/film/film_record.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(FilmRecord, IsReadAsItWasWritten) {
  FilmRecord record;
  record.film_frames = 90;
  record.first_film_frame = 15;
  record.exposure_stops = -0.25;
  record.figure_px = 312.5;
  record.figure_place = {-1.5, 120.25};
  record.warnings = {"a normal map is not drawn"};
  record.visual_degrees = 8.25;
  record.luminance = {.frames = 90,
                      .mean = 0.31,
                      .deviation = 0.11,
                      .rms_contrast = 0.355,
                      .darkest = 0.305,
                      .lightest = 0.312};
  render::VideoCheck check;
  check.frames = 105;
  check.identical = false;
  check.worst_psnr_db = 44.12345;
  check.worst_psnr_frame = 7;
  check.worst_ssim = 0.99123456;
  check.worst_ssim_frame = 9;
  record.videos.push_back(video_record("videos/a.webm", render::VideoKind::webm, 30.0, check));
  check.identical = true;
  check.worst_psnr_db = std::numeric_limits<double>::infinity();
  record.videos.push_back(video_record("videos/a.mkv", render::VideoKind::mkv, 30.0, check));
  record.videos[1].sound = video_sound_record(
      {.codec = "opus", .channels = 2, .frames = 168'000, .hash = 0xab, .match = {0, 0.98765}});
  record.videos[1].frames_hash = "0123";
  record.sound = SoundRecord{.file = "a.wav",
                             .of = "b",
                             .offset_s = 0.5,
                             .gain_db = -3.0,
                             .length = "hold",
                             .source_s = 4.0,
                             .channels = 2,
                             .held_frames = 5,
                             .cut_s = 0.0,
                             .silence_s = 0.01,
                             .loudness_lufs = -23.0,
                             .true_peak_dbtp = {}};

  const FilmRecord read = parse_film_record(film_record_text(record));
  EXPECT_EQ(film_record_text(read), film_record_text(record));
  EXPECT_EQ(read.videos, record.videos);
  EXPECT_EQ(read.videos[0].worst_psnr_db, 44.12);
  EXPECT_EQ(read.videos[0].duration_s, 3.5);
  EXPECT_EQ(read.videos[0].frames_hash, "") << "as in records of former versions";
  EXPECT_EQ(read.videos[1].frames_hash, "0123");
  EXPECT_EQ(read.videos[1].format, "mkv");
  EXPECT_EQ(read.luminance.lightest, 0.312);
  EXPECT_EQ(read.exposure_stops, -0.25);
  EXPECT_EQ(read.figure_px, 312.5);
  EXPECT_EQ(read.figure_place, record.figure_place);
  EXPECT_EQ(read.warnings, record.warnings);
  EXPECT_EQ(read.visual_degrees, 8.25);
  EXPECT_EQ(read.sound, record.sound);
  EXPECT_EQ(read.videos[1].sound->hash, "00000000000000ab");
  EXPECT_EQ(read.videos[1].sound->correlation, 0.988);
  EXPECT_FALSE(read.videos[0].sound);
}

TEST(FilmRecord, RefusesWhatIsNone) {
  EXPECT_THROW(parse_film_record("{}"), std::runtime_error);
  EXPECT_THROW(parse_film_record("no json"), std::runtime_error);
}

}  // namespace
}  // namespace mien::pipeline
