#include "pipeline/manifest/factors.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

bool has(const Factors& factors, const std::string& name) {
  return std::ranges::find(factors, name, &Factors::value_type::first) != factors.end();
}

Factors plain_levels(const Stimulus& stimulus) {
  std::string emotions, strengths;
  for (const ModificationStep& step : stimulus.modify) {
    if (step.emotion.empty()) continue;
    emotions += (emotions.empty() ? "" : "+") + step.emotion;
    strengths += (strengths.empty() ? "" : "+") + shortest(step.strength);
  }
  Factors levels;
  if (!emotions.empty()) levels = {{"emotion", emotions}, {"strength", strengths}};
  const auto counts = [](const auto& weight) { return weight.second > 0.0; };
  if (std::ranges::count_if(stimulus.weights, counts) == 1) {
    levels.emplace_back("example", std::ranges::find_if(stimulus.weights, counts)->first);
  }
  if (stimulus.clip) levels.emplace_back("clip", stimulus.clip->file.stem().string());
  if (stimulus.sound) levels.emplace_back("audio", sound_level(stimulus));
  return levels;
}

}  // namespace

std::string level_text(const json& level) {
  if (level.is_string()) return level.get<std::string>();
  return level.is_number_float() ? shortest(level.get<double>()) : level.dump();
}

void FactorsForm::read(const DocumentValue& given, Factors& factors) {
  if (!given.value.is_object()) return;
  factors.clear();
  for (const std::string& name : written_order(given.value, given.path, given.context.places)) {
    const json& level = given.value[name];
    if (level.is_primitive() && !level.is_null()) factors.emplace_back(name, level_text(level));
  }
}

OrderedJson FactorsForm::write(const Factors& factors, const WritingOptions&) {
  if (factors.empty()) return {};
  OrderedJson map;
  for (const auto& [name, level] : factors) map[name] = level;
  return map;
}

Factors levels_of(const Stimulus& stimulus) {
  Factors levels = stimulus.factors;
  for (const auto& [name, level] : plain_levels(stimulus)) {
    if (!has(stimulus.factors, name)) levels.emplace_back(name, level);
  }
  return levels;
}

std::vector<std::string> factors_of(const Manifest& manifest) {
  std::vector<std::string> names;
  const auto add = [&](const Factors& factors) {
    for (const auto& [name, level] : factors) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  };
  for (const Stimulus& stimulus : manifest.stimuli) add(stimulus.factors);
  for (const Stimulus& stimulus : manifest.stimuli) add(plain_levels(stimulus));
  return names;
}

bool is_stated(const Manifest& manifest, const std::string& factor) {
  return std::ranges::any_of(manifest.stimuli,
                             [&](const Stimulus& one) { return has(one.factors, factor); });
}

std::vector<std::string> studied_factors(const Manifest& manifest) {
  std::vector<std::string> names = factors_of(manifest);
  std::erase_if(names, [&](const std::string& name) {
    return name != "emotion" && name != "audio" && !is_stated(manifest, name);
  });
  return names;
}

std::string level_of(const Stimulus& stimulus, const std::string& factor) {
  for (const auto& [name, level] : levels_of(stimulus)) {
    if (name == factor) return level;
  }
  return "";
}

}  // namespace mien::pipeline
