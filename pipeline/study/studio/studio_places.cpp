#include "pipeline/study/studio/studio_places.h"

#include <algorithm>
#include <map>
#include <system_error>

#include "motion/formats/motion_file.h"
#include "scenes/character/character.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int deepest_folder = 6;
constexpr int max_entries = 20000;  // entries visited at most
constexpr std::size_t max_names = 400;

fs::path resolved(const fs::path& path) {
  std::error_code unknown;
  const fs::path real = fs::weakly_canonical(fs::absolute(path, unknown), unknown);
  return real.has_filename() ? real : real.parent_path();
}

bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

/// The folder of examples that a document names; empty without one.
std::string examples_folder(const ordered_json& document) {
  const ordered_json::json_pointer at("/examples/set/folder");
  return document.contains(at) && document[at].is_string() ? document[at].get<std::string>() : "";
}

bool is_left_out(const fs::path& folder) {
  std::error_code unknown;
  return folder.filename().string().starts_with(".") || fs::exists(folder / ".mien", unknown);
}

/// The files below a place, by folder.
struct Found {
  std::map<std::string, std::vector<std::string>> motions;
  std::vector<std::string> characters;
  int entries = 0;
  bool is_all = true;
};

std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + "/" + name;
}

void list_folder(const fs::path& folder, const std::string& name, int depth, Found& found) {
  std::error_code closed;
  std::vector<fs::path> below;
  for (fs::directory_iterator entry(folder, closed); !closed && entry != fs::directory_iterator();
       entry.increment(closed)) {
    if (++found.entries > max_entries || found.characters.size() > max_names) {
      found.is_all = false;
      return;
    }
    std::error_code unknown;
    const fs::path& path = entry->path();
    if (entry->is_directory(unknown) && !entry->is_symlink(unknown)) below.push_back(path);
    if (!entry->is_regular_file(unknown)) continue;
    if (motion::is_found_as_motion(path))
      found.motions[name.empty() ? "." : name].push_back(path.filename().string());
    if (scenes::is_character_file(path))
      found.characters.push_back(joined(name, path.filename().string()));
  }
  std::sort(below.begin(), below.end());
  for (const fs::path& one : below) {
    if (is_left_out(one)) continue;
    if (depth == 0 || found.motions.size() >= max_names) {
      found.is_all = false;
      return;
    }
    list_folder(one, joined(name, one.filename().string()), depth - 1, found);
  }
}

}  // namespace

StudioPlaces::StudioPlaces(const fs::path& manifest, const ordered_json& known)
    : beside_(resolved(manifest).parent_path()) {
  places_.push_back({beside_, ""});
  const std::string named = examples_folder(known);
  if (named.empty()) return;
  const fs::path folder = resolved(beside_ / named);
  if (!lies_in(folder, beside_)) places_.push_back({folder, named});
}

ordered_json StudioPlaces::listing() const {
  Found found;
  for (const Place& place : places_) list_folder(place.folder, place.name, deepest_folder, found);
  ordered_json folders = ordered_json::array();
  for (auto& [folder, motions] : found.motions) {
    std::sort(motions.begin(), motions.end());
    if (motions.size() > max_names) {
      motions.resize(max_names);
      found.is_all = false;
    }
    folders.push_back({{"folder", folder}, {"motions", motions}});
  }
  std::sort(found.characters.begin(), found.characters.end());
  return {{"folders", folders}, {"characters", found.characters}, {"all", found.is_all}};
}

bool StudioPlaces::contains(const std::string& name) const {
  if (name.find('\0') != std::string::npos) return false;
  const fs::path path = resolved(beside_ / name);
  const bool is_inside = std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return lies_in(path, place.folder);
  });
  if (!is_inside) return false;
  std::error_code unknown;
  if (fs::is_directory(path, unknown)) return true;
  return fs::is_regular_file(path, unknown) &&
         (motion::is_found_as_motion(path) || scenes::is_character_file(path));
}

}  // namespace mien::pipeline
