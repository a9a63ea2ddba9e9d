#include "pipeline/manifest/reading/manifest_builder.h"

#include <algorithm>
#include <utility>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/manifest/look/point_form.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

/// Built-in sets that are blended come with ratings.
void add_builtin_ratings(const json& document, Manifest& manifest) {
  const json* examples = member(document, "examples");
  if (examples == nullptr || member(*examples, "ratings") != nullptr) return;
  if (manifest.examples.builtin.empty() || !manifest.examples.blendable) return;
  manifest.ratings.source = Ratings::Source::builtin;
}

void name_places(Manifest& manifest) {
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i)
    manifest.stimuli[i].path = element_path("stimuli", i);
  for (std::size_t i = 0; i < manifest.overlays.size(); ++i)
    manifest.overlays[i].film.path = element_path("overlays", i);
  for (std::size_t i = 0; i < manifest.sheets.size(); ++i)
    manifest.sheets[i].path = element_path("sheets", i);
}

std::string usual_id(const Sheet& sheet) {
  return !sheet.stills.empty()    ? "stills"
         : !sheet.gallery.empty() ? "gallery"
                                  : sheet.target + "_" + sheet.created;
}

void name_what_has_no_id(Manifest& manifest) {
  for (Overlay& overlay : manifest.overlays) {
    if (overlay.film.id.empty()) overlay.film.id = overlay.target + "_with_" + overlay.created;
  }
  for (Sheet& sheet : manifest.sheets) {
    if (sheet.id.empty()) sheet.id = usual_id(sheet);
  }
}

}  // namespace

Manifest build_manifest(
    JsonReading reading, const std::filesystem::path& file,
    const std::function<void(const std::string&, const std::filesystem::path&)>& names) {
  Manifest manifest;
  manifest.file = file;
  manifest.places = std::move(reading.places);
  const auto resolve = [&names, folder = file.parent_path()](const std::string& path) {
    std::filesystem::path resolved = (folder / path).lexically_normal();
    if (names) names(path, resolved);
    return resolved;
  };
  const ReadingContext context{manifest.places, resolve};
  read({reading.document, "", context}, manifest);
  manifest.interpolation.weights.nearest.seed = manifest.seed;
  add_builtin_ratings(reading.document, manifest);
  name_places(manifest);
  name_what_has_no_id(manifest);
  return manifest;
}

}  // namespace mien::pipeline
