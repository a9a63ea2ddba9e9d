#include <algorithm>
#include <cctype>
#include <string>
#include <variant>

#include "motion/interpolation/interpolation_options.h"
#include "motion/measures/distance/body_part.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/checks/take_checks.h"
#include "pipeline/manifest/people.h"

namespace mien::pipeline {

namespace {

using Method = motion::InterpolationMethod;

/// Options that only one method of interpolation has.
struct MethodOption {
  const char* key;
  Method method;
};

constexpr MethodOption method_options[] = {
    {"neighbours", Method::nearest},
    {"blends", Method::nearest},
    {"power", Method::inverse_distance},
    {"cells", Method::grid},
    {"nodes", Method::grid},
    {"drift", Method::kriging},
    {"nugget", Method::kriging},
    {"variance", Method::pca},
    {"estimate", Method::pca},
    {"noise", Method::pca},
    {"step", Method::incremental},
};

constexpr char add_examples[] = "add examples: {set: builtin:walks-10}";

bool uses(const motion::InterpolationOptions& options, Method method) {
  const bool by_grid =
      options.method == Method::grid && options.grid_source == motion::GridSource::nearest;
  return options.method == method || (by_grid && method == Method::nearest);
}

void check_method_options(const std::string& path, FaultList& list, auto is_used) {
  for (const MethodOption& option : method_options) {
    const std::string at = member_path(path, option.key);
    if (!list.was_given(at) || is_used(option.method)) continue;
    const std::string method(motion::name_of(option.method));
    list.add(at, "only " + method + " interpolation has this key",
             "add method: " + method + ", or omit it");
  }
}

/// Options of the whole study, of which each must be for some stimulus.
void check_shared_interpolation(const Manifest& manifest, FaultList& list) {
  check_method_options("interpolation", list, [&](Method method) {
    const auto is_for = [method](const Interpolation& how) { return uses(how.weights, method); };
    return is_for(manifest.interpolation) ||
           std::ranges::any_of(motion_sources(manifest), [&](const Stimulus* stimulus) {
             return is_for(stimulus->interpolation);
           });
  });
}

void check_requested_values(const std::string& path, const std::string& what,
                            const NamedValues& requested, Method method, FaultList& list) {
  if (requested.empty()) return;
  if (method == Method::direct) {
    list.add(path, "direct interpolation requires weights, not " + what,
             "give weights:, or another method");
  }
  const auto most = static_cast<std::size_t>(motion::max_grid_dimensions);
  if (method != Method::grid || requested.size() <= most) return;
  list.add(path,
           "a grid over " + std::to_string(requested.size()) + " parameters has too many corners",
           "name at most " + std::to_string(most) + ", or use another method");
}

void check_interpolation(const Stimulus& stimulus, FaultList& list) {
  const motion::InterpolationOptions& options = stimulus.interpolation.weights;
  check_method_options(member_path(stimulus.path, "interpolation"), list,
                       [&](Method method) { return uses(options, method); });
  check_requested_values(member_path(stimulus.path, "adjectives"), "adjectives",
                         stimulus.adjectives, options.method, list);
  check_requested_values(member_path(stimulus.path, "features"), "features", stimulus.features,
                         options.method, list);
}

void check_hold(const Stimulus& stimulus, FaultList& list) {
  const Hold& hold = stimulus.hold;
  if (!hold.anything()) return;
  const std::string path = member_path(stimulus.path, "hold");
  if (stimulus.adjectives.empty()) {
    list.add(path, "only stimuli made from adjectives can hold other parameters",
             "use adjectives:, or omit hold:");
  }
  const auto is_asked = [&](const std::string& name) {
    return std::ranges::find(stimulus.adjectives, name, &NamedValues::value_type::first) !=
           stimulus.adjectives.end();
  };
  const std::string remedy = "use it either in adjectives: or in hold:";
  for (std::size_t i = 0; i < hold.names.size(); ++i) {
    if (is_asked(hold.names[i]))
      list.add(element_path(path, i), motion::in_quotes(hold.names[i]) + " is already requested",
               remedy);
  }
  for (const auto& value : hold.values) {
    if (is_asked(value.first))
      list.add_at_key(member_path(path, value.first), "this is already requested", remedy);
  }
}

void check_weights(const Stimulus& stimulus, bool has_examples, FaultList& list) {
  if (stimulus.weights.empty()) return;
  const std::string path = member_path(stimulus.path, "weights");
  if (!has_examples) list.add(path, "weights need examples", add_examples);
  const auto is_positive = [](const auto& weight) { return weight.second > 0; };
  if (std::ranges::any_of(stimulus.weights, is_positive)) return;
  list.add(path, "all weights are 0", "give at least one example a weight");
}

/// Examples that cannot be blended can only be shown one at a time.
void check_single(const Stimulus& stimulus, FaultList& list) {
  const auto refuse = [&](const char* key) {
    list.add(member_path(stimulus.path, key), "the examples of this set cannot be blended",
             "name one example in weights:, or use a set that can be blended (builtin:walks-10, or "
             "a folder without blend: false)");
  };
  if (!stimulus.adjectives.empty()) refuse("adjectives");
  if (!stimulus.features.empty()) refuse("features");
  if (stimulus.weights.size() > 1) refuse("weights");
}

void check_adjectives(const Stimulus& stimulus, const Manifest& manifest, bool has_examples,
                      FaultList& list) {
  if (stimulus.adjectives.empty()) return;
  const std::string path = member_path(stimulus.path, "adjectives");
  if (!has_examples) {
    list.add(path, "adjectives need examples", add_examples);
  } else if (manifest.ratings.source == Ratings::Source::none) {
    list.add(path, "adjectives need ratings of the examples",
             "add ratings: with a CSV file or 'simulated' to examples");
  }
}

void check_clip(const Stimulus& stimulus, FaultList& list) {
  if (!stimulus.clip) return;
  const std::string path = member_path(stimulus.path, "clip");
  const ClipSource& clip = *stimulus.clip;
  check_motion_file(path, clip.file, read_options(clip.how), list);
  if (clip.frames && (*clip.frames)[0] > (*clip.frames)[1]) {
    list.add(member_path(path, "frames"), "the first frame comes after the last",
             "exchange the two");
  }
}

/// Only a recording has markers, and only as long as nothing changes its motion. Whether a file
/// holds any is known when it is read.
void check_markers(const Stimulus& stimulus, FaultList& list) {
  if (!std::holds_alternative<scenes::MarkersOptions>(stimulus.look.figure)) return;
  const std::string own = member_path(stimulus.path, "look.figure");
  const std::string path = list.was_given(own) ? own : "look.figure";
  const std::string motion = "the motion of " + motion::in_quotes(stimulus.id);
  if (!stimulus.clip) {
    list.add(path, motion + " is not a recording, so it has no markers",
             "show a recording of markers (clip), or another figure, such as point-light");
  } else if (!stimulus.modify.empty()) {
    list.add(path, motion + " is modified, and its markers cannot follow",
             "omit modify, or show another figure, such as point-light");
  }
}

/// Factors become columns, which programs of statistics take as names.
void check_factors(const Stimulus& stimulus, FaultList& list) {
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const auto is_part = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  for (const auto& [name, level] : stimulus.factors) {
    if (!name.empty() && is_letter(name.front()) && std::ranges::all_of(name, is_part)) continue;
    list.add_at_key(member_path(member_path(stimulus.path, "factors"), name),
                    motion::in_quotes(name) + " is not a valid column name",
                    "begin with a letter, and use letters, digits and _");
  }
}

/// `path` is that of the map that `regression:` stands in; what it has from elsewhere is checked
/// there.
void check_limits(const RegressionLimits& limits, const std::string& path, FaultList& list) {
  std::vector<std::string> parts;
  for (int joint = 0; joint < motion::body_joint_count; ++joint)
    parts.push_back(motion::part_name(static_cast<motion::BodyJoint>(joint)));
  const std::string map = path.empty() ? "regression" : member_path(path, "regression");
  for (const auto& [part, limit] : limits.parts_mm) {
    const std::string place = member_path(member_path(map, "parts_mm"), part);
    if (!list.was_given(place) || std::ranges::find(parts, part) != parts.end()) continue;
    list.add_at_key(place, "unknown part of the body " + motion::in_quotes(part),
                    motion::did_you_mean(part, parts));
  }
}

/// The motion of a stimulus or of one of its people.
void check_source(const Stimulus& stimulus, const Manifest& manifest, FaultList& list) {
  if (stimulus.foil) return;  // its motion is that of another, which is checked
  const bool has_examples = list.was_given("examples");
  check_adjectives(stimulus, manifest, has_examples, list);
  if (!stimulus.features.empty() && !has_examples) {
    list.add(member_path(stimulus.path, "features"), "features need examples", add_examples);
  }
  check_hold(stimulus, list);
  check_weights(stimulus, has_examples, list);
  if (has_examples && !manifest.examples.blendable) check_single(stimulus, list);
  check_interpolation(stimulus, list);
  check_clip(stimulus, list);
  check_markers(stimulus, list);
  check_walk_path(stimulus, list);
}

void check_stimulus(const Stimulus& stimulus, const Manifest& manifest, FaultList& list) {
  check_factors(stimulus, list);
  check_limits(stimulus.regression, stimulus.path, list);
  for (const Stimulus* motion : motions_in(stimulus)) check_source(*motion, manifest, list);
}

}  // namespace

std::vector<Fault> check_stimuli(const Manifest& manifest) {
  FaultList list(manifest.places);
  check_shared_interpolation(manifest, list);
  check_limits(manifest.regression, "", list);
  // What is no map at all has been reported.
  const bool is_map = !manifest.places.keys.empty();
  if (is_map && manifest.stimuli.empty() && !manifest.adaptive &&
      !manifest.places.values.contains("stimuli"))
    list.add("stimuli", "missing",
             "add it, for example stimuli: [{id: happy-quick, adjectives: {quickness: 0.8}}]");
  for (const Stimulus& stimulus : manifest.stimuli) check_stimulus(stimulus, manifest, list);
  return list.take();
}

}  // namespace mien::pipeline
