// Any text gives a manifest with a list of faults that can be told, and scales or their faults.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/ratings/scales/scales.h"

using namespace mien::pipeline;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const Environment environment = [](const std::string& name) { return std::optional(name); };
  const ManifestReading reading = parse_manifest(text, "fuzz.yaml", environment);
  for (const Fault& fault : reading.faults) {
    if (to_string(fault).empty()) std::abort();
  }
  check_names(reading.manifest, {{"quickness", "sad-happy"}, {"normal", "proud"}});
  try {
    const ScaleSet scales = parse_scales(text, "fuzz.yaml");
    for (const Scale& scale : scales.scales) {
      if (!(scale.least < scale.most)) std::abort();
    }
  } catch (const mien::Error&) {
    // Refused, with words.
  }
  return 0;
}
