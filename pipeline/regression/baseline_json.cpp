#include "pipeline/regression/baseline_json.h"

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

namespace {

using Json = nlohmann::ordered_json;

// Conversions of types without a list of members.

Json as_kept(const NamedValues& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = value;
  return json;
}

void take_kept(const Json& json, NamedValues& values) {
  for (const auto& [name, value] : json.items()) values.emplace_back(name, value.get<double>());
}

/// Options by what they change: those of one aspect stand together.
Json as_kept(const std::vector<Setting>& settings) {
  Json json = Json::object();
  for (const auto& [word, aspect] : aspect_words) {
    Json some = Json::object();
    for (const Setting& setting : settings)
      if (setting.aspect == aspect) some[setting.path] = Json::parse(setting.value);
    json[word] = std::move(some);
  }
  return json;
}

void take_kept(const Json& json, std::vector<Setting>& settings) {
  for (const auto& [word, aspect] : aspect_words)
    for (const auto& [path, value] : json.at(word).items())
      settings.push_back({path, aspect, value.dump()});
}

Json as_kept(const std::vector<KeyFrame>& key_frames) {
  Json frames = Json::object();
  for (const KeyFrame& frame : key_frames) frames[std::to_string(frame.frame)] = frame.pixels;
  return frames;
}

void take_kept(const Json& json, std::vector<KeyFrame>& key_frames) {
  for (const auto& [frame, pixels] : json.items()) key_frames.push_back({std::stoi(frame), pixels});
}

Json as_kept(const std::vector<VideoFacts>& facts) {
  Json videos = Json::array();
  for (const VideoFacts& video : facts) {
    videos.push_back(video_json(video.record));
    videos.back()["hash"] = video.hash;
    videos.back()["first_film_frame"] = video.first_film_frame;
  }
  return videos;
}

void take_kept(const Json& json, std::vector<VideoFacts>& videos) {
  for (const Json& video : json)
    videos.push_back(
        {video_record_of(video), video.at("hash"), video.value("first_film_frame", 0)});
}

// Members in the order in which they stand there, by which records are written and read.

void fields_of(auto&& field, MaybeConst<Origin> auto& origin) {
  field("mien", origin.program);
  field("motion_code", origin.motion_code);
  field("film_code", origin.film_code);
  field("libraries", origin.libraries);
  field("processor", origin.processor);
}

void fields_of(auto&& field, MaybeConst<StimulusFacts> auto& facts) {
  field("id", facts.id);
  field("edition", facts.edition);
  field("origin", facts.origin);
  field("settings", facts.settings);
  field("weights", facts.weights);
  field("asked", facts.requested);
  field("reached", facts.reached);
  field("findings", facts.findings);
  field("motion", facts.motion);
  field("scene", facts.scene);
  field("drawing", facts.drawing);
  field("frames", facts.frames);
  field("fps", facts.fps);
  field("limits", facts.limits);
  field("key_frames", facts.key_frames);
  field("videos", facts.videos);
  field("files", facts.files);
}

template <class Value>
concept HasMembers = requires(Value& value) {
  fields_of([](auto&&...) {}, value);
};

template <class Value>
Json as_kept(const Value& value) {
  if constexpr (HasMembers<const Value>) {
    Json json;
    fields_of([&](const char* key, auto& member, auto...) { json[key] = as_kept(member); }, value);
    return json;
  } else {
    return value;
  }
}

template <class Value>
void take_kept(const Json& json, Value& value) {
  if constexpr (HasMembers<Value>)
    fields_of([&](const char* key, auto& member, auto...) { take_kept(json.at(key), member); },
              value);
  else
    json.get_to(value);
}

}  // namespace

Json json_of(const StimulusFacts& facts) { return as_kept(facts); }

StimulusFacts stimulus_facts_of(const Json& json) {
  StimulusFacts facts;
  take_kept(json, facts);
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
