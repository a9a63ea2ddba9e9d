#include "pipeline/manifest/recording_files.h"

#include <algorithm>
#include <map>
#include <set>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/named_motions.h"
#include "pipeline/manifest/people.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A place of the manifest that names a file.
struct Mention {
  fs::path file;
  Licence licence;
  std::string source;
  std::string path;
};

bool is_folder(const Examples& examples) {
  return examples.builtin.empty() && !examples.folder.empty();
}

std::vector<Mention> mentions_in(const Stimulus& stimulus) {
  std::vector<Mention> mentions;
  for (const NamedMotion& motion : named_motions(stimulus))
    mentions.push_back({motion.file, motion.licence, motion.source, motion.path});
  return mentions;
}

std::vector<Mention> all_mentions(const Manifest& manifest) {
  std::vector<Mention> mentions;
  const Examples& examples = manifest.examples;
  if (is_folder(examples)) {
    for (const fs::path& file : motion::example_files(example_folder(examples)))
      mentions.push_back({file, examples.how.licence, examples.how.source, "examples.set"});
  }
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (Mention& mention : mentions_in(stimulus)) mentions.push_back(std::move(mention));
  }
  for (Mention& mention : mentions) mention.file = fs::absolute(mention.file).lexically_normal();
  return mentions;
}

/// The mentions of each file.
std::map<fs::path, std::vector<Mention>> by_file(std::vector<Mention> mentions) {
  std::map<fs::path, std::vector<Mention>> files;
  for (Mention& mention : mentions) files[mention.file].push_back(std::move(mention));
  return files;
}

std::string described(const Licence& licence) {
  return motion::in_quotes(licence.name) + (licence.share ? "" : " (share: false)");
}

class LicenceChecker : public FaultList {
 public:
  using FaultList::FaultList;

  /// All statements about one file must agree with the first one.
  void check(const std::vector<Mention>& mentions) {
    const Mention* licensed = nullptr;
    const Mention* sourced = nullptr;
    for (const Mention& mention : mentions) {
      if (!mention.licence.name.empty()) {
        if (licensed == nullptr) licensed = &mention;
        if (licensed->licence != mention.licence) {
          add(member_path(mention.path, "licence"),
              motion::printable(mention.file.filename().string()) + " has the licence " +
                  described(licensed->licence) + " in " + licensed->path,
              "state the same licence, or only one");
        }
      }
      if (mention.source.empty()) continue;
      if (sourced == nullptr) sourced = &mention;
      if (sourced->source != mention.source) {
        add(member_path(mention.path, "source"),
            motion::printable(mention.file.filename().string()) + " has the source " +
                motion::in_quotes(sourced->source) + " in " + sourced->path,
            "state the same source, or only one");
      }
    }
  }

  void check_pose(const std::string& path, const PoseSource& pose) {
    if (pose.example.empty()) return;
    for (const char* key : {"licence", "source"}) {
      if (!was_given(member_path(path, key))) continue;
      add(member_path(path, key), motion::in_quotes(pose.example) + " is an example",
          "state it in examples.set");
    }
  }
};

}  // namespace

std::vector<RecordingFile> recording_files(const Manifest& manifest) {
  std::vector<RecordingFile> recordings;
  for (const auto& [file, mentions] : by_file(all_mentions(manifest))) {
    RecordingFile recording{file, motion_parts(file), {}, "", mentions.front().path, false};
    for (const Mention& mention : mentions) {
      if (!mention.licence.name.empty() && recording.licence.name.empty()) {
        recording.licence = mention.licence;
        recording.path = mention.path;
      }
      recording.is_example |= mention.path == "examples.set";
      if (recording.source.empty()) recording.source = mention.source;
    }
    recordings.push_back(std::move(recording));
  }
  return recordings;
}

std::vector<Fault> check_licences(const Manifest& manifest) {
  LicenceChecker checker(manifest.places);
  try {
    for (const auto& [file, mentions] : by_file(all_mentions(manifest))) checker.check(mentions);
  } catch (const Error&) {
    // A folder that cannot be read is reported by the checks of the examples.
  }
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    for (const ModificationStep& step : stimulus->modify) {
      if (!step.pose || !step.edit.pose) continue;
      const std::string path = member_path(step.path, "pose");
      checker.check_pose(member_path(path, "neutral"), step.pose->neutral);
      checker.check_pose(member_path(path, "posed"), step.pose->posed);
    }
  }
  return checker.take();
}

bool names_examples(const Stimulus& stimulus) {
  const auto has_example = [](const ModificationStep& step) {
    if (step.style) return true;
    return step.pose && !(step.pose->neutral.example.empty() && step.pose->posed.example.empty());
  };
  return std::ranges::any_of(motions_in(stimulus), [&](const Stimulus* motion) {
    return std::ranges::any_of(motion->modify, has_example);
  });
}

std::vector<std::string> restricting_licences(const Stimulus& stimulus,
                                              const std::vector<RecordingFile>& recordings) {
  std::set<fs::path> files;
  for (const Mention& mention : mentions_in(stimulus))
    files.insert(fs::absolute(mention.file).lexically_normal());
  const auto motions = motions_in(stimulus);
  const bool is_of_examples =
      names_examples(stimulus) ||
      std::ranges::any_of(motions, [](const Stimulus* motion) { return is_blend(*motion); });
  std::set<std::string> names;
  for (const RecordingFile& recording : recordings) {
    if (recording.licence.share) continue;
    const bool is_used = files.contains(recording.file) || (is_of_examples && recording.is_example);
    if (is_used) names.insert(recording.licence.name);
  }
  return {names.begin(), names.end()};
}

}  // namespace mien::pipeline
