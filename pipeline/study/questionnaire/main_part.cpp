#include "pipeline/study/questionnaire/main_part.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

namespace {

using Subjects = std::vector<std::size_t>;

/// The row of Williams' square for a participant. All rows of a square are used, in random order,
/// before those of its mirror image or of the next round.
Subjects square_row(std::size_t count, int index, std::uint64_t seed) {
  const auto round = static_cast<std::size_t>(index) / count;
  const Subjects rows = random_order(count, seed, fmt::format("rows/{}", round));
  const bool is_mirror = count % 2 == 1 && round % 2 == 1;
  const Subjects letters = random_order(count, seed, "letters");
  Subjects row =
      williams_row(count, rows[static_cast<std::size_t>(index) % count] + (is_mirror ? count : 0));
  for (std::size_t& letter : row) letter = letters[letter];
  return row;
}

class MainPart {
 public:
  MainPart(const Manifest& manifest, const TrialSubjects& subjects, const Subjects& share,
           int index, int round)
      : manifest_(manifest),
        questionnaire_(questionnaire_of(manifest)),
        subjects_(subjects),
        share_(share),
        index_(index),
        round_(round),
        // Where all see the same order, random additions are the same for all too.
        order_seed_(hashed_seed(manifest.seed, questionnaire_.order.kind == TrialOrder::Kind::fixed
                                                   ? "everybody"
                                                   : name_of_round(index, round))) {}

  std::vector<MainTrial> run() {
    order();
    for (int i = 0; i < questionnaire_.repeated; ++i) repeat_one(i);
    warm_up();
    return trials_;
  }

 private:
  static std::string name_of_round(int index, int round) {
    return participant_name(index) + (round == 0 ? "" : fmt::format("/{}", round));
  }

  void order() {
    if (questionnaire_.order.kind == TrialOrder::Kind::fixed) return append(share_);
    if (questionnaire_.order.kind == TrialOrder::Kind::latin) return append_latin();
    if (questionnaire_.order.kind == TrialOrder::Kind::blocked) return append_blocks();
    append_apart(share_, "order");
  }

  void append(const Subjects& subjects) {
    for (const std::size_t subject : subjects) trials_.push_back({.subject = subject});
  }

  void append_latin() {
    for (const std::size_t place : square_row(share_.size(), index_ + round_, manifest_.seed))
      append({share_[place]});
  }

  void append_blocks() {
    std::vector<std::string> levels;
    for (const std::string& level : subjects_.blocks)
      if (std::ranges::find(levels, level) == levels.end()) levels.push_back(level);
    for (const std::size_t place :
         square_row(levels.size(), index_ + round_, hashed_seed(manifest_.seed, "blocks"))) {
      Subjects block;
      for (const std::size_t subject : share_)
        if (subjects_.blocks[subject] == levels[place]) block.push_back(subject);
      append_apart(block, "block/" + levels[place]);
    }
  }

  void append_apart(const Subjects& subjects, const std::string& name) {
    const std::optional<std::size_t> before =
        trials_.empty() ? std::nullopt : std::optional(trials_.back().subject);
    const auto found =
        separated_order(subjects_.factor_levels, subjects, before, order_seed_, name);
    if (!found) refuse(no_order_reason(subjects_.factor_levels, subjects));
    append(*found);
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(
        place_of(manifest_.places, "questionnaire.no_repeats"),
        fmt::format(
            "questionnaire.no_repeats: no order of {} separates stimuli with the same {} ({})",
            participant_name(index_), fmt::join(questionnaire_.no_repeats, " or "), why),
        "use fewer factors, or other stimuli");
  }

  bool share_level(std::size_t a, std::size_t b) const {
    return a == b || subjects_.factor_levels.share_level(a, b);
  }

  const std::string& block_of(std::size_t place) const {
    return subjects_.blocks[trials_[place].subject];
  }

  /// Inserts a repetition in the same block, half a block later where possible.
  void repeat_one(int number) {
    const std::string name = fmt::format("repeat/{}", number);
    const Subjects order = random_order(trials_.size(), order_seed_, name);
    const Subjects places = random_order(trials_.size() + 1, order_seed_, name + "/place");
    for (const std::size_t part : {2, 4, 8}) {
      for (const std::size_t first : order) {
        if (is_repeated(trials_[first].subject)) continue;
        const auto length =
            static_cast<std::size_t>(std::ranges::count(subjects_.blocks, block_of(first)));
        for (const std::size_t place : places) {
          if (place < first + std::max<std::size_t>(2, std::min(length, trials_.size()) / part))
            continue;
          if (!takes(place, first)) continue;
          trials_.insert(trials_.begin() + static_cast<std::ptrdiff_t>(place),
                         {.subject = trials_[first].subject, .repeated = true});
          return;
        }
      }
    }
    const bool is_one = questionnaire_.repeated == 1;
    throw Error(
        place_of(manifest_.places, "questionnaire.retest.repeat"),
        fmt::format("questionnaire.retest.repeat: {} cannot see {} a second time with others "
                    "in between",
                    participant_name(index_),
                    is_one ? "a stimulus" : fmt::format("{} stimuli", questionnaire_.repeated)),
        is_one ? "omit it, or show more stimuli" : "use a smaller number");
  }

  bool is_repeated(std::size_t subject) const {
    return std::ranges::any_of(trials_, [&](const MainTrial& trial) {
      return trial.repeated && trial.subject == subject;
    });
  }

  /// Whether the trial at `first` may be repeated before the trial at `place`.
  bool takes(std::size_t place, std::size_t first) const {
    const std::size_t subject = trials_[first].subject;
    if (block_of(place - 1) != block_of(first)) return false;
    if (share_level(trials_[place - 1].subject, subject)) return false;
    return place == trials_.size() || !share_level(trials_[place].subject, subject);
  }

  /// Subjects for the warm-up, of the first block: those that the participant does not rate,
  /// otherwise those rated last.
  Subjects warm_up_candidates() const {
    Subjects candidates;
    const std::string& block = block_of(0);
    for (const std::size_t subject : random_order(subjects_.size(), order_seed_, "warm-up")) {
      const bool is_own = std::ranges::find(share_, subject) != share_.end();
      if (!is_own && subjects_.blocks[subject] == block) candidates.push_back(subject);
    }
    for (std::size_t place = trials_.size(); place-- > 0;)
      if (!trials_[place].repeated && block_of(place) == block)
        candidates.push_back(trials_[place].subject);
    return candidates;
  }

  void warm_up() {
    Subjects candidates = warm_up_candidates();
    for (int i = 0; i < questionnaire_.warm_up; ++i) {
      const std::size_t next = trials_.front().subject;
      const auto found = std::ranges::find_if(
          candidates, [&](std::size_t subject) { return !share_level(subject, next); });
      if (found == candidates.end()) refuse("no stimuli remain for the warm-up");
      trials_.insert(trials_.begin(), {.subject = *found, .warm_up = true});
      candidates.erase(found);
    }
  }

  const Manifest& manifest_;
  const Questionnaire& questionnaire_;
  const TrialSubjects& subjects_;
  const Subjects& share_;
  int index_;
  int round_;
  std::uint64_t order_seed_;
  std::vector<MainTrial> trials_;
};

}  // namespace

std::vector<MainTrial> main_part(const Manifest& manifest, const TrialSubjects& subjects,
                                 const std::vector<std::size_t>& share, int index, int round) {
  return MainPart(manifest, subjects, share, index, round).run();
}

}  // namespace mien::pipeline
