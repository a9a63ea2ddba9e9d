// `face:` in manifests: how it is read and written, its faults, and the keys of films.

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "motion/skeleton/body.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/temporary_folder.h"
#include "scenes/face_figure.h"
#include "scenes/skinned_gltf.h"

namespace mien::pipeline {
namespace {

using mien::test::SkinnedGltf;
using mien::test::TemporaryFolder;

/// A folder with a character that has a face, one that has none, and tables of weights.
class FaceManifests : public testing::Test {
 protected:
  FaceManifests() {
    SkinnedGltf figure = mien::test::skinned_gltf(motion::standard_body(), {});
    std::ofstream(folder_.path() / "stone.gltf") << figure.text();
    mien::test::add_face(figure);
    std::ofstream(folder_.path() / "face.gltf") << figure.text();
    write("rise.csv", "time,one\n0,0\n1,1\n");
    write("high.csv", "time,one\n0,0\n1,1.5\n");
    write("tongue.csv", "time,tongueOut\n0,0\n");
    write("frames.csv", "frame,one\n0,0\n");
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }

  ManifestReading read(const std::string& look, const std::string& stimulus = "") {
    const std::string text = "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nlook: {" +
                             look + "}\nstimuli: [{id: a, weights: {normal: 1}" + stimulus + "}]\n";
    return parse_manifest(text, folder_.path() / "m.yaml",
                          [](const std::string&) { return std::nullopt; });
  }

  std::string faults(const std::string& look, const std::string& stimulus = "") {
    std::string told;
    for (const Fault& fault : read(look, stimulus).faults) told += to_string(fault) + "\n";
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at; (at = told.find(folder)) != std::string::npos;)
      told.erase(at, folder.size());
    return told;
  }

  TemporaryFolder folder_;
};

TEST_F(FaceManifests, AreReadAndWritten) {
  const auto face_of = [&](const std::string& face) {
    const ManifestReading reading = read("figure: {character: face.gltf}, face: " + face);
    EXPECT_TRUE(reading.faults.empty()) << face << ": " << to_string(reading.faults.front());
    return reading.manifest.stimuli.front().look.face;
  };
  EXPECT_TRUE(face_of("neutral").is_neutral());
  EXPECT_TRUE(face_of("hidden").is_hidden);
  EXPECT_EQ(face_of("{one: 0.25, other: 1}").weights,
            (scenes::FaceWeights{{"one", 0.25}, {"other", 1.0}}));
  const scenes::Face table = face_of("{file: frames.csv, fps: 25, start: -0.5}");
  EXPECT_EQ(table.file, folder_.path() / "frames.csv");
  EXPECT_EQ(table.frames_per_second, 25.0);
  EXPECT_EQ(table.start_s, -0.5);
  EXPECT_EQ(face_of("{file: face.gltf, take: Fall}").take, "Fall");
  const WritingOptions how{.folder = folder_.path()};
  EXPECT_EQ(FaceForm::write(table, how).dump(), R"({"file":"frames.csv","start":-0.5,"fps":25.0})");
  EXPECT_EQ(FaceForm::write(face_of("hidden"), how).dump(), R"("hidden")");
  EXPECT_TRUE(FaceForm::write(face_of("neutral"), how).is_null());
}

TEST_F(FaceManifests, OfAStimulusReplaceThatOfTheManifest) {
  const ManifestReading reading =
      read("figure: {character: face.gltf}, face: {one: 0.5}", ", look: {face: {other: 1}}");
  EXPECT_EQ(reading.manifest.stimuli.front().look.face.weights,
            (scenes::FaceWeights{{"other", 1.0}}));
  EXPECT_TRUE(read("figure: {character: face.gltf}, face: {one: 0.5}", ", look: {face: neutral}")
                  .manifest.stimuli.front()
                  .look.face.is_neutral());
}

TEST_F(FaceManifests, HaveFaultsWithPlaceAndRemedy) {
  const std::string figure = "figure: {character: face.gltf}, ";
  EXPECT_EQ(
      faults(figure + "face: {on: 0.5}"),
      "m.yaml:4:47: look.face.on: the character's face has no \"on\"; did you mean \"one\"?\n");
  EXPECT_EQ(faults("face: {one: 0.5}"),
            "m.yaml:4:14: look.face: the figure \"stick\" has no face; use the figure of a "
            "character's file, or face: neutral\n");
  EXPECT_EQ(faults(figure + "face: hidden", ", look: {figure: mannequin}"),
            "m.yaml:5:56: stimuli[0].look.figure: the figure \"mannequin\" has no face; use the "
            "figure of a character's file, or face: neutral\n");
  EXPECT_EQ(faults("figure: {character: stone.gltf}, face: {one: 0.5}"),
            "m.yaml:4:47: look.face: the character has neither morph targets nor joints of jaw or "
            "eyes to move its face; export it with its morph targets, or omit face\n");
  EXPECT_EQ(faults("figure: {character: stone.gltf}, face: hidden"), "");
}

TEST_F(FaceManifests, HaveNoAnglesOfRecordingsForWeights) {
  std::ofstream(folder_.path() / "jointed.glb", std::ios::binary)
      << mien::test::face_figure_glb(mien::test::FaceFormat::joints);
  EXPECT_EQ(faults("figure: {character: jointed.glb}, face: {jawOpen: 0.5}"), "");
  EXPECT_NE(faults("figure: {character: jointed.glb}, face: {jaw_pose_x: 0.5}")
                .find("look.face.jaw_pose_x: the character's face has no \"jaw_pose_x\""),
            std::string::npos);
}

TEST_F(FaceManifests, ShareAFaceThatTheFiguresOfStimuliHave) {
  EXPECT_EQ(faults("face: hidden", ", look: {figure: {character: face.gltf}}"), "");
  EXPECT_NE(faults("face: hidden").find("has no face"), std::string::npos);
  EXPECT_NE(
      faults("face: hidden", ", look: {figure: {character: face.gltf}}}, {id: b, weights: {sad: 1}")
          .find("look.face: the figure \"stick\" has no face"),
      std::string::npos);
}

TEST_F(FaceManifests, HaveFaultsOfTheirFiles) {
  const std::string figure = "figure: {character: face.gltf}, ";
  EXPECT_EQ(faults(figure + "face: {file: none.csv}"),
            "m.yaml:4:53: look.face.file: there is no file none.csv; give a table of weights "
            "(.csv, .tsv), a glTF file, or an .npz file of SMPL-X; paths are taken from the "
            "manifest's folder\n");
  EXPECT_EQ(faults(figure + "face: {file: high.csv}"),
            "m.yaml:4:53: look.face.file: high.csv:3:3: one: the weight 1.5 is not from 0 to 1; "
            "divide percentages by 100\n");
  EXPECT_EQ(faults(figure + "face: {file: tongue.csv}"),
            "m.yaml:4:53: look.face.file: none of its names is one of the character's face, which "
            "has one, other; rename those of the file\n");
  EXPECT_EQ(faults(figure + "face: {file: frames.csv}"),
            "m.yaml:4:53: look.face.file: frames.csv:1:1: the table counts frames without stating "
            "their rate; state the frames per second (fps)\n");
  EXPECT_EQ(faults(figure + "face: {file: rise.csv, take: Rise}"),
            "m.yaml:4:69: look.face.take: only glTF files have takes; omit take\n");
  EXPECT_EQ(faults(figure + "face: {file: face.gltf, fps: 30}"),
            "m.yaml:4:69: look.face.fps: the times of a glTF file are in seconds; omit fps\n");
  EXPECT_EQ(
      faults(figure + "face: {file: face.gltf, take: Rize}"),
      "m.yaml:4:53: look.face.file: face.gltf: no animation of a face is called \"Rize\"; did "
      "you mean \"Rise\"?\n");
}

TEST_F(FaceManifests, RefuseWhatIsGivenTwice) {
  const std::string figure = "figure: {character: face.gltf}, ";
  EXPECT_EQ(
      faults(figure + "face: {one: 0.5, One: 0.2}"),
      "m.yaml:4:57: look.face.One: it has a weight already, as \"one\"; omit one of the two\n");
  write("sides.csv", "time,eyeBlink_L,eyeBlinkLeft\n0,0,1\n");
  SkinnedGltf figure_of_lids = mien::test::skinned_gltf(motion::standard_body(), {});
  mien::test::add_face(figure_of_lids);
  figure_of_lids.json["meshes"][0]["extras"]["targetNames"][0] = "eyeBlinkLeft";
  write("lids.gltf", figure_of_lids.text());
  EXPECT_EQ(faults("figure: {character: lids.gltf}, face: {file: sides.csv}"),
            "m.yaml:4:53: look.face.file: \"eyeBlink_L\" and \"eyeBlinkLeft\" are the same part of "
            "the character's face; keep one of them\n");
  EXPECT_EQ(faults(figure + "face: {file: rise.csv, fps: 30}"),
            "m.yaml:4:53: look.face.file: rise.csv:1:1: its times are in seconds, so that it has "
            "no rate of frames; omit fps\n");
  write("walk.bvh", "HIERARCHY\n");
  EXPECT_EQ(faults(figure + "face: {file: walk.bvh}"),
            "m.yaml:4:53: look.face.file: walk.bvh is no file of weights of a face; give a table "
            "of weights (.csv, .tsv), a glTF file, or an .npz file of SMPL-X\n");
}

/// A face that all have is refused for people without one, as for stimuli.
TEST_F(FaceManifests, AreRefusedForPeopleWithoutOne) {
  const std::string figure = "figure: {character: face.gltf}, face: hidden";
  const auto people = [](const std::string& look) {
    return "}, {id: b, people: [{weights: {sad: 1}, place: {x: 0}}, {weights: {sad: 1}, place: {x: "
           "1}, look: {" +
           look + "}}]";
  };
  EXPECT_EQ(faults(figure, people("face: {one: 1}")), "");
  EXPECT_EQ(faults(figure, people("figure: mannequin, face: neutral")), "");
  const std::string told = faults(figure, people("figure: mannequin"));
  EXPECT_NE(told.find("stimuli[1].people[1].look.figure: the figure \"mannequin\" has no face; use "
                      "the figure of a character's file, or face: neutral"),
            std::string::npos)
      << told;
}

TEST_F(FaceManifests, HaveWeightsFrom0To1) {
  const std::string figure = "figure: {character: face.gltf}, ";
  EXPECT_EQ(faults(figure + "face: {one: 1.5}"),
            "m.yaml:4:52: look.face.one: 1.5 is out of range; use a number from 0 to 1\n");
  const std::string word = faults(figure + "face: smiling");
  EXPECT_TRUE(word.starts_with("m.yaml:4:46: look.face: ")) << word;
  const std::string text = faults(figure + "face: {one: much}");
  EXPECT_TRUE(text.starts_with("m.yaml:4:52: look.face.one: must be a number")) << text;
  EXPECT_EQ(faults(figure + "face: {file: rise.csv, strat: 1}"),
            "m.yaml:4:63: look.face.strat: a file already gives the weights; did you mean "
            "\"start\"?\n");
  EXPECT_EQ(
      faults(figure + "face: {file: rise.csv, one: 1}"),
      "m.yaml:4:63: look.face.one: a file already gives the weights; omit it, or omit file\n");
  EXPECT_EQ(faults(figure + "face: {take: Rise}"),
            "m.yaml:4:46: look.face: take, start and fps are of a file of weights, which is "
            "missing; add file, or omit them\n");
}

TEST_F(FaceManifests, AreInTheKeysOfFilms) {
  const auto key = [&](const std::string& face) {
    const ManifestReading reading =
        read("figure: {character: face.gltf}" + (face.empty() ? "" : ", face: " + face));
    KeyBuilder builder;
    FileKeys files;
    add_film(builder, reading.manifest.stimuli.front(), files);
    return builder.key();
  };
  EXPECT_EQ(key(""), key("neutral"));
  EXPECT_NE(key("hidden"), key(""));
  EXPECT_NE(key("{one: 0.5}"), key("{one: 0.6}"));
  EXPECT_NE(key("{file: rise.csv}"), key("{file: rise.csv, start: 1}"));
  const Hash before = key("{file: rise.csv}");
  write("rise.csv", "time,one\n0,0\n2,1\n");
  EXPECT_NE(key("{file: rise.csv}"), before);
}

}  // namespace
}  // namespace mien::pipeline
