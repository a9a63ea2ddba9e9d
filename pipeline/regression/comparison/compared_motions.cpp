#include "pipeline/regression/comparison/compared_motions.h"

#include "motion/error.h"
#include "motion/examples/make_example.h"
#include "motion/formats/motion_file.h"
#include "motion/measures/differences/recording_difference.h"
#include "motion/measures/features/motion_features.h"

namespace mien::pipeline {

namespace {

/// The take that the recording is, where its file holds several; else empty.
std::string several_take(const motion::Recording& recording) {
  return recording.takes.size() > 1 ? recording.take : "";
}

/// The person who moves in the recording, where its file holds several; else empty.
std::string several_people(const motion::Recording& recording) {
  return recording.subjects.size() > 1 ? recording.subject : "";
}

/// Where these frames hold no whole cycle (of a take that holds half a one), as it is by itself.
motion::PreparedExample prepared_over_same_frames(const motion::Clip& clip,
                                                  const motion::ExampleOptions& same_frames) {
  try {
    return motion::prepare_example(clip, same_frames);
  } catch (const Error&) {
    return motion::prepare_example(clip);
  }
}

/// The features of `mien motion features`; both over the same frames where they have as many, so
/// that a cycle chosen otherwise is not taken for other walking.
std::vector<motion::FeatureDifference> features_of(const motion::Clip& before,
                                                   const motion::Clip& now) {
  if (before.frame_count() < 2 || now.frame_count() < 2) return {};
  const motion::PreparedExample was = motion::prepare_example(before);
  motion::ExampleOptions same_frames;
  if (was.cycle && now.frame_count() == before.frame_count()) same_frames.frames = was.frames;
  const motion::PreparedExample is = prepared_over_same_frames(now, same_frames);
  return motion::feature_differences(motion::measure_features(was.example),
                                     motion::measure_features(is.example));
}

}  // namespace

ComparedMotions compared_motion_files(const std::string& before, const std::string& now,
                                      const motion::MotionTolerance& tolerance,
                                      const std::array<motion::ReadOptions, 2>& how) {
  const motion::Recording was = motion::read_motion(before, how[0]);
  const motion::Recording is = motion::read_motion(now, how[1]);
  const motion::ComparedRecordings recordings = motion::compared_recordings(was, is);
  ComparedMotions result{before,
                         now,
                         several_take(was),
                         several_take(is),
                         several_people(was),
                         several_people(is),
                         motion::motion_difference(recordings),
                         tolerance,
                         {}};
  if (recordings.body_before && recordings.body_now) {
    try {
      result.difference.features = features_of(*recordings.body_before, *recordings.body_now);
    } catch (const Error& error) {  // the motions are compared nevertheless
      result.difference.remarks.push_back(std::string("Motion features are not compared: ") +
                                          error.what());
    }
  }
  result.excesses = motion::excesses(result.difference, tolerance);
  return result;
}

}  // namespace mien::pipeline
