#include <algorithm>
#include <cmath>

#include "pipeline/base/documents/html.h"
#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/report/report_pictures.h"

namespace mien::pipeline {

namespace {

using ReportJson = nlohmann::ordered_json;
using JointPaths = std::vector<std::vector<motion::Vec3>>;

double rounded(double value, double step) { return std::round(value / step) * step; }

ReportJson shares_json(const std::vector<BodyShare>& shares) {
  ReportJson json = ReportJson::array();
  for (const BodyShare& share : shares)
    json.push_back({{"part", share.part}, {"share", rounded(share.share, 1e-4)}});
  return json;
}

double farthest_m(const JointPaths& paths) {
  double farthest = 0.0;
  for (const std::vector<motion::Vec3>& joints : paths)
    for (const motion::Vec3& joint : joints)
      farthest = std::max(farthest, joint.cwiseAbs().maxCoeff());
  return farthest;
}

/// Millimetres a step: one, or more for motions that go farther than 16 bits do.
double step_mm(double farthest) { return std::max(1.0, std::ceil(1000.0 * farthest / 32'000.0)); }

std::string packed(const JointPaths& paths, double step) {
  std::string bytes;
  for (const std::vector<motion::Vec3>& joints : paths) {
    for (const motion::Vec3& joint : joints) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto steps = static_cast<unsigned>(std::lround(1000.0 * joint[axis] / step));
        bytes += static_cast<char>(steps & 255U);
        bytes += static_cast<char>(steps >> 8U & 255U);
      }
    }
  }
  return data_uri("application/octet-stream", bytes);
}

ReportJson curve_json(const std::vector<double>& metres) {
  ReportJson json = ReportJson::array();
  for (const double value : metres) json.push_back(std::round(1e4 * value) / 10.0);
  return json;
}

ReportJson bones_json(const motion::Skeleton& skeleton) {
  ReportJson bones = ReportJson::array();
  for (std::size_t j = 0; j < skeleton.joints.size(); ++j)
    if (skeleton.joints[j].parent >= 0) bones.push_back({skeleton.joints[j].parent, j});
  return bones;
}

ReportJson poses_json(const motion::Clip& clip, const JointPaths& paths, double step) {
  return {{"fps", clip.frames_per_second},
          {"joints", clip.body.joints.size()},
          {"bones", bones_json(clip.body)},
          {"step_mm", step},
          {"places", packed(paths, step)}};
}

}  // namespace

ReportJson frames_json(const StimulusComparison& one, const ComparedPictures& pictures,
                       const ReportPictures& chosen) {
  ReportJson json = ReportJson::array();
  const auto uri = [&](const std::filesystem::path& file) {
    return picture_uri(file, chosen.most_width);
  };
  for (const FrameComparison* frame : shown_frames(one, chosen.every_frame)) {
    json.push_back({{"frame", frame->frame},
                    {"flip_mean", frame->perceived.mean},
                    {"flip_most", frame->perceived.largest},
                    {"ssim", frame->similarity},
                    {"largest", frame->difference.largest},
                    {"is_bias", frame->noise.is_bias},
                    {"shares", shares_json(frame->shares)},
                    {"before", uri(pictures.before(one.id, frame->frame))},
                    {"now", uri(pictures.now(one.id, frame->frame))},
                    {"flip", uri(pictures.flip(one.id, frame->frame))}});
    if (one.motion) json.back()["seconds"] = frame->frame / one.motion->frames_per_second();
  }
  return json;
}

ReportJson motion_json(const StimulusComparison& one, const ComparedStudy& study) {
  const motion::Clip& now = study.now.clip_of(one.id);
  const motion::Clip before = approved_clip(study.baseline, one.id, now);
  const JointPaths paths_before = motion::joint_paths(before);
  const JointPaths paths_now = motion::joint_paths(now);
  const double step = step_mm(std::max(farthest_m(paths_before), farthest_m(paths_now)));
  std::vector<double> most;
  ReportJson parts = ReportJson::array();
  for (const motion::JointDifference& joint : one.motion->joints) {
    most.resize(std::max(most.size(), joint.point_m.size()));
    for (std::size_t f = 0; f < joint.point_m.size(); ++f)
      most[f] = std::max(most[f], joint.point_m[f]);
    parts.push_back({{"name", joint.part}, {"curve", curve_json(joint.point_m)}});
  }
  return {{"before", poses_json(before, paths_before, step)},
          {"now", poses_json(now, paths_now, step)},
          {"fps", one.motion->frames_per_second()},
          {"curve", curve_json(most)},
          {"worst", motion::peak_of(most).frame},
          {"parts", parts}};
}

}  // namespace mien::pipeline
