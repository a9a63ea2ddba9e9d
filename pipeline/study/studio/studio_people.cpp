#include "pipeline/study/studio/studio_people.h"

#include <algorithm>
#include <cmath>

#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t max_films = 4;

bool has_people(const ordered_json& document, const std::string& name) {
  const ordered_json stimuli = document.value("stimuli", ordered_json::array());
  return std::ranges::any_of(stimuli, [&](const ordered_json& stimulus) {
    return stimulus.is_object() && stimulus.value("id", ordered_json()) == name &&
           stimulus.contains("people");
  });
}

/// Adds what is to be said of a person's motion.
void add_remarks(const Person& person, const Synthesis& motion, double fps, PeopleOfFilm& film) {
  const std::string name = person.name + ": ";
  const auto delay = static_cast<int>(std::lround(person.start * fps));
  for (motion::Finding finding : motion.findings) {
    finding.first += delay;
    finding.last += delay;
    finding.sentence = name + finding.sentence;
    film.findings.push_back(std::move(finding));
  }
  for (const std::string& warning : motion.warnings) film.warnings.push_back(name + warning);
  for (const std::string& note : motion.notes) film.notes.push_back(name + note);
}

}  // namespace

StudioPeople::Cached StudioPeople::of(const ordered_json& document, const std::string& name) {
  if (!has_people(document, name)) return nullptr;
  const ordered_json about = document_excerpt(document, {name});
  const std::string key =
      name + "\n" + about.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  std::erase_if(cache_, [](const auto& entry) { return !entry.second->files.are_unchanged(); });
  for (const auto& [cached_key, cached] : cache_)
    if (cached_key == key) return cached;
  const Manifest manifest = reader_.read(about);
  const Stimulus& stimulus = *find_stimulus(manifest, name);
  Motions motions(manifest);
  std::vector<std::filesystem::path> files = files_of_examples(manifest);
  for (std::filesystem::path& file : files_of_motion(manifest, stimulus))
    files.push_back(std::move(file));
  auto film = std::make_shared<PeopleOfFilm>(PeopleOfFilm{{}, {}, {}, {}, SeenFiles(files)});
  film->shown = shown_people(stimulus, motions);
  for (const Person& person : stimulus.people)
    add_remarks(person, motions.of(person.motion.id), stimulus.output.fps, *film);
  film->notes.push_back("The feet in the timeline are those of " + stimulus.people.front().name +
                        ".");
  cache_.emplace_front(key, film);
  if (cache_.size() > max_films) cache_.pop_back();
  return film;
}

}  // namespace mien::pipeline
