#include "pipeline/commands/render_options.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/environment.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/base/reading/option_document.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/film_checks.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json output_schema() {
  const json& manifest = manifest_schema();
  json schema = manifest["definitions"]["output"];
  schema["definitions"] = manifest["definitions"];
  return schema;
}

std::string flag_of(std::string key) {
  std::ranges::replace(key, '_', '-');
  return "--" + key;
}

/// "(1 to 240)", "(draft, standard, final, reference)", or nothing.
std::string limits_of(const json& schema) {
  if (schema.contains("enum")) {
    std::string words;
    for (const json& word : schema["enum"])
      words += (words.empty() ? "" : ", ") + word.get<std::string>();
    return fmt::format(" ({})", words);
  }
  if (!schema.contains("minimum") || !schema.contains("maximum")) return "";
  return fmt::format(" ({} to {})", schema["minimum"].dump(), schema["maximum"].dump());
}

/// 960x540 and 1,2,3,4 as YAML arrays.
std::string as_array(std::string text) {
  if (text.starts_with('[')) return text;
  std::ranges::replace(text, 'x', ',');
  for (std::size_t comma = text.find(','); comma != std::string::npos;
       comma = text.find(',', comma + 2))
    text.insert(comma + 1, " ");
  return "[" + text + "]";
}

std::string default_of(const json& schema) {
  const json& value = schema["default"];
  if (value.is_string()) return value.get<std::string>();
  return value.is_array() ? fmt::format("{}x{}", value[0].dump(), value[1].dump()) : value.dump();
}

fs::path file_of(const RenderOptions& options) {
  if (options.out.empty()) return fs::path(options.files.front()).stem().concat(".mp4");
  if (fs::path(options.out).extension() == ".exr" && !options.still)
    throw Error("--output: only a still has layers", "add --still, or use the extension .png");
  if (is_picture(options.out) || render::video_kind_of(options.out)) return options.out;
  throw Error("--output: " + motion::in_quotes(options.out) + " is neither a video nor an image",
              "use the extension " + video_endings() + " (video) or .png (contact sheet)");
}

bool is_cut_out(const RenderOptions& options) { return options.background != "shown"; }

/// Sets the output's video or frame format from the file name.
void add_file(const fs::path& out, Output& output) {
  output.video.clear();
  output.frames = out.extension() == ".exr" ? FrameFormat::layers : FrameFormat::none;
  if (!is_picture(out)) output.video = {*render::video_kind_of(out)};
}

/// Checks the plan by the rules of a manifest. Throws Faults.
void check_as_manifest(const RenderPlan& plan, const Places& places) {
  Stimulus film;
  film.look = plan.look;
  film.output = plan.settings.output;
  std::vector<Fault> faults = check_output(film.output, "", places);
  for (Fault& fault : check_film(film, {}, places)) faults.push_back(std::move(fault));
  if (!faults.empty()) throw as_option_faults(std::move(faults));
}

/// Checks options for stills and cut-outs, which manifests do not have. Throws Error.
void check_kind(const RenderOptions& options, const RenderPlan& plan) {
  if (options.still && !is_picture(plan.out))
    throw Error("--still: a still is an image",
                "use an --output file ending in .png, or in .exr for layers");
  if (!is_cut_out(options)) return;
  const Output& output = plan.settings.output;
  if (!is_still(options, plan) || output.frames == FrameFormat::layers)
    throw Error("--background: only stills can have a transparent background",
                "add --still, and --output in .png");
  if (output.shutter > 0.0)
    throw Error("--shutter: stills with a transparent background have no motion blur", "omit it");
  if (plan.look.camera.stereo_separation_m)
    throw Error("--camera: stills with a transparent background cannot be stereo pairs",
                "omit stereo");
}

int threads_of(const RenderOptions& options) {
  if (options.jobs > 0) return options.jobs;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

CommandOption OutputFlags::option_of(const std::string& key) {
  const json& schema = manifest_schema()["definitions"]["output"]["properties"][key];
  const std::string text = schema["description"].get<std::string>() + limits_of(schema);
  const auto take = [this, key](const std::string& value) { given_[key] = value; };
  is_array_[key] = schema["type"] == "array";
  if (schema["type"] == "boolean") return flag(flag_of(key), take, text);
  return option(flag_of(key), take, text)
      .with_default(schema.contains("default") ? default_of(schema) : "");
}

std::vector<CommandOption> OutputFlags::options() {
  std::vector<CommandOption> options;
  for (const FieldEntry& entry : entries_of(Output(), {.concerned = concerns::picture}))
    options.push_back(option_of(entry.path));
  return options;
}

OutputReading OutputFlags::read() const {
  std::string yaml;
  for (const auto& [key, text] : given_)
    yaml += fmt::format("{}: {}\n", key, is_array_.at(key) ? as_array(text) : text);
  if (yaml.empty()) return {};
  JsonReading reading = read_options(yaml, output_schema(), process_environment());
  const ReadingContext context{reading.places, [](const std::string& path) { return path; }};
  OutputReading result;
  pipeline::read({reading.document, "", context}, result.output);
  result.places = std::move(reading.places);
  return result;
}

RenderPlan plan_of(const RenderOptions& options) {
  OutputReading reading = options.output.read();
  RenderPlan plan;
  plan.out = file_of(options);
  plan.look = look_of(options.look, plan.warnings);
  plan.settings.output = reading.output;
  plan.settings.loops = options.repeat;
  plan.settings.threads = threads_of(options);
  plan.settings.eyes = plan.look.camera.stereo_separation_m ? 2 : 1;
  add_file(plan.out, plan.settings.output);
  check_as_manifest(plan, reading.places);
  check_kind(options, plan);
  return plan;
}

bool is_still(const RenderOptions& options, const RenderPlan& plan) {
  const bool is_trail = std::holds_alternative<scenes::TrailOptions>(plan.look.figure);
  return options.still.has_value() || (is_trail && plan.out.extension() == ".png");
}

bool is_picture(const fs::path& out) {
  return out.extension() == ".png" || out.extension() == ".exr";
}

std::string video_endings() {
  std::string endings;
  for (const render::VideoTraits& traits : render::video_kinds())
    endings += (endings.empty() ? "" : ", ") + std::string(traits.ending);
  return endings;
}

}  // namespace mien::pipeline
