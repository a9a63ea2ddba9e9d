#include "pipeline/motions.h"

#include <algorithm>

namespace mien::pipeline {

struct Motions::Entry {
  std::once_flag once;
  std::optional<Synthesis> synthesis;
};

Motions::Motions(const Manifest& manifest) : manifest_(manifest) {}

Motions::~Motions() = default;

const Repertoire& Motions::repertoire() {
  std::call_once(repertoire_once_, [this] { repertoire_ = load_repertoire(manifest_); });
  return *repertoire_;
}

const Synthesis& Motions::of(const std::string& name) {
  Entry& found = entry(name);
  std::call_once(found.once, [&] { found.synthesis = make(name); });
  return *found.synthesis;
}

Motions::Entry& Motions::entry(const std::string& name) {
  const std::lock_guard guard(mutex_);
  std::unique_ptr<Entry>& found = entries_[name];
  if (!found) found = std::make_unique<Entry>();
  return *found;
}

Synthesis Motions::make(const std::string& name) {
  const Stimulus* stimulus = find_stimulus(manifest_, name);
  if (stimulus == nullptr) {
    return synthesize_example(name, manifest_.output, manifest_.interpolation, repertoire());
  }
  // A file needs no examples, unless its modifications do; there may be none.
  if (stimulus->clip && !names_examples(*stimulus)) return synthesize(*stimulus, Repertoire{});
  return synthesize(*stimulus, repertoire());
}

bool names_examples(const Stimulus& stimulus) {
  return std::any_of(stimulus.modify.begin(), stimulus.modify.end(), [](const auto& step) {
    if (step.style) return true;
    return step.pose && !(step.pose->neutral.example.empty() && step.pose->posed.example.empty());
  });
}

bool blends_examples(const Manifest& manifest) {
  return std::any_of(manifest.stimuli.begin(), manifest.stimuli.end(),
                     [](const Stimulus& stimulus) { return !stimulus.clip; });
}

const Stimulus* find_stimulus(const Manifest& manifest, const std::string& id) {
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.id == id) return &stimulus;
  }
  return nullptr;
}

}  // namespace mien::pipeline
