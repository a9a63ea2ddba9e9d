#include "pipeline/base/documents/fault_list.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/paths_of_manifests.h"

namespace mien::pipeline {

namespace {

std::string remedy_of_file(const std::string& expected) {
  return "give " + expected + std::string(from_the_manifest);
}

/// What was probably meant by a path under which there is nothing; or empty. A path has a single
/// slash where an address has two.
std::string hint_about_path(const std::filesystem::path& file) {
  const std::string text = file.string();
  if (text.find("http:/") != std::string::npos || text.find("https:/") != std::string::npos)
    return "files are not fetched from the web: download this one, and give the path of the copy";
  if (std::ranges::find(file, "~") != file.end())
    return "~ is not replaced by your home folder: write the whole path";
  if (text.find('\\') != std::string::npos) return "write / instead of \\ between folders";
  return "";
}

}  // namespace

void append(std::vector<Fault>& faults, std::vector<Fault> more) {
  faults.insert(faults.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
}

std::vector<Fault> merged_faults(std::vector<std::vector<Fault>> lists) {
  std::vector<Fault> faults;
  std::set<std::string> reported;
  for (std::vector<Fault>& list : lists) {
    std::erase_if(list, [&](const Fault& fault) { return reported.contains(fault.path); });
    for (const Fault& fault : list)
      if (!fault.path.empty()) reported.insert(fault.path);
    append(faults, std::move(list));
  }
  return in_reading_order(std::move(faults));
}

void FaultList::add(const std::string& path, std::string wrong, std::string remedy) {
  faults_.push_back({place_of(places_, path), path, std::move(wrong), std::move(remedy)});
}

void FaultList::add_at_key(const std::string& path, std::string wrong, std::string remedy) {
  faults_.push_back({key_place_of(places_, path), path, std::move(wrong), std::move(remedy)});
}

void FaultList::check_known_name(const std::string& path, const std::string& name,
                                 const std::string& what, const std::vector<std::string>& known) {
  if (known.empty() || std::find(known.begin(), known.end(), name) != known.end()) return;
  // Searching many names for the most similar one is slow, so the number of remedies is limited.
  constexpr std::size_t most_remedies = 1000;
  add(path, "unknown " + what + " " + motion::in_quotes(name),
      faults_.size() < most_remedies ? motion::did_you_mean(name, known) : "");
}

void FaultList::check_file(const std::string& path, const std::filesystem::path& file,
                           const std::string& expected, std::uintmax_t most_bytes) {
  const std::string problem = motion::read_error(file, most_bytes);
  if (problem.empty()) return;
  std::error_code unknown;
  const bool is_there = std::filesystem::exists(file, unknown);
  if (is_there) return add(path, file.string() + " " + problem, remedy_of_file(expected));
  const std::string hint = hint_about_path(file);
  add(path, "there is no file " + file.string(), hint.empty() ? remedy_of_file(expected) : hint);
}

}  // namespace mien::pipeline
