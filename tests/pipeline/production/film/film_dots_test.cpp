#include "pipeline/production/film/film_dots.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/production/film/film_shot.h"
#include "scenes/marked_clip.h"
#include "scenes/walking_clip.h"

namespace mien::pipeline {
namespace {

constexpr int left_ankle = 0;

/// One motion for every stimulus.
class OneMotion : public FinishedMotions {
 public:
  explicit OneMotion(motion::Clip clip) : clip_(std::move(clip)) {}

  const Stimulus* stimulus(const std::string&) const override { return nullptr; }
  const motion::Clip& clip(const std::string&) override { return clip_; }
  motion::Clip shown(const Stimulus&) override { return clip_; }
  int shown_frames(const Stimulus&) override { return clip_.frame_count(); }
  void know_shortest(double) override {}

 private:
  motion::Clip clip_;
};

Stimulus with_figure(const scenes::Figure& figure) {
  Stimulus stimulus;
  stimulus.id = "a";
  stimulus.look.figure = figure;
  return stimulus;
}

motion::Clip recording(bool filled) {
  return scenes::test::with_gap(
      scenes::test::with_markers(scenes::test::walking_clip(60, motion::Vec3::UnitZ(), 0.04)),
      left_ankle, 10, 19, filled);
}

TEST(DotTable, LeavesMarkersThatAreDarkWithoutAPosition) {
  const scenes::Shot shot =
      scenes::stage(recording(false), scenes::Look{.figure = scenes::MarkersOptions{}});
  const CsvTable table = parse_csv(dots_csv(shot), "dots.csv");
  const auto field = [&](std::size_t row, const char* name) {
    return table.rows[row][static_cast<std::size_t>(require_column(table, name))].text;
  };
  int dark = 0;
  std::map<std::string, int> kinds;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    ++kinds[field(row, "kind")];
    const bool is_dark = field(row, "x_m").empty();
    for (const char* column : {"x_px", "y_px", "y_m", "z_m"}) {
      EXPECT_EQ(field(row, column).empty(), is_dark) << row << ' ' << column;
    }
    EXPECT_EQ(field(row, "visible"), is_dark ? "0" : "1");
    if (!is_dark) continue;
    ++dark;
    EXPECT_EQ(field(row, "kind"), "LANK");
  }
  EXPECT_EQ(dark, 10);
  EXPECT_EQ(kinds["LANK"], 60);
  EXPECT_EQ(kinds.size(), 6u);
}

TEST(DotTable, NamesThePersonWhereThereAreSeveral) {
  const motion::Clip clip = scenes::test::walking_clip(3, motion::Vec3::UnitZ(), 0.04);
  const scenes::Look look{.figure = scenes::PointLightOptions{},
                          .layout = scenes::Layout::as_recorded};
  const auto people_of = [](const scenes::Shot& shot) {
    const CsvTable table = parse_csv(dots_csv(shot), "dots.csv");
    std::map<std::string, int> rows;
    for (const auto& row : table.rows)
      ++rows[row[static_cast<std::size_t>(require_column(table, "person"))].text];
    return rows;
  };
  EXPECT_EQ(people_of(scenes::stage(clip, look)), (std::map<std::string, int>{{"", 3 * 13}}));
  const std::vector<scenes::Performance> people = {{.name = "ann", .clip = clip},
                                                   {.name = "bo", .clip = clip}};
  EXPECT_EQ(people_of(scenes::stage(people, look)),
            (std::map<std::string, int>{{"ann", 3 * 13}, {"bo", 3 * 13}}));
}

TEST(MarkerFacts, SayHowManyAreShownAndHowMuchIsMissing) {
  OneMotion missing(recording(false)), filled(recording(true));
  scenes::MarkersOptions options;
  EXPECT_EQ(marker_facts(with_figure(options), missing),
            "6 of 6 markers, dark in 2.8 % of their frames");
  options.show = {"R*", "HEAD"};
  EXPECT_EQ(marker_facts(with_figure(options), missing), "3 of 6 markers, dark in no frame");
  options.show = {"LANK"};
  options.fills_gaps = true;
  EXPECT_EQ(marker_facts(with_figure(options), filled),
            "1 of 6 markers, at interpolated positions in 17 % of their frames, dark in no frame");
  EXPECT_EQ(marker_facts(with_figure(scenes::StickOptions{}), missing), "");
}

}  // namespace
}  // namespace mien::pipeline
