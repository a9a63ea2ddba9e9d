// Stimuli that participants turn, in Chromium (page/tests/questionnaire/turned.mjs).

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "scenes/face_figure.h"

#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char turned_text[] = R"(mien: 1
study: turned
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 72], fps: 15, cycles: 1, quality: draft, video: [mp4], frames: none, clips: [bvh, glb]}
look: {hands: drawn}
stimuli:
  - {id: stick, weights: {normal: 1}}
  - {id: doll, weights: {sad: 1}, look: {figure: mannequin}}
  - {id: twin, weights: {proud: 1}, look: {figure: mannequin}}
  - {id: talker, weights: {normal: 1}, look: {figure: {character: face.glb}, face: {file: talk.csv}}}
  - {id: covered, weights: {normal: 1}, look: {figure: {character: face.glb}, face: hidden}}
  - {id: dots, weights: {normal: 1}, look: {figure: point-light}}
  - {id: raised, weights: {sad: 1}, modify: {keys: [{at: 0.4 s, right-hand: [-0.15, 2.05, 0.1]}]}}
  - id: pair
    people:
      - {weights: {sad: 1}, place: {x: -0.6, turn: 90}, look: {figure: mannequin, colour: "#d55e00"}}
      - {weights: {tired: 1}, place: {x: 0.6, z: 0.2, turn: -90}}
questionnaire:
  participants: 2
  scales: [sad-happy]
  view: turn
  watch: free
)";

double distance(const json& a, const json& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum += std::pow(a.at(axis).get<double>() - b.at(axis).get<double>(), 2);
  return std::sqrt(sum);
}

void export_turned(const fs::path& folder) {
  std::ofstream(folder / "turned.yaml") << turned_text;
  std::ofstream(folder / "face.glb", std::ios::binary) << face_figure_glb(FaceFormat::gltf);
  std::ofstream(folder / "talk.csv") << "time,jawOpen,mouthSmileLeft\n0,0,1\n2,1,0\n";
  must_run(mien_with({"study", "export", (folder / "turned.yaml").string(), "--out",
                      (folder / "out").string(), "-o", (folder / "page").string()}));
}

class TurnedPage : public QuestionnairePage {
 protected:
  static void SetUpTestSuite() {
    if (!skip_reason().empty()) return;
    there = shared_set_up("turned page", export_turned);
  }

  static json experiment() { return json::parse(text_of(there / "page/experiment.json")); }

  /// The media of a stimulus.
  static json media_of(const std::string& stimulus) {
    const json all = experiment();
    for (const auto& [token, id] : all.at("stimuli").items())
      if (id == stimulus) return all.at("media").at(token);
    return {};
  }

  static json seen_from(const std::vector<std::string>& more = {}) {
    std::vector<std::string> script = {(page_tests() / "turned.mjs").string(),
                                       (there / "page").string()};
    script.insert(script.end(), more.begin(), more.end());
    return output_of(script);
  }

  /// What both a page of files and a served one show.
  static void expect_figures(const json& seen) {
    EXPECT_EQ(seen.at("troubles"), json::array());
    const json& stimuli = seen.at("stimuli");
    ASSERT_EQ(stimuli.size(), 8u);
    expect_hands(stimuli.at("stick").at(0).at("people").at(0), stimuli.at("doll"));
    expect_faces(stimuli.at("talker"), stimuli.at("covered"));
    expect_pair(stimuli.at("pair"));
    for (const auto& [stimulus, camera] : seen.at("cameras").items()) {
      EXPECT_EQ(camera.at("home"), stimuli.at(stimulus).at(0).at("camera")) << stimulus;
      EXPECT_NE(camera.at("turned"), camera.at("home")) << stimulus;
    }
    expect_in_view(stimuli.at("raised"));
    expect_in_view(stimuli.at("stick"));
    EXPECT_EQ(stimuli.at("dots").at(0).at("people").at(0).at("surfaces"), 0);
  }

  static void expect_hands(const json& stick, const json& doll) {
    // 19 joints without wrists, 2 palms and 30 joints of fingers.
    EXPECT_EQ(stick.at("surfaces"), 0);
    EXPECT_EQ(stick.at("balls"), 51);
    // Neutral slate, its light left and its dark right.
    std::map<std::string, int> colours;
    for (const json& colour : stick.at("colours")) ++colours[colour.get<std::string>()];
    EXPECT_EQ(colours.at("7a8696"), 5);
    EXPECT_EQ(colours.size(), 3u);
    EXPECT_EQ(stick.at("colours").at(5), "b1b6be") << "the left clavicle";
    EXPECT_EQ(stick.at("colours").at(8), "58616d") << "the right one";
    const json& places = doll.at(0).at("people").at(0).at("places");
    EXPECT_EQ(places.size(), 51u);
    const double length = distance(places.at("LeftWrist"), places.at("LeftMiddle3"));
    EXPECT_GT(length, 0.12);
    EXPECT_LT(length, 0.17);
    const json& later = doll.at(1).at("people").at(0).at("places");
    EXPECT_GT(distance(places.at("Pelvis"), later.at("Pelvis")), 0.1);
    EXPECT_NEAR(distance(later.at("LeftWrist"), later.at("LeftMiddle3")), length, 1e-3);
  }

  /// Nothing is cut off by the upper edge of the picture, whose field of view is 35° high; the
  /// camera looks at a height of 0.9 m, from 0.12 rad above.
  static void expect_in_view(const json& moments) {
    double highest = 0.0;
    for (const json& moment : moments)
      for (const auto& [joint, place] : moment.at("people").at(0).at("places").items())
        highest = std::max(highest, place.at(1).get<double>());
    const double away = (moments.at(0).at("camera").at(1).get<double>() - 0.9) / std::sin(0.12);
    EXPECT_GE(away, 3.69);
    EXPECT_LT(highest + 0.05, 0.9 + std::tan(17.5 * std::numbers::pi / 180.0) * away);
  }

  static void expect_faces(const json& talker, const json& covered) {
    const json& begun = talker.at(0).at("people").at(0).at("face");
    const json& later = talker.at(1).at("people").at(0).at("face");
    EXPECT_EQ(begun.size(), face_targets.size());
    EXPECT_NEAR(begun.at("jawOpen").get<double>(), 0.0, 1e-6);
    EXPECT_NEAR(begun.at("mouthSmileLeft").get<double>(), 1.0, 1e-6);
    EXPECT_NEAR(later.at("jawOpen").get<double>(), 0.2, 1e-5);
    EXPECT_NEAR(later.at("mouthSmileLeft").get<double>(), 0.8, 1e-5);
    const json& hidden = covered.at(1).at("people").at(0);
    EXPECT_EQ(hidden.at("face"), json::object());
    EXPECT_GT(hidden.at("surfaces").get<int>(), 0);
  }

  /// The first person is at the left of the front camera, the second at the right, face to face.
  static void expect_pair(const json& pair) {
    const json& people = pair.at(0).at("people");
    ASSERT_EQ(people.size(), 2u);
    const json& first = people.at(0).at("places");
    const json& pelvis = first.at("Pelvis");
    EXPECT_NEAR(pelvis.at(0).get<double>(), -0.6, 1e-4);
    EXPECT_NEAR(pelvis.at(2).get<double>(), 0.0, 1e-4);
    EXPECT_LT(first.at("LeftShoulder").at(2).get<double>(),
              first.at("RightShoulder").at(2).get<double>() - 0.2);
    const json& second = people.at(1);
    EXPECT_EQ(second.at("balls"), 51);
    EXPECT_EQ(second.at("colours").at(0), "e69f00");
    EXPECT_NEAR(second.at("places").at("ball 1").at(0).get<double>(), 0.6, 1e-4);
    EXPECT_NEAR(second.at("places").at("ball 1").at(2).get<double>(), 0.2, 1e-4);
    const json& camera = pair.at(0).at("camera");
    EXPECT_GT(camera.at(2).get<double>(), 3.0);
    EXPECT_LT(std::abs(camera.at(0).get<double>()), 0.5);
    EXPECT_EQ(camera, pair.at(1).at("camera"));
  }

  inline static fs::path there;
};

TEST_F(TurnedPage, ShowsTheFiguresOfTheFilms) { expect_figures(seen_from()); }

TEST_F(TurnedPage, HasEachFigureOnce) {
  const json doll = media_of("doll").at("figures"), twin = media_of("twin").at("figures");
  EXPECT_EQ(doll, twin);
  ASSERT_EQ(doll.size(), 1u);
  EXPECT_FALSE(media_of("stick").contains("figures"));
  EXPECT_NE(media_of("talker").at("figures"), media_of("covered").at("figures"));
  EXPECT_NE(media_of("pair").at("figures"), doll) << "another colour";
  const json all = experiment();
  EXPECT_EQ(all.at("stimuli").size(), 8u);
  EXPECT_EQ(all.at("media").size(), 8u + 4u);
  const std::string archive = text_of(there / "page/turned.jzip");
  for (const auto& [token, media] : all.at("media").items()) {
    const std::string file = media.at("file");
    EXPECT_TRUE(fs::exists(there / "page" / file)) << file;
    EXPECT_TRUE(fs::exists(there / "page/media" / (token + ".js"))) << token;
    EXPECT_NE(archive.find("turned/" + file), std::string::npos) << file;
  }
}

TEST_F(TurnedPage, IsServedWithItsFigures) {
  const Scratch own;
  fs::copy(there, own.path(), fs::copy_options::recursive);
  const fs::path links = own.path() / "kept-links.csv";
  Running server({MIEN_PROGRAM, "study", "serve", (own.path() / "turned.yaml").string(), "--out",
                  (own.path() / "out").string(), "--port", "0", "--json", "--store",
                  (own.path() / "kept.db").string()});
  std::string link;
  for (int tries = 0; tries < 600 && link.empty() && server.is_running(); ++tries) {
    pause_for(0.1);
    std::ifstream lines(links);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("p001,")) link = line.substr(line.find("http://"));
  }
  ASSERT_FALSE(link.empty());
  expect_figures(seen_from({link}));
  server.send(SIGINT);
  EXPECT_EQ(server.wait(20.0).code, 0);
}

}  // namespace
}  // namespace mien::test
