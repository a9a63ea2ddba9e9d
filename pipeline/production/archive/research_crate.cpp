#include "pipeline/production/archive/research_crate.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr char crate_version[] = "https://w3id.org/ro/crate/1.1";
constexpr char workflow_crate[] = "https://w3id.org/workflowhub/workflow-ro-crate/1.0";
constexpr char process_run[] = "https://w3id.org/ro/wfrun/process/0.5";
constexpr char workflow_run[] = "https://w3id.org/ro/wfrun/workflow/0.5";

// Identifiers of what is not a file.
constexpr char program_id[] = "#mien";
constexpr char language_id[] = "#manifest";
constexpr char run_id[] = "#run";
constexpr char owner_id[] = "#organization";
constexpr char contact_id[] = "#contact";

/// Media types by the ends of file names.
constexpr auto media_types = std::to_array<std::pair<std::string_view, std::string_view>>({
    {".apng", "image/apng"},
    {".bib", "application/x-bibtex"},
    {".bvh", "text/plain"},
    {".c3d", "application/octet-stream"},
    {".csv", "text/csv"},
    {".exr", "image/x-exr"},
    {".flac", "audio/flac"},
    {".gif", "image/gif"},
    {".glb", "model/gltf-binary"},
    {".gltf", "model/gltf+json"},
    {".html", "text/html"},
    {".json", "application/json"},
    {".md", "text/markdown"},
    {".mkv", "video/x-matroska"},
    {".mp3", "audio/mpeg"},
    {".mp4", "video/mp4"},
    {".opus", "audio/ogg"},
    {".pdf", "application/pdf"},
    {".png", "image/png"},
    {".svg", "image/svg+xml"},
    {".tsv", "text/tab-separated-values"},
    {".txt", "text/plain"},
    {".wav", "audio/wav"},
    {".webm", "video/webm"},
    {".webp", "image/webp"},
    {".yaml", "application/yaml"},
    {".yml", "application/yaml"},
});

ordered_json reference(const std::string& id) { return {{"@id", id}}; }

/// A path as a relative URI (RFC 3986).
std::string uri_of(const std::string& path) {
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos)
      uri += c;
    else
      uri += fmt::format("%{:02X}", byte);
  }
  return uri;
}

std::string name_of_path(const std::string& path) { return path.substr(path.rfind('/') + 1); }

bool is_below(const std::string& path, const std::string& folder) {
  return path.starts_with(folder + "/");
}

ordered_json creative_work(const std::string& id, const std::string& name) {
  return {{"@id", id}, {"@type", "CreativeWork"}, {"name", name}};
}

/// A profile that the crate follows.
ordered_json profile(const std::string& id, const std::string& name) {
  ordered_json work = creative_work(id, name);
  work["version"] = name_of_path(id);
  return work;
}

/// "CC-BY-4.0" is a name of the SPDX list; a URL is itself.
ordered_json licence_of(const std::string& text) {
  const bool is_address = text.starts_with("https://") || text.starts_with("http://");
  const bool is_short = std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '+';
  });
  return creative_work(is_address ? text
                       : is_short ? "https://spdx.org/licenses/" + text
                                  : "#licence",
                       text);
}

/// Collects the entities of a crate.
class Crate {
 public:
  Crate(const StudyContents& contents, const std::vector<PayloadFile>& payload, const BagInfo& info)
      : contents_(contents), payload_(payload), info_(info) {}

  std::string text() {
    describe_files();
    describe_recordings();
    ordered_json graph = ordered_json::array({descriptor(), root()});
    graph.push_back(profile(process_run, "Process Run Crate"));
    graph.push_back(profile(workflow_run, "Workflow Run Crate"));
    graph.push_back(profile(workflow_crate, "Workflow RO-Crate"));
    graph.push_back({{"@id", language_id},
                     {"@type", "ComputerLanguage"},
                     {"name", "manifest of mien"},
                     {"version", "1"}});
    graph.push_back({{"@id", program_id},
                     {"@type", "SoftwareApplication"},
                     {"name", "mien"},
                     {"softwareVersion", contents_.program}});
    graph.push_back(run());
    add_people(graph);
    for (ordered_json& entity : entities_) graph.push_back(std::move(entity));
    const ordered_json crate = {{"@context",
                                 {std::string(crate_version) + "/context",
                                  "https://w3id.org/ro/terms/workflow-run/context"}},
                                {"@graph", std::move(graph)}};
    return crate.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  }

 private:
  static ordered_json descriptor() {
    return {{"@id", crate_path},
            {"@type", "CreativeWork"},
            {"about", reference("./")},
            {"conformsTo", {reference(crate_version), reference(workflow_crate)}}};
  }

  ordered_json root() const {
    ordered_json root = {
        {"@id", "./"},
        {"@type", "Dataset"},
        {"name", "Human motion stimuli: " + contents_.study},
        {"description", info_.description.empty()
                            ? "Human motion stimuli, made by: " + contents_.command
                            : info_.description},
        {"identifier", contents_.study},
        {"conformsTo",
         {reference(process_run), reference(workflow_run), reference(workflow_crate)}},
        {"mainEntity", reference(uri_of(contents_.as_run))},
        {"mentions", reference(run_id)}};
    if (!info_.published.empty()) root["datePublished"] = info_.published;
    if (!info_.license.empty()) root["license"] = reference(licence_of(info_.license)["@id"]);
    if (!info_.organization.empty()) {
      root["author"] = reference(owner_id);
      root["publisher"] = reference(owner_id);
    }
    if (has_contact()) root["contactPoint"] = reference(contact_id);
    root["hasPart"] = parts_;
    return root;
  }

  ordered_json run() const {
    ordered_json run = {{"@id", run_id},
                        {"@type", "CreateAction"},
                        {"name", "Production of the study " + contents_.study},
                        {"description", contents_.command},
                        {"instrument", reference(uri_of(contents_.as_run))}};
    if (!info_.organization.empty()) run["agent"] = reference(owner_id);
    run["object"] = objects_;
    run["result"] = results_;
    return run;
  }

  bool has_contact() const { return !info_.contact_name.empty() || !info_.contact_email.empty(); }

  void add_people(ordered_json& graph) const {
    if (!info_.organization.empty())
      graph.push_back({{"@id", owner_id}, {"@type", "Organization"}, {"name", info_.organization}});
    if (has_contact()) {
      ordered_json contact = {{"@id", contact_id}, {"@type", "ContactPoint"}};
      if (!info_.contact_name.empty()) contact["name"] = info_.contact_name;
      if (!info_.contact_email.empty()) contact["email"] = info_.contact_email;
      graph.push_back(std::move(contact));
    }
    if (!info_.license.empty()) graph.push_back(licence_of(info_.license));
  }

  /// Files, and a folder for each frame sequence; what the run read and what it made.
  void describe_files() {
    std::set<std::string> described;
    for (const PayloadFile& file : payload_) {
      const ArtifactRecord* sequence = sequence_of(file.path);
      if (sequence == nullptr) {
        if (file.path != crate_path) describe_file(file);
      } else if (described.insert(sequence->path).second) {
        describe_frames(*sequence);
      }
    }
  }

  /// The frame sequence in whose folder a file is; nullptr for other files.
  const ArtifactRecord* sequence_of(const std::string& path) const {
    for (std::size_t end = path.rfind('/'); end != std::string::npos && end > 0;
         end = path.rfind('/', end - 1)) {
      const ArtifactRecord* artifact = contents_.find(path.substr(0, end));
      if (artifact != nullptr && artifact->frames > 0) return artifact;
    }
    return nullptr;
  }

  void describe_frames(const ArtifactRecord& sequence) {
    const std::string id = uri_of(sequence.path) + "/";
    entities_.push_back({{"@id", id},
                         {"@type", "Dataset"},
                         {"name", name_of_path(sequence.path)},
                         {"description", fmt::format("{} frames", sequence.frames)}});
    parts_.push_back(reference(id));
    results_.push_back(reference(id));
  }

  void describe_file(const PayloadFile& file) {
    const std::string id = uri_of(file.path);
    ordered_json entity = {{"@id", id}, {"@type", "File"}, {"name", name_of_path(file.path)}};
    entity["contentSize"] = std::to_string(file.size);
    for (const auto& [ending, type] : media_types)
      if (file.path.ends_with(ending)) entity["encodingFormat"] = type;
    if (file.path == contents_.as_run) {
      entity["@type"] = {"File", "SoftwareSourceCode", "ComputationalWorkflow"};
      entity["programmingLanguage"] = reference(language_id);
      entity["softwareRequirements"] = reference(program_id);
    }
    entities_.push_back(std::move(entity));
    parts_.push_back(reference(id));
    const bool is_input =
        std::ranges::binary_search(contents_.inputs, file.path, {}, &ArtifactRecord::path) ||
        is_below(file.path, packed_recordings_folder);
    if (is_input && file.path != contents_.as_run) objects_.push_back(reference(id));
    if (contents_.find(file.path) != nullptr) results_.push_back(reference(id));
  }

  /// Recordings that are not in the archive: what is known of them.
  void describe_recordings() {
    for (const RecordingRecord& recording : contents_.recordings) {
      const std::string path = std::string(packed_recordings_folder) + "/" + recording.path;
      if (std::ranges::binary_search(payload_, path, {}, &PayloadFile::path)) continue;
      const std::string id = "#" + uri_of(path);
      ordered_json work = creative_work(id, recording.path);
      work["description"] = recording.share
                                ? "Recording that the study was made from; not in the archive"
                                : "Recording that the study was made from; its licence does not "
                                  "permit sharing it";
      work["identifier"] = "XXH3-128:" + recording.hash;
      if (!recording.licence.empty()) work["license"] = recording.licence;
      entities_.push_back(std::move(work));
      objects_.push_back(reference(id));
    }
  }

  const StudyContents& contents_;
  const std::vector<PayloadFile>& payload_;
  const BagInfo& info_;
  std::vector<ordered_json> entities_;
  ordered_json parts_ = ordered_json::array();
  ordered_json objects_ = ordered_json::array();
  ordered_json results_ = ordered_json::array();
};

}  // namespace

std::string crate_metadata(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                           const BagInfo& info) {
  return Crate(contents, payload, info).text();
}

std::vector<std::string> lacking_of_crate(const BagInfo& info) {
  std::vector<std::string> lacking;
  if (info.published.empty()) lacking.emplace_back("--published");
  if (info.license.empty()) lacking.emplace_back("--license");
  if (info.organization.empty()) lacking.emplace_back("--organization");
  return lacking;
}

}  // namespace mien::pipeline
