#include "pipeline/study/adaptive/pair_tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

/// A chosen pair and an item.
struct ChosenPair {
  const PairChoice& choice;
  const NextPair& pair;
  std::size_t item;
  bool simulated;
};

constexpr auto next_pairs_columns = table_of<ChosenPair>(
    "next_pairs.csv", "chosen pair and scale, in the order of choice",
    {{"first", "", "id of a stimulus", [](auto& r) { return r.choice.first_of(r.pair.pair); }},
     {"second", "", "id of the other", [](auto& r) { return r.choice.second_of(r.pair.pair); }},
     {"scale", "", "id of the scale", [](auto& r) { return r.choice.study.items[r.item].id; }},
     {"first_chosen", "0–1",
      "probability that the first is chosen, once the pairs before it are answered",
      [](auto& r) { return r.pair.first_chosen[r.item]; }},
     {"gain", "",
      "share of what is unknown about the worths of the stimuli (their variance) that the answers "
      "to the pair would remove, mean over the scales, once the pairs before it are answered",
      [](auto& r) { return r.pair.gain; }},
     {"answers", "", "given (by people) or simulated",
      [](auto& r) { return origin_text(r.simulated); }}});

/// A stimulus and an item.
struct KnownWorth {
  const PairChoice& choice;
  std::size_t stimulus;
  std::size_t item;
  bool simulated;

  const PairPosterior& known() const { return choice.next.known[item]; }

  double comparisons() const {
    double sum = 0.0;
    for (const PairCount& count : choice.study.items[item].counts)
      if (count.first == stimulus || count.second == stimulus) sum += count.total();
    return sum;
  }

  /// About the mean of all stimuli.
  double worth() const {
    return known().mean[static_cast<Eigen::Index>(stimulus)] - known().mean.mean();
  }

  double deviation() const {
    const Eigen::MatrixXd& covariance = known().covariance;
    const auto i = static_cast<Eigen::Index>(stimulus);
    const auto count = static_cast<double>(covariance.rows());
    return std::sqrt(std::max(0.0, covariance(i, i) - 2.0 * covariance.col(i).sum() / count +
                                       covariance.sum() / (count * count)));
  }
};

constexpr auto known_worths_columns = table_of<KnownWorth>(
    "known_worths.csv", "stimulus that can be compared, and scale",
    {{"stimulus", "", "id of the stimulus",
      [](auto& r) { return r.choice.study.stimuli[r.stimulus]; }},
     {"scale", "", "id of the scale", [](auto& r) { return r.choice.study.items[r.item].id; }},
     {"comparisons", "", "number of answers about the stimulus",
      [](auto& r) { return r.comparisons(); }},
     {"worth", "",
      "log-worth less the mean of all stimuli: 1 more means odds of 2.7 to 1 of being chosen",
      [](auto& r) { return r.worth(); }},
     {"deviation", "", "standard deviation of the worth, before the next round",
      [](auto& r) { return r.deviation(); }},
     {"answers", "", "given (by people) or simulated",
      [](auto& r) { return origin_text(r.simulated); }}});

}  // namespace

std::vector<WrittenTable> pair_tables(const PairChoice& choice) {
  std::vector<ChosenPair> chosen;
  std::vector<KnownWorth> known;
  for (const NextPair& pair : choice.next.pairs)
    for (std::size_t item = 0; item < choice.study.items.size(); ++item)
      chosen.push_back({choice, pair, item, choice.study.simulated});
  for (std::size_t stimulus = 0; stimulus < choice.study.stimuli.size(); ++stimulus)
    for (std::size_t item = 0; item < choice.study.items.size(); ++item)
      known.push_back({choice, stimulus, item, choice.study.simulated});
  return {next_pairs_columns.of(chosen), known_worths_columns.of(known)};
}

std::string pair_report(const PairChoice& choice) {
  std::string text = choice.study.simulated ? "simulated answers\n" : "";
  text +=
      fmt::format("{} of {} pairs of {} stimuli, to learn the most about their worths\n",
                  choice.next.pairs.size(), choice.study.pairs.size(), choice.study.stimuli.size());
  for (const NextPair& pair : choice.next.pairs)
    text +=
        fmt::format("  {:48} removes {:.1f} % of what is unknown\n",
                    fmt::format("{} – {}", choice.first_of(pair.pair), choice.second_of(pair.pair)),
                    100.0 * pair.gain);
  text +=
      "Standard deviation of log-worths about their mean (root mean square over the stimuli):\n";
  text += fmt::format("  {:24} {:>6}  after this round\n", "", "now");
  for (std::size_t item = 0; item < choice.study.items.size(); ++item)
    text += fmt::format("  {:24} {:6.2f} {:6.2f}\n", choice.study.items[item].id,
                        choice.next.known_now[item], choice.next.known_then[item]);
  return text;
}

}  // namespace mien::pipeline
