#include "pipeline/production/methods/study_facts.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/interpolation/interpolation_options.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/recording_files.h"

namespace mien::pipeline {

std::string ratings_of(const Stimulus* stimulus, Motions& motions) {
  if (stimulus == nullptr || stimulus->adjectives.empty()) return "none";
  return motions.repertoire().simulated_ratings ? "simulated" : "given";
}

std::string_view source_of(const Stimulus& stimulus) {
  if (!stimulus.people.empty()) return "people";
  if (stimulus.clip) return "clip";
  if (stimulus.walk) return "path";
  if (!stimulus.features.empty()) return "features";
  return stimulus.adjectives.empty() ? "weights" : "adjectives";
}

std::vector<const Stimulus*> stimuli_from(const Manifest& manifest, std::string_view source) {
  std::vector<const Stimulus*> found;
  for (const Stimulus* motion : motion_sources(manifest)) {
    if (source_of(*motion) == source) found.push_back(motion);
  }
  return found;
}

std::string method_of(const Stimulus& stimulus) {
  if (!is_blend(stimulus)) return "";
  return std::string(motion::name_of(stimulus.weights.empty()
                                         ? stimulus.interpolation.weights.method
                                         : motion::InterpolationMethod::direct));
}

std::string person_facts(const Person& person) {
  std::string facts = person.place
                          ? fmt::format("at x {:g} m, z {:g} m, turned by {:g}°", person.place->x,
                                        person.place->z, person.place->turn)
                      : person.motion.clip ? std::string("where it was recorded")
                                           : std::string("along its path on the stage");
  if (person.start != 0.0) facts += fmt::format(", begins at {:g} s", person.start);
  return person.stated ? facts + ", with another's motion" : facts;
}

std::string scene_name(const Look& look) {
  return look.scene_file.empty() ? scene_of(look) : look.scene_file.filename().string();
}

bool uses_examples(const Manifest& manifest) {
  return blends_examples(manifest) || std::ranges::any_of(manifest.stimuli, names_examples);
}

std::vector<ExpectationCheck> expectation_checks(const Manifest& manifest,
                                                 const Repertoire& repertoire) {
  if (!repertoire.impressions) return {};
  return check_expectations(manifest.ratings.expected, {repertoire.parameters, repertoire.names,
                                                        repertoire.answers, repertoire.scales});
}

std::string figure_options(const Look& look) {
  const OrderedJson figure =
      FigureForm<scenes::Figure>::write(look.figure, WritingOptions{.for_key = true});
  OrderedJson options = figure.is_string() ? OrderedJson() : *figure.begin();
  if (look.hands != scenes::Hands::automatic) {
    const std::string hands(word_of(hands_words, look.hands));
    // A character has its file in place of options.
    if (options.is_string()) options = {{figure.begin().key(), options}};
    options["hands"] = hands;
  }
  return options.is_null() || options.empty() ? "" : options.dump();
}

std::string camera_options(const Look& look) {
  OrderedJson camera = written(look.camera, WritingOptions{.for_key = true});
  if (camera.is_object()) camera.erase("view");
  return !camera.is_object() || camera.empty() ? "" : camera.dump();
}

}  // namespace mien::pipeline
