#include "pipeline/manifest/checks/manifest_reader.h"

#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

const std::string head = "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n";

class ManifestReaderTest : public testing::Test {
 protected:
  ManifestReaderTest() {
    write_file(folder.path() / "walk.bvh", "");
    write_file(folder.path() / "notes.txt", "");
    write_file(folder.path() / "answers.csv", "");
    std::filesystem::create_directory(folder.path() / "captures");
  }

  ManifestReading parse(const std::string& text) const {
    return parse_manifest(text, folder.path() / "m.yaml", [](const std::string& name) {
      return name == "FPS" ? std::optional<std::string>("50") : std::nullopt;
    });
  }

  /// All faults, one a line, names of folders left out.
  std::string faults_in(const std::string& text) const { return told(parse(text).faults); }

  /// Of a manifest whose first three lines are good.
  std::string faults_after_head(const std::string& rest) const { return faults_in(head + rest); }

  std::string told(const std::vector<Fault>& faults) const {
    std::string text;
    for (const Fault& fault : faults) text += to_string(fault) + "\n";
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }

  test::TemporaryFolder folder;
};

const std::string asked =
    "stimuli: [{id: a, weights: {sad: 1}, factors: {actor: k}}, "
    "{id: b, weights: {normal: 1}, factors: {actor: l}}]\n"
    "questionnaire: {participants: 4, scales: all, ";

TEST_F(ManifestReaderTest, UnderstandsFormerNamesOfKeysAndWarns) {
  const ManifestReading reading =
      parse(head + "look: {figure: {trail: {before: 2, faintest: 0.3}}}\n" + asked +
            "apart: [actor], analysis: {most_failed: 3}, catch: {repeat: 1}}\n");
  EXPECT_EQ(told(reading.faults), "");
  EXPECT_EQ(told(reading.manifest.renamed),
            "m.yaml:4:36: look.figure.trail.faintest: now called min_opacity; rename it\n"
            "m.yaml:6:47: questionnaire.apart: now called no_repeats; rename it\n"
            "m.yaml:6:74: questionnaire.analysis.most_failed: now called max_failed_checks; "
            "rename it\n"
            "m.yaml:6:91: questionnaire.catch: now called retest; rename it\n");
  EXPECT_EQ(std::get<scenes::TrailOptions>(reading.manifest.look.figure).min_opacity, 0.3);
  EXPECT_EQ(reading.manifest.questionnaire->no_repeats, std::vector<std::string>{"actor"});
  EXPECT_EQ(reading.manifest.questionnaire->analysis.max_failed_checks, 3);
  EXPECT_EQ(reading.manifest.questionnaire->repeated, 1);
}

TEST_F(ManifestReaderTest, RefusesAFormerNameBesideTheNewOne) {
  EXPECT_EQ(faults_after_head(asked + "apart: [actor], no_repeats: [actor]}\n"),
            "m.yaml:5:47: questionnaire.apart: now called no_repeats, which is given too; "
            "remove it\n");
}

TEST_F(ManifestReaderTest, ChecksValuesOfFormerNamesAndProposesTheNewOnes) {
  EXPECT_TRUE(
      faults_after_head(asked + "apart: [mood]}\n")
          .starts_with("m.yaml:5:55: questionnaire.no_repeats[0]: unknown factor \"mood\""));
  EXPECT_TRUE(faults_after_head(asked + "catch: {repeat: 9}}\n")
                  .starts_with("m.yaml:5:63: questionnaire.retest.repeat: there are 2"));
  EXPECT_EQ(faults_after_head("look: {figure: {trail: {faintes: 0.3}}}\nstimuli: [{id: a, "
                              "weights: {sad: 1}}]\n")
                .find("did you mean \"faintest\""),
            std::string::npos);
}

TEST_F(ManifestReaderTest, ReadsEveryKindOfValue) {
  const ManifestReading reading = parse(R"(mien: 1
study: all
seed: 7
examples:
  set: {folder: captures, include: "*w*.bvh", exclude: x*, cycle: whole, labels: {b: beta, a: alpha}}
  ratings: answers.csv
  raters: 20
look: {camera: side}
output: {size: [640, 360], fps: 25, cycles: 2, in_place: true, quality: draft, video: [], frames: exr, clips: [glb]}
interpolation: {rotations: direction-vectors, time_warp: linear, foot_lock: false}
stimuli:
  - {id: one, role: target, adjectives: {zeal: 0.5, age: 1}, output: {fps: 50}}
  - {id: two, weights: {b: 1, a: 2}, look: {camera: orbit}, interpolation: {foot_lock: true}}
  - {id: three, clip: walk.bvh}
  - {id: four, clip: {file: walk.bvh, frames: [3, 9]}}
sheets:
  - compare: {target: one, created: two, reference: a}
  - {id: own, compare: {target: one, created: three}}
)");
  EXPECT_EQ(told(reading.faults), "");
  const Manifest& manifest = reading.manifest;
  EXPECT_EQ(manifest.study, "all");
  EXPECT_EQ(manifest.seed, 7u);
  EXPECT_EQ(manifest.examples.folder, folder.path() / "captures");
  EXPECT_EQ(manifest.examples.include, "*w*.bvh");
  EXPECT_EQ(manifest.examples.exclude, "x*");
  EXPECT_EQ(manifest.examples.cycle, motion::CycleChoice::whole);
  const std::vector<std::pair<std::string, std::string>> labels = {{"b", "beta"}, {"a", "alpha"}};
  EXPECT_EQ(manifest.examples.given_labels, labels);
  EXPECT_EQ(manifest.ratings.source, Ratings::Source::file);
  EXPECT_EQ(manifest.ratings.file, folder.path() / "answers.csv");
  EXPECT_EQ(manifest.ratings.raters, 20);
  EXPECT_EQ(manifest.output.size, (std::array<int, 2>{640, 360}));
  EXPECT_TRUE(manifest.output.in_place);
  EXPECT_TRUE(manifest.output.video.empty());
  EXPECT_EQ(manifest.output.frames, FrameFormat::exr);
  EXPECT_EQ(manifest.output.clips, std::vector<std::string>{"glb"});
  EXPECT_EQ(manifest.interpolation.rotations, motion::RotationBlend::direction_vectors);
  ASSERT_EQ(manifest.stimuli.size(), 4u);
  EXPECT_EQ(manifest.stimuli[0].role, Role::target);
  EXPECT_EQ(manifest.stimuli[0].adjectives, (NamedValues{{"zeal", 0.5}, {"age", 1.0}}));
  EXPECT_EQ(manifest.stimuli[3].clip->frames, (std::array<int, 2>{3, 9}));
  EXPECT_EQ(manifest.sheets[0].id, "one_two");
  EXPECT_EQ(manifest.sheets[0].reference, "a");
  EXPECT_EQ(manifest.sheets[1].id, "own");
}

TEST_F(ManifestReaderTest, LaysAStimulussOwnValuesOverTheManifests) {
  const Manifest manifest = parse(head + R"(look: {camera: side}
output: {cycles: 5, fps: 25}
stimuli:
  - {id: a, clip: walk.bvh, output: {fps: 50, size: [320, 180]}}
  - {id: b, clip: walk.bvh, look: {camera: orbit}}
)")
                                .manifest;
  EXPECT_EQ(manifest.stimuli[0].output.fps, 50.0);
  EXPECT_EQ(manifest.stimuli[0].output.cycles, 5);
  EXPECT_EQ(manifest.stimuli[0].look.camera.view, "side");
  EXPECT_EQ(manifest.stimuli[1].output.fps, 25.0);
  EXPECT_EQ(manifest.stimuli[1].look.camera.view, "orbit");
  EXPECT_EQ(manifest.stimuli[1].look.figure, scenes::Figure());
}

TEST_F(ManifestReaderTest, ReadsEveryOptionOfInterpolation) {
  const Manifest manifest = parse(head + R"(seed: 9
interpolation: {method: knn, neighbours: 5, blends: 40, rotations: markley-mean}
stimuli:
  - {id: a, adjectives: {quickness: 1}}
  - {id: b, adjectives: {quickness: 1}, interpolation: {method: kriging, drift: constant, nugget: 0.2}}
  - {id: c, adjectives: {quickness: 1}, interpolation: {method: grid, cells: 4, nodes: knn}}
  - {id: d, adjectives: {quickness: 1}, interpolation: {method: pca, variance: 0.8}}
  - {id: e, adjectives: {quickness: 1}, interpolation: {method: incremental, step: 0.5}}
  - {id: f, adjectives: {quickness: 1}, interpolation: {method: inverse-distance, power: 3}}
)")
                                .manifest;
  using Method = motion::InterpolationMethod;
  ASSERT_EQ(manifest.stimuli.size(), 6u);
  const auto how = [&](int i) { return manifest.stimuli[static_cast<size_t>(i)].interpolation; };
  EXPECT_EQ(how(0), manifest.interpolation);
  EXPECT_EQ(how(0).weights.method, Method::nearest);
  EXPECT_EQ(how(0).weights.nearest.neighbours, 5);
  EXPECT_EQ(how(0).weights.nearest.trials, 40);
  EXPECT_EQ(how(0).weights.nearest.seed, 9u);
  EXPECT_EQ(how(0).rotations, motion::RotationBlend::markley_mean);
  EXPECT_EQ(how(1).weights.method, Method::kriging);
  EXPECT_FALSE(how(1).weights.kriging.linear_drift);
  EXPECT_EQ(how(1).weights.kriging.nugget, 0.2);
  EXPECT_EQ(how(1).rotations, motion::RotationBlend::markley_mean);
  EXPECT_EQ(how(2).weights.method, Method::grid);
  EXPECT_EQ(how(2).weights.grid_cells, 4);
  EXPECT_EQ(how(2).weights.grid_source, motion::GridSource::nearest);
  EXPECT_EQ(how(3).weights.method, Method::pca);
  EXPECT_EQ(how(3).weights.pca.variance_share, 0.8);
  EXPECT_EQ(how(4).weights.method, Method::incremental);
  EXPECT_EQ(how(4).weights.click_step, 0.5);
  EXPECT_EQ(how(5).weights.method, Method::inverse_distance);
  EXPECT_EQ(how(5).weights.power, 3.0);
}

TEST_F(ManifestReaderTest, ReadsKeytimesByHand) {
  const auto reading = [&](const std::string& keytimes) {
    return parse("mien: 1\nstudy: s\nexamples: {set: {folder: captures, keytimes: " + keytimes +
                 "}}\nstimuli: [{id: a, weights: {x: 1}}]\n");
  };
  const ManifestReading good = reading("{b: [0.5, 1, 2.25], a: [0, 3, 4]}");
  EXPECT_EQ(told(good.faults), "");
  const std::vector<std::pair<std::string, std::vector<double>>> keytimes = {
      {"b", {0.5, 1.0, 2.25}}, {"a", {0.0, 3.0, 4.0}}};
  EXPECT_EQ(good.manifest.examples.keytimes, keytimes);
  EXPECT_EQ(told(reading("{b: [0.5, 0.4], a: [0, 1, 2]}").faults),
            "m.yaml:3:50: examples.set.keytimes.b: keytimes are not in ascending order; write "
            "seconds in ascending order\n"
            "m.yaml:3:65: examples.set.keytimes.a: 3 keytimes where \"b\" has 2; give every motion "
            "the same number of keytimes\n");
}

TEST_F(ManifestReaderTest, BuiltInSetsBringTheirRatings) {
  EXPECT_EQ(parse(head).manifest.ratings.source, Ratings::Source::builtin);
  EXPECT_EQ(parse("examples: {set: {folder: captures}}\n").manifest.ratings.source,
            Ratings::Source::none);
}

TEST_F(ManifestReaderTest, ExpandsVariablesToTheTypeThatIsWanted) {
  const ManifestReading reading = parse(
      "mien: 1\nstudy: ${FPS}\noutput: {fps: \"${FPS}\", cycles: \"${CYCLES:-4}\"}\n"
      "stimuli:\n  - id: a\n    clip: ${NOWHERE:-walk}.bvh\n");
  EXPECT_EQ(told(reading.faults), "");
  EXPECT_EQ(reading.manifest.study, "50");
  EXPECT_EQ(reading.manifest.output.fps, 50.0);
  EXPECT_EQ(reading.manifest.output.cycles, 4);
  EXPECT_EQ(reading.manifest.stimuli[0].clip->file, folder.path() / "walk.bvh");
}

TEST_F(ManifestReaderTest, TakesAnchorsAndMergeKeys) {
  const ManifestReading reading = parse(head + R"(stimuli:
  - {id: a, clip: walk.bvh, look: &far {camera: side}}
  - {id: b, clip: walk.bvh, look: *far}
  - {id: c, clip: walk.bvh, look: {<<: *far, scene: studio}}
)");
  EXPECT_EQ(told(reading.faults), "");
  EXPECT_EQ(reading.manifest.stimuli[1].look.camera.view, "side");
  EXPECT_EQ(reading.manifest.stimuli[2].look.camera.view, "side");
}

struct Case {
  const char* text;    ///< after the head
  const char* faults;  ///< expected lines
};

void PrintTo(const Case& example, std::ostream* out) { *out << example.text; }

class ManifestFaults : public ManifestReaderTest, public testing::WithParamInterface<Case> {};

TEST_P(ManifestFaults, AreToldWithPlaceAndRemedy) {
  EXPECT_EQ(faults_after_head(GetParam().text), GetParam().faults);
}

INSTANTIATE_TEST_SUITE_P(
    Table, ManifestFaults,
    testing::Values(
        Case{"stimuli: []\n",
             "m.yaml:4:10: stimuli: has 0 elements but must have at least 1; for "
             "example [{adjectives: {quickness: 0.8, sad-happy: 0.7}, id: "
             "happy-quick}]\n"},
        Case{"sead: 7\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:1: sead: unknown key; did you mean \"seed\"?\n"},
        Case{"seed: -1\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:7: seed: -1 is out of range; use a whole number from 0 to "
             "9007199254740991\n"},
        Case{"seed: seven\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:7: seed: must be a whole number but is the text \"seven\"; for example 7\n"},
        Case{"output: {samples: 4}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:19: output.samples: applies to quality reference only; omit it, or set "
             "quality: reference\n"},
        Case{"output: {quality: reference, samples: 4}\n"
             "stimuli: [{id: a, clip: walk.bvh, output: {quality: draft, samples: 2}}]\n",
             "m.yaml:5:69: stimuli[0].output.samples: applies to quality reference only; omit it, "
             "or set quality: reference\n"},
        Case{"output: {quality: reference, samples: 4097}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:39: output.samples: 4097 is out of range; use a whole number from 1 to "
             "4096\n"},
        Case{"output: {size: [961, 540]}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:16: output.size: mp4 needs an even width and height; use 962 × 540, or no "
             "video\n"},
        Case{
            "output: {size: [8192, 8192]}\nstimuli: [{id: a, clip: walk.bvh}]\n",
            "m.yaml:4:16: output.size: too large for a video; use at most 35 million pixels, or no "
            "video\n"},
        Case{"output: {size: [961, 541], video: [gif, mkv]}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             ""},
        Case{"output: {fps: 60, video: [gif]}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:15: output.fps: gif plays at most 50 frames per second at the correct "
             "speed; use fewer, or another video format\n"},
        Case{"output: {size: [961, 541], video: []}\nstimuli: [{id: a, clip: walk.bvh}]\n", ""},
        Case{"output: {size: [961, 541], video: []}\n"
             "stimuli: [{id: a, clip: walk.bvh, output: {video: [mp4]}}]\n",
             "m.yaml:5:43: stimuli[0].output.size: mp4 needs an even width and height; use "
             "962 × 542, or no video\n"},
        Case{"stimuli: [{id: a, weights: {normal: 1}, modify: {method: hsu, neutral: normal, "
             "styled: sad, harmonics: 5}}]\n",
             "m.yaml:4:104: stimuli[0].modify.harmonics: only method: unuma has this key; omit "
             "it\n"},
        Case{"stimuli: [{id: a, weights: {normal: 1}, modify: {method: hsu, neutral: normal, "
             "styled: sad, tempo: 2}}]\n",
             "m.yaml:4:100: stimuli[0].modify.tempo: a step with a method has no other changes; "
             "make a list of two steps\n"},
        Case{"stimuli: [{id: a, weights: {normal: 1}, modify: {method: hsu, styled: sad}}]\n",
             "m.yaml:4:58: stimuli[0].modify.method: a style is the difference between two "
             "examples, but neutral is missing; add neutral: and styled:\n"},
        Case{"stimuli: [{id: a, weights: {normal: 1}, modify: {tempo: 2, styled: sad}}]\n",
             "m.yaml:4:68: stimuli[0].modify.styled: only a method has this key; omit it\n"},
        Case{"output: {crop: [900, 0, 80, 40]}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:16: output.crop: extends beyond the image of 960 × 540 pixels; write [from "
             "the left, from the top, width, height] in pixels before scaling\n"},
        Case{"output: {crop: [0, 0, 80, 9], video: []}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:16: output.crop: leaves an image of 80 × 9 pixels; leave at least 16 in "
             "each dimension\n"},
        Case{"output: {size: [640, 360], scale: 0.33}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:35: output.scale: mp4 needs an even width and height, but these are 211 × "
             "119; change size, scale or crop until they are even, or use no video\n"},
        Case{"output: {crop: [0, 0, 80, 40]}\nlook: {camera: {stereo: {}}}\n"
             "stimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:16: output.crop: a stereo pair cannot be cropped; omit crop or stereo\n"},
        Case{"look: {camera: {figure_px: 200, screen: {distance_cm: 60, width_cm: 50}}}\n"
             "stimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:28: look.camera.figure_px: the screen already determines the size of the "
             "figure; omit figure_px, or give only a view\n"},
        Case{"equalize: [size]\nstimuli: [{id: a, clip: walk.bvh, look: {camera: {position: [0, 1, "
             "5], target: [0, 1, 0]}}}]\n",
             "m.yaml:4:11: equalize: the camera of \"a\" already determines the size of its "
             "figure; omit size, or give that camera only a view\n"},
        Case{"look: {camera: {figure_px: 600}}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:28: look.camera.figure_px: the figure would be taller than the image of 540 "
             "pixels; use fewer pixels, or a larger size\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\noverlays: [{target: a, created: normal, look: "
             "{camera: side}, layout: side-by-side}]\n",
             "m.yaml:5:71: overlays[0].layout: figures side by side hide each other in a side "
             "view; choose camera: front, three-quarter or follow\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\noverlays: [{target: a, created: normal, look: "
             "{figure: point-light}}]\n",
             "m.yaml:5:56: overlays[0].look.figure: the point lights of several motions cannot be "
             "told apart; give it another look: {figure: stick}\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\noverlays: [{target: a, created: a}]\n",
             "m.yaml:5:33: overlays[0].created: this is the same motion as the target; name "
             "another one\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\noverlays: [{id: a, target: a, created: normal, "
             "layout: side-by-side, opacity: 0.5}]\n",
             "m.yaml:5:17: overlays[0].id: \"a\" is already the id of stimuli[0]; give each a "
             "different one\nm.yaml:5:70: overlays[0].opacity: only superimposed figures can be "
             "transparent; omit it, or use layout: superimposed\n"},
        Case{"output: {fps: .inf}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:15: output.fps: not a finite number; write a finite one\n"},
        Case{"interpolation: {foot_lock: yes}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:28: interpolation.foot_lock: must be true or false but is the text \"yes\"; "
             "write true or false\n"},
        Case{"interpolation: {method: krigging}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:25: interpolation.method: \"krigging\" is not one of reach, cardinal, knn, "
             "inverse-distance, grid, kriging, pca, incremental, direct; did you mean "
             "\"kriging\"?\n"},
        Case{"interpolation: {method: grid, nodes: knn, blends: 9, nugget: 0.1}\n"
             "stimuli: [{id: a, adjectives: {quickness: 1}, interpolation: {power: 3}}]\n",
             "m.yaml:4:62: interpolation.nugget: only kriging interpolation has this key; add "
             "method: kriging, or omit it\n"
             "m.yaml:5:70: stimuli[0].interpolation.power: only inverse-distance interpolation has "
             "this key; add method: inverse-distance, or omit it\n"},
        Case{"interpolation: {power: 3}\nstimuli:\n  - {id: a, adjectives: {quickness: 1}}\n"
             "  - {id: b, adjectives: {quickness: 1}, interpolation: {method: inverse-distance}}\n",
             ""},
        Case{"interpolation: {method: direct}\n"
             "stimuli: [{id: a, adjectives: {quickness: 1}}, {id: b, weights: {normal: 1}}]\n",
             "m.yaml:5:31: stimuli[0].adjectives: direct interpolation requires weights, not "
             "adjectives; give weights:, or another method\n"},
        Case{"interpolation: {method: grid}\nstimuli: [{id: a, adjectives: {a: 0, b: 0, c: 0, d: "
             "0, e: 0, f: 0, g: 0, h: 0, i: 0}}]\n",
             "m.yaml:5:31: stimuli[0].adjectives: a grid over 9 parameters has too many corners; "
             "name at most 8, or use another method\n"},
        Case{"look: {camera: sied}\nstimuli: [{id: a, clip: walk.bvh}]\n",
             "m.yaml:4:16: look.camera: \"sied\" is not one of front, side, three-quarter, follow, "
             "orbit; did you mean \"side\"?\n"},
        Case{"stimuli:\n  - {clip: walk.bvh}\n",
             "m.yaml:5:5: stimuli[0].id: missing; add it, for example id: target-1\n"},
        Case{"stimuli:\n  - {id: ../a, clip: walk.bvh}\n",
             "m.yaml:5:10: stimuli[0].id: \"../a\" must begin with a letter or digit and hold at "
             "most "
             "64 letters, digits, '.', '_' and '-', because files are named after it; for example "
             "target-1\n"},
        Case{"stimuli:\n  - {id: a, clip: walk.bvh}\n  - {id: a, clip: walk.bvh}\n",
             "m.yaml:6:10: stimuli[1].id: \"a\" is already the id of stimuli[0]; give each a "
             "different one\n"},
        Case{"stimuli:\n  - {id: a, clip: walk.bvh}\n  - {id: A, clip: walk.bvh}\n",
             "m.yaml:6:10: stimuli[1].id: \"A\" differs from \"a\" of stimuli[0] only in case, and "
             "so would their files; use another id\n"},
        Case{"stimuli:\n  - {id: Con.1, clip: walk.bvh}\n  - {id: a., clip: walk.bvh}\n",
             "m.yaml:5:10: stimuli[0].id: \"Con.1\" is reserved on Windows, and files are named "
             "after it; use another id\n"
             "m.yaml:6:10: stimuli[1].id: \"a.\" ends with a dot or a space, and files are named "
             "after it; use another id\n"},
        Case{"stimuli:\n  - {id: 7, clip: walk.bvh}\n",
             "m.yaml:5:10: stimuli[0].id: must be text but is 7; put it in quotes: \"7\"\n"},
        Case{"stimuli:\n  - {id: a}\n",
             "m.yaml:5:5: stimuli[0]: has none of adjectives, features, "
             "weights, clip, path, foil, people; give one of them\n"},
        Case{"stimuli:\n  - {id: a, adjectives: {quickness: 1}, weights: {normal: 1}}\n",
             "m.yaml:5:5: stimuli[0]: adjectives and weights exclude each other; keep one of "
             "them\n"},
        Case{"stimuli:\n  - {id: a, features: {duration: 1}, weights: {normal: 1}}\n",
             "m.yaml:5:5: stimuli[0]: features and weights exclude each other; keep one of "
             "them\n"},
        Case{"stimuli:\n  - {id: a, features: {duration: -0.5}}\n",
             "m.yaml:5:34: stimuli[0].features.duration: -0.5 is out of range; use a number from 0 "
             "to 1\n"},
        Case{"stimuli:\n  - {id: a, adjectives: {quickness: 1.5}}\n",
             "m.yaml:5:37: stimuli[0].adjectives.quickness: 1.5 is out of range; use a number from "
             "0 "
             "to 1\n"},
        Case{"stimuli:\n  - {id: a, weights: {normal: 0, sad: 0}}\n",
             "m.yaml:5:22: stimuli[0].weights: all weights are 0; give at least one example a "
             "weight\n"},
        Case{
            "stimuli:\n  - {id: a, clip: run.bvh}\n",
            "m.yaml:5:19: stimuli[0].clip: there is no file run.bvh; give a motion file: "
            "BVH (.bvh), Acclaim (.amc), FBX (.fbx), glTF (.gltf, .glb), VRM (.vrma, .vrm), MVNX "
            "(.mvnx), C3D (.c3d), TRC (.trc), NumPy (.npz, .npy), tables of points (.csv, .tsv) or "
            "keypoints (.json); paths are taken from the "
            "manifest's folder\n"},
        Case{"stimuli:\n  - {id: a, clip: notes.txt}\n",
             "m.yaml:5:19: stimuli[0].clip: \".txt\" is not a motion file format; use BVH (.bvh), "
             "Acclaim (.amc), FBX (.fbx), glTF (.gltf, .glb), VRM (.vrma, .vrm), MVNX (.mvnx), C3D "
             "(.c3d), TRC (.trc), NumPy (.npz, .npy), tables of points (.csv, .tsv) or keypoints "
             "(.json)\n"},
        Case{"stimuli:\n  - {id: a, clip: {file: walk.bvh, frames: [9, 3]}}\n",
             "m.yaml:5:44: stimuli[0].clip.frames: the first frame comes after the last; exchange "
             "the "
             "two\n"},
        Case{
            "stimuli:\n  - {id: a, clip: [walk.bvh]}\n",
            "m.yaml:5:19: stimuli[0].clip: must be text or a map of keys and values but is a list; "
            "for example captures/walk.bvh\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\nsheets:\n  - compare: {target: a, created: a}\n",
             "m.yaml:6:35: sheets[0].compare.created: this is the same motion as the target; name "
             "another one\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\nsheets:\n  - compare: {target: a}\n",
             "m.yaml:6:14: sheets[0].compare.created: missing; add it, for example created: "
             "guess-1\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\nsheets: [{stills: [a]}, {stills: [a]}]\n",
             "m.yaml:5:25: sheets[1].id: \"stills\" is already the id of sheets[0]; give each a "
             "different one\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}, {id: b, clip: walk.bvh}]\n"
             "sheets: [{gallery: [a, b], columns: 3}]\n",
             "m.yaml:5:28: sheets[0].columns: only sheets of stills have columns; remove it, or "
             "use stills\n"},
        Case{"stimuli: [{id: a, clip: walk.bvh}]\nsheets: [{stills: [a], columns: 13}]\n",
             "m.yaml:5:33: sheets[0].columns: 13 is out of range; use a whole number from 1 to "
             "12\n"},
        Case{"stimuli: [{id: \"${ID}\", clip: walk.bvh}]\n",
             "m.yaml:4:16: stimuli[0].id: the environment variable ID is not set; set it, or write "
             "${ID:-default}\n"}));

TEST_F(ManifestReaderTest, TellsWhatIsWrongWithExamples) {
  EXPECT_EQ(
      faults_in("mien: 1\nstudy: s\nexamples:\n  set: builtin:walks-11\n  ratings: no.csv\n"
                "  scales: no.yaml\nstimuli: [{id: a, weights: {x: 1}}]\n"),
      "m.yaml:4:8: examples.set: \"builtin:walks-11\" is not one of builtin:walks-10, "
      "builtin:walks-27, builtin:actors; did you mean \"builtin:walks-10\"?\n"
      "m.yaml:5:12: examples.ratings: there is no file no.csv; give 'builtin', 'simulated', "
      "'none' or a CSV file; paths are taken from the manifest's folder\n"
      "m.yaml:6:11: examples.scales: there is no file no.yaml; give 'builtin' or a YAML file; "
      "paths are taken from the manifest's folder\n");
  EXPECT_EQ(faults_in("mien: 1\nstudy: s\nexamples: {set: {folder: nowhere}, ratings: builtin}\n"
                      "stimuli: [{id: a, weights: {x: 1}}]\n"),
            "m.yaml:3:26: examples.set.folder: there is no folder nowhere; correct the path; it is "
            "relative to the manifest's folder\n"
            "m.yaml:3:45: examples.ratings: only built-in sets have built-in ratings; name a CSV "
            "file, or use simulated\n");
  EXPECT_EQ(faults_in("mien: 1\nstudy: s\nstimuli:\n  - {id: a, adjectives: {x: 1}}\n"
                      "  - {id: b, weights: {x: 1}}\n"),
            "m.yaml:4:25: stimuli[0].adjectives: adjectives need examples; add examples: {set: "
            "builtin:walks-10}\n"
            "m.yaml:5:22: stimuli[1].weights: weights need examples; add examples: {set: "
            "builtin:walks-10}\n");
  EXPECT_EQ(faults_in("mien: 1\nstudy: s\nexamples: {set: {folder: captures}}\n"
                      "stimuli: [{id: a, adjectives: {x: 1}}]\n"),
            "m.yaml:4:31: stimuli[0].adjectives: adjectives need ratings of the examples; add "
            "ratings: with a CSV file or 'simulated' to examples\n");
}

TEST_F(ManifestReaderTest, ListsManyFaultsAtOnceInReadingOrder) {
  EXPECT_EQ(
      faults_in("mien: 2\nstudy: my study\nstimuli:\n  - {id: a, clip: walk.bvh, look: x}\n"
                "  - walk.bvh\noutput: {fps: 0, frames: jpg}\n"),
      "m.yaml:1:7: mien: is version 2, which this version of mien does not know; use a newer "
      "version "
      "of mien, or write 1\n"
      "m.yaml:2:8: study: \"my study\" must begin with a letter or digit and hold at most 64 "
      "letters, digits, '.', '_' and '-'; for example quickstart\n"
      "m.yaml:4:35: stimuli[0].look: must be a map of keys and values but is the text \"x\"\n"
      "m.yaml:5:5: stimuli[1]: must be a map of keys and values but is the text \"walk.bvh\"\n"
      "m.yaml:6:15: output.fps: 0 is out of range; use a number from 1 to 240\n"
      "m.yaml:6:26: output.frames: \"jpg\" is not one of the choices; use one of none, png, "
      "png16, exr, layers\n");
}

TEST_F(ManifestReaderTest, TellsTextThatIsNoManifestAtAll) {
  EXPECT_EQ(faults_in(""), "m.yaml:1:1: the file is empty; write a document into it\n");
  EXPECT_EQ(faults_in("hello"),
            "m.yaml:1:1: must be a map of keys and values but is the text \"hello\"\n");
  EXPECT_EQ(faults_in("[1, 2]"), "m.yaml:1:1: must be a map of keys and values but is a list\n");
  EXPECT_EQ(faults_in("~"), "m.yaml:1:1: must be a map of keys and values but is empty\n");
}

TEST_F(ManifestReaderTest, TellsNamesThatNothingHas) {
  const ManifestReading reading = parse(head + R"(stimuli:
  - {id: target-1, adjectives: {quicknes: 0.5, sad-happy: 1}}
  - {id: b, weights: {norml: 1, proud: 1, xyzzy: 1}}
  - {id: c, features: {step-length: 1, sigma-hed-lr: 0}}
sheets:
  - compare: {target: target-2, created: proud, reference: b}
)");
  EXPECT_EQ(told(reading.faults), "");
  const Vocabulary vocabulary = {
      {"quickness", "sad-happy"}, {"step-length", "sigma-head-lr"}, {"normal", "proud"}};
  EXPECT_EQ(told(check_names(reading.manifest, vocabulary)),
            "m.yaml:5:33: stimuli[0].adjectives.quicknes: unknown parameter; did you mean "
            "\"quickness\"?\n"
            "m.yaml:6:23: stimuli[1].weights.norml: unknown example; did you mean \"normal\"?\n"
            "m.yaml:6:43: stimuli[1].weights.xyzzy: unknown example; use one of \"normal\", "
            "\"proud\"\n"
            "m.yaml:7:40: stimuli[2].features.sigma-hed-lr: unknown feature; did you mean "
            "\"sigma-head-lr\"?\n"
            "m.yaml:9:23: sheets[0].compare.target: \"target-2\" is neither a stimulus nor an "
            "example; did you mean \"target-1\"?\n");
}

TEST_F(ManifestReaderTest, TellsAMisspeltKeyOnce) {
  EXPECT_EQ(faults_after_head("stimuli: [{id: a, clip: walk.bvh}]\nsheets: [{galery: [a]}]\n"),
            "m.yaml:5:11: sheets[0].galery: unknown key; did you mean \"gallery\"?\n");
  EXPECT_EQ(faults_after_head("stimuli: [{idd: a, clip: walk.bvh}]\n"),
            "m.yaml:4:12: stimuli[0].idd: unknown key; did you mean \"id\"?\n");
}

/// What may be an example is no fault then, unless it is nearly a stimulus.
TEST_F(ManifestReaderTest, TellsNamesOfStimuliThoughTheExamplesAreAtFault) {
  const ManifestReading reading = check_manifest_text(
      "mien: 1\nstudy: s\nexamples: {set: none-here, ratings: none}\n"
      "stimuli:\n  - {id: bowed, clip: walk.bvh}\n  - {id: normal, clip: walk.bvh}\n"
      "overlays:\n  - {target: proud, created: boed}\n"
      "sheets:\n  - {id: s, stills: [head-dwn]}\n",
      folder.path() / "m.yaml", process_environment());
  std::vector<std::string> paths;
  for (const Fault& fault : reading.faults) paths.push_back(fault.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"examples.set", "overlays[0].created",
                                             "sheets[0].stills[0]"}));
}

TEST_F(ManifestReaderTest, TellsLabelsAndKeytimesOfFilesThatAreNotThere) {
  const ManifestReading reading = parse(
      "mien: 1\nstudy: s\nexamples:\n  set:\n    folder: captures\n"
      "    labels: {walk_sda: sad, walk_fast: fast}\n    keytimes: {walk_fst: [0, 1]}\n"
      "stimuli: [{id: a, weights: {sad: 1}}]\n");
  EXPECT_EQ(told(reading.faults), "");
  EXPECT_EQ(told(check_names(reading.manifest, {{}, {}, {"sad"}, {"walk_sad", "walk_fast"}})),
            "m.yaml:6:14: examples.set.labels.walk_sda: no example has a file of this name; did "
            "you mean \"walk_sad\"?\n"
            "m.yaml:7:16: examples.set.keytimes.walk_fst: no example has a file of this name; did "
            "you mean \"walk_fast\"?\n");
}

TEST_F(ManifestReaderTest, ReadsAndChecksSheetsOfStills) {
  const ManifestReading reading = parse(head + R"(stimuli:
  - {id: stick, weights: {normal: 1}}
  - {id: dots, weights: {normal: 1}}
sheets:
  - {id: looks, stills: [stick, dots, stick], columns: 2}
  - stills: [stik, normal]
)");
  EXPECT_EQ(told(reading.faults), "");
  ASSERT_EQ(reading.manifest.sheets.size(), 2u);
  const Sheet& looks = reading.manifest.sheets[0];
  EXPECT_EQ(looks.id, "looks");
  EXPECT_EQ(looks.stills, (std::vector<std::string>{"stick", "dots", "stick"}));
  EXPECT_EQ(looks.columns, 2);
  EXPECT_EQ(motions_on(looks), looks.stills);
  EXPECT_TRUE(pairs_on(looks).empty());
  EXPECT_EQ(reading.manifest.sheets[1].id, "stills");
  EXPECT_EQ(reading.manifest.sheets[1].columns, 6);
  EXPECT_EQ(
      told(check_names(reading.manifest, {{}, {}, {"normal"}})),
      "m.yaml:9:14: sheets[1].stills[0]: \"stik\" is not a stimulus; did you mean \"stick\"?\n"
      "m.yaml:9:20: sheets[1].stills[1]: \"normal\" is not a stimulus; use one of \"stick\", "
      "\"dots\"\n");
}

TEST_F(ManifestReaderTest, ChecksTheNamesInExpectations) {
  const ManifestReading reading = parse(
      "mien: 1\nstudy: s\nexamples:\n  set: builtin:walks-10\n"
      "  expect: [{parameter: quicknes, order: [slow, briks]}]\n"
      "stimuli: [{id: a, weights: {slow: 1}}]\n");
  EXPECT_EQ(told(reading.faults), "");
  ASSERT_EQ(reading.manifest.ratings.expected.size(), 1u);
  EXPECT_EQ(reading.manifest.ratings.expected[0].order,
            (std::vector<std::string>{"slow", "briks"}));
  EXPECT_EQ(told(check_names(reading.manifest, {{"quickness"}, {}, {"slow", "brisk"}})),
            "m.yaml:5:24: examples.expect[0].parameter: unknown parameter \"quicknes\"; did you "
            "mean \"quickness\"?\n"
            "m.yaml:5:48: examples.expect[0].order[1]: unknown example \"briks\"; did you mean "
            "\"brisk\"?\n");
}

TEST_F(ManifestReaderTest, RefusesExpectationsThatCompareAnExampleWithItself) {
  const ManifestReading reading = parse(
      "mien: 1\nstudy: s\nexamples:\n  set: builtin:walks-10\n"
      "  expect:\n"
      "    - {parameter: quickness, order: [sad, sad]}\n"
      "    - {parameter: quickness, order: [slow, sad, slow]}\n"
      "stimuli: [{id: a, weights: {slow: 1}}]\n");
  EXPECT_EQ(
      told(check_names(reading.manifest, {{"quickness"}, {}, {"slow", "sad"}})),
      "m.yaml:6:43: examples.expect[0].order[1]: \"sad\" is already in this order, as number "
      "1; name each example once\n"
      "m.yaml:7:49: examples.expect[1].order[2]: \"slow\" is already in this order, as number "
      "1; name each example once\n");
}

TEST_F(ManifestReaderTest, AFileThatCannotBeReadIsAFaultToo) {
  const auto environment = process_environment();
  EXPECT_EQ(told(read_manifest(folder.path() / "none.yaml", environment).faults),
            "none.yaml: there is no such file; name a manifest (YAML)\n");
  EXPECT_EQ(told(read_manifest(folder.path() / "captures", environment).faults),
            "captures: is a folder, not a file; name a manifest (YAML)\n");
}

TEST_F(ManifestReaderTest, FindsNoFaultInTheManifestsOfTheSourceTree) {
  const auto file = std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / "quickstart.yaml";
  EXPECT_EQ(told(read_manifest(file, process_environment()).faults), "");
}

}  // namespace
}  // namespace mien::pipeline
