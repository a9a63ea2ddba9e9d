#include <string>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"

namespace mien::pipeline {

namespace {

void check_figure(const Overlay& overlay, FaultList& list) {
  const Stimulus& film = overlay.film;
  const std::string own = member_path(film.path, "look.figure");
  const std::string path = list.was_given(own) ? own : film.path;
  const std::string fault = scenes::kind_of(film.look.figure).not_in_overlays;
  if (!fault.empty()) list.add(path, fault, "give it another look: {figure: stick}");
}

void check_layout(const Overlay& overlay, FaultList& list) {
  if (overlay.layout == scenes::Layout::superimposed) return;
  const std::string opacity = member_path(overlay.film.path, "opacity");
  if (list.was_given(opacity)) {
    list.add_at_key(opacity, "only superimposed figures can be transparent",
                    "omit it, or use layout: superimposed");
  }
  if (overlay.layout != scenes::Layout::side_by_side) return;
  if (!scenes::looks_across_lanes(overlay.film.look.camera)) return;
  list.add(member_path(overlay.film.path, "layout"),
           "figures side by side hide each other in a side view",
           "choose camera: front, three-quarter or follow");
}

void check_pair(const std::string& path, const std::string& target, const std::string& created,
                FaultList& list) {
  if (target.empty() || target != created) return;
  list.add(member_path(path, "created"), "this is the same motion as the target",
           "name another one");
}

}  // namespace

std::vector<Fault> check_overlays(const Manifest& manifest) {
  FaultList list(manifest.places);
  for (const Overlay& overlay : manifest.overlays) {
    if (overlay.target.empty() || overlay.created.empty()) continue;
    check_pair(overlay.film.path, overlay.target, overlay.created, list);
    check_layout(overlay, list);
    check_figure(overlay, list);
  }
  return list.take();
}

std::vector<Fault> check_sheets(const Manifest& manifest) {
  FaultList list(manifest.places);
  for (const Sheet& sheet : manifest.sheets) {
    const std::string columns = member_path(sheet.path, "columns");
    if (sheet.stills.empty() && list.was_given(columns)) {
      list.add_at_key(columns, "only sheets of stills have columns", "remove it, or use stills");
    }
    check_pair(member_path(sheet.path, "compare"), sheet.target, sheet.created, list);
  }
  return list.take();
}

}  // namespace mien::pipeline
