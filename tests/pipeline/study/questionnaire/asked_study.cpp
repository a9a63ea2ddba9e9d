#include "pipeline/study/questionnaire/asked_study.h"

#include <optional>

#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::test {

std::string asked_study_text(int stimuli, const std::string& members) {
  constexpr const char* actors[] = {"a", "b", "c"};
  constexpr const char* emotions[] = {"sad", "happy", "angry", "calm"};
  std::string text =
      "mien: 1\nstudy: s\nseed: 11\nexamples: {set: builtin:walks-10}\n"
      "questionnaire: {" +
      members + "}\nstimuli:\n";
  for (int i = 0; i < stimuli; ++i) {
    const std::string actor = actors[i % 3];
    text += "  - {id: " + actor + std::to_string(i + 1) +
            ", weights: {normal: 1}, factors: {actor: " + actor +
            ", emotion: " + emotions[i / 4 % 4] + "}}\n";
  }
  return text;
}

pipeline::Manifest asked_study(int stimuli, const std::string& members) {
  const pipeline::ManifestReading reading =
      pipeline::parse_manifest(asked_study_text(stimuli, members), "/nowhere/m.yaml",
                               [](const std::string&) { return std::nullopt; });
  if (!reading.faults.empty()) throw pipeline::Faults(reading.faults);
  return reading.manifest;
}

}  // namespace mien::test
