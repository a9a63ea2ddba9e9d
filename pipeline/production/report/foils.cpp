#include "pipeline/production/report/foils.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "motion/math/rotation.h"
#include "motion/measures/distance/distance.h"
#include "pipeline/production/report/tables.h"

namespace mien::pipeline {

namespace {

using motion::Vec3;

constexpr std::array<motion::BodyJoint, 5> ends = {
    motion::Head, motion::LeftWrist, motion::RightWrist, motion::LeftAnkle, motion::RightAnkle};

constexpr double held_posture_degrees = 2.0;
constexpr double held_ratio = 0.05;

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
           b.path_m, share(a.path_m, b.path_m), held_ratio},
          {FoilAspect::speed, "duration (s)", a.duration_s, b.duration_s,
           share(a.duration_s, b.duration_s), held_ratio},
          {FoilAspect::acceleration, "variation of speed", a.unevenness, b.unevenness,
           share(a.unevenness, b.unevenness), held_ratio}};
}

struct FoilAspectRow {
  std::string id;
  Foil foil;
  CertifiedAspect certified;
};

constexpr auto foils_columns = table_of<FoilAspectRow>(
    "metrics/foils.csv", "foil and aspect",
    {{"foil", "", "id of the foil", [](auto& r) { return r.id; }},
     {"of", "", "id of the stimulus of which it is a foil", [](auto& r) { return r.foil.of; }},
     {"differ", "", "aspect in which the two are intended to differ",
      [](auto& r) { return name_of(r.foil.differ); }},
     {"aspect", "", "aspect of this row: posture, path-length, speed or acceleration",
      [](auto& r) { return name_of(r.certified.aspect); }},
     {"measure", "", "measure compared between the two finished motions, with its unit",
      [](auto& r) { return r.certified.measure; }},
     {"of_value", "see measure", "value of the stimulus; empty if only the difference is known",
      [](auto& r) { return r.certified.of_value; }},
     {"foil_value", "see measure", "value of the foil; empty if only the difference is known",
      [](auto& r) { return r.certified.foil_value; }},
     {"difference", "° or relative",
      "for posture, the largest difference between the mean rotations of a joint, in degrees; "
      "otherwise the ratio of the foil's value to the stimulus's, minus 1",
      [](auto& r) { return r.certified.difference; }},
     {"is_held", "0/1",
      "1: the absolute difference is below 2° for posture, otherwise below 0.05; empty for the "
      "aspect intended to differ",
      [](auto& r) {
        return r.certified.aspect == r.foil.differ ? std::nullopt
                                                   : std::optional(r.certified.is_held());
      }}});

std::vector<FoilAspectRow> foil_aspects(const Manifest& manifest, Motions& motions) {
  std::vector<FoilAspectRow> rows;
  for (const auto& [id, foil, aspects] : foil_certificates(manifest.stimuli, motions))
    for (const CertifiedAspect& aspect : aspects) rows.push_back({id, foil, aspect});
  return rows;
}

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

const StudyTable foils_table = study_table<foils_columns, foil_aspects>;

}  // namespace mien::pipeline
