// Grids with films that cannot be played, in Chromium (page/tests/questionnaire/grid_faults.mjs).

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

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
  for (const auto& [name, faulty, fault] : {std::tuple("missing", 1, "not_loaded"),
                                            {"broken", 1, "not_decoded"},
                                            {"both", 3, "not_loaded"}}) {
    const json& taken = told.at(name);
    // The videos in their order, and the reference.
    const std::vector<bool> is_faulty = taken.at("is_faulty");
    ASSERT_EQ(is_faulty.size(), 4u);
    EXPECT_EQ(std::ranges::count(is_faulty, true), faulty) << name;
    std::string said;
    for (std::size_t i = 0; i < 4; ++i)
      if (is_faulty[i])
        said += (said.empty() ? "" : ", ") + (i < 3 ? std::to_string(i + 1) : "Reference");
    EXPECT_EQ(taken.at("said"), said + ": This video cannot be played.");
    EXPECT_EQ(taken.at("disabled"), (json{is_faulty[3], is_faulty[0], is_faulty[1], is_faulty[2]}))
        << name << ": the reference's button comes first";
    EXPECT_FALSE(taken.at("is_covered")) << name << ": the offer is not over what plays";
    EXPECT_TRUE(taken.at("is_offered_again")) << name;
    EXPECT_NE(taken.at("note").get<std::string>().find("still to be played"), std::string::npos);
    const auto rows = rows_in(taken.at("answers").get<std::string>());
    ASSERT_EQ(rows.size(), 3u) << name;
    for (const auto& row : rows) {
      EXPECT_EQ(row.at("play_fault"), fault) << name;
      EXPECT_EQ(row.at("value") + row.at("value_raw") + row.at("rt_ms"), "");
      EXPECT_FALSE(row.at("stimulus").empty());
    }
    const auto people = rows_in(taken.at("participant").get<std::string>());
    EXPECT_EQ(people.at(0).at("finished"), "1");
  }
}

}  // namespace
}  // namespace mien::test
