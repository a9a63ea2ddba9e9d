#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "motion/formats/written_motion.h"
#include "motion/interpolation/interpolation_options.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/people.h"
#include "render/video/video_kind.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

using Names = std::vector<std::string>;

bool is_among(const std::string& name, const Names& known) {
  return std::ranges::find(known, name) != known.end();
}

/// Names that many others are looked up in.
struct NameIndex {
  explicit NameIndex(Names all, bool is_all_known = true)
      : names(std::move(all)), known(names.begin(), names.end()), is_all(is_all_known) {}

  /// Whether the name is unknown. Where not all names are known, only if it is a near miss of one.
  bool lacks(const std::string& name) const {
    const auto is_near = [&](const std::string& one) {
      return motion::edit_distance(name, one) <= 1;
    };
    return !known.contains(name) && (is_all || std::ranges::any_of(names, is_near));
  }

  Names names;  ///< as they were given
  std::set<std::string_view> known;
  bool is_all;  ///< there are no other valid names
  /// Stimuli with several people, which have no motion of their own, and the id of the first.
  std::map<std::string, std::string> several = {};
};

/// What many file systems take for one name is the same here. Ids are ASCII.
std::string without_case(std::string name) {
  std::ranges::transform(name, name.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return name;
}

struct TakenId {
  std::string id;
  std::string path;
};

/// Ids that are taken, without their case.
using TakenIds = std::map<std::string, TakenId>;

void check_unique(const std::string& id, const std::string& path, TakenIds& taken,
                  FaultList& list) {
  if (id.empty()) return;
  if (const std::string fault = motion::fault_of_name(id); !fault.empty()) {
    list.add(member_path(path, "id"), "\"" + id + "\" " + fault + ", and files are named after it",
             "use another id");
    return;
  }
  const auto [entry, is_new] = taken.emplace(without_case(id), TakenId{id, path});
  if (is_new) return;
  const TakenId& first = entry->second;
  const std::string at = member_path(path, "id");
  if (first.id == id) {
    list.add(at, motion::in_quotes(id) + " is already the id of " + first.path,
             "give each a different one");
  } else {
    list.add(at,
             motion::in_quotes(id) + " differs from " + motion::in_quotes(first.id) + " of " +
                 first.path + " only in case, and so would their files",
             "use another id");
  }
}

/// The videos and motion files of a film, as they are named; none if its id cannot be a name.
Names file_names(const Stimulus& film) {
  Names names;
  if (film.id.empty() || !motion::fault_of_name(film.id).empty()) return names;
  for (const render::VideoKind kind : film.output.video)
    names.push_back("video " + render::with_ending(film.id, kind).string());
  for (const Stimulus* motion : motions_in(film)) {
    for (const std::string& ending : film.output.clips)
      for (const auto& file : motion::written_files(motion->id + "." + ending))
        names.push_back("clip " + file.string());
  }
  if (scenes::kind_of(film.look.figure).has_dots) names.push_back("clip " + film.id + ".dots.csv");
  return names;
}

/// Files of two films may have the same name: "a.lossless" as mp4 and "a" as mp4-lossless, or
/// "a.dots" as csv and the dots of "a".
void check_file_names(const Manifest& manifest, FaultList& list) {
  std::map<std::string, std::string> taken;
  for (const Stimulus* film : films_of(manifest)) {
    for (const std::string& file : file_names(*film)) {
      const auto [first, is_new] = taken.emplace(without_case(file), film->id);
      // Ids that differ by case alone have been reported.
      if (is_new || without_case(first->second) == without_case(film->id)) continue;
      list.add(member_path(film->path, "id"),
               "its " + file + " would be that of " + motion::in_quotes(first->second),
               "use another id");
    }
  }
}

bool has_two_motions(const std::string& target, const std::string& created) {
  return !target.empty() && !created.empty() && target != created;
}

void check_keys(const Stimulus& stimulus, const char* map, const NamedValues& values,
                const char* what, const Names& known, FaultList& list) {
  // Without any, something else is at fault, and has been reported.
  if (known.empty()) return;
  for (const auto& [name, value] : values) {
    if (is_among(name, known)) continue;
    list.add_at_key(member_path(member_path(stimulus.path, map), name),
                    std::string("unknown ") + what, motion::did_you_mean(name, known));
  }
}

/// Parameters of the kind that the stimulus asks for, groups or scales, that it does not name.
std::size_t unnamed_parameter_count(const Stimulus& stimulus, const Names& parameters,
                                    const ScaleSet& scales) {
  const auto is_group = [&](const std::string& name) {
    return std::ranges::find(scales.groups, name, &ScaleGroup::id) != scales.groups.end();
  };
  const bool by_groups =
      std::ranges::any_of(stimulus.adjectives, is_group, &NamedValues::value_type::first);
  const auto of_kind = std::ranges::count_if(
      parameters, [&](const std::string& name) { return is_group(name) == by_groups; });
  return static_cast<std::size_t>(of_kind) -
         std::min(static_cast<std::size_t>(of_kind), stimulus.adjectives.size());
}

void check_hold(const Stimulus& stimulus, const Names& parameters, const ScaleSet& scales,
                FaultList& list) {
  const std::string path = member_path(stimulus.path, "hold");
  for (std::size_t i = 0; i < stimulus.hold.names.size(); ++i)
    list.check_known_name(element_path(path, i), stimulus.hold.names[i], "parameter", parameters);
  check_keys(stimulus, "hold", stimulus.hold.values, "parameter", parameters, list);
  const Hold& hold = stimulus.hold;
  const std::size_t held = hold.others ? unnamed_parameter_count(stimulus, parameters, scales)
                                       : hold.names.size() + hold.values.size();
  const std::size_t count = stimulus.adjectives.size() + held;
  if (stimulus.interpolation.weights.method != motion::InterpolationMethod::grid || held == 0 ||
      count <= static_cast<std::size_t>(motion::max_grid_dimensions))
    return;
  list.add(path,
           fmt::format("a grid over {} requested and held parameters has too many corners", count),
           fmt::format("hold fewer, at most {} in all, or use another method",
                       motion::max_grid_dimensions));
}

void check_motion(const std::string& path, const std::string& name, const NameIndex& motions,
                  FaultList& list) {
  if (name.empty() || !motions.lacks(name)) return;
  if (const auto found = motions.several.find(name); found != motions.several.end()) {
    return list.add(path, motion::in_quotes(name) + " has several people, each with a motion",
                    "name one of them, such as " + found->second);
  }
  list.add(path, motion::in_quotes(name) + " is neither a stimulus nor an example",
           motion::did_you_mean(name, motions.names));
}

/// Stills need a stimulus: an example has no film to take a picture from.
void check_pictured(const std::string& path, const std::string& name, const NameIndex& stimuli,
                    FaultList& list) {
  if (name.empty() || stimuli.known.contains(name)) return;
  list.add(path, motion::in_quotes(name) + " is not a stimulus",
           motion::did_you_mean(name, stimuli.names));
}

/// Refuses an order that names an example twice.
void check_order(const std::string& path, const Names& order, const Names& examples,
                 FaultList& list) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string at = element_path(path, i);
    list.check_known_name(at, order[i], "example", examples);
    const auto first = std::ranges::find(order, order[i]) - order.begin();
    if (static_cast<std::size_t>(first) == i) continue;
    list.add(at,
             fmt::format("{} is already in this order, as number {}", motion::in_quotes(order[i]),
                         first + 1),
             "name each example once");
  }
}

void check_expectations(const Manifest& manifest, const Vocabulary& vocabulary, FaultList& list) {
  const std::vector<Expectation>& expected = manifest.ratings.expected;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string path = element_path("examples.expect", i);
    list.check_known_name(member_path(path, "parameter"), expected[i].parameter, "parameter",
                          vocabulary.parameters);
    check_order(member_path(path, "order"), expected[i].order, vocabulary.examples, list);
  }
}

/// Labels and keytimes are of files.
void check_stems(const Manifest& manifest, const Names& stems, FaultList& list) {
  const auto check = [&](const std::string& path, const auto& by_stem) {
    for (const auto& [stem, value] : by_stem) {
      if (stems.empty() || is_among(stem, stems)) continue;
      list.add_at_key(member_path(path, stem), "no example has a file of this name",
                      motion::did_you_mean(stem, stems));
    }
  };
  check("examples.set.labels", manifest.examples.given_labels);
  check("examples.set.keytimes", manifest.examples.keytimes);
}

void check_compared(const std::string& path, const auto& compared, const NameIndex& motions,
                    FaultList& list) {
  check_motion(member_path(path, "target"), compared.target, motions, list);
  check_motion(member_path(path, "created"), compared.created, motions, list);
  check_motion(member_path(path, "reference"), compared.reference, motions, list);
}

void check_sheet(const Sheet& sheet, const NameIndex& motions, const NameIndex& stimuli,
                 FaultList& list) {
  check_compared(member_path(sheet.path, "compare"), sheet, motions, list);
  const std::string gallery = member_path(sheet.path, "gallery");
  for (std::size_t i = 0; i < sheet.gallery.size(); ++i)
    check_motion(element_path(gallery, i), sheet.gallery[i], motions, list);
  const std::string stills = member_path(sheet.path, "stills");
  for (std::size_t i = 0; i < sheet.stills.size(); ++i)
    check_pictured(element_path(stills, i), sheet.stills[i], stimuli, list);
}

/// What can be compared: stimuli with one motion, and people.
Names motions_of_stimuli(const Manifest& manifest) {
  Names motions;
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    if (!stimulus->id.empty()) motions.push_back(stimulus->id);
  }
  return motions;
}

Names stimuli_of(const Manifest& manifest) {
  Names stimuli;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!stimulus.id.empty()) stimuli.push_back(stimulus.id);
  }
  return stimuli;
}

}  // namespace

std::vector<Fault> check_ids(const Manifest& manifest) {
  FaultList list(manifest.places);
  TakenIds films, sheets;
  for (const Stimulus& stimulus : manifest.stimuli)
    check_unique(stimulus.id, stimulus.path, films, list);
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.id.empty()) continue;
    for (const Person& person : stimulus.people) {
      // Names that two of the people have are reported there.
      if (std::ranges::count(stimulus.people, person.name, &Person::name) == 1)
        check_unique(person.motion.id, person.motion.path, films, list);
    }
  }
  for (const Overlay& overlay : manifest.overlays) {
    if (!overlay.target.empty() && !overlay.created.empty())
      check_unique(overlay.film.id, overlay.film.path, films, list);
  }
  for (const Sheet& sheet : manifest.sheets) {
    if (!sheet.gallery.empty() || !sheet.stills.empty() ||
        has_two_motions(sheet.target, sheet.created))
      check_unique(sheet.id, sheet.path, sheets, list);
  }
  check_file_names(manifest, list);
  return list.take();
}

std::vector<Fault> check_names(const Manifest& manifest, const Vocabulary& vocabulary) {
  FaultList list(manifest.places);
  const ScaleSet scales = scales_of(manifest.scales);
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    if (stimulus->foil) continue;
    check_keys(*stimulus, "adjectives", stimulus->adjectives, "parameter", vocabulary.parameters,
               list);
    check_hold(*stimulus, vocabulary.parameters, scales, list);
    check_keys(*stimulus, "features", stimulus->features, "feature", vocabulary.features, list);
    check_keys(*stimulus, "weights", stimulus->weights, "example", vocabulary.examples, list);
  }
  const NameIndex stimuli(stimuli_of(manifest));
  Names all = motions_of_stimuli(manifest);
  all.insert(all.end(), vocabulary.examples.begin(), vocabulary.examples.end());
  NameIndex motions(std::move(all), vocabulary.knows_examples);
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!stimulus.people.empty())
      motions.several.emplace(stimulus.id, stimulus.people.front().motion.id);
  }
  check_expectations(manifest, vocabulary, list);
  check_stems(manifest, vocabulary.file_stems, list);
  for (const Overlay& overlay : manifest.overlays)
    check_compared(overlay.film.path, overlay, motions, list);
  for (const Sheet& sheet : manifest.sheets) check_sheet(sheet, motions, stimuli, list);
  return list.take();
}

}  // namespace mien::pipeline
