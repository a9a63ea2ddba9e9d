#include "pipeline/study/studio/studio_motions.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "motion/examples/compared_example.h"
#include "motion/gait/contact.h"
#include "motion/live/live_core.h"
#include "motion/live/live_message.h"
#include "motion/measures/distance/distance.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "pipeline/manifest/recording_files.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/study/figures/figure_message.h"
#include "pipeline/study/live/live_bundle_writer.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t max_studies = 4;
constexpr std::size_t max_motions = 48;

ordered_json findings_json(const std::vector<motion::Finding>& findings) {
  ordered_json list = ordered_json::array();
  for (const motion::Finding& finding : findings)
    list.push_back({{"check", finding.check},
                    {"joint", finding.joint},
                    {"first", finding.first},
                    {"last", finding.last},
                    {"is_error", finding.severity == motion::Severity::error},
                    {"sentence", finding.sentence}});
  return list;
}

ordered_json values_json(const NamedValues& values) {
  ordered_json map = ordered_json::object();
  for (const auto& [name, value] : values) map[name] = value;
  return map;
}

/// Weights of the examples with non-zero weight.
ordered_json weights_json(const Synthesis& synthesis, const Repertoire& repertoire) {
  ordered_json map = ordered_json::object();
  for (Eigen::Index i = 0; i < synthesis.weights.size(); ++i)
    if (synthesis.weights[i] != 0.0)
      map[repertoire.names[static_cast<std::size_t>(i)].name] = synthesis.weights[i];
  return map;
}

ordered_json distance_json(const motion::Distance& distance) {
  return {{"D", distance.mean},
          {"D_sum", distance.sum},
          {"by_joint", distance.by_joint()},
          {"by_time", distance.by_time()}};
}

DraftFaults as_fault(const std::string& path, const Error& error) {
  return DraftFaults({{{}, path, error.what(), ""}});
}

std::string text_of(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

bool has_stimuli(const ordered_json& about) {
  return about.contains("stimuli") && !about["stimuli"].empty();
}

/// Figures take longer to check than motions take to synthesize.
ordered_json without_looks(ordered_json document) {
  document.erase("look");
  if (!document.contains("stimuli") || !document["stimuli"].is_array()) return document;
  for (ordered_json& stimulus : document["stimuli"])
    if (stimulus.is_object()) stimulus.erase("look");
  return document;
}

/// A key of the looks of a document, and of its stimuli with their roles.
std::string looks_of(const ordered_json& about) {
  ordered_json looks = {about.value("look", ordered_json())};
  for (const ordered_json& stimulus : about.value("stimuli", ordered_json::array())) {
    if (!stimulus.is_object()) continue;
    looks.push_back(stimulus.value("look", ordered_json()));
    looks.push_back(stimulus.value("role", ordered_json()));
  }
  return text_of(looks);
}

/// Of the film, in which loops are repeated.
int film_frames(const motion::Clip& clip, const Output& output) {
  return clip.loops ? output.cycles * clip.frame_count() : clip.frame_count();
}

using Moment = std::chrono::steady_clock::time_point;

double seconds_since(Moment begun) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

/// The answer for several people, whose first is the motion of the timeline.
std::string people_answer(const PeopleOfFilm& film, PeopleMessage message, Moment begun) {
  message.head["figures"] = message.keys;
  const motion::Clip& first = film.shown.people.front().clip;
  const ordered_json head = {{"body", body_info(first.body)},
                             {"hands", nullptr},
                             {"findings", findings_json(film.findings)},
                             {"warnings", film.warnings},
                             {"notes", film.notes},
                             {"reached", ordered_json::object()},
                             {"weights", ordered_json::object()},
                             {"modified", ""},
                             {"seconds", seconds_since(begun)},
                             {"distance", nullptr},
                             {"figure", figure_json({})},
                             {"people", std::move(message.head)}};
  const motion::LiveMotion live{{.clip = first}, {}, motion::foot_plants(first)};
  return framed(head, motion::to_message(live) + message.bytes);
}

/// The file with that key; empty if there is none.
std::string file_named(const std::string& key, const PeopleMessage& message) {
  const auto found = std::ranges::find(message.keys, key);
  if (found == message.keys.end()) return "";
  return message.files[static_cast<std::size_t>(found - message.keys.begin())];
}

const motion::Example& compared(StudioMotion& made) {
  if (!made.compared)
    made.compared =
        motion::compared_example_as_written(playback_clip(made.synthesis.motion.clip, made.output));
  return *made.compared;
}

}  // namespace

/// With all motions, of which some were made from them.
void StudioMotions::forget_changed_examples() {
  const auto have_changed = [](const Study& study) { return !study.files.are_unchanged(); };
  if (std::erase_if(studies_, have_changed) > 0) motion_cache_.clear();
}

Motions& StudioMotions::study(const ordered_json& document) {
  const std::string key = examples_key(document);
  const auto found = std::find_if(studies_.begin(), studies_.end(),
                                  [&](const Study& study) { return study.key == key; });
  if (found != studies_.end()) {
    if (found != studies_.begin()) std::rotate(studies_.begin(), found, found + 1);
    return *studies_.front().motions;
  }
  auto manifest = std::make_unique<const Manifest>(reader_.read_examples(document));
  auto motions = std::make_unique<Motions>(*manifest);
  SeenFiles files(files_of_examples(*manifest));
  studies_.push_front({key, std::move(manifest), std::move(motions), std::move(files)});
  if (studies_.size() > max_studies) studies_.pop_back();
  return *studies_.front().motions;
}

StudioMotions::CachedMotion StudioMotions::made(const ordered_json& document,
                                                const std::string& name) {
  const ordered_json about = without_looks(document_excerpt(document, {name}));
  const std::string key = name + "\n" + text_of(about);
  std::erase_if(motion_cache_, [&](const auto& entry) {
    return entry.first == key && !entry.second->files.are_unchanged();
  });
  for (const auto& [cached_key, cached] : motion_cache_)
    if (cached_key == key) return cached;
  const Manifest manifest = has_stimuli(about) ? reader_.read(about) : reader_.read_examples(about);
  const Stimulus* stimulus = find_stimulus(manifest, name);
  if (stimulus != nullptr && !stimulus->people.empty())
    throw Error("\"" + name + "\" has several people, with whom no motion can be compared",
                "compare it with a stimulus of one motion");
  SeenFiles files(stimulus != nullptr ? files_of_motion(manifest, *stimulus)
                                      : std::vector<std::filesystem::path>());
  auto motion = std::make_shared<StudioMotion>(StudioMotion{
      {}, stimulus != nullptr ? stimulus->output : manifest.output, std::move(files), {}});
  // As in a run: stimuli from a file or a path need no examples.
  if (stimulus != nullptr && !is_blend(*stimulus) && !names_examples(*stimulus)) {
    motion->synthesis = synthesize(*stimulus, Repertoire{});
  } else {
    const Repertoire& repertoire = study(document).repertoire();
    motion->synthesis =
        stimulus != nullptr
            ? synthesize(*stimulus, repertoire)
            : synthesize_example(name, motion->output, manifest.interpolation, repertoire);
  }
  motion_cache_.emplace_front(key, motion);
  if (motion_cache_.size() > max_motions) motion_cache_.pop_back();
  return motion;
}

StudioMotions::Shown StudioMotions::shown(const ordered_json& document, const std::string& name) {
  const ordered_json about = document_excerpt(document, {name});
  const std::string key = name + "\n" + looks_of(about);
  for (const auto& [cached_key, cached] : shown_cache_)
    if (cached_key == key) return cached;
  const Manifest manifest = has_stimuli(about) ? reader_.read(about) : reader_.read_examples(about);
  const Stimulus* stimulus = find_stimulus(manifest, name);
  shown_cache_.emplace_front(
      key, stimulus == nullptr
               ? Shown{shown_figure(manifest.look), manifest.look.hands}
               : Shown{shown_figure(stimulus->look), stimulus->look.hands, stimulus->role});
  if (shown_cache_.size() > max_motions) shown_cache_.pop_back();
  return shown_cache_.front().second;
}

std::string StudioMotions::motion(const ordered_json& document, const std::string& show,
                                  const std::string& against) {
  const std::lock_guard lock(mutex_);
  forget_changed_examples();
  const auto begun = std::chrono::steady_clock::now();
  try {
    if (const auto people = people_.of(document, show))
      return people_answer(*people, people_message(people->shown, figures_), begun);
    const CachedMotion motion = made(document, show);
    ordered_json distance;
    if (!against.empty())
      distance =
          distance_json(motion::distance(compared(*made(document, against)), compared(*motion)));
    const Synthesis& synthesis = motion->synthesis;
    const Shown on = shown(document, show);
    const motion::Clip clip = scenes::with_shown_hands(synthesis.motion.clip, on.hands);
    const PageFigure figure =
        figures_.fitted_figure({.figure = on.figure,
                                .colours = scenes::colours_of(on.role),
                                .clip = clip,
                                .film_frames = film_frames(clip, motion->output)});
    const ordered_json weights = synthesis.weights.size() == 0
                                     ? ordered_json::object()
                                     : weights_json(synthesis, study(document).repertoire());
    const motion::Skeleton& body = clip.body;
    const ordered_json head = {
        {"body", body_info(body)},
        {"hands", motion::is_body(body) ? body_info(motion::with_fingers(body)) : ordered_json()},
        {"findings", findings_json(synthesis.findings)},
        {"warnings", synthesis.warnings},
        {"notes", synthesis.notes},
        {"reached", values_json(synthesis.reached)},
        {"weights", weights},
        {"modified", synthesis.modified},
        {"seconds", seconds_since(begun)},
        {"distance", distance},
        {"figure", figure_json(figure)},
        {"people", nullptr}};
    const motion::LiveMotion live{synthesis.motion, synthesis.weights,
                                  motion::foot_plants(synthesis.motion.clip)};
    return framed(head, motion::to_message(live) + figure.poses + figure.face);
  } catch (const Error& error) {
    throw as_fault("", error);
  }
}

std::string StudioMotions::figure(const ordered_json& document, const std::string& show,
                                  const std::string& key) {
  const std::lock_guard lock(mutex_);
  forget_changed_examples();
  try {
    if (const auto people = people_.of(document, show))
      return file_named(key, people_message(people->shown, figures_));
    const Shown on = shown(document, show);
    const CachedMotion motion = made(document, show);
    const motion::Clip clip = scenes::with_shown_hands(motion->synthesis.motion.clip, on.hands);
    return figures_.file(
        key, {.figure = on.figure, .colours = scenes::colours_of(on.role), .clip = clip});
  } catch (const Error& error) {
    throw as_fault("", error);
  }
}

ordered_json StudioMotions::choices(const ordered_json& document) {
  const std::lock_guard lock(mutex_);
  forget_changed_examples();
  const Manifest manifest = reader_.read_examples(document);
  try {
    Motions& motions = study(document);
    const Repertoire& repertoire = motions.repertoire();
    ordered_json examples = ordered_json::array();
    for (const RatedExample& example : repertoire.names) examples.push_back(example.name);
    ordered_json sliders = {{"adjectives", ordered_json::array()},
                            {"features", ordered_json::array()}};
    if (repertoire.examples.blendable) {
      const motion::LiveBundle bundle = live_bundle(manifest, motions, live_choice(manifest));
      sliders = live_info(bundle, repertoire.scales, {}).at("sliders");
    }
    return {{"examples", examples},
            {"sliders", sliders},
            {"blendable", repertoire.examples.blendable},
            {"simulated", repertoire.simulated_ratings},
            {"warnings", repertoire.warnings}};
  } catch (const Error& error) {
    throw as_fault("examples", error);
  }
}

}  // namespace mien::pipeline
