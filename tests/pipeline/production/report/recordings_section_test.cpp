#include "pipeline/production/report/recordings_section.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "motion/fitting/fit.h"
#include "motion/fitting/virtual_points.h"
#include "motion/formats/trc/trc.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/plot_texts.h"
#include "pipeline/production/methods/methods.h"
#include "pipeline/production/report/fit_chart.h"
#include "pipeline/production/report/tables.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// A walk's points with a short gap, a long one, and a wrist that is far from the body.
motion::PointRecording faulty_points() {
  using namespace motion;
  PointRecording points =
      motion::test::recorded(motion::test::truth(), motion::test::plug_in_gait_markers());
  const auto point = [&](const char* name) {
    return static_cast<int>(std::ranges::find(points.points, name) - points.points.begin());
  };
  for (int frame = 0; frame < points.frame_count(); ++frame) {
    const auto hide = [&](int which) {
      points.seen[points.at(frame, which)] = false;
      points.positions[points.at(frame, which)] = Vec3::Zero();
    };
    if (frame >= 20 && frame < 26) hide(point("LHEE"));
    if (frame >= 30 && frame < 90) hide(point("RTOE"));
    points.positions[points.at(frame, point("LFIN"))].x() += frame % 2 == 0 ? 0.3 : -0.3;
  }
  return points;
}

class RecordingsSection : public testing::Test {
 protected:
  RecordingsSection() { write_file(folder.path() / "walk.trc", motion::to_trc(faulty_points())); }

  Manifest manifest(const std::string& terms = "") const {
    const fs::path file = folder.path() / "m.yaml";
    write_file(file,
               "mien: 1\nstudy: s\noutput: {fps: 60}\nstimuli:\n  - {id: a, clip: {file: walk.trc" +
                   terms + "}, look: {figure: markers}}\n  - {id: b, clip: walk.trc}\n");
    return load_manifest(file, [](const std::string&) { return std::nullopt; });
  }
  motion::FittedMotion fit() const {
    return motion::fit_body(motion::read_trc(folder.path() / "walk.trc"));
  }

  const test::TemporaryFolder folder;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(RecordingsSection, HasTheNumbersOfTheFit) {
  const Manifest study = manifest();
  Motions motions(study);
  const std::string html = recordings_section(study, motions);
  const motion::FittedMotion fitted = fit();
  EXPECT_TRUE(
      has(html,
          fmt::format(
              "Plug-in Gait, {0} of {0} points used, RMS {1:.1f} mm; largest: "
              "LFIN {2:.1f} mm",
              fitted.points.size(), fitted.residual_mm,
              std::ranges::max(fitted.points, {}, &motion::FittedPoint::residual_mm).residual_mm)))
      << html.substr(0, 600);
  for (const motion::FittedPoint& point : fitted.points) {
    const std::string mm = fmt::format("{:.1f}", point.residual_mm);
    const bool is_far = point.residual_mm > 40.0;
    EXPECT_TRUE(
        has(html, fmt::format("<th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td>",
                              point.name, point.role, is_far ? "<b>" + mm + "</b>" : mm)))
        << point.name;
  }
  EXPECT_TRUE(has(html, "<td>1 gap, 0.10 s</td><td></td></tr>"));  // LHEE: filled
  EXPECT_TRUE(has(html, "<td></td><td>1 gap, 1.00 s</td></tr>"));  // RTOE: missing
  EXPECT_TRUE(has(html, "Used by a, b."));
  EXPECT_EQ(html.find("<details>"), html.rfind("<details>"));  // one recording
}

TEST_F(RecordingsSection, IsATableToo) {
  const Manifest study = manifest();
  Motions motions(study);
  const std::string csv = fits_table.csv(study, motions);
  const motion::FittedMotion fitted = fit();
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + static_cast<long>(fitted.points.size()));
  for (const motion::FittedPoint& point : fitted.points)
    EXPECT_TRUE(has(csv, "walk.trc,,Plug-in Gait," + point.name + "," + point.role + ",used,"));
}

TEST_F(RecordingsSection, IsInTheLintOfTheStimulus) {
  const Manifest study = manifest();
  Motions motions(study);
  const auto& findings = motions.of("a").findings;
  const auto found = std::ranges::find(findings, "LFIN", &motion::Finding::joint);
  ASSERT_NE(found, findings.end());
  EXPECT_EQ(found->check, "fit-residual");
  EXPECT_TRUE(has(findings_table.csv(study, motions), "a,fit-residual,warning,LFIN,"));
}

TEST_F(RecordingsSection, IsInTheLintAtTheTimesOfTheModifiedMotion) {
  const fs::path file = folder.path() / "m.yaml";
  write_file(file,
             "mien: 1\nstudy: s\noutput: {fps: 60}\non_fault: warn\nstimuli:\n"
             "  - {id: a, clip: {file: walk.trc, frames: [10, 80]}}\n"
             "  - {id: b, clip: {file: walk.trc, frames: [10, 80]}, modify: {tempo: 0.5, ends: "
             "{before: 1}}}\n");
  const Manifest study = load_manifest(file, [](const std::string&) { return std::nullopt; });
  Motions motions(study);
  const auto frames = [&](const char* id) {
    const auto& findings = motions.of(id).findings;
    const auto found = std::ranges::find(findings, "LFIN", &motion::Finding::joint);
    if (found == findings.end()) throw std::runtime_error("no finding about LFIN");
    return std::pair(found->first, found->last);
  };
  const auto [first, last] = frames("a");
  ASSERT_GT(last - first, 20);
  EXPECT_NEAR(frames("b").first, 60 + 2 * first, 2);
  EXPECT_NEAR(frames("b").second, 60 + 2 * last, 2);
}

TEST_F(RecordingsSection, SaysUnderWhichLicence) {
  const Manifest study =
      manifest(", licence: {name: \"<my> licence\", share: false}, source: example.org");
  Motions motions(study);
  const std::string html = recordings_section(study, motions);
  EXPECT_TRUE(has(html,
                  "<td>walk.trc</td><td>&lt;my&gt; licence (not to be shared)</td>"
                  "<td>example.org</td>"))
      << html.substr(0, 400);
  EXPECT_FALSE(has(recordings_section(manifest(), motions), "licence"));
  EXPECT_TRUE(has(methods_of(study, motions).markdown,
                  "1 recording under the licence <my> licence from example.org"))
      << methods_of(study, motions).markdown;
}

TEST_F(RecordingsSection, SaysWhetherMarkersAreDarkInGaps) {
  const Manifest study = manifest();
  Motions motions(study);
  EXPECT_TRUE(has(methods_of(study, motions).markdown, "dark in "));
}

TEST(FitChart, HasARowForEachPointWithGaps) {
  motion::FitQuality fit;
  fit.first_frame = 5;
  fit.frame_residual_mm.assign(100, 3.0);
  fit.points.resize(3);
  fit.points[0].name = "LASI";
  fit.points[1].name = "RASI";
  fit.points[1].gaps = {{10, 20, true}, {50, 90, false}};
  fit.points[2].name = "LPSI";
  fit.points[2].gaps = {{0, 4, false}};  // before the clip
  const Plot chart = fit_chart(fit);
  EXPECT_TRUE(test::says(chart, "RASI"));
  EXPECT_FALSE(test::says(chart, "LASI"));
  EXPECT_FALSE(test::says(chart, "LPSI"));
  test::expect_texts_apart(chart);
}

}  // namespace
}  // namespace mien::pipeline
