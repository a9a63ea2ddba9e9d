#include "pipeline/manifest/people.h"

#include <algorithm>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"

namespace mien::pipeline {

namespace {

Person* person_named(Stimulus& stimulus, const std::string& name) {
  const auto found = std::ranges::find(stimulus.people, name, &Person::name);
  return found == stimulus.people.end() ? nullptr : &*found;
}

/// The motion that a swap of a person names: that of a stimulus, of its person of the same name, or
/// of the person "stimulus.name".
const Stimulus* named_motion(const std::vector<Stimulus>& stimuli, const std::string& name,
                             const std::string& person) {
  for (const Stimulus& stimulus : stimuli) {
    if (stimulus.people.empty() && stimulus.id == name) return &stimulus;
    for (const Person& other : stimulus.people) {
      const bool is_namesake = stimulus.id == name && other.name == person;
      if (is_namesake || other.motion.id == name) return &other.motion;
    }
  }
  return nullptr;
}

std::vector<std::string> names_of_motions(const std::vector<Stimulus>& stimuli) {
  std::vector<std::string> names;
  for (const Stimulus& stimulus : stimuli) {
    names.push_back(stimulus.id);
    for (const Person& person : stimulus.people) names.push_back(person.motion.id);
  }
  return names;
}

/// What is made stays under the person's own name.
void take_motion(const Stimulus& source, Stimulus& motion) {
  motion.adjectives = source.adjectives;
  motion.hold = source.hold;
  motion.features = source.features;
  motion.weights = source.weights;
  motion.clip = source.clip;
  motion.walk = source.walk;
  motion.walk_moods = source.walk_moods;
  motion.modify = source.modify;
  motion.interpolation = source.interpolation;
  motion.on_fault = source.on_fault;
}

void swap_motion(Stimulus& stimulus, const std::string& name, const std::string& from,
                 const std::vector<Stimulus>& stated, FaultList& list) {
  const std::string at = member_path(member_path(stimulus.path, "swap"), name);
  Person* person = person_named(stimulus, name);
  if (person == nullptr) {
    std::vector<std::string> names;
    for (const Person& one : stimulus.people) names.push_back(one.name);
    return list.add_at_key(at, motion::in_quotes(name) + " is not a person of this stimulus",
                           motion::did_you_mean(name, names));
  }
  const Stimulus* source = named_motion(stated, from, name);
  if (source == nullptr) {
    const auto film = std::ranges::find(stated, from, &Stimulus::id);
    if (film != stated.end() && !film->people.empty())
      return list.add(at, from + " has no person " + motion::in_quotes(name),
                      "name one of its people, such as " + film->people.front().motion.id);
    return list.add(at,
                    motion::in_quotes(from) +
                        " is neither a stimulus with one motion or a person " +
                        motion::in_quotes(name) + " nor a person of a stimulus",
                    motion::did_you_mean(from, names_of_motions(stated)));
  }
  if (source->id == person->motion.id)
    return list.add(at, "this is the person's own motion", "name the motion of another");
  person->stated = person->motion;
  take_motion(*source, person->motion);
}

}  // namespace

void PersonFigureForm::read(const DocumentValue& given, std::optional<scenes::Figure>& figure) {
  scenes::BodyFigure body;
  FigureForm<scenes::BodyFigure>::read(given, body);
  figure = std::visit([](const auto& options) { return scenes::Figure(options); }, body);
}

OrderedJson PersonFigureForm::write(const std::optional<scenes::Figure>& figure,
                                    const WritingOptions& how) {
  return figure ? FigureForm<scenes::Figure>::write(*figure, how) : OrderedJson();
}

Person plain_person(const Stimulus& stimulus) {
  Person person;
  person.motion.look = stimulus.look;
  person.motion.output = stimulus.output;
  person.motion.interpolation = stimulus.interpolation;
  person.motion.on_fault = stimulus.on_fault;
  person.motion.regression = stimulus.regression;
  return person;
}

std::vector<const Stimulus*> motions_in(const Stimulus& stimulus) {
  if (stimulus.people.empty()) return {&stimulus};
  std::vector<const Stimulus*> motions;
  for (const Person& person : stimulus.people) motions.push_back(&person.motion);
  return motions;
}

std::vector<const Stimulus*> motion_sources(const Manifest& manifest) {
  std::vector<const Stimulus*> sources;
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const Stimulus* motion : motions_in(stimulus)) sources.push_back(motion);
  }
  return sources;
}

const Stimulus* film_showing(const Manifest& manifest, const std::string& id) {
  const auto shows = [&](const Stimulus& film) {
    const auto is_it = [&](const Stimulus* motion) { return motion->id == id; };
    return film.id == id || std::ranges::any_of(motions_in(film), is_it);
  };
  const auto found = std::ranges::find_if(manifest.stimuli, shows);
  return found == manifest.stimuli.end() ? nullptr : &*found;
}

bool has_people(const Manifest& manifest) {
  return std::ranges::any_of(manifest.stimuli,
                             [](const Stimulus& stimulus) { return !stimulus.people.empty(); });
}

void name_people(Manifest& manifest) {
  for (Stimulus& stimulus : manifest.stimuli) {
    for (std::size_t i = 0; i < stimulus.people.size(); ++i) {
      Person& person = stimulus.people[i];
      if (person.name.empty()) person.name = std::string(1, static_cast<char>('a' + i % 26));
      person.motion.id = stimulus.id + "." + person.name;
      person.motion.path = element_path(member_path(stimulus.path, "people"), i);
      if (person.figure) person.motion.look.figure = *person.figure;
      if (person.face) person.motion.look.face = *person.face;
      if (person.hands) person.motion.look.hands = *person.hands;
    }
  }
}

bool keeps_captured_space(const Stimulus& stimulus) {
  const auto is_captured = [](const Person& person) { return person.motion.clip.has_value(); };
  const auto is_placed = [](const Person& person) { return person.place.has_value(); };
  return std::ranges::any_of(stimulus.people, is_captured) &&
         std::ranges::none_of(stimulus.people, [&](const Person& person) {
           return is_captured(person) && is_placed(person);
         });
}

std::vector<Fault> resolve_swaps(Manifest& manifest) {
  FaultList list(manifest.places);
  const auto has_swap = [](const Stimulus& stimulus) { return !stimulus.swap.empty(); };
  if (std::ranges::none_of(manifest.stimuli, has_swap)) return {};
  const std::vector<Stimulus> stated = manifest.stimuli;
  for (Stimulus& stimulus : manifest.stimuli) {
    for (const auto& [name, from] : stimulus.swap) swap_motion(stimulus, name, from, stated, list);
  }
  return list.take();
}

}  // namespace mien::pipeline
