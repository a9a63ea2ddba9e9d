#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/run/video_seconds.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

/// The session of one participant: its trials in order.
struct SessionPlan {
  int index = 0;            ///< from 0
  std::string participant;  ///< "p001"
  std::uint64_t seed = 0;   ///< derived from the study's seed and the index
  std::vector<Trial> trials;
  std::vector<std::string> choices;  ///< ids of the choices in emotion trials, in page order
  double expected_seconds = 0.0;     ///< including texts and demographic questions

  friend bool operator==(const SessionPlan&, const SessionPlan&) = default;
};

/// Assumed duration of a video that is missing in VideoSeconds.
inline constexpr double usual_video_seconds = 4.0;

/// The session plans of `count` participants, or of all planned ones if `count` is 0. Each plan,
/// apart from its expected duration, is a pure function of (manifest, index), so further
/// participants do not change earlier plans. The manifest must have a valid questionnaire.
///
/// Throws Error as main_part() does.
std::vector<SessionPlan> plan_sessions(const Manifest& manifest, const VideoSeconds& seconds = {},
                                       int count = 0);

/// Index of the plan for the next participant, given that plan i was assigned to `assigned[i]`
/// participants and finished by `finished[i]` of them: among the plans assigned least often, the
/// first one whose stimuli were, on average, rated least often in finished sessions. Both vectors
/// have the size of `plans`, which must not be empty.
std::size_t next_plan(const std::vector<SessionPlan>& plans, const std::vector<int>& assigned,
                      const std::vector<int>& finished);

/// Name of the participant of a plan: "p001" for index 0, "p040" for 39.
std::string participant_name(int index);

}  // namespace mien::pipeline
