#include "pipeline/manifest/manifest_builder.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "pipeline/documents/json_assign.h"
#include "pipeline/documents/yaml_json.h"
#include "pipeline/manifest/example_source.h"
#include "pipeline/manifest/modification_json.h"
#include "pipeline/manifest/recipes.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

bool contains(const json& array, const char* word) {
  return std::find(array.begin(), array.end(), word) != array.end();
}

constexpr Words<OnFault> fault_words = {{"warn", OnFault::warn},
                                        {"fail", OnFault::fail},
                                        {"revert", OnFault::revert},
                                        {"reduce", OnFault::reduce}};

/// Builds one manifest; knows the folder that paths start from and the places that give the
/// members of a map their written order.
class Builder {
 public:
  Builder(Places places, const fs::path& file) : folder_(file.parent_path()) {
    manifest_.file = file;
    manifest_.places = std::move(places);
  }

  Manifest build(const json& document) {
    assign(member(document, "study"), manifest_.study);
    assign(member(document, "seed"), manifest_.seed);
    manifest_.interpolation.weights.nearest.seed = manifest_.seed;
    if (const json* examples = member(document, "examples")) read_examples(*examples);
    if (const json* look = member(document, "look")) overlay_look(*look, manifest_.look);
    if (const json* output = member(document, "output")) overlay(*output, manifest_.output);
    if (const json* how = member(document, "interpolation")) {
      overlay(*how, manifest_.interpolation);
    }
    assign(member(document, "recipes"), manifest_.recipes.name);
    if (builtin_recipes_text(manifest_.recipes.name).empty()) {
      manifest_.recipes.file = resolved(manifest_.recipes.name);
    }
    assign(member(document, "on_fault"), manifest_.on_fault, fault_words);
    if (const json* alike = member(document, "equalize"); alike && alike->is_array()) {
      manifest_.equalize.luminance = contains(*alike, "luminance");
      manifest_.equalize.size = contains(*alike, "size");
      manifest_.equalize.duration = contains(*alike, "duration");
    }
    if (const json* stimuli = member(document, "stimuli"); stimuli && stimuli->is_array()) {
      for (const json& stimulus : *stimuli) read_stimulus(stimulus);
    }
    if (const json* overlays = member(document, "overlays"); overlays && overlays->is_array()) {
      for (const json& one : *overlays) read_overlay(one);
    }
    if (const json* sheets = member(document, "sheets"); sheets && sheets->is_array()) {
      for (const json& sheet : *sheets) read_sheet(sheet);
    }
    return std::move(manifest_);
  }

 private:
  fs::path resolved(const std::string& path) const {
    return path.empty() ? fs::path() : (folder_ / path).lexically_normal();
  }

  NamedValues named_values(const json* map, const std::string& path) const {
    NamedValues values;
    if (map == nullptr || !map->is_object()) return values;
    for (const std::string& key : written_order(*map, path, manifest_.places)) {
      if ((*map)[key].is_number()) values.emplace_back(key, (*map)[key].get<double>());
    }
    return values;
  }

  void read_examples(const json& examples) {
    if (const json* set = member(examples, "set")) read_set(*set);
    Ratings& ratings = manifest_.ratings;
    if (!manifest_.examples.builtin.empty() && manifest_.examples.blendable) {
      ratings.source = Ratings::Source::builtin;
    }
    if (const json* source = member(examples, "ratings"); source && source->is_string()) {
      ratings.source = Ratings::Source::file;
      assign(source, ratings.source,
             {{"none", Ratings::Source::none},
              {"builtin", Ratings::Source::builtin},
              {"simulated", Ratings::Source::simulated}});
      if (ratings.source == Ratings::Source::file) {
        ratings.file = resolved(source->get<std::string>());
      }
    }
    assign(member(examples, "raters"), ratings.raters);
    if (const json* expected = member(examples, "expect")) read_expectations(*expected);
    std::string scales = "builtin";
    assign(member(examples, "scales"), scales);
    if (scales != "builtin") manifest_.scales.file = resolved(scales);
  }

  void read_expectations(const json& expected) {
    for (const json& given : expected) {
      Expectation expectation;
      assign(member(given, "parameter"), expectation.parameter);
      if (const json* order = member(given, "order"); order && order->is_array()) {
        for (const json& example : *order) {
          if (example.is_string()) expectation.order.push_back(example.get<std::string>());
        }
      }
      manifest_.ratings.expected.push_back(std::move(expectation));
    }
  }

  void read_set(const json& set) {
    Examples& examples = manifest_.examples;
    if (set.is_string()) {
      constexpr std::string_view prefix = "builtin:";
      const auto& name = set.get_ref<const std::string&>();
      if (name.starts_with(prefix)) examples.builtin = name.substr(prefix.size());
      examples.blendable = examples.builtin != unblendable_set;
      return;
    }
    std::string folder;
    assign(member(set, "folder"), folder);
    examples.folder = resolved(folder);
    assign(member(set, "include"), examples.include);
    assign(member(set, "exclude"), examples.exclude);
    assign(member(set, "cycle"), examples.cycle,
           {{"auto", Examples::Cycle::automatic},
            {"whole", Examples::Cycle::whole},
            {"start-peak-end", Examples::Cycle::start_peak_end}});
    assign(member(set, "blend"), examples.blendable);
    if (const json* keytimes = member(set, "keytimes")) read_keytimes(*keytimes);
    const json* labels = member(set, "labels");
    assign(
        labels, examples.labels,
        {{"from-name", Examples::Labels::from_name}, {"file-name", Examples::Labels::file_name}});
    if (labels == nullptr || !labels->is_object()) return;
    const std::string path = "examples.set.labels";
    for (const std::string& stem : written_order(*labels, path, manifest_.places)) {
      if ((*labels)[stem].is_string()) {
        examples.given_labels.emplace_back(stem, (*labels)[stem].get<std::string>());
      }
    }
  }

  void read_keytimes(const json& keytimes) {
    if (!keytimes.is_object()) return;
    const std::string path = "examples.set.keytimes";
    for (const std::string& stem : written_order(keytimes, path, manifest_.places)) {
      std::vector<double> times;
      for (const json& time : keytimes[stem]) {
        if (time.is_number()) times.push_back(time.get<double>());
      }
      manifest_.examples.keytimes.emplace_back(stem, std::move(times));
    }
  }

  void overlay_look(const json& given, Look& look) const {
    pipeline::overlay(given, look, [this](const std::string& path) { return resolved(path); });
  }

  static void overlay(const json& given, Presentation& presentation) {
    if (const json* card = member(given, "card")) {
      assign(card, presentation.card);
      assign(member(*card, "text"), presentation.card);
      assign(member(*card, "seconds"), presentation.card_seconds);
    }
    if (const json* fixation = member(given, "fixation")) {
      assign(fixation, presentation.fixation_seconds);
      assign(member(*fixation, "seconds"), presentation.fixation_seconds);
      assign(member(*fixation, "size"), presentation.fixation_size);
    }
    assign(member(given, "blank_before"), presentation.blank_before);
    assign(member(given, "blank_after"), presentation.blank_after);
    assign(member(given, "fade_in"), presentation.fade_in);
    assign(member(given, "fade_out"), presentation.fade_out);
    assign(member(given, "background"), presentation.background);
  }

  static void overlay(const json& given, Output& output) {
    assign(member(given, "size"), output.size);
    assign(member(given, "scale"), output.scale);
    assign(member(given, "crop"), output.crop);
    assign(member(given, "fps"), output.fps);
    assign(member(given, "cycles"), output.cycles);
    assign(member(given, "in_place"), output.in_place);
    assign(member(given, "quality"), output.quality,
           {{"draft", Quality::draft}, {"standard", Quality::standard}, {"final", Quality::final}});
    assign(member(given, "frames"), output.frames,
           {{"none", FrameFormat::none},
            {"png", FrameFormat::png},
            {"png16", FrameFormat::png16},
            {"exr", FrameFormat::exr},
            {"layers", FrameFormat::layers}});
    assign(member(given, "shutter"), output.shutter);
    if (const json* video = member(given, "video"); video && video->is_array()) {
      output.video.clear();
      for (const render::VideoTraits& traits : render::video_kinds()) {
        if (contains(*video, traits.name.data())) output.video.push_back(traits.kind);
      }
    }
    if (const json* shown = member(given, "presentation")) overlay(*shown, output.presentation);
    if (const json* clips = member(given, "clips"); clips && clips->is_array()) {
      output.bvh = contains(*clips, "bvh");
      output.glb = contains(*clips, "glb");
    }
  }

  static void overlay(const json& given, motion::InterpolationOptions& weights) {
    using Method = motion::InterpolationMethod;
    assign(member(given, "method"), weights.method,
           {{"cardinal", Method::cardinal},
            {"knn", Method::nearest},
            {"inverse-distance", Method::inverse_distance},
            {"grid", Method::grid},
            {"kriging", Method::kriging},
            {"pca", Method::pca},
            {"incremental", Method::incremental},
            {"direct", Method::direct}});
    assign(member(given, "neighbours"), weights.nearest.neighbours);
    assign(member(given, "blends"), weights.nearest.trials);
    assign(member(given, "power"), weights.power);
    assign(member(given, "cells"), weights.grid_cells);
    assign(member(given, "nodes"), weights.grid_source,
           {{"cardinal", motion::GridSource::cardinal}, {"knn", motion::GridSource::nearest}});
    if (const json* drift = member(given, "drift"))
      weights.kriging.linear_drift = *drift == "linear";
    assign(member(given, "nugget"), weights.kriging.nugget);
    assign(member(given, "variance"), weights.pca.variance_share);
    assign(member(given, "estimate"), weights.pca.estimate,
           {{"expected", motion::ModelEstimate::expected},
            {"most-likely", motion::ModelEstimate::most_likely}});
    assign(member(given, "noise"), weights.pca.noise);
    assign(member(given, "step"), weights.click_step);
  }

  static void overlay(const json& given, Interpolation& interpolation) {
    overlay(given, interpolation.weights);
    assign(member(given, "rotations"), interpolation.rotations,
           {{"karcher-mean", motion::RotationBlend::karcher_mean},
            {"direction-vectors", motion::RotationBlend::direction_vectors},
            {"markley-mean", motion::RotationBlend::markley_mean}});
    assign(member(given, "time_warp"), interpolation.time_warp,
           {{"monotone", motion::WarpShape::monotone}, {"linear", motion::WarpShape::linear}});
    assign(member(given, "foot_lock"), interpolation.foot_lock);
  }

  void read_stimulus(const json& given) {
    Stimulus stimulus;
    stimulus.path = element_path("stimuli", manifest_.stimuli.size());
    assign(member(given, "id"), stimulus.id);
    assign(member(given, "role"), stimulus.role,
           {{"target", Role::target}, {"created", Role::created}, {"reference", Role::reference}});
    stimulus.adjectives =
        named_values(member(given, "adjectives"), member_path(stimulus.path, "adjectives"));
    stimulus.features =
        named_values(member(given, "features"), member_path(stimulus.path, "features"));
    stimulus.weights =
        named_values(member(given, "weights"), member_path(stimulus.path, "weights"));
    if (const json* clip = member(given, "clip")) stimulus.clip = read_clip(*clip);
    stimulus.look = manifest_.look;
    stimulus.output = manifest_.output;
    stimulus.interpolation = manifest_.interpolation;
    if (const json* look = member(given, "look")) overlay_look(*look, stimulus.look);
    if (const json* output = member(given, "output")) overlay(*output, stimulus.output);
    if (const json* how = member(given, "interpolation")) overlay(*how, stimulus.interpolation);
    if (const json* modify = member(given, "modify")) read_modify(*modify, stimulus);
    stimulus.on_fault = manifest_.on_fault;
    assign(member(given, "on_fault"), stimulus.on_fault, fault_words);
    manifest_.stimuli.push_back(std::move(stimulus));
  }

  void read_modify(const json& given, Stimulus& stimulus) const {
    const std::string path = member_path(stimulus.path, "modify");
    if (given.is_object()) stimulus.modify.push_back(modification_step(given, path));
    if (!given.is_array()) return;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (!given[i].is_object()) continue;
      stimulus.modify.push_back(modification_step(given[i], element_path(path, i)));
    }
  }

  ModificationStep modification_step(const json& given, const std::string& path) const {
    ModificationStep step{.path = path};
    assign(member(given, "emotion"), step.emotion);
    assign(member(given, "strength"), step.strength);
    step.style = style_step(given);
    step.edit = modification_edit(given, path, manifest_.places,
                                  [this](const std::string& file) { return resolved(file); });
    return step;
  }

  ClipSource read_clip(const json& given) const {
    ClipSource clip;
    std::string file;
    assign(&given, file);
    assign(member(given, "file"), file);
    clip.file = resolved(file);
    if (const json* frames = member(given, "frames")) {
      clip.frames = {0, std::numeric_limits<int>::max()};
      assign(frames, *clip.frames);
    }
    return clip;
  }

  static std::vector<std::string> names_in(const json* list) {
    std::vector<std::string> names;
    if (list == nullptr || !list->is_array()) return names;
    for (const json& name : *list) {
      if (name.is_string()) names.push_back(name.get<std::string>());
    }
    return names;
  }

  void read_overlay(const json& given) {
    Overlay overlay;
    overlay.film.path = element_path("overlays", manifest_.overlays.size());
    assign(member(given, "target"), overlay.target);
    assign(member(given, "created"), overlay.created);
    assign(member(given, "reference"), overlay.reference);
    overlay.film.id = overlay.target + "_with_" + overlay.created;
    assign(member(given, "id"), overlay.film.id);
    assign(member(given, "layout"), overlay.layout,
           {{"superimposed", scenes::Layout::superimposed},
            {"side-by-side", scenes::Layout::side_by_side}});
    assign(member(given, "opacity"), overlay.opacity);
    overlay.film.look = manifest_.look;
    overlay.film.output = manifest_.output;
    overlay.film.output.bvh = overlay.film.output.glb = false;
    if (const json* look = member(given, "look")) overlay_look(*look, overlay.film.look);
    if (const json* output = member(given, "output")) this->overlay(*output, overlay.film.output);
    manifest_.overlays.push_back(std::move(overlay));
  }

  void read_sheet(const json& given) {
    Sheet sheet;
    sheet.path = element_path("sheets", manifest_.sheets.size());
    if (const json* compare = member(given, "compare")) {
      assign(member(*compare, "target"), sheet.target);
      assign(member(*compare, "created"), sheet.created);
      assign(member(*compare, "reference"), sheet.reference);
    }
    sheet.gallery = names_in(member(given, "gallery"));
    sheet.stills = names_in(member(given, "stills"));
    assign(member(given, "columns"), sheet.columns);
    sheet.id = !sheet.stills.empty()    ? "stills"
               : !sheet.gallery.empty() ? "gallery"
                                        : sheet.target + "_" + sheet.created;
    assign(member(given, "id"), sheet.id);
    manifest_.sheets.push_back(std::move(sheet));
  }

  fs::path folder_;
  Manifest manifest_;
};

}  // namespace

Manifest build_manifest(const json& document, Places places, const fs::path& file) {
  return Builder(std::move(places), file).build(document);
}

}  // namespace mien::pipeline
