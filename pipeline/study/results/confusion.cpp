#include "pipeline/study/results/confusion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "pipeline/base/statistics/proportion.h"
#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

namespace {

/// Points of a participant's answers to a stimulus, by column.
using Showings = std::map<std::pair<std::size_t, std::size_t>, std::vector<double>>;

Showings rated_showings(const AnswerSet& answer_set, std::size_t columns) {
  Showings showings;
  for (const AnalysedRating& rating : answer_set.ratings) {
    auto& points = showings[{rating.stimulus, rating.person}];
    points.resize(columns);
    const EndPoints ends = points_of(answer_set.scales[rating.scale], rating.value);
    points[2 * rating.scale] += ends.low;
    points[2 * rating.scale + 1] += ends.high;
  }
  return showings;
}

Showings chosen_showings(const AnswerSet& answer_set) {
  Showings showings;
  for (const AnalysedChoice& choice : answer_set.chosen) {
    auto& points = showings[{choice.stimulus, choice.person}];
    points.resize(answer_set.choices.size());
    for (std::size_t i = 0; i < answer_set.choices.size(); ++i)
      if (answer_set.choices[i].first == choice.chosen) points[i] += 1.0;
  }
  return showings;
}

void add_showing(ConfusionRow& row, const std::vector<double>& points) {
  ++row.showings;
  double total = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    row.points[i] += points[i];
    total += points[i];
  }
  row.total += total;
  if (total == 0.0) return;
  ++row.judged;
  if (row.own < 0) return;
  const auto most = std::ranges::max_element(points);
  if (std::ranges::count(points, *most) > 1) return;
  ++row.decided;
  row.hits += most - points.begin() == row.own ? 1 : 0;
}

void finish(Confusion& confusion, TestCorrection correction) {
  std::vector<double> p_values;
  for (ConfusionRow& row : confusion.rows) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    row.recall = row.low = row.high = row.p = none;
    if (row.own >= 0 && row.total > 0.0) {
      row.recall = row.points[static_cast<std::size_t>(row.own)] / row.total;
      const ShareInterval interval = wilson(row.recall * row.judged, row.judged);
      row.low = interval.low;
      row.high = interval.high;
      if (row.decided > 0) row.p = binomial_test(row.hits, row.decided, confusion.chance);
    }
    p_values.push_back(row.p);
  }
  const std::vector<double> adjusted = corrected(p_values, correction);
  for (std::size_t i = 0; i < adjusted.size(); ++i) confusion.rows[i].adjusted = adjusted[i];
}

Confusion confusion_of(const AnswerSet& answer_set, const std::string& of,
                       const std::vector<std::string>& columns, const Showings& showings,
                       const std::function<bool(const ReportedStimulus&)>& belongs) {
  Confusion confusion;
  confusion.of = of;
  confusion.columns = columns;
  confusion.chance = 1.0 / static_cast<double>(columns.size());
  std::map<std::string, std::size_t> row_of;
  for (const ReportedStimulus& stimulus : answer_set.stimuli) {
    if (!belongs(stimulus) || stimulus.emotion.empty()) continue;
    if (!row_of.emplace(stimulus.emotion, confusion.rows.size()).second) continue;
    const auto own = std::ranges::find(columns, stimulus.emotion);
    confusion.rows.push_back(
        {.emotion = stimulus.emotion,
         .points = std::vector<double>(columns.size()),
         .own = own == columns.end() ? -1 : static_cast<int>(own - columns.begin())});
  }
  for (const auto& [who, points] : showings) {
    const ReportedStimulus& stimulus = answer_set.stimuli[who.first];
    if (belongs(stimulus) && !stimulus.emotion.empty())
      add_showing(confusion.rows[row_of.at(stimulus.emotion)], points);
  }
  std::erase_if(confusion.rows, [](const ConfusionRow& row) { return row.showings == 0; });
  finish(confusion, answer_set.correction);
  return confusion;
}

/// Levels of the factor `made` whose stimuli show emotions.
std::set<std::string> making_levels(const AnswerSet& answer_set) {
  std::set<std::string> ways;
  for (const ReportedStimulus& stimulus : answer_set.stimuli)
    if (!stimulus.is_neutral() && !stimulus.emotion.empty()) ways.insert(stimulus.made);
  return ways;
}

void add_confusions(const AnswerSet& answer_set, const std::vector<std::string>& columns,
                    const Showings& showings, bool by_points, std::vector<Confusion>& all) {
  if (showings.empty() || columns.empty()) return;
  const std::set<std::string> ways = making_levels(answer_set);
  const auto add = [&](const std::string& of, const auto& belongs) {
    Confusion confusion = confusion_of(answer_set, of, columns, showings, belongs);
    confusion.by_points = by_points;
    if (!confusion.rows.empty()) all.push_back(std::move(confusion));
  };
  if (ways.size() > 1)
    for (const std::string& made : ways)
      add(made.empty() ? "other" : made, [&](const ReportedStimulus& stimulus) {
        return stimulus.made == made && !stimulus.is_neutral();
      });
  add("all", [](const ReportedStimulus&) { return true; });
}

/// For each end, the points of every presentation; NaN where its scale was not answered.
std::vector<std::vector<double>> points_by_end(const AnswerSet& answer_set) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> showings;
  for (const AnalysedRating& rating : answer_set.ratings)
    showings.emplace(std::pair(rating.stimulus, rating.person), showings.size());
  const std::vector<double> unanswered(showings.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::vector<double>> ends(2 * answer_set.scales.size(), unanswered);
  for (const AnalysedRating& rating : answer_set.ratings) {
    const std::size_t showing = showings.at({rating.stimulus, rating.person});
    const EndPoints points = points_of(answer_set.scales[rating.scale], rating.value);
    ends[2 * rating.scale][showing] = points.low;
    ends[2 * rating.scale + 1][showing] = points.high;
  }
  return ends;
}

}  // namespace

EndPoints points_of(const Scale& scale, double value) {
  const double half = 0.5 * (scale.most - scale.least);
  const double points = 2.0 * (value - 0.5 * (scale.least + scale.most)) / half;
  return {std::max(0.0, -points), std::max(0.0, points)};
}

std::vector<std::string> ends_of(const std::vector<Scale>& scales) {
  std::vector<std::string> ends;
  for (const Scale& scale : scales) {
    ends.push_back(scale.low);
    ends.push_back(scale.high);
  }
  return ends;
}

std::vector<Confusion> confusions_of(const AnswerSet& answer_set) {
  std::vector<Confusion> all;
  const std::vector<std::string> ends = ends_of(answer_set.scales);
  add_confusions(answer_set, ends, rated_showings(answer_set, ends.size()), true, all);
  std::vector<std::string> choices;
  for (const auto& [id, shown] : answer_set.choices) choices.push_back(id);
  add_confusions(answer_set, choices, chosen_showings(answer_set), false, all);
  return all;
}

std::vector<EndCorrelation> end_correlations(const AnswerSet& answer_set) {
  if (answer_set.ratings.empty()) return {};
  const auto ends = points_by_end(answer_set);
  std::vector<EndCorrelation> all;
  std::vector<double> p_values;
  for (std::size_t one = 0; one < ends.size(); ++one) {
    for (std::size_t other = one + 1; other < ends.size(); ++other) {
      EndCorrelation pair{one, other, one / 2 == other / 2, pearson(ends[one], ends[other]), 1.0};
      p_values.push_back(pair.same_scale ? std::nan("") : pair.correlation.p);
      all.push_back(pair);
    }
  }
  const std::vector<double> adjusted = corrected(p_values, answer_set.correction);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].adjusted = adjusted[i];
  return all;
}

}  // namespace mien::pipeline
