#include "pipeline/study/questionnaire/adaptive_part.h"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {

namespace {

class AdaptivePart {
 public:
  AdaptivePart(const Manifest& manifest, std::uint64_t seed)
      : manifest_(manifest),
        asked_(questionnaire_of(manifest)),
        kind_(trial_kind_of(*asked_.trials)),
        levels_(adaptive_levels(manifest)),
        seed_(seed) {
    for (const AdaptiveLevel& level : levels_.grid)
      for (const std::string& id : level.stimuli)
        references_[id] = references_of(manifest, levels_, id);
  }

  std::vector<Trial> run() {
    const auto tracks = static_cast<std::size_t>(asked_.adaptive.tracks);
    const int rounds = most_track_trials(asked_.adaptive);
    for (int round = 0; round < rounds; ++round)
      for (const std::size_t track : random_order(tracks, seed_, fmt::format("round/{}", round)))
        trials_.push_back(track_trial(track, static_cast<std::size_t>(round)));
    add_noise();
    return std::move(trials_);
  }

 private:
  bool is_two_interval() const { return asked_.trials == &two_interval_form; }

  /// One of some ids: over as many draws in succession as there are ids, each once.
  const std::string& drawn(const std::vector<std::string>& ids, const std::string& what,
                           std::size_t draw) const {
    const std::string name = fmt::format("{}/{}", what, draw / ids.size());
    return ids[random_order(ids.size(), seed_, name)[draw % ids.size()]];
  }

  /// Whether, of two possible orders, the second is used: as often as the first.
  bool is_turned(const std::string& what, std::size_t draw) const {
    return random_order(2, seed_, fmt::format("{}/{}", what, draw / 2))[draw % 2] == 1;
  }

  /// The raw answer to a trial, with the signal in the second interval if there are two.
  std::string positive_answer(bool is_second) const {
    if (asked_.trials == &yes_no_form) return yes_answer;
    if (asked_.trials == &same_different_form) return different_answer;
    return is_second ? "second" : "first";
  }

  Trial empty_trial() const {
    return {.block = "main", .kind = &kind_, .reference = asked_.reference};
  }

  Trial track_trial(std::size_t track, std::size_t round) const {
    Trial trial = empty_trial();
    trial.adaptive.track = static_cast<int>(track) + 1;
    const bool is_second =
        asked_.trials->stimuli > 1 && is_turned(fmt::format("interval/{}", track), round);
    trial.adaptive.positive = positive_answer(is_second);
    for (std::size_t place = 0; place < levels_.grid.size(); ++place) {
      const std::string name = fmt::format("level/{}/{}", track, place);
      const std::string& shown = drawn(levels_.grid[place].stimuli, name, round);
      std::vector<std::string> stimuli = {shown};
      if (asked_.trials->stimuli > 1)
        stimuli.push_back(
            drawn(references_.at(shown), fmt::format("reference/{}/{}", track, shown), round));
      if (is_second) std::swap(stimuli[0], stimuli[1]);
      trial.adaptive.by_level.push_back(std::move(stimuli));
    }
    return trial;
  }

  /// Puts each trial without the signal before a random one of the others, or at the end.
  void add_noise() {
    const auto count = static_cast<std::size_t>(adaptive_noise_trials(asked_));
    std::vector<bool> is_noise(trials_.size() + count);
    const std::vector<std::size_t> places = random_order(is_noise.size(), seed_, "noise places");
    for (std::size_t i = 0; i < count; ++i) is_noise[places[i]] = true;
    std::vector<Trial> all;
    std::size_t next = 0, noise = 0;
    for (const bool is_without : is_noise)
      all.push_back(is_without ? noise_trial(noise++) : std::move(trials_[next++]));
    trials_ = std::move(all);
  }

  Trial noise_trial(std::size_t draw) const {
    Trial trial = empty_trial();
    const std::string& shown = drawn(levels_.references, "noise", draw);
    trial.stimuli.assign(asked_.trials->stimuli, shown);
    trial.level = level_of(manifest_, shown, asked_.adaptive.factor);
    trial.adaptive.positive = positive_answer(false);
    return trial;
  }

  const Manifest& manifest_;
  const Questionnaire& asked_;
  const TrialKind& kind_;
  AdaptiveLevels levels_;
  std::uint64_t seed_;
  std::map<std::string, std::vector<std::string>> references_;
  std::vector<Trial> trials_;
};

}  // namespace

std::vector<Trial> adaptive_part(const Manifest& manifest, std::uint64_t seed) {
  return AdaptivePart(manifest, seed).run();
}

Trial shown_at(const Trial& trial, std::size_t place, const std::vector<std::string>& levels) {
  Trial shown = trial;
  shown.stimuli = trial.adaptive.by_level.at(place);
  shown.level = levels.at(place);
  return shown;
}

}  // namespace mien::pipeline
