#include "pipeline/production/synthesis/motions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/examples/flight_examples.h"
#include "motion/examples/settled_feet.h"
#include "motion/gait/contact.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/recording_files.h"
#include "pipeline/production/clips/people_clips.h"
#include "pipeline/production/synthesis/walked_path.h"

namespace mien::pipeline {

namespace {

/// The place of a script's step in the manifest, at its turn if it has one.
Place place_of_step(const Manifest& manifest, const Stimulus& stimulus, std::size_t step) {
  const std::string path = member_path(stimulus.path, "path");
  const std::string map = member_path(path, "script");
  const bool is_map = manifest.places.values.contains(map);
  return place_of(manifest.places, member_path(element_path(is_map ? map : path, step), "turn"));
}

bool is_file(const Stimulus* stimulus) { return stimulus != nullptr && stimulus->clip; }

}  // namespace

struct Motions::Entry {
  std::once_flag once;
  std::optional<Synthesis> synthesis;
  std::once_flag measured_once;
  std::optional<motion::Example> settled;  ///< of a motion file
};

Motions::Motions(const Manifest& manifest) : manifest_(manifest) {}

Motions::~Motions() = default;

const Repertoire& Motions::repertoire() {
  std::call_once(repertoire_once_, [this] { repertoire_ = load_repertoire(manifest_); });
  return *repertoire_;
}

const Stimulus* Motions::stimulus(const std::string& id) const {
  std::call_once(stimuli_once_, [this] {
    for (const Stimulus& one : manifest_.stimuli) stimuli_.emplace(one.id, &one);
    for (const Stimulus* motion : motion_sources(manifest_)) stimuli_.emplace(motion->id, motion);
  });
  const auto found = stimuli_.find(id);
  return found == stimuli_.end() ? nullptr : found->second;
}

const Synthesis& Motions::of(const std::string& name) {
  Entry& found = entry(name);
  std::call_once(found.once, [&] { found.synthesis = make(name); });
  return *found.synthesis;
}

motion::Distance Motions::distance(const std::string& target, const std::string& created) {
  if (!is_file(stimulus(target)) && !is_file(stimulus(created))) {
    return motion::distance(measured(target), measured(created));
  }
  motion::Example of_target = measured(target);
  motion::Example of_created = measured(created);
  motion::match_keytimes(of_target, of_created);
  return motion::distance(of_target, of_created);
}

const motion::Example& Motions::measured(const std::string& name) {
  const motion::Example& made = of(name).motion;
  const Stimulus* requested = stimulus(name);
  if (requested == nullptr || !requested->clip || motion::stays_in_place(made.clip)) return made;
  Entry& found = entry(name);
  std::call_once(found.measured_once, [&] {
    found.settled = made;
    found.settled->clip = motion::with_settled_feet(made.clip);
  });
  return *found.settled;
}

motion::Clip Motions::shown(const Stimulus& stimulus) {
  motion::Clip shown = playback_clip(clip(stimulus.id), stimulus.output);
  const int frames = cut_to_shortest(shown.frame_count(), shown.frames_per_second);
  return frames == shown.frame_count() ? shown : motion::cut(shown, 0, frames - 1);
}

int Motions::shown_frames(const Stimulus& stimulus) {
  return cut_to_shortest(own_frames(stimulus, *this), stimulus.output.fps);
}

int Motions::cut_to_shortest(int frames, double frames_per_second) {
  if (!manifest_.equalize.duration) return frames;
  const double most = std::max(1.0, std::round(shortest_seconds() * frames_per_second));
  return std::min(frames, static_cast<int>(most));
}

double Motions::shortest_seconds() {
  std::call_once(shortest_once_, [this] {
    shortest_s_ = std::numeric_limits<double>::infinity();
    for (const Stimulus& one : manifest_.stimuli) {
      shortest_s_ = std::min(shortest_s_, own_frames(one, *this) / one.output.fps);
    }
  });
  return shortest_s_;
}

void Motions::know_shortest(double seconds) {
  std::call_once(shortest_once_, [&] { shortest_s_ = seconds; });
}

Motions::Entry& Motions::entry(const std::string& name) {
  const std::lock_guard guard(mutex_);
  std::unique_ptr<Entry>& found = entries_[name];
  if (!found) found = std::make_unique<Entry>();
  return *found;
}

Synthesis Motions::make(const std::string& name) {
  const Stimulus* requested = stimulus(name);
  if (requested == nullptr) {
    return synthesize_example(name, manifest_.output, manifest_.interpolation, repertoire());
  }
  if (!requested->people.empty()) {
    throw Error("\"" + name + "\" has several people, each with a motion",
                "name one of them, such as " + requested->people.front().motion.id);
  }
  try {
    return synthesized(*requested);
  } catch (const UnwalkableStep& fault) {
    throw fault.at(place_of_step(manifest_, *requested, fault.step()));
  }
}

Synthesis Motions::synthesized(const Stimulus& requested) {
  // A file or a path needs no examples, unless its modifications do; there may be none.
  if (!is_blend(requested) && !names_examples(requested))
    return synthesize(requested, Repertoire{});
  return synthesize(requested, repertoire());
}

bool blends_examples(const Manifest& manifest) {
  return std::ranges::any_of(motion_sources(manifest),
                             [](const Stimulus* motion) { return is_blend(*motion); });
}

const Stimulus* find_stimulus(const Manifest& manifest, const std::string& id) {
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.id == id) return &stimulus;
    for (const Person& person : stimulus.people) {
      if (person.motion.id == id) return &person.motion;
    }
  }
  return nullptr;
}

}  // namespace mien::pipeline
