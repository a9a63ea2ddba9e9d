#include "pipeline/study/thresholds/dose_study.h"

#include <optional>

#include <fmt/format.h>

#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::test {

std::string dose_study_text(const std::string& members) {
  std::string text =
      "mien: 1\nstudy: doses\nseed: 5\nexamples: {set: builtin:walks-10}\n"
      "questionnaire: {" +
      members + "}\noutput: {video: [mp4]}\nstimuli:\n";
  for (const char* actor : {"a", "b"})
    for (int i = 0; i < 7; ++i)
      text += fmt::format(
          "  - {{id: {0}{1}, weights: {{normal: 1}}, factors: {{actor: {0}, dose: {2:g}, dots: "
          "{3}, word: w{1}}}}}\n",
          actor, i, 0.5 * i, 70 - 10 * i);
  return text;
}

pipeline::Manifest dose_study(const std::string& members) {
  const pipeline::ManifestReading reading = pipeline::parse_manifest(
      dose_study_text(members), "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  if (!reading.faults.empty()) throw pipeline::Faults(reading.faults);
  return reading.manifest;
}

std::string adaptive_members(const std::string& form, const std::string& more) {
  return fmt::format("participants: 3, question: Which one, trials: {}, adaptive: {{{}}}", form,
                     more);
}

}  // namespace mien::test
