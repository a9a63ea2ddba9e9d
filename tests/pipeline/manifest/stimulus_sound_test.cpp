#include "pipeline/manifest/stimulus_sound.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/factors.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/temporary_folder.h"
#include "render/sounds.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> letters(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i)
    names.push_back("stimulus-" + std::string(1, static_cast<char>('a' + i)));
  return names;
}

bool is_permutation_of_places(std::vector<std::size_t> sources) {
  std::ranges::sort(sources);
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i] != i) return false;
  return true;
}

TEST(Derangement, GivesEveryPlaceAnothersThingOnce) {
  for (std::size_t count = 2; count <= 20; ++count) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const std::vector<std::string> names = letters(count);
      const std::vector<std::size_t> sources = derangement(names, names, seed);
      ASSERT_EQ(sources.size(), count);
      EXPECT_TRUE(is_permutation_of_places(sources));
      for (std::size_t i = 0; i < count; ++i) EXPECT_NE(sources[i], i);
      EXPECT_EQ(derangement(names, names, seed), sources);
    }
  }
}

// Four things have nine derangements. The 0.999 quantile of χ² with 8 degrees of freedom is 26.1.
TEST(Derangement, HasAllExchangesEquallyOften) {
  constexpr int draws = 1800;
  std::map<std::vector<std::size_t>, int> counts;
  for (std::uint64_t seed = 0; seed < draws; ++seed)
    ++counts[derangement(letters(4), letters(4), seed)];
  ASSERT_EQ(counts.size(), 9u);
  double chi_square = 0.0;
  for (const auto& [sources, count] : counts) {
    const double expected = draws / 9.0;
    chi_square += (count - expected) * (count - expected) / expected;
  }
  EXPECT_LT(chi_square, 26.1);
}

TEST(Derangement, KeepsEqualThingsApart) {
  // As many of one thing as of all others: few exchanges are left, which are not found by trying.
  for (const std::vector<std::string>& owned :
       {std::vector<std::string>{"x", "y", "x", "y"},
        {"x", "x", "y", "z"},
        {"x", "x", "x", "x", "x", "x", "x", "x", "y", "y", "y", "y", "z", "z", "z", "z"},
        {"z", "x", "y", "x", "z", "x"}}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const std::vector<std::size_t> sources = derangement(letters(owned.size()), owned, seed);
      ASSERT_TRUE(!sources.empty() && is_permutation_of_places(sources));
      for (std::size_t i = 0; i < owned.size(); ++i) EXPECT_NE(owned[sources[i]], owned[i]);
    }
  }
}

TEST(Derangement, IsNoneWhereThereCannotBeOne) {
  EXPECT_TRUE(derangement({}, {}, 1).empty());
  EXPECT_TRUE(derangement({"a"}, {"x"}, 1).empty());
  EXPECT_TRUE(derangement(letters(3), {"x", "y", "x"}, 1).empty());
}

class Sounds : public testing::Test {
 protected:
  Sounds() {
    for (const char* name : {"one.wav", "two.wav", "three.wav"})
      render::test::write_wav(folder.path() / name, render::test::noise(0.1, 1000));
  }

  /// Reads a manifest with these stimuli, whose motion is added, and these further lines.
  ManifestReading reading(const std::string& stimuli, const std::string& more = "") {
    std::string text = "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n" + more;
    text += "stimuli:\n" + stimuli;
    std::ofstream(folder.path() / "m.yaml") << text;
    return check_manifest(folder.path() / "m.yaml",
                          [](const std::string&) { return std::nullopt; });
  }

  Manifest manifest_of(const std::string& stimuli, const std::string& more = "") {
    ManifestReading read = reading(stimuli, more);
    EXPECT_EQ(faults_in(read), "");
    return std::move(read.manifest);
  }

  static std::string faults_in(const ManifestReading& read) {
    std::string text;
    for (const Fault& fault : read.faults)
      text += std::to_string(fault.place.line) + " " + fault.path + ": " + fault.wrong + "; " +
              fault.remedy + "\n";
    return text;
  }

  std::string faults_of(const std::string& stimuli, const std::string& more = "") {
    return faults_in(reading(stimuli, more));
  }

  test::TemporaryFolder folder;
};

constexpr char three[] =
    "  - {id: a, weights: {sad: 1}, audio: one.wav}\n"
    "  - {id: b, weights: {sad: 1}, audio: {file: two.wav, offset: 0.5, gain: -3, length: cut}}\n"
    "  - {id: c, weights: {sad: 1}, audio: {from: b, length: hold}}\n";

TEST_F(Sounds, AreThoseOfTheirFilesOrOfAnotherStimulus) {
  const Manifest manifest = manifest_of(three);
  ASSERT_TRUE(manifest.stimuli[2].sound);
  const StimulusSound& own = *manifest.stimuli[0].sound;
  EXPECT_EQ(own.file, folder.path() / "one.wav");
  EXPECT_EQ(own.length, SoundLength::error);
  EXPECT_EQ(own.of, "a");
  const StimulusSound& other = *manifest.stimuli[2].sound;
  EXPECT_EQ(other.file, folder.path() / "two.wav");
  EXPECT_EQ(other.offset, 0.5);
  EXPECT_EQ(other.gain, -3.0);
  EXPECT_EQ(other.length, SoundLength::hold);
  EXPECT_EQ(other.of, "b");
  EXPECT_EQ(level_of(manifest.stimuli[0], "audio"), "matched");
  EXPECT_EQ(level_of(manifest.stimuli[2], "audio"), "mismatched");
}

TEST_F(Sounds, AreExchangedByTheSeed) {
  const std::string stimuli =
      std::string(three) + "  - {id: d, weights: {sad: 1}, audio: three.wav}\n";
  std::set<std::string> orders;
  for (int seed = 0; seed < 20; ++seed) {
    const std::string more =
        "mismatch: {audio: derange, seed: " + std::to_string(seed) + ", stimuli: [a, b, d]}\n";
    const Manifest manifest = manifest_of(stimuli, more);
    std::string order;
    for (const std::size_t i : {0u, 1u, 3u}) {
      const Stimulus& stimulus = manifest.stimuli[i];
      EXPECT_NE(stimulus.sound->of, stimulus.id);
      EXPECT_EQ(level_of(stimulus, "audio"), "mismatched");
      order += stimulus.sound->of;
    }
    EXPECT_EQ(manifest.stimuli[1].sound->length, SoundLength::cut);  // its own
    EXPECT_EQ(manifest.stimuli[2].sound->of, "b");                   // is not in the list
    orders.insert(order);
  }
  EXPECT_EQ(orders, (std::set<std::string>{"bda", "dab"}));
}

TEST_F(Sounds, AreExchangedAmongAllStimuliWithASoundByDefault) {
  const Manifest manifest = manifest_of(
      "  - {id: a, weights: {sad: 1}, audio: {file: one.wav, gain: -1}}\n"
      "  - {id: quiet, weights: {sad: 1}}\n"
      "  - {id: b, weights: {sad: 1}, audio: two.wav, factors: {audio: swapped}}\n",
      "mismatch: {audio: derange}\n");
  EXPECT_EQ(manifest.stimuli[0].sound->of, "b");
  EXPECT_EQ(manifest.stimuli[0].sound->gain, 0.0);
  EXPECT_FALSE(manifest.stimuli[1].sound);
  EXPECT_EQ(level_of(manifest.stimuli[1], "audio"), "");
  EXPECT_EQ(manifest.stimuli[2].sound->of, "a");
  EXPECT_EQ(manifest.stimuli[2].sound->gain, -1.0);
  EXPECT_EQ(level_of(manifest.stimuli[2], "audio"), "swapped");
}

TEST_F(Sounds, AreWrittenAsTheyWereRead) {
  const Manifest manifest = manifest_of(
      three, "mismatch: {audio: derange, seed: 4, stimuli: [a, b]}\nequalize: [size, duration]\n");
  std::ofstream(folder.path() / "again.yaml") << manifest_yaml(manifest, folder.path());
  const Manifest again =
      load_manifest(folder.path() / "again.yaml", [](const std::string&) { return std::nullopt; });
  ASSERT_TRUE(again.mismatch);
  EXPECT_EQ(again.mismatch->seed, 4u);
  EXPECT_EQ(again.mismatch->stimuli, manifest.mismatch->stimuli);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.stimuli[i].sound->file, manifest.stimuli[i].sound->file);
    EXPECT_EQ(again.stimuli[i].sound->offset, manifest.stimuli[i].sound->offset);
    EXPECT_EQ(again.stimuli[i].sound->length, manifest.stimuli[i].sound->length);
    EXPECT_EQ(again.stimuli[i].sound->of, manifest.stimuli[i].sound->of);
  }
}

TEST_F(Sounds, HaveAnEqualizedLoudness) {
  const std::string stimuli = "  - {id: a, weights: {sad: 1}, audio: one.wav}\n";
  EXPECT_EQ(manifest_of(stimuli, "equalize: [loudness]\n").equalize.loudness, -23.0);
  EXPECT_EQ(manifest_of(stimuli, "equalize: {loudness: true}\n").equalize.loudness, -23.0);
  EXPECT_EQ(manifest_of(stimuli, "equalize: {loudness: -27.5}\n").equalize.loudness, -27.5);
  EXPECT_FALSE(manifest_of(stimuli, "equalize: {loudness: false}\n").equalize.loudness);
  EXPECT_FALSE(manifest_of(stimuli).equalize.loudness);
}

TEST_F(Sounds, AreRefusedWhereTheyAreNamedWrong) {
  EXPECT_EQ(faults_of("  - {id: a, weights: {sad: 1}, audio: {offset: 1}}\n"),
            "5 stimuli[0].audio: names no sound; give either file or from\n");
  EXPECT_EQ(faults_of("  - {id: a, weights: {sad: 1}, audio: {file: one.wav, from: a}}\n"),
            "5 stimuli[0].audio: names a file and a stimulus; give either file or from\n");
  const std::string a = "  - {id: first, weights: {sad: 1}, audio: one.wav}\n";
  EXPECT_EQ(faults_of(a + "  - {id: b, weights: {sad: 1}, audio: {from: firts}}\n"),
            "6 stimuli[1].audio.from: \"firts\" is not a stimulus; did you mean \"first\"?\n");
  EXPECT_EQ(faults_of(a + "  - {id: b, weights: {sad: 1}}\n"
                          "  - {id: c, weights: {sad: 1}, audio: {from: b}}\n"),
            "7 stimuli[2].audio.from: \"b\" has no sound; name a stimulus with audio: file\n");
  EXPECT_EQ(faults_of(a + "  - {id: b, weights: {sad: 1}, audio: {from: first}}\n"
                          "  - {id: c, weights: {sad: 1}, audio: {from: b}}\n"),
            "7 stimuli[2].audio.from: \"b\" takes its sound from another stimulus; name that one: "
            "\"first\"\n");
  EXPECT_EQ(
      faults_of(a + "  - {id: b, weights: {sad: 1}, audio: {from: b}}\n"),
      "6 stimuli[1].audio.from: is this stimulus itself; name another one, or give the file\n");
  EXPECT_EQ(faults_of(a + "  - {id: b, weights: {sad: 1}, audio: {from: first, gain: 2}}\n"),
            "6 stimuli[1].audio.gain: belongs to the sound of \"first\"; set it there, or give the "
            "file\n");
}

TEST_F(Sounds, AreRefusedWhereTheyCannotBeExchanged) {
  const std::string a = "  - {id: a, weights: {sad: 1}, audio: one.wav}\n";
  const std::string b = "  - {id: b, weights: {sad: 1}}\n";
  const std::string all = "mismatch: {audio: derange}\n";
  EXPECT_EQ(
      faults_of(b, all),
      "4 mismatch: no stimulus has a sound, so none can get another's; give audio to at least "
      "two stimuli, or omit mismatch\n");
  EXPECT_EQ(
      faults_of(a + b, all),
      "4 mismatch: only one stimulus has a sound, so none can get another's; give audio to at "
      "least two stimuli, or omit mismatch\n");
  EXPECT_EQ(faults_of(a + b, "mismatch: {audio: derange, stimuli: [a, b]}\n"),
            "4 mismatch.stimuli[1]: \"b\" has no sound; give it audio, or omit it here\n");
  EXPECT_EQ(faults_of(a + b, "mismatch: {audio: derange, stimuli: [a, x]}\n").substr(0, 49),
            "4 mismatch.stimuli[1]: \"x\" is not a stimulus; did");
  EXPECT_EQ(
      faults_of(a + "  - {id: c, weights: {sad: 1}, audio: {from: a}}\n", all),
      "4 mismatch: 2 of 2 stimuli have the sound \"one.wav\", so not all can get another; list "
      "stimuli of which at most half have the same sound\n");
}

TEST_F(Sounds, AreRefusedWhereNoVideoCanHoldThem) {
  const std::string a = "  - {id: a, weights: {sad: 1}, audio: one.wav}\n";
  EXPECT_EQ(faults_of(a, "output: {video: [mp4, gif]}\n"),
            "4 output.video: \"a\" has a sound, which gif cannot hold; write mp4, webm or mkv, or "
            "omit audio\n");
  EXPECT_EQ(
      faults_of(a, "output: {video: []}\n"),
      "4 output.video: \"a\" has a sound, but no video is written; write mp4, webm or mkv, or "
      "omit audio\n");
  EXPECT_EQ(faults_of("  - {id: a, weights: {sad: 1}, audio: one.wav, output: {video: [apng]}}\n"),
            "5 stimuli[0].output.video: \"a\" has a sound, which apng cannot hold; write mp4, webm "
            "or mkv, or omit audio\n");
}

TEST_F(Sounds, AreRefusedWhereTheirFileIsNone) {
  const std::string missing = faults_of("  - {id: a, weights: {sad: 1}, audio: {file: no.wav}}\n");
  EXPECT_EQ(missing.substr(0, 24), "5 stimuli[0].audio.file:") << missing;
  EXPECT_NE(missing.find("no.wav"), std::string::npos);
  std::ofstream(folder.path() / "sound.aiff") << "FORM";
  EXPECT_EQ(
      faults_of("  - {id: a, weights: {sad: 1}, audio: sound.aiff}\n"),
      "5 stimuli[0].audio: \".aiff\" is not a sound file format; use .wav, .flac, .opus, .ogg, "
      ".mp3\n");
  EXPECT_EQ(faults_of("  - {id: a, weights: {sad: 1}, audio: {file: one.wav, gain: 3}}\n",
                      "equalize: [loudness]\n"),
            "6 stimuli[0].audio.gain: the loudness of all sounds is equalized; omit it, or omit "
            "equalize: loudness\n");
}

/// Two stimuli with sounds and one without, and a questionnaire.
std::string heard(const std::string& settings) {
  return "  - {id: a, weights: {sad: 1}, audio: one.wav}\n"
         "  - {id: b, weights: {normal: 1}, audio: two.wav}\n"
         "  - {id: c, weights: {proud: 1}}\n"
         "questionnaire: {participants: 4, " +
         settings + "}\n";
}

TEST_F(Sounds, AreNotHeardTwoAtATime) {
  EXPECT_EQ(faults_of(heard("scales: all, stimuli: [a, b]")), "");
  EXPECT_EQ(
      faults_of(heard("scales: [sad-happy], trials: pair")),
      "8 questionnaire.preference: two sounds would be heard at the same time; show pairs one "
      "after the other: preference: {shown: in_turn}\n");
  EXPECT_EQ(faults_of(heard("scales: [sad-happy], trials: pair, preference: {shown: in_turn}")),
            "");
  EXPECT_EQ(
      faults_of(heard("scales: all, stimuli: [b], reference: a")),
      "8 questionnaire.reference: the reference is shown beside the stimuli, and both would be "
      "heard at the same time; name a reference without audio, or omit it\n");
  EXPECT_EQ(faults_of(heard("scales: all, stimuli: [a, b], reference: c")), "");
  EXPECT_EQ(
      faults_of(heard("scales: all, view: turn"), "output: {clips: [bvh, glb]}\n"),
      "9 questionnaire.view: figures that are turned have no sound; omit view, or show stimuli "
      "without audio\n");
}

TEST_F(Sounds, AreBestTestedBeforeAQuestionnaire) {
  const auto warns = [&](const std::string& settings) {
    return std::ranges::any_of(
        questionnaire_warnings(manifest_of(heard(settings))), [](const Fault& warning) {
          return warning.wrong == "nobody tests whether participants hear the sound of the videos";
        });
  };
  EXPECT_TRUE(warns("scales: all"));
  EXPECT_FALSE(warns("scales: all, screening: {sound: true}"));
  EXPECT_FALSE(warns("scales: all, stimuli: [c]"));
}

}  // namespace
}  // namespace mien::pipeline
