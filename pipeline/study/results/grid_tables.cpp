#include "pipeline/study/results/result_rows.h"
#include "pipeline/study/results/within_columns.h"

namespace mien::pipeline {

namespace {

struct GridMeanRow {
  const AnswerSet& in;
  const GridResults& all;
  const GridMean& of;

  const GridCondition& condition() const { return all.conditions[of.condition]; }
};

struct GridDifferenceRow {
  const AnswerSet& in;
  const GridResults& all;
  const GridDifference& of;
};

constexpr auto grid_mean_columns = result_table<GridMeanRow>(
    "results/grid.csv", "condition of grid trials",
    {{"condition", "", "levels of the factors that differ within sets, or the id of a stimulus",
      [](auto& r) { return r.condition().name; }},
     {"role", "", "reference (hidden among the others) or anchor; otherwise empty",
      [](auto& r) { return r.condition().role; }},
     {"scale", "", "scale id", [](auto& r) { return r.in.scales.front().id; }},
     {"people", "", "number of participants", [](auto& r) { return r.of.people; }},
     {"answers", "", "number of ratings", [](auto& r) { return r.of.answers; }},
     {"mean", "0–100", "mean of the participants' means", [](auto& r) { return r.of.mean; }},
     {"sd", "0–100", "standard deviation (n − 1) of the participants' means",
      [](auto& r) { return r.of.deviation; }},
     {"low", "0–100", "lower end of the 95 % interval of the mean (Student, over participants)",
      [](auto& r) { return r.of.ends.low; }},
     {"high", "0–100", "upper end", [](auto& r) { return r.of.ends.high; }}});

constexpr auto grid_difference_columns = result_table<GridDifferenceRow>(
    "results/grid_differences.csv", "pair of conditions of grid trials",
    {{"condition", "", "condition", [](auto& r) { return r.all.conditions[r.of.one].name; }},
     {"against", "", "condition that is subtracted",
      [](auto& r) { return r.all.conditions[r.of.other].name; }},
     {"scale", "", "scale id", [](auto& r) { return r.in.scales.front().id; }},
     {"people", "", "participants who rated both in the same set",
      [](auto& r) { return r.of.within.people; }}},
    within_columns<GridDifferenceRow>);

}  // namespace

void add_grid(const Results& results, std::vector<WrittenTable>& tables) {
  const AnswerSet& answer_set = results.answer_set;
  std::vector<GridMeanRow> means;
  for (const GridMean& one : results.grid.means) means.push_back({answer_set, results.grid, one});
  std::vector<GridDifferenceRow> differences;
  for (const GridDifference& one : results.grid.differences)
    differences.push_back({answer_set, results.grid, one});
  add_table(grid_mean_columns, means, answer_set.simulated, tables);
  add_table(grid_difference_columns, differences, answer_set.simulated, tables);
}

}  // namespace mien::pipeline
