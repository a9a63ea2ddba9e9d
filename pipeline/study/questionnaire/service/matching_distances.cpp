#include "pipeline/study/questionnaire/service/matching_distances.h"

#include <cmath>

namespace mien::pipeline {

namespace {

/// Of what is the same number, found in a browser or here; metres.
constexpr double distance_slack_m = 1e-9;

void check_distance(LiveMotions& live, const Trial& trial, const SliderSetting& setting,
                    double told) {
  motion::LiveSetting sliders;
  sliders.kind = meaning_of(motion::interface_kinds, trial.items.front().item).value();
  sliders.sliders = setting.sliders;
  sliders.values = setting.values;
  double found = 0.0;
  try {
    found = live.distance(trial.stimuli.front(), sliders).mean;
  } catch (const Error& error) {
    throw RecordFault(error.what());
  }
  if (std::abs(found - told) > distance_slack_m)
    throw RecordFault("a distance does not match its slider settings");
}

}  // namespace

void check_distances(LiveMotions& live, const Trial& trial, const MatchingRecord& record) {
  check_distance(live, trial, record.first, record.first_guess_d);
  check_distance(live, trial, record.last, record.d);
}

}  // namespace mien::pipeline
