#include "pipeline/checked_manifest.h"

#include <utility>

#include "pipeline/manifest_checks.h"
#include "pipeline/vocabulary.h"

namespace mien::pipeline {

ManifestReading check_manifest(const std::filesystem::path& file, const Environment& environment) {
  ManifestReading reading = read_manifest(file, environment);
  Vocabulary vocabulary;
  try {
    vocabulary = vocabulary_of(reading.manifest);
  } catch (const Faults& faults) {
    reading.faults.insert(reading.faults.end(), faults.list().begin(), faults.list().end());
    return reading;
  } catch (const Error& error) {
    // Names cannot be judged when the files that they come from are at fault themselves.
    reading.faults.push_back({{}, "", error.what(), ""});
    return reading;
  }
  for (Fault& fault : check_names(reading.manifest, vocabulary)) {
    reading.faults.push_back(std::move(fault));
  }
  reading.faults = in_reading_order(std::move(reading.faults));
  return reading;
}

Manifest load_manifest(const std::filesystem::path& file, const Environment& environment) {
  ManifestReading reading = check_manifest(file, environment);
  if (!reading.faults.empty()) throw Faults(std::move(reading.faults));
  return std::move(reading.manifest);
}

}  // namespace mien::pipeline
