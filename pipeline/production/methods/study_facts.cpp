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

Look look_of_person(const Stimulus& stimulus, const Person& person) {
  Look look = stimulus.look;
  if (person.figure) look.figure = *person.figure;
  if (person.face) look.face = *person.face;
  look.hands = person.hands.value_or(look.hands);
  return look;
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

namespace {

/// The options of a figure; a character has its file in place of options, until others are added.
class FigureOptions {
 public:
  explicit FigureOptions(const scenes::Figure& figure)
      : figure_(FigureForm<scenes::Figure>::write(figure, by_name)),
        options_(figure_.is_string() ? OrderedJson() : *figure_.begin()) {}

  void add(const char* name, const OrderedJson& value) {
    if (value.is_null()) return;
    if (options_.is_string()) options_ = {{figure_.begin().key(), options_}};
    options_[name] = value;
  }
  void add_look(const Look& look) {
    add("face", FaceForm::write(look.face, by_name));
    if (look.hands != scenes::Hands::automatic)
      add("hands", std::string(word_of(hands_words, look.hands)));
  }
  std::string text() const { return options_.is_null() || options_.empty() ? "" : options_.dump(); }

  static inline const WritingOptions by_name{.for_key = true};

 private:
  OrderedJson figure_;
  OrderedJson options_;
};

/// The figures, faces and hands that people have instead of the stimulus's, by their names; null
/// without.
OrderedJson looks_of_people(const Stimulus& stimulus) {
  OrderedJson people;
  for (const Person& person : stimulus.people) {
    const OrderedJson figure = PersonFigureForm::write(person.figure, FigureOptions::by_name);
    const OrderedJson face = PersonFaceForm::write(person.face, FigureOptions::by_name);
    if (!figure.is_null()) people[person.name]["figure"] = figure;
    if (!face.is_null()) people[person.name]["face"] = face;
    const OrderedJson hands = PersonHandsForm::write(person.hands, FigureOptions::by_name);
    if (!hands.is_null()) people[person.name]["hands"] = hands;
  }
  return people;
}

}  // namespace

std::string figure_options(const Look& look) {
  FigureOptions options(look.figure);
  options.add_look(look);
  return options.text();
}

std::string figure_options(const Stimulus& stimulus) {
  FigureOptions options(stimulus.look.figure);
  options.add_look(stimulus.look);
  options.add("people", looks_of_people(stimulus));
  return options.text();
}

std::string camera_options(const Look& look) {
  OrderedJson camera = written(look.camera, WritingOptions{.for_key = true});
  if (camera.is_object()) camera.erase("view");
  return !camera.is_object() || camera.empty() ? "" : camera.dump();
}

}  // namespace mien::pipeline
