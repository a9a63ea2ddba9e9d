#include "pipeline/manifest/stimulus_sound.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/manifest/derived_seed.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

namespace {

/// More than are ever needed if all things differ: a random order is such an exchange with a
/// probability of 1/e.
constexpr int most_tries = 200;

std::string audio_path(const Stimulus& stimulus, const char* key) {
  return member_path(member_path(stimulus.path, "audio"), key);
}

/// A random order of places: that of numbers drawn for their names.
std::vector<std::size_t> drawn_order(const std::vector<std::string>& names, std::uint64_t seed,
                                     const std::string& draw) {
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::uint64_t> numbers;
  for (const std::string& name : names) numbers.push_back(derived_seed(seed, draw + " " + name));
  std::ranges::stable_sort(order, {}, [&](std::size_t place) { return numbers[place]; });
  return order;
}

bool keeps_nothing(const std::vector<std::size_t>& sources, const std::vector<std::string>& owned) {
  for (std::size_t place = 0; place < sources.size(); ++place)
    if (owned[sources[place]] == owned[place]) return false;
  return true;
}

/// The number of places that have the most frequent thing.
std::size_t most_equal(const std::vector<std::string>& owned) {
  std::map<std::string, std::size_t> counts;
  std::size_t most = 0;
  for (const std::string& thing : owned) most = std::max(most, ++counts[thing]);
  return most;
}

/// The places in random order, equal things in succession, moved on by the number of the most
/// frequent.
std::vector<std::size_t> rotated(std::vector<std::size_t> order,
                                 const std::vector<std::string>& owned) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < order.size(); ++i) first.try_emplace(owned[order[i]], i);
  std::ranges::stable_sort(order, {}, [&](std::size_t place) { return first.at(owned[place]); });
  const std::size_t step = most_equal(owned);
  std::vector<std::size_t> sources(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    sources[order[i]] = order[(i + step) % order.size()];
  return sources;
}

std::vector<std::string> stimuli_with_files(const Manifest& manifest) {
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : manifest.stimuli)
    if (stimulus.audio && !stimulus.audio->file.empty()) ids.push_back(stimulus.id);
  return ids;
}

class SoundResolver : public FaultList {
 public:
  explicit SoundResolver(Manifest& manifest) : FaultList(manifest.places), manifest_(manifest) {}

  void resolve() {
    for (Stimulus& stimulus : manifest_.stimuli)
      if (stimulus.audio) resolve_own(stimulus, *stimulus.audio);
    if (manifest_.mismatch) exchange(*manifest_.mismatch);
  }

 private:
  void resolve_own(Stimulus& stimulus, const StatedSound& stated) {
    const std::string path = member_path(stimulus.path, "audio");
    if (stated.file.empty() == stated.from.empty()) {
      return add(path, stated.file.empty() ? "names no sound" : "names a file and a stimulus",
                 "give either file or from");
    }
    const Stimulus* owner = &stimulus;
    if (!stated.from.empty()) owner = owner_of(stimulus, stated.from);
    if (owner == nullptr) return;
    const StatedSound& source = *owner->audio;
    stimulus.sound = {source.file, source.offset, source.gain, stated.length, owner->id};
  }

  /// The stimulus whose sound another takes; nullptr, with a fault, if there is none.
  const Stimulus* owner_of(const Stimulus& stimulus, const std::string& from) {
    const std::string path = audio_path(stimulus, "from");
    for (const char* key : {"offset", "gain"}) {
      if (!was_given(audio_path(stimulus, key))) continue;
      add(audio_path(stimulus, key), "belongs to the sound of " + motion::in_quotes(from),
          "set it there, or give the file");
    }
    const auto named = std::ranges::find(manifest_.stimuli, from, &Stimulus::id);
    if (named == manifest_.stimuli.end()) {
      add(path, motion::in_quotes(from) + " is not a stimulus",
          motion::did_you_mean(from, stimuli_with_files(manifest_)));
    } else if (&*named == &stimulus) {
      add(path, "is this stimulus itself", "name another one, or give the file");
    } else if (!named->audio) {
      add(path, motion::in_quotes(from) + " has no sound", "name a stimulus with audio: file");
    } else if (named->audio->file.empty()) {
      add(path, motion::in_quotes(from) + " takes its sound from another stimulus",
          "name that one: " + motion::in_quotes(named->audio->from));
    } else {
      return &*named;
    }
    return nullptr;
  }

  /// The stimuli of `mismatch:`; nothing where one of them is at fault.
  std::optional<std::vector<Stimulus*>> exchanging(const Mismatch& mismatch) {
    std::vector<Stimulus*> stimuli;
    bool is_complete = true;
    for (Stimulus& stimulus : manifest_.stimuli) {
      is_complete &= !stimulus.audio || stimulus.sound;
      if (mismatch.stimuli.empty() && stimulus.sound) stimuli.push_back(&stimulus);
    }
    for (std::size_t i = 0; i < mismatch.stimuli.size(); ++i) {
      const std::string& id = mismatch.stimuli[i];
      const std::string path = element_path("mismatch.stimuli", i);
      const auto named = std::ranges::find(manifest_.stimuli, id, &Stimulus::id);
      if (named == manifest_.stimuli.end()) {
        std::vector<std::string> ids;
        for (const Stimulus& stimulus : manifest_.stimuli) ids.push_back(stimulus.id);
        add(path, motion::in_quotes(id) + " is not a stimulus", motion::did_you_mean(id, ids));
        is_complete = false;
      } else if (!named->audio) {
        add(path, motion::in_quotes(id) + " has no sound", "give it audio, or omit it here");
        is_complete = false;
      } else {
        stimuli.push_back(&*named);
      }
    }
    return is_complete ? std::optional(stimuli) : std::nullopt;
  }

  void exchange(const Mismatch& mismatch) {
    const auto stimuli = exchanging(mismatch);
    if (!stimuli) return;
    std::vector<std::string> names, owned;
    std::vector<StimulusSound> sounds;
    for (const Stimulus* stimulus : *stimuli) {
      const StimulusSound& sound = *stimulus->sound;
      names.push_back(stimulus->id);
      owned.push_back(sound.file.string() + " from " + shortest(sound.offset));
      sounds.push_back(sound);
    }
    const std::vector<std::size_t> sources = derangement(names, owned, mismatch.seed);
    if (sources.empty()) return refuse(sounds, owned);
    for (std::size_t i = 0; i < sounds.size(); ++i) {
      const SoundLength length = sounds[i].length;
      (*stimuli)[i]->sound = sounds[sources[i]];
      (*stimuli)[i]->sound->length = length;
    }
  }

  void refuse(const std::vector<StimulusSound>& sounds, const std::vector<std::string>& owned) {
    if (sounds.size() < 2) {
      const char* count = sounds.empty() ? "no stimulus has" : "only one stimulus has";
      return add("mismatch", fmt::format("{} a sound, so none can get another's", count),
                 "give audio to at least two stimuli, or omit mismatch");
    }
    for (std::size_t i = 0; i < owned.size(); ++i) {
      const auto equal = static_cast<std::size_t>(std::ranges::count(owned, owned[i]));
      if (2 * equal <= owned.size()) continue;
      return add(
          "mismatch",
          fmt::format("{} of {} stimuli have the sound {}, so not all can get another", equal,
                      owned.size(), motion::in_quotes(sounds[i].file.filename().string())),
          "list stimuli of which at most half have the same sound");
    }
  }

  Manifest& manifest_;
};

}  // namespace

void LoudnessForm::read(const DocumentValue& given, std::optional<double>& target_lufs) {
  if (given.value.is_boolean())
    target_lufs = given.value.get<bool>() ? std::optional(broadcast_lufs) : std::nullopt;
  if (given.value.is_number()) target_lufs = given.value.get<double>();
}

OrderedJson LoudnessForm::write(const std::optional<double>& target_lufs, const WritingOptions&) {
  if (!target_lufs) return false;
  return *target_lufs == broadcast_lufs ? OrderedJson(true) : OrderedJson(*target_lufs);
}

std::vector<Fault> resolve_sounds(Manifest& manifest) {
  SoundResolver resolver(manifest);
  resolver.resolve();
  return resolver.take();
}

std::vector<std::size_t> derangement(const std::vector<std::string>& names,
                                     const std::vector<std::string>& owned, std::uint64_t seed) {
  if (names.size() < 2 || 2 * most_equal(owned) > names.size()) return {};
  for (int number = 0; number < most_tries; ++number) {
    std::vector<std::size_t> sources =
        drawn_order(names, seed, "derangement " + std::to_string(number));
    if (keeps_nothing(sources, owned)) return sources;
  }
  return rotated(drawn_order(names, seed, "rotation"), owned);
}

std::string sound_level(const Stimulus& stimulus) {
  if (!stimulus.sound) return "";
  return stimulus.sound->of == stimulus.id ? "matched" : "mismatched";
}

}  // namespace mien::pipeline
