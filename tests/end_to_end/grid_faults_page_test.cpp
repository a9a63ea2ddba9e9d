// Grids with films that cannot be played, in Chromium (page/tests/questionnaire/grid_faults.mjs).

#include <string>

#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char grid_of_three[] = R"(mien: 1
study: grids
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 72], fps: 15, cycles: 1, quality: draft, video: [mp4], frames: none}
stimuli:
  - {id: usual, weights: {normal: 1}}
  - {id: sad, weights: {normal: 0.4, sad: 0.6}}
  - {id: proud, weights: {normal: 0.4, proud: 0.6}}
questionnaire:
  participants: 1
  scales: [sad-happy]
  trials: grid
  grid: {sets: [[usual, sad, proud]], reference: [usual]}
)";

class GridFaultsPage : public QuestionnairePage {};

TEST_F(GridFaultsPage, SayWhichVideoCannotBePlayedShowTheOthersAndCanBeLeftOut) {
  const fs::path there = scratch->path() / "grids";
  must_run(mien_with({"study", "export", scratch->write("grids.yaml", grid_of_three).string(),
                      "--out", (scratch->path() / "out-grids").string(), "-o", there.string()}));
  const json told = output_of({(page_tests() / "grid_faults.mjs").string(), there.string()});
  struct Case {
    const char* name;
    const char* said;
    json disabled;  // the reference's button, and then those of the videos
    const char* fault;
  };
  for (const Case& one : {Case{"missing",
                               "2: This video cannot be played.",
                               {false, false, true, false},
                               "not_loaded"},
                          Case{"broken",
                               "1: This video cannot be played.",
                               {false, true, false, false},
                               "not_decoded"},
                          Case{"both",
                               "1, Reference: This video cannot be played.",
                               {true, true, false, false},
                               "not_loaded"}}) {
    const json& taken = told.at(one.name);
    EXPECT_EQ(taken.at("said"), one.said);
    EXPECT_EQ(taken.at("disabled"), one.disabled) << one.name;
    EXPECT_FALSE(taken.at("is_covered")) << one.name << ": the offer is not over what plays";
    EXPECT_TRUE(taken.at("is_offered_again")) << one.name;
    EXPECT_NE(taken.at("note").get<std::string>().find("still to be played"), std::string::npos);
    const auto rows = rows_in(taken.at("answers").get<std::string>());
    ASSERT_EQ(rows.size(), 3u) << one.name;
    for (const auto& row : rows) {
      EXPECT_EQ(row.at("play_fault"), one.fault) << one.name;
      EXPECT_EQ(row.at("value") + row.at("value_raw") + row.at("rt_ms"), "");
      EXPECT_FALSE(row.at("stimulus").empty());
    }
    const auto people = rows_in(taken.at("participant").get<std::string>());
    EXPECT_EQ(people.at(0).at("finished"), "1");
  }
}

}  // namespace
}  // namespace mien::test
