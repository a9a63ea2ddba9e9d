#include "pipeline/manifest/manifest.h"

#include <cmath>

namespace mien::pipeline {

std::vector<std::pair<Role, std::string>> motions_on(const Overlay& overlay) {
  std::vector<std::pair<Role, std::string>> motions = {{Role::target, overlay.target},
                                                       {Role::created, overlay.created}};
  if (!overlay.reference.empty()) motions.emplace_back(Role::reference, overlay.reference);
  return motions;
}

std::vector<const Stimulus*> films_of(const Manifest& manifest) {
  std::vector<const Stimulus*> films;
  for (const Stimulus& stimulus : manifest.stimuli) films.push_back(&stimulus);
  for (const Overlay& overlay : manifest.overlays) films.push_back(&overlay.film);
  return films;
}

std::vector<std::string> motions_on(const Sheet& sheet) {
  if (!sheet.stills.empty()) return sheet.stills;
  if (!sheet.gallery.empty()) return sheet.gallery;
  std::vector<std::string> motions = {sheet.target, sheet.created};
  if (!sheet.reference.empty()) motions.push_back(sheet.reference);
  return motions;
}

std::vector<MotionPair> pairs_on(const Sheet& sheet) {
  if (!sheet.stills.empty()) return {};
  if (sheet.gallery.empty()) return {{sheet.target, sheet.created}};
  std::vector<MotionPair> pairs;
  for (std::size_t i = 1; i < sheet.gallery.size(); ++i) {
    pairs.push_back({sheet.gallery.front(), sheet.gallery[i]});
  }
  return pairs;
}

std::array<int, 2> Output::whole_size() const {
  return {static_cast<int>(std::lround(scale * size[0])),
          static_cast<int>(std::lround(scale * size[1]))};
}

std::optional<render::Window> Output::window() const {
  if (!crop) return std::nullopt;
  const auto scaled = [&](int pixels) { return static_cast<int>(std::lround(scale * pixels)); };
  const auto [left, top, width, height] = *crop;
  const int x = scaled(left), y = scaled(top);
  return render::Window{x, y, scaled(left + width) - x, scaled(top + height) - y};
}

std::array<int, 2> Output::shown_size() const {
  if (!crop) return whole_size();
  const render::Window shown = *window();
  return {shown.width, shown.height};
}

}  // namespace mien::pipeline
