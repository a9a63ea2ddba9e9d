#include "pipeline/comparison/compared_motions.h"

#include "motion/examples/make_example.h"
#include "motion/formats/motion_file.h"
#include "motion/measures/motion_features.h"
#include "motion/measures/recording_difference.h"

namespace mien::pipeline {

namespace {

/// As `mien motion features` measures them; both over the same frames where they have as many, so
/// that a cycle chosen otherwise is not taken for other walking.
std::vector<motion::FeatureDifference> features_of(const motion::Clip& before,
                                                   const motion::Clip& now) {
  if (before.frame_count() < 2 || now.frame_count() < 2) return {};
  const motion::PreparedExample was = motion::prepare_example(before);
  motion::ExampleOptions same_frames;
  if (was.cycle && now.frame_count() == before.frame_count()) same_frames.frames = was.frames;
  const motion::PreparedExample is = motion::prepare_example(now, same_frames);
  return motion::feature_differences(motion::measure_features(was.example),
                                     motion::measure_features(is.example));
}

}  // namespace

ComparedMotions compared_motion_files(const std::string& before, const std::string& now,
                                      const motion::MotionTolerance& tolerance) {
  const motion::ComparedRecordings recordings =
      motion::compared_recordings(motion::read_motion(before), motion::read_motion(now));
  ComparedMotions result{before, now, motion::motion_difference(recordings), tolerance, {}};
  if (recordings.body_before && recordings.body_now)
    result.difference.features = features_of(*recordings.body_before, *recordings.body_now);
  result.excesses = motion::excesses(result.difference, tolerance);
  return result;
}

}  // namespace mien::pipeline
