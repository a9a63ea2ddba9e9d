#include "pipeline/production/report/foils.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/measures/distance/distance.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/production/report/table_forms.h"

namespace mien::pipeline {

namespace {

using motion::Vec3;

constexpr std::array<motion::BodyJoint, 5> ends = {
    motion::Head, motion::LeftWrist, motion::RightWrist, motion::LeftAnkle, motion::RightAnkle};

constexpr double held_posture_degrees = 2.0;
constexpr double held_share = 0.05;

/// Places of the joints at every frame, without the body's place on the floor and its heading.
std::vector<std::vector<Vec3>> places_in_body(const motion::Clip& clip) {
  std::vector<std::vector<Vec3>> frames;
  for (int f = 0; f < clip.frame_count(); ++f) {
    const double seconds = f / clip.frames_per_second;
    frames.push_back(motion::world_positions(
        clip.body, motion::aligned_pose_at(clip, seconds, motion::Alignment::pelvis)));
  }
  return frames;
}

/// Means of the joints' rotations: sums of their quaternions, made unit ones.
std::vector<motion::Quat> mean_rotations(const motion::Clip& clip) {
  std::vector<Eigen::Vector4d> sums(clip.body.joints.size(), Eigen::Vector4d::Zero());
  for (int f = 0; f < clip.frame_count(); ++f) {
    const motion::Pose pose =
        motion::aligned_pose_at(clip, f / clip.frames_per_second, motion::Alignment::pelvis);
    for (std::size_t j = 0; j < sums.size(); ++j) {
      const Eigen::Vector4d q = pose.rotations[j].coeffs();
      sums[j] += q.dot(sums[j]) < 0.0 ? Eigen::Vector4d(-q) : q;
    }
  }
  std::vector<motion::Quat> means;
  for (const Eigen::Vector4d& sum : sums) means.emplace_back(Eigen::Vector4d(sum.normalized()));
  return means;
}

/// Length of every step of a joint from frame to frame, of a loop also the one that closes it.
std::vector<double> steps_of(const std::vector<std::vector<Vec3>>& frames, motion::BodyJoint joint,
                             bool loops) {
  std::vector<double> steps;
  const auto j = static_cast<std::size_t>(joint);
  for (std::size_t f = 0; f + 1 < frames.size(); ++f)
    steps.push_back((frames[f + 1][j] - frames[f][j]).norm());
  if (loops) steps.push_back((frames.front()[j] - frames.back()[j]).norm());
  return steps;
}

std::vector<CertifiedAspect> certificate(const motion::Clip& of, const motion::Clip& foil) {
  const EmotionMeasures a = measure_emotion(of);
  const EmotionMeasures b = measure_emotion(foil);
  const auto share = [](double from, double to) { return from == to ? 0.0 : to / from - 1.0; };
  return {{FoilAspect::posture, "largest difference of a joint rotation (degrees)", NAN, NAN,
           posture_difference(of, foil), held_posture_degrees},
          {FoilAspect::path_length, "path length of head, wrists and ankles (m)", a.path_m,
           b.path_m, share(a.path_m, b.path_m), held_share},
          {FoilAspect::speed, "duration (s)", a.duration_s, b.duration_s,
           share(a.duration_s, b.duration_s), held_share},
          {FoilAspect::acceleration, "variation of speed", a.unevenness, b.unevenness,
           share(a.unevenness, b.unevenness), held_share}};
}

std::string number(double value) { return std::isnan(value) ? "" : shortest(value); }

}  // namespace

EmotionMeasures measure_emotion(const motion::Clip& clip) {
  const auto frames = places_in_body(clip);
  EmotionMeasures measures;
  measures.duration_s = clip.duration_seconds();
  for (const motion::BodyJoint joint : ends) {
    const std::vector<double> steps = steps_of(frames, joint, clip.loops);
    double sum = 0.0, squares = 0.0;
    for (const double step : steps) sum += step;
    const double mean = sum / static_cast<double>(steps.size());
    for (const double step : steps) squares += (step - mean) * (step - mean);
    measures.path_m += sum / ends.size();
    if (mean > 0.0)
      measures.unevenness +=
          std::sqrt(squares / static_cast<double>(steps.size())) / mean / ends.size();
  }
  return measures;
}

double posture_difference(const motion::Clip& a, const motion::Clip& b) {
  const std::vector<motion::Quat> of_a = mean_rotations(a);
  const std::vector<motion::Quat> of_b = mean_rotations(b);
  double largest = 0.0;
  for (std::size_t j = 0; j < of_a.size(); ++j)
    largest = std::max(largest, motion::angle_between(of_a[j], of_b[j]));
  return largest * 180.0 / std::numbers::pi;
}

bool CertifiedAspect::is_held() const { return std::abs(difference) < tolerance; }

std::vector<Certificate> foil_certificates(std::span<const Stimulus> stimuli, Motions& motions) {
  std::vector<Certificate> certificates;
  for (const Stimulus& stimulus : stimuli) {
    if (!stimulus.foil) continue;
    certificates.push_back({stimulus.id, *stimulus.foil,
                            certificate(motions.of(stimulus.foil->of).motion.clip,
                                        motions.of(stimulus.id).motion.clip)});
  }
  return certificates;
}

std::string foils_csv(const Manifest& manifest, Motions& motions) {
  CsvWriter table = table_of(foils_form);
  for (const auto& [id, foil, aspects] : foil_certificates(manifest.stimuli, motions)) {
    for (const CertifiedAspect& aspect : aspects) {
      table.row({id, foil.of, std::string(name_of(foil.differ)),
                 std::string(name_of(aspect.aspect)), aspect.measure, number(aspect.of_value),
                 number(aspect.foil_value), shortest(aspect.difference),
                 aspect.aspect == foil.differ ? ""
                 : aspect.is_held()           ? "1"
                                              : "0"});
    }
  }
  return table.text();
}

}  // namespace mien::pipeline
