#include "pipeline/base/documents/files.h"
#include "pipeline/regression/baseline.h"
#include "pipeline/regression/baseline_json.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The text of baseline.json with the hash of all that stands before it as its last member.
std::string with_checksum(const Json& json) {
  std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
  text.erase(text.rfind("\n}"));
  text += ",\n  ";
  const Hash hash = hash_of(text);
  return text + std::string(checksum_key) + hash + "\"\n}\n";
}

void write_text(const fs::path& file, const std::string& text) {
  make_folder(file.parent_path());
  fs::path next = file;
  next += ".next";
  replace_file(file, next, text);
}

}  // namespace

void write_facts(const StimulusFacts& facts, const fs::path& folder) {
  write_text(folder / "stimulus.json",
             json_of(facts).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void write_baseline(const Baseline& baseline) {
  Json ids = Json::array();
  for (const StimulusFacts& facts : baseline.stimuli) ids.push_back(facts.id);
  Json approvals = Json::array();
  for (const Approval& approval : baseline.approvals) approvals.push_back(json_of(approval));
  Json json = {{"baseline", baseline_version},
               {"study", baseline.study},
               {"approvals", approvals},
               {"stimuli", ids}};
  if (baseline.overlays) {
    json["overlays"] = Json::array();
    for (const StimulusFacts& facts : *baseline.overlays)
      json["overlays"].push_back(json_of(facts));
  }
  json["sums"] = baseline.sums;
  write_text(baseline.folder / "baseline.json", with_checksum(json));
}

}  // namespace mien::pipeline
