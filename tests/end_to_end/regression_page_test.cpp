#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/browser.h"
#include "end_to_end/program.h"
#include "shared_set_up.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char study_start[] = R"(mien: 1
study: pair
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 54], fps: 10, cycles: 1, quality: draft, video: [mp4], frames: none}
stimuli:
  - {id: same, weights: {normal: 1}}
)";
constexpr char stimuli_before[] =
    "  - {id: a, weights: {normal: 0.6, proud: 0.4}}\n  - {id: b, weights: {normal: 0.6, sad: "
    "0.4}}\n";
constexpr char stimuli_now[] =
    "  - {id: a, weights: {normal: 0.5, proud: 0.5}}\n  - {id: b, weights: {normal: 0.5, sad: "
    "0.5}}\n";

void make_report(const fs::path& folder) {
  const fs::path manifest = folder / "study.yaml";
  const std::string out = (folder / "out").string();
  std::ofstream(manifest) << study_start << stimuli_before;
  must_run(mien_with({"regress", "approve", manifest.string(), "--reason", "first", "--keep-videos",
                      "--out", out}));
  std::ofstream(manifest) << study_start << stimuli_now;
  const std::string report = (folder / "report").string();
  const Ended compared = run_mien({"regress", manifest.string(), "--out", out, "-o", report});
  if (compared.code != 1) throw std::runtime_error("no difference: " + compared.errors);
}

/// The report of a study of which two stimuli have changed, made once.
class RegressionPage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!chromium().empty() && fs::exists(script))
      folder = shared_set_up("regression_page", make_report) / "report";
  }

  void SetUp() override {
    if (chromium().empty()) GTEST_SKIP() << "no Chromium here: install it to test pages";
    if (!fs::exists(script)) GTEST_SKIP() << script << " is not built: ./mien test builds it";
  }

  /// What a script gives in the page, which finds shorthands in it. The page alone is opened:
  /// nothing lies beside it.
  static json seen(const std::string& body) {
    const Scratch alone;
    const fs::path page = alone.write("report.html", text_of(folder / "report.html"));
    return in_browser(page, R"(
      const opened = () => [...document.querySelectorAll("details.card[open]")].map(one => one.id).join();
      const card = () => document.querySelector("details.card[open]");
      const pressed = () => [...card().querySelectorAll("button[aria-pressed=true]")].map(one => one.textContent.split(" ")[0]).join();
      const frame = () => card().querySelector("output").textContent.split(" ")[1];
      const tag = () => card().querySelector(".tag.left").textContent;
    )" + body);
  }

  inline static const fs::path script =
      fs::path(MIEN_PROGRAM).parent_path() / "pages/regress/regress.js";
  inline static fs::path folder;
};

TEST_F(RegressionPage, OpensFromDiskWithoutANetwork) {
  const json page = seen(R"(
    return {stimulus: opened(), cards: document.querySelectorAll("details.card").length,
            fetched: performance.getEntriesByType("resource").map(one => one.name).filter(name => !/^(data|blob):/.test(name)),
            broken: [...document.images].filter(one => one.getAttribute("src") && one.complete && !one.naturalWidth).length,
            painted: [...document.querySelectorAll("canvas.space, canvas.chart")].map(one =>
              one.getContext("2d").getImageData(0, 0, one.width, one.height).data.some(value => value))};
  )");
  EXPECT_EQ(page, (json{{"stimulus", "stimulus-a"},
                        {"cards", 2},
                        {"fetched", json::array()},
                        {"broken", 0},
                        {"painted", {true, true}}}));
}

TEST_F(RegressionPage, IsWorkedByKeys) {
  const json page = seen(R"(
    const did = {};
    await press("j"); did.j = opened();
    await press("j"); did.last = opened();
    await press("k"); did.k = opened();
    did.focus = document.activeElement.className;
    for (const key of ["2", "3", "4", "1"]) { await press(key); did[key] = pressed(); }
    const worst = frame();
    await press("]"); did.nextKey = frame() !== worst;
    await press("["); did.back = frame() === worst;
    await press("ArrowLeft"); did.left = worst - frame();
    await press("ArrowRight"); did.right = worst - frame();
    await press("ArrowRight", true); did.split = card().querySelector(".edge").style.left;
    await press("3");
    const gain = tag(); await press("g"); did.gain = tag() !== gain;
    await press("v"); did.v = pressed();
    return did;
  )");
  EXPECT_EQ(page, (json{{"j", "stimulus-b"},
                        {"last", "stimulus-b"},
                        {"k", "stimulus-a"},
                        {"focus", "stage"},
                        {"1", "Slider"},
                        {"2", "Blink"},
                        {"3", "Difference"},
                        {"4", "ꟻLIP"},
                        {"nextKey", true},
                        {"back", true},
                        {"left", 1},
                        {"right", 0},
                        {"split", "calc(55% - 1px)"},
                        {"gain", true},
                        {"v", "Difference,Video"}}));
}

TEST_F(RegressionPage, ShowsTheSameFrameOfBothVideos) {
  const json page = seen(R"(
    await press("v");
    const videos = [...card().querySelectorAll("video")];
    const did = {videos: videos.length, sound: videos.some(one => !one.muted), off: 0};
    while (frame() !== "0") await press("ArrowLeft");
    for (let step = 0; step < 8; ++step) {
      await wait(200);
      for (const one of videos) did.off += Number(Math.floor(one.currentTime * 10) !== step);
      await press("ArrowRight");
    }
    return did;
  )");
  EXPECT_EQ(page, (json{{"videos", 2}, {"sound", false}, {"off", 0}}));
}

TEST(KeptVideos, AreRefusedWhereNoneAreMade) {
  const Scratch folder;
  const fs::path manifest = folder.write("study.yaml", std::string(study_start) + stimuli_before);
  const Ended ended = run_mien({"regress", "approve", manifest.string(), "--reason", "first",
                                "--keep-videos", "--without-videos"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.errors.find("--keep-videos"), std::string::npos) << ended.errors;
  EXPECT_FALSE(fs::exists(folder.path() / "baselines"));
}

}  // namespace
}  // namespace mien::test
