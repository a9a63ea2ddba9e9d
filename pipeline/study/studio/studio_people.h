#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/lint/finding.h"
#include "pipeline/study/figures/shown_people.h"
#include "pipeline/study/studio/seen_files.h"
#include "pipeline/study/studio/studio_draft.h"

namespace mien::pipeline {

/// The people of a stimulus's film, and what is to be said of their motions.
struct PeopleOfFilm {
  ShownPeople shown;
  std::vector<motion::Finding> findings;  ///< in frames of the film; sentences begin with the name
  std::vector<std::string> warnings;      ///< the same
  std::vector<std::string> notes;
  SeenFiles files;  ///< that the motions were made from
};

/// Makes the motions of stimuli with several people as `mien run` does. Caches the most recent, and
/// makes them again when a file that they were made from has changed. Not thread-safe.
class StudioPeople {
 public:
  explicit StudioPeople(DraftReader& reader) : reader_(reader) {}

  /// Null if the document has no such stimulus with several people. Throws Error, DraftFaults.
  std::shared_ptr<const PeopleOfFilm> of(const nlohmann::ordered_json& document,
                                         const std::string& name);

 private:
  using Cached = std::shared_ptr<const PeopleOfFilm>;

  DraftReader& reader_;
  std::deque<std::pair<std::string, Cached>> cache_;  ///< by request, newest first
};

}  // namespace mien::pipeline
