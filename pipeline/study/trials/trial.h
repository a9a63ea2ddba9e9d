#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

struct TrialKind;
extern const TrialKind rating_trials;

/// One question of a trial: a scale by its id, or the own item of the form of trials (TrialForm).
/// Of a trial of matching: the interface, whose stimulus is the target.
struct AskedItem {
  std::string item;
  bool flipped = false;  ///< the high end is at the left

  friend bool operator==(const AskedItem&, const AskedItem&) = default;
};

/// One page of a session.
struct Trial {
  int number = 0;     ///< from 1, through all blocks
  std::string block;  ///< "practice", "main", or the level of the blocking factor
  const TrialKind* kind = &rating_trials;  ///< of a check: the kind that it looks like
  std::vector<std::string> stimuli;  ///< one; two of a pair, from left to right; none of a check
  std::string reference;             ///< stimulus beside; empty for none
  std::vector<AskedItem> items;      ///< in the order in which they stand there
  bool practice = false;
  bool warm_up = false;
  bool is_catch = false;  ///< an attention check, or a stimulus that is shown a second time
  /// Of an attention check: the raw answer that passes. Else empty.
  std::string expected;

  bool is_attention_check() const { return !expected.empty(); }

  /// Neither practice nor warm-up nor a check.
  bool is_analysed() const { return !practice && !warm_up && !is_catch; }

  /// What plans, pages and answers call its kind.
  std::string_view kind_name() const;

  /// What stands beside the first stimulus: the other one of a pair, or the reference. May be
  /// empty.
  const std::string& against() const { return stimuli.size() > 1 ? stimuli[1] : reference; }

  friend bool operator==(const Trial&, const Trial&) = default;
};

}  // namespace mien::pipeline
