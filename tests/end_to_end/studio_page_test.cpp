#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/study/server/raw_client.h"
#include "scenes/face_figure.h"

#include "end_to_end/browser.h"
#include "end_to_end/program.h"
#include "real_data.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using pipeline::body_in;
using pipeline::header_in;
using pipeline::reply_of;
using pipeline::status_in;

const fs::path pages = fs::path(MIEN_PROGRAM).parent_path() / "pages";

/// A copy of the quickstart in the studio.
class StudioAtWork : public testing::Test {
 protected:
  /// With the program at `mien`, until it tells its link. Fewer frames are sooner drawn.
  /// `more`: further stimuli.
  void open(const fs::path& mien, int fps = 30, const std::string& figure = "stick",
            const std::string& more = "") {
    std::string quickstart = text_of(fs::path(MIEN_SOURCE_DIR) / "manifests/quickstart.yaml");
    quickstart.replace(quickstart.find("[960, 540], fps: 30"), 19,
                       "[160, 90], fps: " + std::to_string(fps));
    quickstart.replace(quickstart.find("stick"), 5, figure);
    quickstart.insert(quickstart.find("\nsheets:"), more);
    manifest = folder.write("my.yaml", quickstart);
    const fs::path told = folder.path() / "link.json";
    studio.emplace(std::vector<std::string>{
        "sh", "-c", "exec \"$0\" studio \"$1\" --out \"$2\" --json > \"$3\"", mien.string(),
        manifest.string(), (folder.path() / "out").string(), told.string()});
    for (int tries = 0; tries < 600 && link.empty(); ++tries) {
      pause_for(0.1);
      const json said = fs::exists(told) ? json::parse(text_of(told), nullptr, false) : json();
      if (said.is_object()) link = said.at("link");
      if (!studio->is_running()) break;
    }
    ASSERT_FALSE(link.empty()) << studio->wait().errors;
    const std::size_t colon = link.rfind(':'), slash = link.find('/', colon);
    port = std::stoi(link.substr(colon + 1, slash - colon - 1));
    place = link.substr(slash);
  }

  std::string host() const { return "127.0.0.1:" + std::to_string(port); }

  std::string ask(const std::string& method, const std::string& target, const std::string& headers,
                  const std::string& body = "") const {
    std::string request = method + " " + target + " HTTP/1.1\r\nConnection: close\r\n" + headers;
    if (method == "POST") request += "Content-Length: " + std::to_string(body.size()) + "\r\n";
    return reply_of(port, request + "\r\n" + body);
  }

  const Scratch folder;
  fs::path manifest;
  std::optional<Running> studio;
  std::string link, place;
  int port = 0;
};

/// Pages that stand for those that Node.js builds.
fs::path mien_with_studio_page(const fs::path& folder) {
  fs::create_directories(folder / "pages/studio");
  std::ofstream(folder / "pages/studio/index.html")
      << "<!doctype html><meta name=\"mien-mode\" content=\"static\"><title>stand-in</title>";
  std::ofstream(folder / "pages/studio/studio.js") << "start();";
  for (const char* part : {"mien", "mien-study"}) {
    const fs::path built = fs::path(MIEN_PROGRAM).parent_path() / part;
    std::error_code other_disk;
    fs::create_hard_link(built, folder / part, other_disk);
    if (other_disk) fs::copy_file(built, folder / part);
  }
  return folder / "mien";
}

TEST_F(StudioAtWork, IsReachedByItsLinkAloneAndEndsWhenTold) {
  open(mien_with_studio_page(folder.path() / "bin"));
  const std::string here = "Host: " + host() + "\r\n";
  const std::string json_type = here + "Content-Type: application/json\r\n";
  const std::string page = ask("GET", place, here);
  EXPECT_EQ(status_in(page), 200);
  EXPECT_NE(header_in(page, "Content-Security-Policy").find("script-src 'self'"), page.npos);
  EXPECT_EQ(header_in(page, "X-Frame-Options"), "DENY");
  EXPECT_EQ(header_in(page, "Access-Control-Allow-Origin"), "");
  EXPECT_EQ(status_in(ask("GET", place + "studio.json", here)), 200);

  // Names of other machines that lead here, other sites, other links, other files.
  EXPECT_EQ(status_in(ask("GET", place, "Host: evil.example\r\n")), 421);
  EXPECT_EQ(status_in(ask("GET", place, "Host: evil.example:" + std::to_string(port) + "\r\n")),
            421);
  EXPECT_EQ(
      status_in(ask("POST", place + "save", json_type + "Origin: http://evil.example\r\n", "{}")),
      403);
  EXPECT_EQ(status_in(ask("POST", place + "save", here + "Content-Type: text/plain\r\n", "{}")),
            415);
  EXPECT_EQ(status_in(ask("OPTIONS", place + "save", here)), 405);
  EXPECT_EQ(status_in(ask("GET", "/", here)), 404);
  EXPECT_EQ(status_in(ask("GET", "/" + std::string(32, '0') + "/studio.json", here)), 404);
  for (const std::string target : {"../my.yaml", "%2e%2e/my.yaml", "..%2fmy.yaml", "/etc/passwd",
                                   "my.yaml", "jobs/../studio.json", "jobs/1/result/x"})
    EXPECT_EQ(status_in(ask("GET", place + target, here)), 404) << target;
  const std::string long_head = json_type + "Content-Length: 99999999\r\n";
  EXPECT_EQ(status_in(reply_of(port, "POST " + place + "save HTTP/1.1\r\n" + long_head + "\r\n")),
            413);
  std::string nested(100000, '[');
  EXPECT_EQ(status_in(ask("POST", place + "save", json_type, nested)), 400);
  EXPECT_EQ(status_in(ask("GET", place, here)), 200);

  studio->send(SIGINT);
  const Ended ended = studio->wait(20.0);
  EXPECT_EQ(ended.code, 0) << ended.errors;
}

TEST_F(StudioAtWork, WarnsOfFormerNames) {
  open(mien_with_studio_page(folder.path() / "bin"), 30, "{trail: {before: 1, faintest: 0.2}}");
  studio->send(SIGINT);
  const std::string errors = studio->wait(20.0).errors;
  const std::string warning =
      "warning: " + manifest.string() +
      ":11:51: look.figure.trail.faintest: now called min_opacity; rename it\n";
  EXPECT_TRUE(errors.starts_with(warning)) << errors;
  EXPECT_EQ(errors.find("warning: ", 1), std::string::npos) << errors;
}

TEST_F(StudioAtWork, RefusesABrokenManifest) {
  const fs::path mien = mien_with_studio_page(folder.path() / "bin");
  const fs::path broken = folder.write("broken.yaml", "mien: 1\nstudy: x\nstimuli: [{id: a}]\n");
  const Ended ended = run_program({mien.string(), "studio", broken.string(), "--json"}, 30.0);
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.errors.find("broken.yaml:3:"), std::string::npos) << ended.errors;
  const Ended missing = run_program({mien.string(), "studio", "none/such.yaml", "--json"}, 30.0);
  EXPECT_EQ(missing.code, 2);
}

std::string skip_reason() {
  if (chromium().empty()) return "no Chromium here: install it to test pages";
  if (run_program({"node", "--version"}).code != 0) return "no Node.js here";
  if (!fs::exists(pages / "work/node_modules/playwright-core"))
    return "no playwright-core in build/release/pages/work: ./mien test brings it";
  return "";
}

class StudioPage : public StudioAtWork {
 protected:
  /// What a scripted browser prints that does as tests/studio/`script` says.
  json played(const std::string& script, const std::vector<std::string>& more = {}) const {
    const std::string where = run_program({"sh", "-c", "command -v " + chromium()}).output;
    std::vector<std::string> line = {"env", "MIEN_CHROMIUM=" + where.substr(0, where.find('\n')),
                                     "node", (pages / "work/tests/studio" / script).string(), link};
    line.insert(line.end(), more.begin(), more.end());
    const Ended ended = run_program(line, 500.0);
    EXPECT_EQ(ended.code, 0) << ended.errors;
    return json::parse(ended.output, nullptr, false);
  }
};

TEST_F(StudioPage, ChangesTheQuickstartAndMakesIt) {
  if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  open(MIEN_PROGRAM, 10);
  const json seen = played("author.mjs", {manifest.string()});
  ASSERT_TRUE(seen.is_object());
  EXPECT_EQ(seen.at("wrong"), json::array());
  EXPECT_EQ(seen.at("stimuli"), json({"target-1", "guess-1", "mix-1"}));
  EXPECT_EQ(seen.at("undone"), "0.7");
  EXPECT_EQ(seen.at("redone"), "0.9");
  EXPECT_GE(seen.at("weights").get<int>(), 2);
  EXPECT_NE(seen.at("modified").get<std::string>().find("sad"), std::string::npos);

  // What was changed, and nothing else: comments stay.
  const std::string saved = seen.at("saved");
  EXPECT_NE(saved.find("# simulated ratings, marked as such in all output"), std::string::npos);
  EXPECT_NE(saved.find("quickness: 0.9, clearness: 0.6"), std::string::npos);
  EXPECT_NE(saved.find("head-flexion: 10"), std::string::npos);
  EXPECT_TRUE(seen.at("kept").get<bool>());
  const std::string over = seen.at("over");
  EXPECT_NE(over.find("# by another hand"), std::string::npos);
  EXPECT_NE(over.find("quickness: 0.8"), std::string::npos);

  EXPECT_EQ(seen.at("still"), 160);
  EXPECT_GT(seen.at("video").get<double>(), 1.0);
  EXPECT_TRUE(fs::exists(folder.path() / "out/quickstart.studio/videos/target-1.mp4"));
  studio->send(SIGTERM);
  studio->wait(20.0);

  // The rest of mien takes what was saved.
  const std::string file = manifest.string(), out = (folder.path() / "out").string();
  const Ended checked = run_mien({"check", file});
  EXPECT_EQ(checked.code, 0) << checked.errors;
  const Ended planned = run_mien({"plan", file, "--out", out});
  EXPECT_EQ(planned.code, 0) << planned.errors;
  const Ended made =
      run_mien({"run", file, "--out", out, "--only", "target-1", "--quality", "draft"});
  EXPECT_EQ(made.code, 0) << made.errors;

  // The distance that the page told is that of the written clips.
  run_mien({"run", file, "--out", out, "--only", "guess-1", "--quality", "draft"});
  const std::string clips = out + "/quickstart/clips/";
  const Ended compared =
      run_mien({"motion", "compare", clips + "guess-1.bvh", clips + "target-1.bvh", "--json"});
  EXPECT_NEAR(json::parse(compared.output).at("D").get<double>(), seen.at("D").get<double>(), 1e-9);
}

TEST_F(StudioPage, ChoosesFiguresCapturesAndOptionsThatTheManifestThenHas) {
  if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  fs::create_directory(folder.path() / "captures");
  for (const std::string name : {"normal", "happy", "proud", "tired", "sad"})
    run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights", name + "=1",
              "--cycles", "3", "-o", (folder.path() / "captures" / (name + ".bvh")).string()});
  const auto data = real_data();
  const bool has_robot = data && fs::exists(*data / "characters/cesium_man.gltf");
  if (has_robot) fs::copy_file(*data / "characters/cesium_man.gltf", folder.path() / "robot.gltf");
  open(MIEN_PROGRAM);
  const json seen = played("chooser.mjs", {manifest.string()});
  ASSERT_TRUE(seen.is_object());
  EXPECT_EQ(seen.at("wrong"), json::array());
  EXPECT_EQ(seen.at("stick"), 0);
  EXPECT_EQ(seen.at("mannequin"), seen.at("body_joints"));
  if (has_robot) {
    EXPECT_EQ(seen.at("character"), seen.at("characters_joints"));
    EXPECT_LT(seen.at("off").get<double>(), 1e-6);
  }
  EXPECT_EQ(seen.at("count"), 5);
  EXPECT_EQ(seen.at("chosen"), json({"happy", "normal", "proud", "sad"}));
  EXPECT_EQ(seen.at("folder_faults"), json::array());
  // Every key of a modification that has no field of its own, but for those of older methods.
  for (const char* key :
       {"gains", "signal", "acceleration_at", "limbs", "pose", "seed", "repair", "soft_limits",
        "step_width", "step_length", "sway", "arm_swing", "trunk_swing", "range", "gesture"})
    EXPECT_TRUE(std::ranges::count(seen.at("options"), json(key)) == 1) << key;
  EXPECT_EQ(seen.at("modify_faults"), json::array());
  EXPECT_EQ(seen.at("refusal"), json::array());
  const std::string saved = seen.at("saved");
  for (const char* text :
       {"folder: captures", "exclude: \"tired*\"", "ratings: simulated", "middle: 1.7",
        "0.5, 1, 1.4", "captures/proud.bvh", "frame: 4", "feet", "soft_limits: false"})
    EXPECT_NE(saved.find(text), saved.npos) << text << "\n" << saved;
  const Ended checked = run_mien({"check", manifest.string()});
  EXPECT_EQ(checked.code, 0) << checked.errors;
}

TEST_F(StudioPage, DrawsTheFingersOfAStickFigureAsFilmsDo) {
  if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  open(MIEN_PROGRAM, 30, "stick, hands: drawn");
  const json seen = played("onlooker.mjs", {"stick"});
  ASSERT_TRUE(seen.is_object());
  EXPECT_EQ(seen.at("wrong"), json::array());
  const json& hands = seen.at("hands");
  EXPECT_EQ(hands.at("fingers").size(), 30u);
  EXPECT_EQ(hands.at("fingers")[4], "LeftIndex2");
  EXPECT_EQ(hands.at("palms"), json({"LeftWrist", "RightWrist"}));
  EXPECT_EQ(hands.at("whole"), json::array());
  EXPECT_LT(hands.at("off").get<double>(), 1e-6);
  EXPECT_LT(hands.at("palm_off").get<double>(), 1e-9);
  // At rest fingers are straight along the x axis: the radii of scenes/figures/stick_figure.cpp.
  const json& radii = hands.at("radii");
  const double scale = radii.at("LeftMiddle1").get<double>() / 0.0108;
  EXPECT_NEAR(scale, 1.0, 0.05);
  EXPECT_NEAR(radii.at("LeftMiddle2").get<double>(), 0.0093 * scale, 1e-6);
  EXPECT_NEAR(radii.at("RightMiddle3").get<double>(), 0.0084 * scale, 1e-6);
  EXPECT_NEAR(radii.at("RightThumb1").get<double>(), 0.0125 * scale, 1e-6);
}

TEST_F(StudioPage, MovesTheFaceOfACharacterAsFilmsDo) {
  if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  std::ofstream(folder.path() / "face.glb", std::ios::binary) << face_figure_glb(FaceFormat::gltf);
  folder.write("talk.csv", "time,jawOpen,mouthSmileLeft\n0,0,1\n4,1,0.5\n");
  open(MIEN_PROGRAM, 30, "{character: face.glb}, face: {file: talk.csv}, hands: drawn");
  const json seen = played("onlooker.mjs", {""});
  ASSERT_TRUE(seen.is_object());
  EXPECT_EQ(seen.at("wrong"), json::array());
  const double cycle_s = seen.at("cycle_s");
  for (const auto& [moment, cycles] : {std::pair("quarter", 0.25), std::pair("half_later", 1.5)}) {
    const json& face = seen.at(moment);
    EXPECT_EQ(face.size(), face_targets.size());
    EXPECT_NEAR(face.at("jawOpen").get<double>(), cycles * cycle_s / 4.0, 1e-5) << moment;
    EXPECT_NEAR(face.at("mouthSmileLeft").get<double>(), 1.0 - cycles * cycle_s / 8.0, 1e-5);
    EXPECT_EQ(face.at("eyeBlinkLeft").get<double>(), 0.0);
  }
}

TEST_F(StudioPage, ShowsSeveralPeopleWhereTheyAreInTheFilm) {
  if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  std::ofstream(folder.path() / "face.glb", std::ios::binary) << face_figure_glb(FaceFormat::gltf);
  open(MIEN_PROGRAM, 15, "stick, hands: drawn", R"(
  - id: greet
    output: {cycles: 1}
    people:
      - {weights: {sad: 1}, place: {x: -0.6, turn: 90}, look: {figure: mannequin}}
      - {weights: {tired: 1}, place: {x: 0.6, z: 0.2, turn: -90}}
      - weights: {normal: 1}
        place: {z: -1}
        look: {figure: {character: face.glb}, face: {jawOpen: 0.25}}
)");
  const json seen = played("crowd.mjs", {"greet"});
  ASSERT_TRUE(seen.is_object());
  EXPECT_EQ(seen.at("wrong"), json::array());
  const json& people = seen.at("begun").at("people");
  ASSERT_EQ(people.size(), 3u);
  EXPECT_EQ(people.at(0).at("places").size(), 51u);
  EXPECT_NEAR(people.at(0).at("places").at("Pelvis").at(0).get<double>(), -0.6, 1e-4);
  EXPECT_EQ(people.at(1).at("balls"), 51);
  EXPECT_NEAR(people.at(1).at("places").at("ball 1").at(0).get<double>(), 0.6, 1e-4);
  EXPECT_NEAR(people.at(1).at("places").at("ball 1").at(2).get<double>(), 0.2, 1e-4);
  EXPECT_NEAR(people.at(2).at("face").at("jawOpen").get<double>(), 0.25, 1e-6);
  // They walk as they face: the first to the right of the picture, the second to the left.
  const json& later = seen.at("middle").at("people");
  EXPECT_GT(later.at(0).at("places").at("Pelvis").at(0).get<double>(), -0.5);
  EXPECT_LT(later.at(1).at("places").at("ball 1").at(0).get<double>(), 0.5);
  EXPECT_GT(seen.at("begun").at("camera").at(2).get<double>(), 3.0);
  EXPECT_LT(std::abs(seen.at("begun").at("camera").at(0).get<double>()), 0.5);
  EXPECT_EQ(seen.at("canvases"), 1);
  EXPECT_EQ(seen.at("canvases_then"), 1);
  EXPECT_NE(seen.at("notes").dump().find("The feet in the timeline are those of a."),
            std::string::npos);
  EXPECT_NE(seen.at("motion").get<std::string>().find("several people"), std::string::npos);
  EXPECT_NE(seen.at("refusal").get<std::string>().find("\"greet\" has several people"),
            std::string::npos);
}

TEST_F(StudioPage, StopsFilmsAlsoFromAnotherPage) {
  if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  open(MIEN_PROGRAM);
  const json seen = played("stopper.mjs");
  ASSERT_TRUE(seen.is_object());
  EXPECT_EQ(seen.at("wrong"), json::array());
  EXPECT_NE(seen.at("going").get<std::string>().find("video of target-1: "), std::string::npos);
  EXPECT_TRUE(seen.at("bar_is_gone").get<bool>());
  EXPECT_EQ(seen.at("result"), 0);
  EXPECT_NE(seen.at("found").get<std::string>().find("video of target-1"), std::string::npos);
  // What was stopped is not there as if it were whole.
  EXPECT_FALSE(fs::exists(folder.path() / "out/quickstart.studio/videos/target-1.mp4"));
  const bool has_walker = fs::exists(pages / "live_core/live_core.wasm");
  EXPECT_EQ(seen.at("walker"), has_walker ? "Walker" : "Walker…");
  if (has_walker)
    EXPECT_EQ(seen.at("back"), "./");
  else
    EXPECT_NE(seen.at("why").get<std::string>().find("--walk"), std::string::npos);
}

}  // namespace
}  // namespace mien::test
