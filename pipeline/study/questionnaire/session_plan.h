#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

enum class TrialKind { rating, emotion, pair, attention, matching };

inline constexpr Words<TrialKind> trial_kind_words = {{"rating", TrialKind::rating},
                                                      {"emotion", TrialKind::emotion},
                                                      {"pair", TrialKind::pair},
                                                      {"attention", TrialKind::attention},
                                                      {"matching", TrialKind::matching}};

/// One question of a trial: a scale by its id, or `emotion_item` (manifest/asked.h). Of a trial of
/// matching: the interface, whose stimulus is the target.
struct AskedItem {
  std::string item;
  bool flipped = false;  ///< the high end is at the left

  friend bool operator==(const AskedItem&, const AskedItem&) = default;
};

/// One page of a session.
struct Trial {
  int number = 0;     ///< from 1, through all blocks
  std::string block;  ///< "practice", "main", or the level of the blocking factor
  TrialKind kind = TrialKind::rating;
  std::vector<std::string> stimuli;  ///< one; two of a pair, from left to right; none of a check
  std::string reference;             ///< stimulus beside; empty for none
  std::vector<AskedItem> items;      ///< in the order in which they stand there
  bool practice = false;
  bool warm_up = false;
  bool is_catch = false;  ///< an attention check, or a stimulus that is shown a second time
  /// Of an attention check: the raw answer that passes. Else empty.
  std::string expected;

  /// Neither practice nor warm-up nor a check.
  bool is_analysed() const { return !practice && !warm_up && !is_catch; }

  friend bool operator==(const Trial&, const Trial&) = default;
};

/// All that one participant is shown.
struct SessionPlan {
  int index = 0;            ///< from 0
  std::string participant;  ///< "p001"
  std::uint64_t seed = 0;   ///< of this participant, from the study's and the index
  std::vector<Trial> trials;
  std::vector<std::string> choices;  ///< ids of what emotion trials offer, as they stand there
  double expected_seconds = 0.0;     ///< with the texts and the questions about the participant

  friend bool operator==(const SessionPlan&, const SessionPlan&) = default;
};

/// Seconds that the videos last, by stimulus. A stimulus that is not there counts as `usual_video`.
using VideoSeconds = std::map<std::string, double>;
inline constexpr double usual_video_seconds = 4.0;

/// The sessions of all planned participants, or of `count` when that is not 0. Every plan is a pure
/// function of (manifest, its index): more participants change none of the earlier plans. The
/// manifest must have a questionnaire without faults.
///
/// Throws Error when no order keeps the factors of `apart` apart.
std::vector<SessionPlan> plan_sessions(const Manifest& manifest, const VideoSeconds& seconds = {},
                                       int count = 0);

/// Which plan the next participant should get, when plan i was given to `given[i]` people and
/// finished by `finished[i]` of them: of those given out least often the first whose stimuli have
/// been seen least often to the end. As many numbers as plans, which must not be empty.
std::size_t least_filled(const std::vector<SessionPlan>& plans, const std::vector<int>& given,
                         const std::vector<int>& finished);

/// "p001", "p040"; from 0.
std::string participant_name(int index);

}  // namespace mien::pipeline
