#include "pipeline/regression/baseline_json.h"

namespace mien::pipeline {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const NamedValues& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = value;
  return json;
}

NamedValues values_of(const Json& json) {
  NamedValues values;
  for (const auto& [name, value] : json.items()) values.emplace_back(name, value.get<double>());
  return values;
}

Json json_of(const Origin& origin) {
  return {{"mien", origin.program},
          {"motion_code", origin.motion_code},
          {"film_code", origin.film_code},
          {"libraries", origin.libraries},
          {"processor", origin.processor}};
}

Origin origin_of(const Json& json) {
  return {.program = json.at("mien"),
          .motion_code = json.at("motion_code"),
          .film_code = json.at("film_code"),
          .libraries = json.at("libraries"),
          .processor = json.at("processor")};
}

/// Options by what they change: those of one aspect stand together.
Json json_of(const std::vector<Setting>& settings) {
  Json json = Json::object();
  for (const auto& [word, aspect] : aspect_words) {
    Json some = Json::object();
    for (const Setting& setting : settings)
      if (setting.aspect == aspect) some[setting.path] = Json::parse(setting.value);
    json[word] = std::move(some);
  }
  return json;
}

std::vector<Setting> settings_of(const Json& json) {
  std::vector<Setting> settings;
  for (const auto& [word, aspect] : aspect_words)
    for (const auto& [path, value] : json.at(word).items())
      settings.push_back({path, aspect, value.dump()});
  return settings;
}

Json json_of(const RegressionLimits& limits) {
  return {{"position_mm", limits.position_mm},   {"turn_degrees", limits.turn_degrees},
          {"speed_m_s", limits.speed_m_s},       {"contact_seconds", limits.contact_seconds},
          {"slide_mm", limits.slide_mm},         {"findings", limits.findings},
          {"perceptual", limits.perceptual},     {"psnr_db", limits.psnr_db},
          {"parts_mm", json_of(limits.parts_mm)}};
}

RegressionLimits limits_of(const Json& json) {
  return {.position_mm = json.at("position_mm"),
          .turn_degrees = json.at("turn_degrees"),
          .speed_m_s = json.at("speed_m_s"),
          .contact_seconds = json.at("contact_seconds"),
          .slide_mm = json.at("slide_mm"),
          .findings = json.at("findings"),
          .perceptual = json.at("perceptual"),
          .psnr_db = json.at("psnr_db"),
          .parts_mm = values_of(json.at("parts_mm"))};
}

}  // namespace

Json json_of(const StimulusFacts& facts) {
  Json frames = Json::object();
  for (const KeyFrame& frame : facts.key_frames) frames[std::to_string(frame.frame)] = frame.pixels;
  Json videos = Json::array();
  for (const VideoFacts& video : facts.videos) {
    Json one = video_json(video.record);
    one["hash"] = video.hash;
    one["first_film_frame"] = video.first_film_frame;
    videos.push_back(std::move(one));
  }
  return {{"id", facts.id},
          {"edition", facts.edition},
          {"origin", json_of(facts.origin)},
          {"settings", json_of(facts.settings)},
          {"weights", json_of(facts.weights)},
          {"asked", json_of(facts.asked)},
          {"reached", json_of(facts.reached)},
          {"findings", facts.findings},
          {"motion", facts.motion},
          {"scene", facts.scene},
          {"drawing", facts.drawing},
          {"frames", facts.frames},
          {"fps", facts.fps},
          {"limits", json_of(facts.limits)},
          {"key_frames", frames},
          {"videos", videos},
          {"files", facts.files}};
}

StimulusFacts stimulus_facts_of(const Json& json) {
  StimulusFacts facts{.id = json.at("id"),
                      .edition = json.at("edition"),
                      .origin = origin_of(json.at("origin")),
                      .settings = settings_of(json.at("settings")),
                      .weights = values_of(json.at("weights")),
                      .asked = values_of(json.at("asked")),
                      .reached = values_of(json.at("reached")),
                      .findings = json.at("findings"),
                      .motion = json.at("motion"),
                      .scene = json.at("scene"),
                      .drawing = json.at("drawing"),
                      .frames = json.at("frames"),
                      .fps = json.at("fps"),
                      .limits = limits_of(json.at("limits")),
                      .key_frames = {},
                      .videos = {},
                      .files = json.at("files")};
  for (const auto& [frame, pixels] : json.at("key_frames").items())
    facts.key_frames.push_back({std::stoi(frame), pixels});
  for (const Json& video : json.at("videos"))
    facts.videos.push_back(
        {video_record_of(video), video.at("hash"), video.value("first_film_frame", 0)});
  return facts;
}

Json json_of(const Approval& approval) {
  Json json = {{"who", approval.who}, {"when", approval.when}, {"why", approval.why}};
  if (!approval.only.empty()) json["only"] = approval.only;
  return json;
}

Approval approval_of(const Json& json) {
  return {.who = json.at("who"),
          .when = json.at("when"),
          .why = json.at("why"),
          .only = json.value("only", std::vector<std::string>{})};
}

}  // namespace mien::pipeline
