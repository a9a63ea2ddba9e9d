#include "pipeline/regression/rendition.h"

#include <algorithm>
#include <array>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/derived_seed.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/synthesis/durations_task.h"
#include "pipeline/production/synthesis/motion_record.h"
#include "pipeline/production/synthesis/motion_task.h"
#include "pipeline/regression/settings.h"
#include "pipeline/tasks/parallel.h"
#include "pipeline/tasks/task_graph.h"
#include "render/image/tone.h"

namespace mien::pipeline {

namespace {

/// Makes what the films of a study have in common.
void equalize(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions,
              const std::filesystem::path& folder, int threads, const std::stop_token& stop) {
  if (manifest.equalize == Equalize{}) return;
  TaskGraph graph;
  for (const Stimulus* motion : motion_sources(manifest))
    graph.add(motion_task(*motion, shared, motions));
  if (manifest.equalize.duration) graph.add(durations_task(manifest, shared, motions));
  const FilmSettings settings{.seed = manifest.seed, .threads = threads};
  for (Task& task : equalizing_tasks(manifest, shared, settings, motions))
    graph.add(std::move(task));
  Store store(folder);
  for (const TaskOutcome& outcome : run(graph, store, threads, stop, {})) {
    if (outcome.state == TaskState::interrupted) throw Interrupted{};
    if (outcome.state == TaskState::failed)
      throw Error(outcome.error, "mien check shows what can be equalized");
  }
}

/// The stimulus that shows a motion, of which there may be several.
const Stimulus& stimulus_of(const Rendition& rendition, const std::string& id) {
  return *film_showing(rendition.manifest(), id);
}

/// The clips of all people of the scene's film: that of `id` as given, and the others from the
/// rendition of the motion or, where it lacks them, from that of the scene.
std::vector<motion::Clip> people_of(const Stimulus& film, const std::string& id,
                                    const motion::Clip& clip, const FrameSources& sources) {
  std::vector<motion::Clip> clips;
  for (const Stimulus* motion : motions_in(film)) {
    const bool is_there = find_stimulus(sources.motion->manifest(), motion->id) != nullptr;
    Rendition& from = is_there ? *sources.motion : *sources.scene;
    clips.push_back(motion->id == id
                        ? clip
                        : motion::resampled(from.clip_of(motion->id), clip.frames_per_second));
  }
  return clips;
}

scenes::Shot shot_with(const std::string& id, const motion::Clip& clip, const FrameSources& sources,
                       const Framing& framing) {
  const Stimulus& film = stimulus_of(*sources.scene, id);
  const std::uint64_t seed = sources.scene->manifest().seed;
  if (film.people.empty()) return shot_of(film, clip, seed, framing);
  return shot_of(film, people_of(film, id, clip, sources), seed, framing);
}

/// Gives `output` the options of another that concern any of these.
void take_options(Output& output, const Output& other, unsigned concerned) {
  const nlohmann::json options = nested_map(entries_of(other, {.concerned = concerned}));
  const Places nowhere{};
  read({options, "", {nowhere, {}}}, output);
}

/// The output that a frame is drawn with: the scene's, with how it moves and how it is drawn from
/// others.
Output output_of(const FrameSources& sources, const std::string& id) {
  Output output = stimulus_of(*sources.scene, id).output;
  take_options(output, stimulus_of(*sources.drawing, id).output, concerns::drawing);
  output.fps = sources.clip != nullptr ? sources.clip->frames_per_second
                                       : stimulus_of(*sources.motion, id).output.fps;
  output.frames = FrameFormat::none;
  return output;
}

/// The light that a display gives.
render::Framebuffer as_light(const render::Image8& picture) {
  std::array<float, 256> light{};
  for (std::size_t level = 0; level < light.size(); ++level)
    light[level] = static_cast<float>(render::linear_from_srgb(static_cast<double>(level) / 255.0));
  render::Framebuffer film(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) film.at(x, y)[c] = light[picture.at(x, y)[c]];
  return film;
}

/// Shares that round to nothing are none.
constexpr double least_weight = 1e-9;

NamedValues weights_of(const Synthesis& made, const Repertoire& repertoire) {
  NamedValues weights;
  for (Eigen::Index e = 0; e < made.weights.size(); ++e) {
    const double weight = made.weights[e];
    if (std::abs(weight) > least_weight)
      weights.emplace_back(repertoire.names[static_cast<std::size_t>(e)].name, weight);
  }
  return weights;
}

}  // namespace

Rendition::Rendition(Manifest manifest, const std::filesystem::path& folder, int threads,
                     const std::stop_token& stop)
    : manifest_(std::move(manifest)), motions_(manifest_) {
  equalize(manifest_, shared_determinants(manifest_, files_), motions_, folder, threads, stop);
  equalized_ = equalized_films(manifest_.equalize, folder, motions_);
}

const motion::Clip& Rendition::clip_of(const std::string& id) {
  const auto known = clips_.find(id);
  if (known != clips_.end()) return known->second;
  const Stimulus& film = stimulus_of(*this, id);
  if (film.people.empty()) return clips_.emplace(id, staged_clip(film, motions_)).first->second;
  std::vector<motion::Clip> people = placed_people(film, motions_);
  for (std::size_t i = 0; i < people.size(); ++i)
    clips_.emplace(film.people[i].motion.id, std::move(people[i]));
  return clips_.at(id);
}

Hash Rendition::scene_key(const std::string& id) {
  Stimulus scene = stimulus_of(*this, id);
  take_options(scene.output, {}, concerns::motion | concerns::drawing);
  KeyBuilder key;
  add_film(key, scene, files_);
  const Equalized equal = alike(id);
  key.add("stops", equal.exposure_stops);
  if (equal.framing.figure_px) key.add("size", *equal.framing.figure_px);
  if (equal.framing.figure_place) {
    key.add("x", equal.framing.figure_place->front());
    key.add("y", equal.framing.figure_place->back());
  }
  if (scenes::kind_of(scene.look.figure).has_dots)
    key.add("dots", static_cast<std::int64_t>(manifest_.seed));
  if (!scene.people.empty()) {
    for (const Stimulus* other : motions_in(scene))
      if (other->id != id) key.add(other->id, digest_of(clip_of(other->id)));
  }
  return key.key();
}

Hash Rendition::drawing_key(const std::string& id) const {
  const Output& output = stimulus_of(*this, id).output;
  KeyBuilder key;
  for (const FieldEntry& option : entries_of(output, {.concerned = concerns::drawing})) {
    if (option.value.is_string())
      key.add(option.path, option.value.get<std::string>());
    else
      key.add(option.path, option.value.get<double>());
  }
  key.add("seed", static_cast<std::int64_t>(manifest_.seed));
  return key.key();
}

StagedFilm staged(const std::string& id, const FrameSources& sources, int threads) {
  const Equalized equal = sources.scene->alike(id);
  const motion::Clip& clip = sources.clip != nullptr ? *sources.clip : sources.motion->clip_of(id);
  StagedFilm film{shot_with(id, clip, sources, equal.framing),
                  {.output = output_of(sources, id),
                   .seed = sources.drawing->manifest().seed,
                   .threads = threads}};
  film.shot.tone.exposure_stops += equal.exposure_stops;
  return film;
}

std::vector<render::Image8> drawn(const StagedFilm& film, const std::vector<int>& frames,
                                  const std::stop_token& stop) {
  std::vector<render::Image8> pictures;
  draw_frames(
      film.shot, frames, film.settings, nullptr,
      [&](int, const render::Image8& picture) { pictures.push_back(picture); }, stop,
      [](double) {});
  return pictures;
}

std::vector<BlockStatistics> measured_blocks(const StagedFilm& film, const std::vector<int>& frames,
                                             const std::stop_token& stop) {
  if (frames.empty()) return {};
  std::vector<std::vector<render::Framebuffer>> patterns(frames.size());
  for (std::vector<render::Framebuffer>& of_frame : patterns) of_frame.resize(noise_patterns);
  // One thread a pattern: small pictures leave more of them little to do.
  for_each_of(noise_patterns, film.settings.threads, stop, [&](std::size_t k) {
    StagedFilm pattern{film.shot, film.settings};
    pattern.settings.seed = derived_seed(film.settings.seed, "pattern " + std::to_string(k + 1));
    pattern.settings.threads = 1;
    const std::vector<render::Image8> pictures = drawn(pattern, frames, stop);
    for (std::size_t i = 0; i < frames.size(); ++i) patterns[i][k] = as_light(pictures[i]);
  });
  std::vector<BlockStatistics> blocks;
  for (const std::vector<render::Framebuffer>& of_frame : patterns)
    blocks.push_back(block_statistics(of_frame));
  return blocks;
}

StimulusFacts facts_of(const std::string& id, Rendition& rendition) {
  const Stimulus& stimulus = *find_stimulus(rendition.manifest(), id);
  const motion::Clip& clip = rendition.clip_of(id);
  const Synthesis& made = rendition.motions().of(id);
  StimulusFacts facts{
      .id = id,
      .edition = {},
      .origin = this_origin(),
      .settings = settings_of(stimulus_of(rendition, id), rendition.manifest(), rendition.files()),
      .weights = {},
      .requested = made.requested,
      .reached = made.reached,
      .findings = {},
      .motion = digest_of(clip),
      .scene = rendition.scene_key(id),
      .drawing = rendition.drawing_key(id),
      .frames = clip.frame_count(),
      .fps = clip.frames_per_second,
      .limits = stimulus.regression,
      .key_frames = {},
      .videos = {}};
  if (made.weights.size() > 0) facts.weights = weights_of(made, rendition.motions().repertoire());
  for (const motion::Finding& finding : made.findings) facts.findings.push_back(finding.sentence);
  return facts;
}

}  // namespace mien::pipeline
