#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

#include "motion/formats/motion_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/checks/take_checks.h"
#include "pipeline/manifest/example_files.h"

namespace mien::pipeline {

namespace {

void check_folder(const Examples& examples, FaultList& list) {
  std::error_code error;
  if (examples.folder.empty() || std::filesystem::is_directory(examples.folder, error)) return;
  list.add("examples.set.folder", "there is no folder " + examples.folder.string(),
           "correct the path; it is relative to the manifest's folder");
}

void check_takes(const Examples& examples, FaultList& list) {
  std::error_code error;
  if (examples.how.take.empty() || !std::filesystem::is_directory(examples.folder, error)) return;
  if (may_hold_takes(examples)) return;
  list.add("examples.set.take", "none of the files can hold several motions",
           "omit take; only " + motion::formats_with_takes() + " can hold several");
}

void check_keytimes(const Examples& examples, FaultList& list) {
  for (const auto& [stem, times] : examples.keytimes) {
    const std::string path = member_path("examples.set.keytimes", stem);
    if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end()) {
      list.add(path, "keytimes are not in ascending order", "write seconds in ascending order");
    }
    const auto& [first, moments] = examples.keytimes.front();
    if (times.size() == moments.size()) continue;
    list.add(path,
             std::to_string(times.size()) + " keytimes where " + motion::in_quotes(first) +
                 " has " + std::to_string(moments.size()),
             "give every motion the same number of keytimes");
  }
}

void check_ratings(const Manifest& manifest, FaultList& list) {
  const Ratings& ratings = manifest.ratings;
  if (ratings.source == Ratings::Source::file) {
    list.check_file("examples.ratings", ratings.file,
                    "'builtin', 'simulated', 'none' or a CSV file", motion::max_table_bytes);
  }
  if (ratings.source == Ratings::Source::builtin && !manifest.examples.folder.empty()) {
    list.add("examples.ratings", "only built-in sets have built-in ratings",
             "name a CSV file, or use simulated");
  }
  if (!ratings.expected.empty() && ratings.source == Ratings::Source::none) {
    list.add("examples.expect", "expectations need ratings of the examples",
             "add ratings: with a CSV file to examples");
  }
}

void check_scales(const Manifest& manifest, FaultList& list) {
  if (manifest.scales.file.empty()) return;
  list.check_file("examples.scales", manifest.scales.file, "'builtin' or a YAML file",
                  motion::max_document_bytes);
  if (manifest.ratings.source != Ratings::Source::builtin) return;
  list.add("examples.scales", "built-in ratings are on the built-in scales",
           "use ratings: simulated, or omit scales");
}

}  // namespace

std::vector<Fault> check_examples(const Manifest& manifest) {
  FaultList list(manifest.places);
  check_folder(manifest.examples, list);
  check_takes(manifest.examples, list);
  check_body_model("examples.set.body_model", {}, read_options(manifest.examples.how), list);
  check_keytimes(manifest.examples, list);
  check_ratings(manifest, list);
  check_scales(manifest, list);
  return list.take();
}

}  // namespace mien::pipeline
