#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/archive/verify.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/run/rehearsal.h"
#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/sounds.h"
#include "render/video/sound_file.h"
#include "render/video/video.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using render::sound_rate;

/// A study of three small films with sounds, which is made in a folder of its own.
class SoundStudy : public testing::Test {
 protected:
  SoundStudy() {
    render::Sound clicks = render::test::silence(2 * sound_rate);
    for (const int frame : {12'000, 60'000}) render::test::add_click(clicks, frame);
    render::test::write_wav(folder.path() / "clicks.wav", clicks);
    render::test::write_wav(folder.path() / "noise.wav", render::test::noise(0.2, sound_rate, 2));
  }

  static std::string manifest_text(const std::string& more = "") {
    return "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
           "output: {size: [48, 32], fps: 10, cycles: 1, quality: draft, frames: none, clips: [], "
           "video: [mp4, webm]}\n" +
           more +
           "stimuli:\n"
           "  - {id: a, weights: {sad: 1}, audio: {file: clicks.wav, offset: 0.1, length: hold}}\n"
           "  - {id: b, weights: {normal: 1}, audio: {file: noise.wav, length: cut}}\n"
           "  - {id: c, weights: {normal: 1}}\n";
  }

  Manifest manifest(const std::string& text) const {
    std::ofstream(folder.path() / "m.yaml") << text;
    return load(folder.path() / "m.yaml");
  }

  static Manifest load(const fs::path& file) {
    return load_manifest(file, [](const std::string&) { return std::nullopt; });
  }

  /// Runs a study and returns the states of its tasks.
  std::map<std::string, TaskState> made(Manifest study, const std::string& out,
                                        int jobs = 1) const {
    Production production(std::move(study), {.quality = {}, .only = {}, .jobs = jobs});
    const RunResult result = run(production, folder.path() / out, jobs, {}, {});
    std::map<std::string, TaskState> states;
    for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
      EXPECT_EQ(result.outcomes[i].error, "");
      states[production.graph().tasks[i].id] = result.outcomes[i].state;
    }
    return states;
  }

  std::map<std::string, std::string> row(const fs::path& table, const std::string& file) const {
    const CsvTable read = read_csv(table);
    for (const auto& fields : read.rows) {
      std::map<std::string, std::string> values;
      for (std::size_t i = 0; i < fields.size(); ++i) values[read.header[i].text] = fields[i].text;
      if (values["file"] == file || values["stimulus"] == file) return values;
    }
    ADD_FAILURE() << "no row " << file;
    return {};
  }

  test::TemporaryFolder folder;
};

TEST_F(SoundStudy, HasVideosWithTheSoundsOfItsManifest) {
  made(manifest(manifest_text()), "out");
  const fs::path out = folder.path() / "out";
  for (const char* name : {"videos/a.mp4", "videos/a.webm"}) {
    const auto found = render::sound_of_video(out / name);
    ASSERT_TRUE(found);
    EXPECT_EQ(render::test::loudest_frame(found->sound, 0, 20'000), 12'000 - 4'800);
    EXPECT_EQ(render::test::loudest_frame(found->sound, 40'000, 70'000), 60'000 - 4'800);
    // 1.9 s of sound: the last picture is held until its end.
    EXPECT_EQ(render::probe(out / name).frames, 19);
  }
  EXPECT_EQ(render::sound_of_video(out / "videos/b.mp4")->sound.channels, 2);
  EXPECT_FALSE(render::sound_of_video(out / "videos/c.mp4"));

  auto video = row(out / "metrics/videos.csv", "videos/a.mp4");
  EXPECT_EQ(video["sound_codec"], "aac");
  EXPECT_EQ(video["sound_channels"], "1");
  EXPECT_EQ(video["sound_frames"], "91200");
  EXPECT_EQ(video["sound_offset_frames"], "0");
  EXPECT_GT(std::stod(video["sound_correlation"]), 0.9);
  EXPECT_EQ(video["sound_hash"].size(), 16u);
  EXPECT_EQ(row(out / "metrics/videos.csv", "videos/a.webm")["sound_hash"], video["sound_hash"]);
  EXPECT_EQ(row(out / "metrics/videos.csv", "videos/c.mp4")["sound_codec"], "");

  auto stimulus = row(out / "metrics/stimuli.csv", "a");
  EXPECT_EQ(stimulus["sound"], "clicks.wav");
  EXPECT_EQ(stimulus["sound_of"], "a");
  EXPECT_EQ(stimulus["factor_audio"], "matched");
  EXPECT_EQ(std::stoi(stimulus["held_frames"]) + std::stoi(stimulus["film_frames"]), 19);
  EXPECT_LT(std::stod(row(out / "metrics/stimuli.csv", "b")["loudness_lufs"]), -5.0);
  EXPECT_EQ(row(out / "metrics/stimuli.csv", "c")["sound"], "");

  const std::string report = read_file(out / "report.html");
  EXPECT_NE(report.find("src=\"sheets/sound/a.svg\""), std::string::npos);
  EXPECT_EQ(report.find("sheets/sound/c.svg"), std::string::npos);
  const std::string wave = read_file(out / "sheets/sound/a.svg");
  EXPECT_NE(wave.find("clicks.wav, 1.90 s"), std::string::npos);
  EXPECT_NE(wave.find("the last picture is held from here"), std::string::npos);
  const std::string methods = read_file(out / "methods.md");
  for (const char* sentence : {"clicks.wav (from 0.1 s) and noise.wav", "The sound of b was cut",
                               "The last picture of a was held", "AAC (128 kbit/s per channel)",
                               "Opus (96 kbit/s per channel)", "loudness"})
    EXPECT_NE(methods.find(sentence), std::string::npos) << sentence;
}

TEST_F(SoundStudy, IsTheSameWhateverTheThreadsAndFromItsProvenance) {
  made(manifest(manifest_text()), "one", 1);
  made(manifest(manifest_text()), "two", 2);
  const fs::path one = folder.path() / "one";
  EXPECT_TRUE(fs::is_regular_file(one / "inputs/clicks.wav"));
  fs::remove(folder.path() / "clicks.wav");
  fs::remove(folder.path() / "noise.wav");
  made(load(one / "provenance.json"), "again");
  for (const char* name : {"videos/a.mp4", "videos/a.webm", "videos/b.mp4", "videos/b.webm",
                           "metrics/films/a.json", "sheets/sound/b.svg"}) {
    const auto bytes = render::test::bytes_of(one / name);
    EXPECT_TRUE(render::test::bytes_of(folder.path() / "two" / name) == bytes) << name;
    EXPECT_TRUE(render::test::bytes_of(folder.path() / "again" / name) == bytes) << name;
  }
}

TEST_F(SoundStudy, MakesOnlyTheFilmAgainWhoseSoundChanged) {
  made(manifest(manifest_text()), "out");
  render::test::write_wav(folder.path() / "noise.wav", render::test::noise(0.1, sound_rate, 2));
  const auto states = made(manifest(manifest_text()), "out");
  EXPECT_EQ(states.at("film:a"), TaskState::cached);
  EXPECT_EQ(states.at("film:b"), TaskState::made);
  EXPECT_EQ(states.at("film:c"), TaskState::cached);
  EXPECT_EQ(states.at("motion:b"), TaskState::cached);
}

// Two stimuli may have one sound, and a third takes it from one or the other.
TEST_F(SoundStudy, StatesWhoseSoundItIsAfterThatChanged) {
  const auto text_of = [](const std::string& from) {
    return "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
           "output: {size: [48, 32], fps: 10, cycles: 1, quality: draft, clips: [], video: [mp4]}\n"
           "stimuli:\n"
           "  - {id: a, weights: {sad: 1}, audio: {file: noise.wav, length: cut}}\n"
           "  - {id: b, weights: {normal: 1}, audio: {file: noise.wav, length: cut}}\n"
           "  - {id: c, weights: {normal: 1}, audio: {length: cut, from: " +
           from + "}}\n";
  };
  for (const char* from : {"a", "b"}) {
    made(manifest(text_of(from)), "out");
    EXPECT_EQ(row(folder.path() / "out/metrics/stimuli.csv", "c")["sound_of"], from);
  }
}

TEST_F(SoundStudy, IsVerifiedWithItsSounds) {
  made(manifest(manifest_text()), "out");
  const fs::path out = folder.path() / "out";
  const auto told = [&] {
    std::string text;
    for (const Finding& finding : verify(contents_of(out), 1, {}, {}).findings)
      text += std::string(name_of(finding.kind)) + " " + finding.path + ": " + finding.what + "\n";
    return text;
  };
  EXPECT_EQ(told(), "");
  std::string bytes = read_file(out / "inputs/clicks.wav");
  bytes[bytes.size() / 2] ^= 1;
  write_file(out / "inputs/clicks.wav", bytes);
  EXPECT_EQ(told(), "changed inputs/clicks.wav: different content\n");
}

TEST_F(SoundStudy, EqualizesLoudness) {
  made(manifest(manifest_text("equalize: {loudness: -40}\n")), "out");
  const fs::path out = folder.path() / "out";
  EXPECT_NEAR(std::stod(row(out / "metrics/stimuli.csv", "b")["loudness_lufs"]), -40.0, 0.011);
  const auto decoded = render::sound_of_video(out / "videos/b.mp4");
  // Of noise, AAC leaves out the highest frequencies.
  EXPECT_NEAR(render::loudness_of(decoded->sound).integrated_lufs, -40.0, 1.5);
  EXPECT_NE(read_file(out / "report.html").find("loudness of the sounds (-40 LUFS)"),
            std::string::npos);
  EXPECT_NE(read_file(out / "methods.md").find("equalized to -40 LUFS by gain"), std::string::npos);
}

TEST_F(SoundStudy, IsRehearsedWithItsSounds) {
  std::string text = manifest_text();
  text.replace(text.find("length: cut"), 11, "length: error");
  const std::vector<Fault> faults = rehearse(manifest(text));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults.front().path, "stimuli[1].audio");
  EXPECT_EQ(faults.front().place.line, 7);
  EXPECT_NE(faults.front().wrong.find("noise.wav lasts 1.000 s from its offset, but the film of"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
