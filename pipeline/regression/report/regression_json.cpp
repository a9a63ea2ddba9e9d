#include "pipeline/regression/report/regression_texts.h"

namespace mien::pipeline {

namespace {

nlohmann::ordered_json as_json(const FrameComparison& frame) {
  nlohmann::ordered_json json = {{"frame", frame.frame}, {"same", frame.same}};
  if (frame.same || !frame.same_size) {
    json["same_size"] = frame.same_size;
    return json;
  }
  json["largest"] = frame.difference.largest;
  json["rms"] = frame.difference.rms;
  json["openimageio"] = {{"largest", frame.openimageio_difference.largest},
                         {"rms", frame.openimageio_difference.rms}};
  json["flip_mean"] = frame.perceived.mean;
  json["flip_max"] = frame.perceived.largest;
  json["ssim"] = frame.similarity;
  json["noise"] = {{"tests", frame.noise.tests},           {"outside", frame.noise.outside},
                   {"largest_t", frame.noise.largest_t},   {"least_p", frame.noise.least_p},
                   {"together_p", frame.noise.together_p}, {"is_bias", frame.noise.is_bias}};
  nlohmann::ordered_json shares = nlohmann::ordered_json::object();
  for (const BodyShare& share : frame.shares)
    shares[share.part.empty() ? "unexplained" : share.part] = share.share;
  if (!frame.shares.empty()) json["explained_by"] = shares;
  return json;
}

nlohmann::ordered_json as_json(const motion::MotionDifference& motion) {
  nlohmann::ordered_json joints = nlohmann::ordered_json::object();
  for (const motion::JointDifference& joint : motion.joints)
    joints[joint.part] = {{"most_m", motion::peak_of(joint.point_m).value},
                          {"most_turn_rad", motion::peak_of(joint.turn_radians).value},
                          {"does_it_itself", joint.differs_itself()}};
  nlohmann::ordered_json json = {{"mpjpe_m", motion.errors.mpjpe},
                                 {"pa_mpjpe_m", motion.errors.pa_mpjpe}};
  if (motion.body) json["d_m"] = motion.body->d_m;
  json["joints"] = joints;
  return json;
}

nlohmann::ordered_json as_json(const StimulusComparison& one) {
  nlohmann::ordered_json json = {{"id", one.id}, {"verdict", name_of(one.verdict)}};
  if (!one.reasons.empty()) json["reasons"] = one.reasons;
  nlohmann::ordered_json causes = nlohmann::ordered_json::array();
  for (const Attribution& cause : one.causes) {
    nlohmann::ordered_json entry = {
        {"cause", name_of(cause.cause)}, {"root", cause.root}, {"evidence", cause.evidence}};
    if (cause.share) entry["share"] = *cause.share;
    causes.push_back(std::move(entry));
  }
  if (!one.causes.empty()) {
    json["causes"] = causes;
    json["interaction"] = one.interaction;
  }
  for (const SettingChange& change : one.settings)
    json["settings"][change.path] = {{"before", change.before}, {"now", change.now}};
  for (const ValueChange& change : one.weights)
    json["weights"][change.name] = {change.before, change.now};
  for (const ValueChange& change : one.parameters)
    json["parameters"][change.name] = {change.before, change.now};
  if (one.motion) json["motion"] = as_json(*one.motion);
  for (const FrameComparison& frame : one.frames) json["frames"].push_back(as_json(frame));
  json["frames_reused"] = one.frames_reused;
  for (const VideoChange& video : one.videos) json["videos"][video.format] = video.what;
  return json;
}

}  // namespace

nlohmann::ordered_json as_json(const Regression& regression) {
  nlohmann::ordered_json counts = nlohmann::ordered_json::object();
  for (const auto& [word, verdict] : verdict_words) counts[word] = regression.count(verdict);
  nlohmann::ordered_json groups = nlohmann::ordered_json::array();
  for (const CauseGroup& group : regression.groups)
    groups.push_back({{"cause", name_of(group.cause)},
                      {"root", group.root},
                      {"differs", group.differs},
                      {"stimuli", group.ids}});
  nlohmann::ordered_json stimuli = nlohmann::ordered_json::array();
  for (const StimulusComparison& one : regression.stimuli) stimuli.push_back(as_json(one));
  return {{"study", regression.study},
          {"passes", regression.passes()},
          {"counts", counts},
          {"groups", groups},
          {"gate", {{"holds", regression.gate.holds()}, {"what", gate_text(regression.gate)}}},
          {"repetitions",
           {{"times", regression.repetitions.times},
            {"differing", regression.repetitions.differing},
            {"largest", regression.repetitions.largest}}},
          {"wider_limits", regression.wider},
          {"not_compared", regression.not_compared},
          {"audited", regression.audited},
          {"without_approved_videos", regression.without_videos},
          {"stimuli", stimuli}};
}

}  // namespace mien::pipeline
