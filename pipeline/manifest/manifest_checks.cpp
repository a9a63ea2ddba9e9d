#include "pipeline/manifest/manifest_checks.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "motion/formats/motion_file.h"
#include "motion/interpolation/interpolation_options.h"
#include "motion/text/nearest_word.h"
#include "pipeline/documents/fault_list.h"
#include "pipeline/manifest/modification_checks.h"
#include "pipeline/manifest/output_checks.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Options that only one method of interpolation has.
struct MethodOption {
  const char* key;
  motion::InterpolationMethod method;
};

using Method = motion::InterpolationMethod;

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

bool uses(const motion::InterpolationOptions& options, Method method) {
  const bool by_grid =
      options.method == Method::grid && options.grid_source == motion::GridSource::nearest;
  return options.method == method || (by_grid && method == Method::nearest);
}

class Checker : FaultList {
 public:
  explicit Checker(const Manifest& manifest) : FaultList(manifest.places), manifest_(manifest) {}

  using FaultList::take;

  void meaning() {
    check_examples();
    check_shared_interpolation();
    std::map<std::string, std::string> ids;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      check_unique(stimulus.id, stimulus.path, ids);
      check_stimulus(stimulus);
    }
    for (const Overlay& overlay : manifest_.overlays) check_overlay(overlay, ids);
    std::map<std::string, std::string> sheet_ids;
    for (const Sheet& sheet : manifest_.sheets) check_sheet(sheet, sheet_ids);
  }

  void names(const Vocabulary& vocabulary) {
    std::vector<std::string> stimuli;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      const std::string adjectives = member_path(stimulus.path, "adjectives");
      for (const auto& [name, value] : stimulus.adjectives) {
        check_key(adjectives, name, "parameter", vocabulary.parameters);
      }
      const std::string features = member_path(stimulus.path, "features");
      for (const auto& [name, value] : stimulus.features) {
        check_key(features, name, "feature", vocabulary.features);
      }
      const std::string weights = member_path(stimulus.path, "weights");
      for (const auto& [name, value] : stimulus.weights) {
        check_key(weights, name, "example", vocabulary.examples);
      }
      if (!stimulus.id.empty()) stimuli.push_back(stimulus.id);
    }
    std::vector<std::string> motions = stimuli;
    motions.insert(motions.end(), vocabulary.examples.begin(), vocabulary.examples.end());
    check_expectations(vocabulary);
    for (const Overlay& overlay : manifest_.overlays) {
      check_motion(member_path(overlay.film.path, "target"), overlay.target, motions);
      check_motion(member_path(overlay.film.path, "created"), overlay.created, motions);
      check_motion(member_path(overlay.film.path, "reference"), overlay.reference, motions);
    }
    for (const Sheet& sheet : manifest_.sheets) {
      const std::string compare = member_path(sheet.path, "compare");
      check_motion(member_path(compare, "target"), sheet.target, motions);
      check_motion(member_path(compare, "created"), sheet.created, motions);
      check_motion(member_path(compare, "reference"), sheet.reference, motions);
      const std::string gallery = member_path(sheet.path, "gallery");
      for (std::size_t i = 0; i < sheet.gallery.size(); ++i) {
        check_motion(element_path(gallery, i), sheet.gallery[i], motions);
      }
      const std::string stills = member_path(sheet.path, "stills");
      for (std::size_t i = 0; i < sheet.stills.size(); ++i) {
        check_pictured(element_path(stills, i), sheet.stills[i], stimuli);
      }
    }
  }

 private:
  void check_examples() {
    const Examples& examples = manifest_.examples;
    std::error_code error;
    if (!examples.folder.empty() && !fs::is_directory(examples.folder, error)) {
      add("examples.set.folder", "there is no folder " + examples.folder.string(),
          "correct the path; it is taken from the manifest's folder");
    }
    check_keytimes(examples);
    const Ratings& ratings = manifest_.ratings;
    if (ratings.source == Ratings::Source::file) {
      check_file("examples.ratings", ratings.file, "'builtin', 'simulated', 'none' or a CSV file");
    }
    if (ratings.source == Ratings::Source::builtin && !examples.folder.empty()) {
      add("examples.ratings", "only built-in sets have built-in ratings",
          "name a CSV file, or use simulated");
    }
    if (!ratings.expected.empty() && ratings.source == Ratings::Source::none) {
      add("examples.expect", "expectations need ratings of the examples",
          "add ratings: with a CSV file to examples");
    }
    if (!manifest_.scales.file.empty()) {
      check_file("examples.scales", manifest_.scales.file, "'builtin' or a YAML file");
      if (ratings.source == Ratings::Source::builtin) {
        add("examples.scales", "built-in ratings are on the built-in scales",
            "use ratings: simulated, or leave scales out");
      }
    }
  }

  void check_expectations(const Vocabulary& vocabulary) {
    const std::vector<Expectation>& expected = manifest_.ratings.expected;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const std::string path = element_path("examples.expect", i);
      check_word(member_path(path, "parameter"), expected[i].parameter, "parameter",
                 vocabulary.parameters);
      for (std::size_t k = 0; k < expected[i].order.size(); ++k) {
        check_word(element_path(member_path(path, "order"), k), expected[i].order[k], "example",
                   vocabulary.examples);
      }
    }
  }

  void check_keytimes(const Examples& examples) {
    for (const auto& [stem, times] : examples.keytimes) {
      const std::string path = member_path("examples.set.keytimes", stem);
      if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end()) {
        add(path, "keytimes do not ascend", "write seconds in the order in which they come");
      }
      const std::size_t count = examples.keytimes.front().second.size();
      if (times.size() != count) {
        add(path,
            std::to_string(times.size()) + " keytimes where \"" + examples.keytimes.front().first +
                "\" has " + std::to_string(count),
            "give every motion the same moments");
      }
    }
  }

  void check_unique(const std::string& id, const std::string& path,
                    std::map<std::string, std::string>& taken) {
    if (id.empty()) return;
    const auto [first, is_new] = taken.emplace(id, path);
    if (is_new) return;
    add(member_path(path, "id"), "\"" + id + "\" is already the id of " + first->second,
        "give each its own");
  }

  void check_stimulus(const Stimulus& stimulus) {
    const bool has_examples = was_given("examples");
    if (!stimulus.adjectives.empty()) {
      const std::string path = member_path(stimulus.path, "adjectives");
      if (!has_examples) {
        add(path, "adjectives need examples", "add examples: {set: builtin:walks-10}");
      } else if (manifest_.ratings.source == Ratings::Source::none) {
        add(path, "adjectives need ratings of the examples",
            "add ratings: with a CSV file or 'simulated' to examples");
      }
    }
    if (!stimulus.features.empty() && !has_examples) {
      add(member_path(stimulus.path, "features"), "features need examples",
          "add examples: {set: builtin:walks-10}");
    }
    if (!stimulus.weights.empty()) check_weights(stimulus, has_examples);
    if (has_examples && !manifest_.examples.blendable) check_single(stimulus);
    check_interpolation(stimulus);
    if (stimulus.clip) check_clip(stimulus.path, *stimulus.clip);
  }

  /// Options of the whole study, of which each must be for some stimulus.
  void check_shared_interpolation() {
    check_method_options("interpolation", [this](Method method) {
      const auto is_for = [method](const Interpolation& how) { return uses(how.weights, method); };
      return is_for(manifest_.interpolation) ||
             std::any_of(manifest_.stimuli.begin(), manifest_.stimuli.end(),
                         [&](const Stimulus& s) { return is_for(s.interpolation); });
    });
  }

  template <class IsUsed>
  void check_method_options(const std::string& path, IsUsed is_used) {
    for (const MethodOption& option : method_options) {
      const std::string at = member_path(path, option.key);
      if (!was_given(at) || is_used(option.method)) continue;
      const std::string method(motion::name_of(option.method));
      add(at, "only " + method + " interpolation has this",
          "add method: " + method + ", or leave it out");
    }
  }

  void check_interpolation(const Stimulus& stimulus) {
    const motion::InterpolationOptions& options = stimulus.interpolation.weights;
    check_method_options(member_path(stimulus.path, "interpolation"),
                         [&](Method method) { return uses(options, method); });
    check_wish(member_path(stimulus.path, "adjectives"), "adjectives", stimulus.adjectives,
               options.method);
    check_wish(member_path(stimulus.path, "features"), "features", stimulus.features,
               options.method);
  }

  void check_wish(const std::string& path, const std::string& what, const NamedValues& wish,
                  Method method) {
    if (wish.empty()) return;
    if (method == Method::direct) {
      add(path, "direct interpolation takes weights, not " + what,
          "give weights:, or another method");
    }
    const auto most = static_cast<std::size_t>(motion::most_grid_dimensions);
    if (method == Method::grid && wish.size() > most) {
      add(path, "a grid over " + std::to_string(wish.size()) + " parameters has too many corners",
          "name at most " + std::to_string(most) + ", or use another method");
    }
  }

  void check_weights(const Stimulus& stimulus, bool has_examples) {
    const std::string path = member_path(stimulus.path, "weights");
    if (!has_examples) add(path, "weights need examples", "add examples: {set: builtin:walks-10}");
    const auto is_positive = [](const auto& weight) { return weight.second > 0; };
    if (std::none_of(stimulus.weights.begin(), stimulus.weights.end(), is_positive)) {
      add(path, "no weight is above 0", "give at least one example a share");
    }
  }

  /// Of examples that are not blended, one can be shown.
  void check_single(const Stimulus& stimulus) {
    const std::string remedy =
        "name one example in weights:, or a set that is blended (builtin:walks-10, or a folder "
        "without blend: false)";
    const std::string wrong = "the examples of this set are not blended";
    if (!stimulus.adjectives.empty()) add(member_path(stimulus.path, "adjectives"), wrong, remedy);
    if (!stimulus.features.empty()) add(member_path(stimulus.path, "features"), wrong, remedy);
    if (stimulus.weights.size() > 1) add(member_path(stimulus.path, "weights"), wrong, remedy);
  }

  void check_clip(const std::string& stimulus, const ClipSource& clip) {
    const std::string path = member_path(stimulus, "clip");
    const std::string file =
        was_given(member_path(path, "file")) ? member_path(path, "file") : path;
    if (!clip.file.empty()) {
      check_file(file, clip.file, "a motion file (.bvh, .amc, .gltf, .glb)");
      check_ending(file, clip.file);
    }
    if (clip.frames && (*clip.frames)[0] > (*clip.frames)[1]) {
      add(member_path(path, "frames"), "the first frame comes after the last", "exchange the two");
    }
  }

  void check_ending(const std::string& path, const fs::path& file) {
    if (motion::is_motion_file(file)) return;
    add(path, "\"" + file.extension().string() + "\" is no kind of motion file",
        "use .bvh, .amc, .gltf or .glb");
  }

  void check_overlay(const Overlay& overlay, std::map<std::string, std::string>& ids) {
    if (overlay.target.empty() || overlay.created.empty()) return;
    const Stimulus& film = overlay.film;
    if (overlay.target == overlay.created) {
      add(member_path(film.path, "created"), "the same motion as the target", "name another one");
    }
    check_unique(film.id, film.path, ids);
    if (overlay.layout == scenes::Layout::side_by_side &&
        was_given(member_path(film.path, "opacity"))) {
      add_at_key(member_path(film.path, "opacity"), "figures side by side are not seen through",
                 "leave it out, or layout: superimposed");
    }
    const std::string own_figure = member_path(film.path, "look.figure");
    const std::string figure = was_given(own_figure) ? own_figure : film.path;
    if (std::holds_alternative<scenes::TrailOptions>(film.look.figure)) {
      add(figure, "a trail is of one motion alone", "give it another look: {figure: stick}");
    }
    if (std::holds_alternative<scenes::PointLightOptions>(film.look.figure)) {
      add(figure, "the point lights of several motions cannot be told apart",
          "give it another look: {figure: stick}");
    }
    if (overlay.layout == scenes::Layout::side_by_side &&
        scenes::looks_along_lanes(film.look.camera)) {
      add(member_path(film.path, "layout"),
          "side by side, figures hide each other from a camera at their side",
          "choose camera: front, three-quarter or follow");
    }
  }

  void check_sheet(const Sheet& sheet, std::map<std::string, std::string>& ids) {
    if (!sheet.gallery.empty() || !sheet.stills.empty()) {
      check_unique(sheet.id, sheet.path, ids);
    }
    if (sheet.stills.empty() && was_given(member_path(sheet.path, "columns"))) {
      add_at_key(member_path(sheet.path, "columns"), "only stills stand in columns",
                 "remove it, or make the sheet of stills");
    }
    if (sheet.target.empty() || sheet.created.empty()) return;
    const std::string compare = member_path(sheet.path, "compare");
    if (sheet.target == sheet.created) {
      add(member_path(compare, "created"), "the same motion as the target", "name another one");
    } else {
      check_unique(sheet.id, sheet.path, ids);
    }
  }

  void check_key(const std::string& map, const std::string& name, const std::string& what,
                 const std::vector<std::string>& known) {
    // Without any, something else is at fault, and has been told.
    if (known.empty() || std::find(known.begin(), known.end(), name) != known.end()) return;
    const std::string path = member_path(map, name);
    add_at_key(path, "unknown " + what, motion::did_you_mean(name, known));
  }

  void check_motion(const std::string& path, const std::string& name,
                    const std::vector<std::string>& known) {
    if (name.empty() || std::find(known.begin(), known.end(), name) != known.end()) return;
    add(path, "\"" + name + "\" is neither a stimulus nor an example",
        motion::did_you_mean(name, known));
  }

  /// Of an example there is no film to take a picture from.
  void check_pictured(const std::string& path, const std::string& name,
                      const std::vector<std::string>& stimuli) {
    if (name.empty() || std::find(stimuli.begin(), stimuli.end(), name) != stimuli.end()) return;
    add(path, "\"" + name + "\" is no stimulus", motion::did_you_mean(name, stimuli));
  }

  const Manifest& manifest_;
};

std::vector<Fault> joined(std::vector<Fault> faults, std::vector<Fault> more) {
  for (Fault& fault : more) faults.push_back(std::move(fault));
  return faults;
}

}  // namespace

std::vector<Fault> check_meaning(const Manifest& manifest) {
  Checker checker(manifest);
  checker.meaning();
  return joined(joined(checker.take(), check_outputs(manifest)), check_modifications(manifest));
}

std::vector<Fault> check_names(const Manifest& manifest, const Vocabulary& vocabulary) {
  Checker checker(manifest);
  checker.names(vocabulary);
  return joined(checker.take(), check_modification_names(manifest, vocabulary));
}

}  // namespace mien::pipeline
