#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Returns the motions that a stimulus shows: its own, or those of its people.
std::vector<const Stimulus*> motions_in(const Stimulus& stimulus);

/// Returns everything whose motion is made, in the order of the manifest: the stimuli and, in place
/// of a stimulus with several people, these.
std::vector<const Stimulus*> motion_sources(const Manifest& manifest);

/// Returns the stimulus whose film shows the motion with this id, its own or that of one of its
/// people, or nullptr.
const Stimulus* film_showing(const Manifest& manifest, const std::string& id);

/// Whether any stimulus has several people.
bool has_people(const Manifest& manifest);

/// Calls `visit` with each of the motion sources, which it may change.
void visit_motion_sources(Manifest& manifest, const auto& visit) {
  for (Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.people.empty()) visit(stimulus);
    for (Person& person : stimulus.people) visit(person.motion);
  }
}

/// Gives people without a name one by their number (a, b, c …), and all of them the ids of their
/// motions and their paths in the manifest. The stimuli must have theirs.
void name_people(Manifest& manifest);

/// Whether the motions of a stimulus's people stay where they were recorded, relative to each
/// other: those of files, if none of these has a place.
bool keeps_captured_space(const Stimulus& stimulus);

/// Gives people the motions that `swap:` names, as they were before any swap. Modifications and
/// foils must have been resolved. Returns faults if a person or a motion does not exist, and if the
/// motion is the person's own.
std::vector<Fault> resolve_swaps(Manifest& manifest);

}  // namespace mien::pipeline
