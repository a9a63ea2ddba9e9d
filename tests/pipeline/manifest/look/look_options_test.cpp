#include "pipeline/manifest/look/look_options.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/look_checks.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/temporary_folder.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/skinned_gltf.h"

namespace mien::pipeline {
namespace {

/// The look of options without former names.
Look look_of(const LookOptions& options) {
  std::vector<Fault> warnings;
  const Look look = pipeline::look_of(options, warnings);
  EXPECT_TRUE(warnings.empty());
  return look;
}

std::string faults_of_options(const LookOptions& options) {
  try {
    look_of(options);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(LookOptions, TakeNamesAndOptionsWithOrWithoutBraces) {
  const Look plain = look_of({});
  EXPECT_EQ(plain.figure, scenes::Figure(scenes::StickOptions{}));
  EXPECT_EQ(plain.camera, scenes::CameraSettings{});
  const Look look = look_of({.scene = "corridor",
                             .figure = "point-light: {scrambled: true, joints: [Head], seed: 3}",
                             .camera = "{position: [1, 2, 3], target: [0, 1, 0], fov: 30}"});
  EXPECT_EQ(scene_of(look), "corridor");
  const auto& dots = std::get<scenes::PointLightOptions>(look.figure);
  EXPECT_TRUE(dots.scrambled);
  EXPECT_EQ(dots.joints, std::vector<std::string>{"Head"});
  EXPECT_EQ(dots.joint_set, "");
  EXPECT_EQ(dots.seed, 3u);
  EXPECT_EQ(look.camera.position, motion::Vec3(1, 2, 3));
  EXPECT_EQ(look.camera.fov_degrees, 30.0);
}

TEST(LookOptions, HandsAreThoseOfTheMotionUnlessStated) {
  EXPECT_EQ(look_of({}).hands, scenes::Hands::automatic);
  EXPECT_EQ(look_of({.hands = "drawn"}).hands, scenes::Hands::drawn);
  EXPECT_EQ(look_of({.hands = "hidden"}).hands, scenes::Hands::hidden);
  EXPECT_NE(faults_of_options({.hands = "gloved"}).find("--hands"), std::string::npos);
}

TEST(LookOptions, HiddenHandsHaveNoDotsOnFingers) {
  for (const char* dots :
       {"point-light: {joints: hands}", "point-light: {joints: [LeftThumbTip]}"}) {
    EXPECT_EQ(faults_of_options({.figure = dots}), "");
    EXPECT_EQ(faults_of_options({.figure = dots, .hands = "hidden"}),
              "--figure.point-light.joints: hidden hands have no fingers for dots; omit hands: "
              "hidden, or the fingers");
  }
}

TEST(LookOptions, FormerNamesAreUnderstoodWithAWarning) {
  std::vector<Fault> warnings;
  const Look look = pipeline::look_of({.figure = "trail: {faintest: 0.3}"}, warnings);
  EXPECT_EQ(std::get<scenes::TrailOptions>(look.figure).min_opacity, 0.3);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(to_string(warnings[0]), "--figure.trail.faintest: now called min_opacity; rename it");
}

TEST(LookOptions, PointLightsStandInTheVoidBeforeTheirOwnBackground) {
  EXPECT_EQ(scene_of(look_of({})), "studio");
  const Look dark = look_of({.figure = "point-light"});
  EXPECT_EQ(scene_of(dark), "void");
  EXPECT_EQ(staged_set(dark).sky.backdrop_zenith[1], 0.0f);
  const Look light = look_of({.figure = "point-light: {polarity: dark-on-light}"});
  EXPECT_EQ(staged_set(light).sky.backdrop_horizon[1], 1.0f);
  const Look own =
      look_of({.scene = "set: void, background: \"#405060\"", .figure = "point-light"});
  EXPECT_EQ(staged_set(own).sky.backdrop_zenith[0], scenes::colour_from_hex("#405060")[0]);
}

TEST(LookOptions, TakeMarkersByPatternsAndPairs) {
  EXPECT_EQ(look_of({.figure = "markers"}).figure, scenes::Figure(scenes::MarkersOptions{}));
  EXPECT_EQ(look_of({.figure = "markers: {}"}).figure, scenes::Figure(scenes::MarkersOptions{}));
  const Look look =
      look_of({.figure = "markers: {size_mm: 14, pairs: [[LASI, RASI], [LKNE, LANK]], "
                         "show: [\"L*\", RASI], gaps: fill, mask: 20, seed: 3}"});
  EXPECT_EQ(scene_of(look), "void");
  const auto& markers = std::get<scenes::MarkersOptions>(look.figure);
  EXPECT_EQ(markers.show, (std::vector<std::string>{"L*", "RASI"}));
  ASSERT_EQ(markers.pairs.size(), 2u);
  EXPECT_EQ(markers.pairs[1], (std::array<std::string, 2>{"LKNE", "LANK"}));
  EXPECT_TRUE(markers.fills_gaps);
  EXPECT_DOUBLE_EQ(markers.dots.size_m.value(), 0.014);
  EXPECT_EQ(markers.dots.mask, 20);
  EXPECT_EQ(markers.dots.seed, 3u);
}

TEST(LookOptions, OfMarkersAreWrittenAsTheyWereRead) {
  for (const char* size : {"14", "14.1", "9.5", "1.23", "333.3"}) {
    const std::string text =
        std::string("{markers: {pairs: [[LASI, RASI]], gaps: fill, size_mm: ") + size + "}}";
    const Look look = look_of({.figure = text});
    const OrderedJson figure = written(look, WritingOptions{})["figure"];
    EXPECT_EQ(figure["markers"]["size_mm"].dump(),
              OrderedJson::parse(size).get<double>() == 14.0 ? "14.0" : size);
    EXPECT_EQ(look_of({.figure = figure.dump()}).figure, look.figure);
  }
}

TEST(LookOptions, OfMarkersThatContradictEachOtherAreRefused) {
  EXPECT_EQ(faults_of_options({.figure = "markers: {scrambled: true, pairs: [[a, b]]}"}),
            "--figure.markers.pairs: scrambled markers are not on a body, as pairs require; omit "
            "scrambled or pairs");
  EXPECT_EQ(faults_of_options({.figure = "markers: {scrambled: true, lifetime: 4}"}),
            "--figure.markers.lifetime: scrambled dots are not on limbs, so they cannot have a "
            "limited lifetime; omit scrambled or lifetime");
  EXPECT_EQ(faults_of_options({.figure = "markers: {lifetime: 4}"}),
            "--figure.markers.lifetime: markers without pairs are not on limbs, as a limited "
            "lifetime requires; name the two markers of each limb in pairs, or omit lifetime");
  EXPECT_EQ(faults_of_options({.figure = "markers: {pairs: [[a, b], [c, c]]}"}),
            "--figure.markers.pairs[1]: both ends are the same marker; name two markers");
  EXPECT_NE(faults_of_options({.figure = "markers: {pairs: [[a]]}"}).find("--figure.markers.pairs"),
            std::string::npos);
  EXPECT_NE(faults_of_options({.figure = "markers: {gaps: fil}"}).find("did you mean \"fill\"?"),
            std::string::npos);
  EXPECT_NE(faults_of_options({.figure = "markers: {joints: all}"}).find("unknown key"),
            std::string::npos);
}

TEST(LookOptions, AreRefusedInTheWordsOfTheOptions) {
  EXPECT_EQ(faults_of_options({.scene = "stduio"}),
            "--scene: \"stduio\" is neither a set nor a file; did you mean \"studio\"?");
  EXPECT_EQ(faults_of_options({.camera = "sied"}),
            "--camera: \"sied\" is not one of front, side, three-quarter, follow, orbit; did you "
            "mean \"side\"?");
  EXPECT_EQ(faults_of_options({.figure = "point-light: {scrambeld: true}"}),
            "--figure.point-light.scrambeld: unknown key; did you mean \"scrambled\"?");
  EXPECT_EQ(faults_of_options({.figure = "point-light: {scrambled: true, lifetime: 4}"}),
            "--figure.point-light.lifetime: scrambled dots are not on limbs, so they cannot have a "
            "limited lifetime; omit scrambled or lifetime");
  EXPECT_EQ(faults_of_options({.camera = "position: [1, 2, 3]"}),
            "--camera: target is missing; give position and target");
  EXPECT_EQ(faults_of_options({.figure = "trail: {poses: 24, before: 12}"}),
            "--figure.trail: too many poses for one image; use at most 29 in addition to the "
            "present one");
}

TEST(LookOptions, TakeACharacterByItsFileAloneOrAsAManifestHasIt) {
  const std::string none =
      ": there is no file nobody.glb; give a skinned character (.gltf, .glb, .vrm, .fbx)";
  for (const char* figure : {"character: nobody.glb", "{character: nobody.glb}"})
    EXPECT_EQ(faults_of_options({.figure = figure}), "--figure.character" + none) << figure;
  EXPECT_EQ(faults_of_options({.figure = "nobody.glb"}), "--figure" + none);
}

TEST(LookOptions, TakeAFaceAsAWordWeightsOrAFile) {
  const test::TemporaryFolder folder;
  test::SkinnedGltf character = test::skinned_gltf(motion::standard_body(), {});
  test::add_face(character);
  const std::string figure = (folder.path() / "face.gltf").string();
  write_file(figure, character.text());
  const std::string table = (folder.path() / "a face.csv").string();
  write_file(table, "time,one\n0,0\n");
  const auto face_of = [&](const std::string& face) {
    return look_of({.figure = figure, .face = face}).face;
  };
  EXPECT_TRUE(face_of("").is_neutral());
  EXPECT_TRUE(face_of("hidden").is_hidden);
  EXPECT_EQ(face_of("one: 0.5").weights, (scenes::FaceWeights{{"one", 0.5}}));
  EXPECT_EQ(face_of(table).file, table);
  EXPECT_EQ(face_of("{file: '" + table + "', start: 2}").start_s, 2.0);
  const auto faults_of_face = [&](const std::string& face) {
    return faults_of_options({.figure = figure, .face = face});
  };
  EXPECT_EQ(faults_of_face("smile"),
            "--face: \"smile\" is neither neutral, hidden, weights nor a file; write weights as "
            "\"smile: 0.5\", or give a file of weights with its ending (.csv, .npz, .glb)");
  EXPECT_EQ(faults_of_face("hiden"),
            "--face: \"hiden\" is neither neutral nor hidden; did you mean \"hidden\"?");
  EXPECT_EQ(faults_of_face("one:0.5"),
            "--face: \"one:0.5\" is neither neutral, hidden, weights nor a file; write weights as "
            "\"one: 0.5\", or give a file of weights with its ending (.csv, .npz, .glb)");
  EXPECT_EQ(faults_of_face("smile.csv"),
            "--face: there is no file smile.csv; give a table of weights (.csv, .tsv), a glTF "
            "file, or an .npz file of SMPL-X");
  const std::string motion = (folder.path() / "walk.bvh").string();
  write_file(motion, "HIERARCHY\n");
  EXPECT_EQ(faults_of_face(motion), "--face: " + motion +
                                        " is no file of weights of a face; give a table of weights "
                                        "(.csv, .tsv), a glTF file, or an .npz file of SMPL-X");
  EXPECT_EQ(faults_of_options({.face = "hidden"}),
            "--face: the figure \"stick\" has no face; use the figure of a character's file, or "
            "face: neutral");
}

TEST(LookOptions, FaultsOfASetAreToldAtTheirPlaceInItsFile) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "my.set.yaml").string();
  write_file(file, "background: \"#808080\"\nsky: 3\n");
  EXPECT_EQ(faults_of_options({.scene = file}),
            file +
                ":2:6: sky: must be a map of keys and values but is 3; for example {below: "
                "#8b8b8a, horizon: #a2a3a4, zenith: #b4b6b8}");
}

}  // namespace
}  // namespace mien::pipeline
