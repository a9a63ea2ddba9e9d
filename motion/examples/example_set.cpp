#include "motion/examples/example_set.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <set>

#include "motion/error.h"
#include "motion/examples/flight_examples.h"
#include "motion/formats/fitted_file.h"
#include "motion/formats/keypoints/keypoint_frames.h"
#include "motion/formats/motion_file.h"
#include "motion/gait/gait_events.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/retarget.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/frame_file_name.h"
#include "motion/text/glob.h"
#include "motion/text/nearest_word.h"

namespace mien::motion {

namespace {

namespace fs = std::filesystem;

/// Mappings of all recordings, calibrated over those that share a rig.
std::vector<BodyMapping> mappings_of(const std::vector<Recording>& recordings) {
  std::vector<BodyMapping> mappings(recordings.size());
  std::vector<bool> done(recordings.size(), false);
  for (size_t i = 0; i < recordings.size(); ++i) {
    if (done[i]) continue;
    std::vector<Recording> rig;
    std::vector<size_t> members;
    for (size_t k = i; k < recordings.size(); ++k) {
      if (done[k] || !same_rig(recordings[i].skeleton, recordings[k].skeleton)) continue;
      rig.push_back(recordings[k]);
      members.push_back(k);
      done[k] = true;
    }
    const BodyMapping mapping = recognise(rig);
    for (const size_t k : members) mappings[k] = mapping;
  }
  return mappings;
}

std::vector<std::string> names_of(const ExampleFolder& folder,
                                  const std::vector<std::string>& stems) {
  std::vector<std::string> names = folder.shorten_names ? labels_from_names(stems) : stems;
  const std::map<std::string, std::string> given(folder.names.begin(), folder.names.end());
  std::set<std::string> seen;
  for (size_t i = 0; i < stems.size(); ++i) {
    if (const auto name = given.find(stems[i]); name != given.end()) names[i] = name->second;
    if (seen.insert(names[i]).second) continue;
    throw Error({folder.path.string(), 0, 0}, "two motions are named " + in_quotes(names[i]),
                "rename one of them");
  }
  return names;
}

/// Keytimes by hand in the order of the files; empty ones when none are given.
std::vector<std::vector<double>> keytimes_of(const ExampleFolder& folder,
                                             const std::vector<std::string>& stems) {
  std::vector<std::vector<double>> keytimes(stems.size());
  if (folder.keytimes.empty()) return keytimes;
  const Place place{folder.path.string()};
  for (const auto& [stem, times] : folder.keytimes) {
    const auto found = std::find(stems.begin(), stems.end(), stem);
    if (found == stems.end()) {
      throw Error(place, "there are keytimes of " + in_quotes(stem) + " but no such file",
                  did_you_mean(stem, stems));
    }
    keytimes[static_cast<size_t>(found - stems.begin())] = times;
  }
  for (size_t i = 0; i < stems.size(); ++i) {
    if (!keytimes[i].empty()) continue;
    throw Error(place, in_quotes(stems[i]) + " has no keytimes, unlike others",
                "specify them, or omit it with exclude");
  }
  return keytimes;
}

/// "2 heel strikes, the first of the left foot"
std::string heel_strikes_of(const Clip& clip) {
  std::vector<GaitEvent> strikes = gait_events(clip);
  std::erase_if(strikes, [](const GaitEvent& event) {
    return event.kind != GaitEvent::Kind::heel_strike || !event.confirmed;
  });
  if (strikes.empty()) return "no heel strike";
  const std::string foot = strikes.front().left ? "the left foot" : "the right foot";
  if (strikes.size() == 1) return "1 heel strike, of " + foot;
  return std::to_string(strikes.size()) + " heel strikes, the first of " + foot;
}

/// What the keytimes of an example are, and why: "\"sad\" has 7: a gait cycle (frames 12 to 75)".
std::string keytimes_in_words(const Example& example, const ExampleOrigin& origin, bool are_given) {
  const std::size_t count = example.keytimes.size();
  const std::string words = in_quotes(example.name) + " has " + std::to_string(count) + ": ";
  if (are_given) return words + "those given for it";
  if (origin.is_cycle)
    return words + "a gait cycle (frames " + std::to_string(origin.frames.first) + " to " +
           std::to_string(origin.frames.last) + ")";
  const std::string why = " (no gait cycle was found: " + heel_strikes_of(example.clip) + ")";
  if (example.clip.loops) return words + "the start and the end of the loop" + why;
  const std::string pauses = count == 2   ? "the start"
                             : count == 3 ? "the start, a pause"
                                          : "the start, " + std::to_string(count - 2) + " pauses";
  return words + pauses + " and the end of the whole motion" + why;
}

/// Those with another number of keytimes than most come first.
[[noreturn]] void refuse_keytimes(const ExampleFolder& folder, const LoadedExamples& loaded) {
  const std::vector<Example>& examples = loaded.set.examples;
  std::map<std::size_t, int> having;
  for (const Example& example : examples) ++having[example.keytimes.size()];
  const auto usual =
      std::ranges::max_element(having, {}, [](const auto& each) { return each.second; });
  std::vector<std::string> rare;
  std::vector<std::string> others;
  for (std::size_t i = 0; i < examples.size(); ++i)
    (examples[i].keytimes.size() == usual->first ? others : rare)
        .push_back(keytimes_in_words(examples[i], loaded.origins[i], !folder.keytimes.empty()));
  rare.insert(rare.end(), others.begin(), others.end());
  throw Error(
      {folder.path.string()},
      "examples that are blended need the same number of keytimes, but " + first_of(rare, 6, "; "),
      folder.keytimes.empty()
          ? "omit those that differ with exclude, use whole motions with cycle: whole, "
            "state the corresponding moments of all with keytimes, or do not blend with "
            "blend: false"
          : "give every motion the same number of keytimes");
}

/// One number of keytimes, one body. Throws Error where keytimes differ.
void make_blendable(const ExampleFolder& folder, LoadedExamples& loaded) {
  std::vector<Example>& examples = loaded.set.examples;
  const bool any_loops = std::any_of(examples.begin(), examples.end(),
                                     [](const Example& example) { return example.clip.loops; });
  if (!any_loops && folder.keytimes.empty()) even_keytimes(examples);
  const size_t key_count = examples.front().keytimes.size();
  const bool differs = std::ranges::any_of(
      examples, [&](const Example& example) { return example.keytimes.size() != key_count; });
  if (differs) refuse_keytimes(folder, loaded);
  for (size_t i = 1; i < examples.size(); ++i)
    examples[i].clip = retarget(examples[i].clip, examples.front().clip.body);
  if (!folder.keytimes.empty() || use_flight_keytimes(examples)) return;
  for (const std::string& name : running_examples(examples)) {
    loaded.warnings.push_back(name +
                              ": It runs, and other examples of the set do not; in blends of "
                              "both, flight phases do not correspond and feet may slide.");
  }
}

FittedFile read_motion(const ExampleFolder& folder, const fs::path& file) {
  ReadOptions how = folder.how;
  if (!may_hold_takes(file)) how.take.reset();
  FittedFile read = read_fitted(file, how);
  if (read.recording.frame_count() < 2)
    throw Error({file.string()}, "it holds fewer than two frames",
                "give a motion, not a pose, or omit it with exclude");
  return read;
}

/// Throws one Error about all files that cannot be read.
std::vector<FittedFile> read_all(const ExampleFolder& folder, const std::vector<fs::path>& files) {
  std::vector<FittedFile> all;
  std::vector<std::string> faults;
  std::exception_ptr first;
  for (const fs::path& file : files) {
    try {
      all.push_back(read_motion(folder, file));
    } catch (const Error& fault) {
      if (!first) first = std::current_exception();
      faults.push_back(fault.what());
    }
  }
  if (faults.size() == 1) std::rethrow_exception(first);
  if (faults.empty()) return all;
  constexpr std::size_t most_named = 6;
  throw Error({folder.path.string()},
              std::to_string(faults.size()) +
                  " files cannot be used: " + first_of(faults, most_named, " | "),
              "mend them, or omit them with exclude");
}

constexpr std::string_view separators = "_. ";

bool is_separator(char c) { return separators.find(c) != std::string_view::npos; }

/// How many stems' characters agree from the start (or, `reversed`, from the end).
size_t shared_length(std::span<const std::string> stems, bool reversed) {
  const auto at = [&](const std::string& stem, size_t i) {
    return reversed ? stem[stem.size() - 1 - i] : stem[i];
  };
  size_t shared = stems.front().size();
  for (const std::string& stem : stems) {
    shared = std::min(shared, stem.size());
    size_t i = 0;
    while (i < shared && at(stem, i) == at(stems.front(), i)) ++i;
    shared = i;
  }
  return shared;
}

/// Whether the pattern matches the name by its ending, as "*.csv" and "*.{csv,npz}" do.
bool names_ending(const std::string& pattern, const std::string& name) {
  const fs::path other = fs::path(name).replace_extension(".any-other-ending");
  return matches_glob(pattern, name) && !matches_glob(pattern, other.string());
}

}  // namespace

std::vector<fs::path> example_files(const ExampleFolder& folder) {
  std::error_code failed;
  fs::directory_iterator entries(folder.path, failed);
  if (failed) {
    throw Error({folder.path.string(), 0, 0}, "is not a readable folder",
                "name the folder that holds the motion files");
  }
  std::vector<fs::path> files;
  const auto is_chosen = [&](const std::string& name) {
    return matches_glob(folder.include, name) &&
           (folder.exclude.empty() || !matches_glob(folder.exclude, name));
  };
  for (const fs::directory_entry& entry : entries) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.')) continue;  // hidden: macOS puts "._walk.bvh" beside "walk.bvh"
    if (!is_chosen(name)) continue;
    if (entry.is_directory())
      std::ranges::copy(keypoint_recordings(entry.path()), std::back_inserter(files));
    if (!entry.is_regular_file() || frame_file_name(name)) continue;
    const bool is_named = is_motion_file(entry.path()) && names_ending(folder.include, name);
    if (is_named || is_found_as_motion(entry.path())) files.push_back(entry.path());
  }
  for (const fs::path& frame : keypoint_recordings(folder.path))
    if (is_chosen(frame.filename().string())) files.push_back(frame);
  std::sort(files.begin(), files.end());
  if (files.empty()) {
    throw Error({folder.path.string(), 0, 0},
                "holds no motion file that matches " + in_quotes(folder.include),
                "use " + formats_read() + "; check upper and lower case of the pattern");
  }
  return files;
}

std::vector<std::string> example_names(const ExampleFolder& folder) {
  std::vector<std::string> stems;
  for (const fs::path& file : example_files(folder)) stems.push_back(recording_name(file));
  return names_of(folder, stems);
}

LoadedExamples load_examples(const ExampleFolder& folder) {
  std::vector<Recording> recordings;
  std::vector<std::optional<FitQuality>> fits;
  LoadedExamples loaded;
  const std::vector<fs::path> files = example_files(folder);
  for (FittedFile& read : read_all(folder, files)) {
    const std::string name = files[recordings.size()].filename().string();
    recordings.push_back(std::move(read.recording));
    fits.push_back(std::move(read.fit));
    for (const std::string& note : recordings.back().notes)
      loaded.warnings.push_back(name + ": " + note);
    loaded.file_stems.push_back(recording_name(files[recordings.size() - 1]));
  }
  const std::vector<std::string> names = names_of(folder, loaded.file_stems);
  const std::vector<BodyMapping> mappings = mappings_of(recordings);
  const std::vector<std::vector<double>> keytimes = keytimes_of(folder, loaded.file_stems);
  loaded.set.name = folder.path.filename().string();
  for (size_t i = 0; i < recordings.size(); ++i) {
    const Clip take = to_body(recordings[i], mappings[i]);
    PreparedExample prepared =
        prepare_example(take, {.cycle = folder.cycle, .keytimes = keytimes[i]});
    prepared.example.name = names[i];
    if (prepared.cycle) {
      for (const std::string& warning : prepared.cycle->warnings) {
        loaded.warnings.push_back(names[i] + ": " + warning);
      }
    }
    loaded.origins.push_back({files[i], take.frames_per_second, take.frame_count(), prepared.frames,
                              prepared.cycle && prepared.cycle->is_half, std::move(fits[i]),
                              prepared.cycle.has_value()});
    loaded.set.examples.push_back(std::move(prepared.example));
  }
  loaded.set.blendable = folder.blendable;
  if (folder.blendable) make_blendable(folder, loaded);
  return loaded;
}

std::vector<std::string> labels_from_names(std::span<const std::string> stems) {
  std::vector<std::string> labels(stems.begin(), stems.end());
  if (stems.size() < 2) return labels;
  const std::string& first = stems.front();
  size_t prefix = shared_length(stems, false);
  while (prefix > 0 && !is_separator(first[prefix - 1])) --prefix;
  size_t suffix = shared_length(stems, true);
  while (suffix > 0 && !is_separator(first[first.size() - suffix])) --suffix;
  for (std::string& label : labels) {
    if (label.size() <= prefix + suffix) return {stems.begin(), stems.end()};
    label = label.substr(prefix, label.size() - prefix - suffix);
  }
  return labels;
}

}  // namespace mien::motion
