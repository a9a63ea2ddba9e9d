#include "pipeline/manifest/hold.h"

#include <algorithm>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/people.h"

namespace mien::pipeline {

void HoldForm::read(const DocumentValue& given, Hold& hold) {
  hold = Hold();
  hold.others = given.value == "others";
  pipeline::read(given, hold.names);
  pipeline::read(given, hold.values);
}

OrderedJson HoldForm::write(const Hold& hold, const WritingOptions& how) {
  if (hold.others) return "others";
  return hold.names.empty() ? written(hold.values, how) : written(hold.names, how);
}

void resolve_holds(Manifest& manifest) {
  // Captured motions and walks along paths have no parameter values.
  const auto is_reference = [](const Stimulus& stimulus) {
    return stimulus.role == Role::reference && is_blend(stimulus);
  };
  const auto found = std::ranges::find_if(manifest.stimuli, is_reference);
  if (found == manifest.stimuli.end()) return;
  visit_motion_sources(manifest, [&](Stimulus& stimulus) {
    if (&stimulus != &*found) stimulus.hold.reference = {*found};
  });
}

}  // namespace mien::pipeline
