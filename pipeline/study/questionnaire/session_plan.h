#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

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
/// Throws Error when no order keeps the factors of `no_repeats` apart.
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
