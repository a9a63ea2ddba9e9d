#include <algorithm>
#include <set>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/regression/baseline.h"
#include "pipeline/regression/baseline_json.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What merging and git LFS leave in place of a file.
void refuse_text(const fs::path& file, const std::string& text) {
  if (motion::is_lfs_pointer(text))
    throw Error({file.string()}, "is a git LFS pointer; the file itself has not been fetched",
                "run: git lfs pull");
  const std::size_t mark = ("\n" + text).find("\n<<<<<<< ");
  if (mark == std::string::npos) return;
  const auto line =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(mark), '\n');
  throw Error({file.string(), static_cast<int>(line) + 1, 0}, "holds a merge conflict",
              "resolve it (git checkout --ours or --theirs, for the whole folder), look at the "
              "study, and approve it");
}

/// What the library found, without its own number.
std::string library_words(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

constexpr char keep_remedy[] =
    "restore it from version control (git checkout), or remove the folder and approve the study "
    "again";

/// Reads one document of a baseline and makes something of it.
template <class Make>
auto from_document(const fs::path& file, const Make& make) {
  const std::string problem = motion::read_error(file, motion::max_document_bytes);
  if (!problem.empty()) throw Error({file.string()}, problem, keep_remedy);
  const std::string text = read_file(file);
  refuse_text(file, text);
  if (motion::is_nested_deeper(text, motion::max_json_depth))
    throw Error({file.string()}, "is not a valid baseline file", keep_remedy);
  try {
    return make(Json::parse(text), text);
  } catch (const Json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw Error({file.string(), static_cast<int>(std::count(text.begin(), end, '\n')) + 1, 0},
                "is truncated or damaged: invalid JSON from here on", keep_remedy);
  } catch (const Json::exception& error) {
    throw Error({file.string()}, "lacks part of a baseline: " + library_words(error), keep_remedy);
  } catch (const std::logic_error&) {  // no number where one should be
    throw Error({file.string()}, "is not a valid baseline file", keep_remedy);
  }
}

/// Throws Error where the text is not the one that was written. One without checksum may be of mien
/// 0.2, which had none.
void refuse_damage(const fs::path& file, const std::string& text, const Json& json) {
  if (!json.contains("checksum") && !json.contains("sums")) return;
  const std::size_t end = text.rfind(checksum_key);
  const bool is_whole =
      end != std::string::npos &&
      text.substr(end) == std::string(checksum_key) + hash_of(text.substr(0, end)) + "\"\n}\n";
  if (!is_whole)
    throw Error({file.string()}, "was changed after it was written: its checksum differs",
                keep_remedy);
}

/// Whether a file is a git LFS pointer, not fetched yet.
bool is_pointer(const fs::path& file) {
  constexpr std::uintmax_t most = 1024;
  return fs::file_size(file) < most && motion::is_lfs_pointer(read_file(file));
}

/// Empty when a kept file is as it was approved.
std::string damage_of(const fs::path& file, const Hash& hash) {
  if (!fs::is_regular_file(file)) return "is missing";
  if (is_pointer(file)) return "was not fetched by git LFS";
  return hash_of_file(file) == hash ? "" : "differs from what was approved";
}

/// Reports files of an edition that were not approved with it: its manifest may name a folder.
void add_unknown_files(std::vector<Fault>& faults, const Baseline& baseline,
                       const std::string& edition) {
  const fs::path folder = baseline.folder / "editions" / edition;
  if (!fs::is_directory(folder)) return;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().lexically_relative(baseline.folder).generic_string();
    if (!entry.is_directory() && !baseline.sums.contains(path))
      faults.push_back(
          {{entry.path().string()}, "did not exist when the study was approved", "remove it"});
  }
}

/// Reports files that differ from their checksums in baseline.json.
void add_damaged_sums(std::vector<Fault>& faults, const Baseline& baseline) {
  std::set<std::string> editions;
  for (const auto& [path, hash] : baseline.sums) {
    const std::string damage = damage_of(baseline.folder / path, hash);
    if (!damage.empty())
      faults.push_back({{(baseline.folder / path).string()}, damage, keep_remedy});
  }
  if (baseline.sums.empty()) return;
  for (const StimulusFacts& facts : baseline.stimuli) editions.insert(facts.edition);
  for (const std::string& edition : editions) add_unknown_files(faults, baseline, edition);
}

/// Checks that a stimulus's facts name files in its own folder.
StimulusFacts own_facts(StimulusFacts facts, const std::string& id, const fs::path& file) {
  const Place place{file.string()};
  if (facts.id != id)
    throw Error(place, "describes the stimulus " + motion::in_quotes(facts.id),
                "restore it from version control (git checkout), or approve it again");
  motion::safe_component(facts.edition, place);
  for (const auto& [name, hash] : facts.files) motion::safe_names(name, place);
  for (const VideoFacts& video : facts.videos) motion::safe_names(video.record.file, place);
  return facts;
}

}  // namespace

std::string facts_path(const std::string& id) { return "stimuli/" + id + "/stimulus.json"; }

std::map<std::string, Hash> sums_of_edition(const fs::path& folder, const std::string& edition) {
  std::map<std::string, Hash> sums;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(folder / "editions" / edition))
    if (entry.is_regular_file())
      sums[entry.path().lexically_relative(folder).generic_string()] = hash_of_file(entry.path());
  return sums;
}

Baseline read_baseline(const fs::path& folder) {
  Baseline baseline{.folder = folder, .study = {}, .approvals = {}, .stimuli = {}};
  std::vector<std::string> ids;
  from_document(folder / "baseline.json", [&](const Json& json, const std::string& text) {
    if (json.at("baseline") != baseline_version)
      throw Error({(folder / "baseline.json").string()}, "was written by a newer version of mien",
                  "update mien to the version with which the study was approved");
    refuse_damage(folder / "baseline.json", text, json);
    baseline.sums = json.value("sums", std::map<std::string, Hash>{});
    for (const auto& [path, hash] : baseline.sums)
      if (const std::string fault = motion::fault_of_relative(path); !fault.empty())
        throw Error({(folder / "baseline.json").string()},
                    "the path " + motion::in_quotes(path) + " " + fault, keep_remedy);
    baseline.study = json.at("study");
    ids = json.at("stimuli");
    for (const Json& approval : json.at("approvals"))
      baseline.approvals.push_back(approval_of(approval));
    if (!json.contains("overlays")) return 0;
    baseline.overlays.emplace();
    for (const Json& overlay : json.at("overlays"))
      baseline.overlays->push_back(stimulus_facts_of(overlay));
    return 0;
  });
  for (const std::string& id : ids) {
    motion::safe_component(id, {(folder / "baseline.json").string()});
    const fs::path file = folder / facts_path(id);
    StimulusFacts facts = from_document(
        file, [](const Json& json, const std::string&) { return stimulus_facts_of(json); });
    baseline.stimuli.push_back(own_facts(std::move(facts), id, file));
  }
  return baseline;
}

void check_files(const Baseline& baseline) {
  std::vector<Fault> faults;
  add_damaged_sums(faults, baseline);
  for (const StimulusFacts& facts : baseline.stimuli) {
    for (const auto& [name, hash] : facts.files) {
      const fs::path file = baseline.folder / "stimuli" / facts.id / name;
      const std::string damage = damage_of(file, hash);
      if (!damage.empty())
        faults.push_back({{file.string()},
                          damage,
                          "restore it from version control (git checkout, git lfs pull), or "
                          "approve the stimulus again"});
    }
  }
  if (!faults.empty()) throw Faults(std::move(faults));
}

}  // namespace mien::pipeline
