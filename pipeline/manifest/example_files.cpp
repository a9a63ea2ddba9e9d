#include "pipeline/manifest/example_files.h"

#include <algorithm>
#include <set>

#include "motion/formats/keypoints/keypoint_frames.h"
#include "motion/formats/motion_format.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/text/compressed_file.h"
#include "motion/text/frame_file_name.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/ratings/answers/identifying_columns.h"

namespace mien::pipeline {

motion::ExampleFolder example_folder(const Examples& examples) {
  motion::ExampleFolder folder;
  folder.path = examples.folder;
  folder.include = examples.include;
  folder.exclude = examples.exclude;
  folder.how = read_options(examples.how);
  folder.cycle = examples.cycle;
  folder.keytimes = examples.keytimes;
  folder.shorten_names = examples.labels == Examples::Labels::from_name;
  folder.names = examples.given_labels;
  folder.blendable = examples.blendable;
  return folder;
}

std::vector<std::filesystem::path> repertoire_files(const Manifest& manifest) {
  std::vector<std::filesystem::path> files;
  if (manifest.examples.builtin.empty() && !manifest.examples.folder.empty()) {
    files = motion::example_files(example_folder(manifest.examples));
  }
  const std::filesystem::path& body_model = manifest.examples.how.body_model;
  if (!body_model.empty()) files.push_back(body_model);
  if (!manifest.scales.file.empty()) files.push_back(manifest.scales.file);
  if (manifest.ratings.source == Ratings::Source::file) files.push_back(manifest.ratings.file);
  return files;
}

std::vector<std::string> example_names(const Manifest& manifest) {
  const Examples& examples = manifest.examples;
  if (!examples.builtin.empty()) return motion::builtin_example_names(examples.builtin);
  if (examples.folder.empty()) return {};
  return motion::example_names(example_folder(examples));
}

std::vector<RatedExample> rated_examples(const Manifest& manifest) {
  std::vector<RatedExample> rated;
  for (const std::string& name : example_names(manifest)) rated.push_back({name, ""});
  if (!manifest.examples.builtin.empty() || manifest.examples.folder.empty()) return rated;
  const auto files = motion::example_files(example_folder(manifest.examples));
  for (size_t i = 0; i < files.size(); ++i) rated[i].file_stem = motion::recording_name(files[i]);
  return rated;
}

std::vector<std::string> stems_in_folder(const Examples& examples) {
  if (!examples.builtin.empty() || examples.folder.empty()) return {};
  motion::ExampleFolder selected = example_folder(examples);
  selected.exclude.clear();
  std::set<std::string> stems;
  for (const auto& file : motion::example_files(selected))
    stems.insert(motion::recording_name(file));
  for (const auto& entry : std::filesystem::directory_iterator(examples.folder)) {
    if (entry.is_regular_file() && motion::is_found_as_motion(entry.path()))
      stems.insert(motion::recording_name(entry.path()));
  }
  return {stems.begin(), stems.end()};
}

bool may_hold_takes(const Examples& examples) {
  return std::ranges::any_of(motion::example_files(example_folder(examples)),
                             motion::may_hold_takes);
}

std::vector<std::filesystem::path> motion_parts(const std::filesystem::path& file) {
  const motion::MotionFormat* format = motion::motion_format(file);
  std::vector<std::filesystem::path> parts;
  if (motion::frame_file_name(file)) {
    parts = motion::keypoint_frames(absolute(file));
    std::erase_if(parts, [&](const auto& frame) { return frame.filename() == file.filename(); });
    return parts;
  }
  if (format == nullptr || format->part_ending.empty()) return parts;
  const bool is_bids = motion::without_compression(file).string().ends_with("_motion.tsv");
  for (const auto& entry : std::filesystem::directory_iterator(absolute(file).parent_path())) {
    const std::string name = motion::without_compression(entry.path()).filename().string();
    const bool are_channels = is_bids && name.ends_with("_channels.tsv");
    if (motion::lower_case_ending(entry.path()) == format->part_ending || are_channels)
      parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

Answers given_answers(const Manifest& manifest) {
  const std::vector<std::string> stems = stems_in_folder(manifest.examples);
  return read_answers(manifest.ratings.file, scales_of(manifest.scales),
                      {.examples = rated_examples(manifest),
                       .left_out = {stems.begin(), stems.end()},
                       .ignore_unknown = manifest.ratings.ignore_unknown});
}

std::string kept_ratings(const Manifest& manifest) {
  const std::filesystem::path& file = manifest.ratings.file;
  return without_what_identifies(read_file(file), file.string());
}

}  // namespace mien::pipeline
