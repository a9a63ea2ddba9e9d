#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/live/live_bundle_writer.h"

namespace mien::test {

/// A study of built-in walks with targets of every kind. `interpolation` and `output` are YAML.
inline pipeline::Manifest live_manifest(const std::string& interpolation,
                                        const std::string& output = "{fps: 30}",
                                        const std::string& set = "walks-10") {
  const std::string text = "mien: 1\nstudy: live\nexamples: {set: builtin:" + set +
                           ", ratings: builtin}\n" + "output: " + output +
                           "\ninterpolation: " + interpolation + "\n" + R"(stimuli:
  - {id: by-adjectives, adjectives: {quickness: 0.6, largeness: 0.4}}
  - {id: by-features, features: {step-length: 0.6, lateral-swing: 0.3}}
  - {id: by-weights, weights: {normal: 0.4, sad: 0.35, proud: 0.25}}
)";
  pipeline::ManifestReading reading = pipeline::parse_manifest(
      text, "/nowhere/live.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty()) << pipeline::Faults(reading.faults).what();
  return std::move(reading.manifest);
}

/// The setting of sliders that a stimulus of it is.
inline motion::LiveSetting setting_of(const pipeline::Stimulus& stimulus) {
  motion::LiveSetting setting;
  const auto take = [&](motion::InterfaceKind kind, const pipeline::NamedValues& values) {
    if (values.empty()) return;
    setting.kind = kind;
    for (const auto& [name, value] : values) {
      setting.sliders.push_back(name);
      setting.values.push_back(value);
    }
  };
  take(motion::InterfaceKind::adjectives, stimulus.adjectives);
  take(motion::InterfaceKind::features, stimulus.features);
  take(motion::InterfaceKind::weights, stimulus.weights);
  return setting;
}

}  // namespace mien::test
