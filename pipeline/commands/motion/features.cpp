#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/examples/make_example.h"
#include "motion/formats/motion_file.h"
#include "motion/measures/features/motion_features.h"
#include "motion/rig/body_mapping.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/commands/motion/motion.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

struct FeaturesOptions {
  std::vector<std::string> files;
  RecordingArguments recording;
  std::string masses = "male";
  std::string sideways = "outward";
  bool json = false;
  bool csv = false;
};

/// A motion file, what was measured, and over which frames.
struct MeasuredFile {
  std::string file;
  std::string take;    ///< where the file holds several
  std::string person;  ///< where the file holds several
  std::string name;
  motion::PreparedExample prepared;
  motion::FeatureValues values;
};

motion::FeatureOptions feature_options(const FeaturesOptions& options) {
  motion::FeatureOptions result;
  result.outward = options.sideways == "outward";
  if (options.masses == "female") result.masses = motion::MassModel::de_leva_female;
  if (options.masses == "winter") result.masses = motion::MassModel::winter;
  return result;
}

MeasuredFile measured(const NamedRecording& named, const motion::FeatureOptions& options,
                      const Console& console) {
  const motion::Recording recording = read_with_warnings(named, console);
  const motion::Clip clip = motion::to_body(recording);
  motion::PreparedExample prepared = motion::prepare_example(clip);
  const motion::FeatureValues values = motion::measure_features(prepared.example, options);
  return {named.file,
          chosen_take(recording),
          chosen_person(recording),
          std::filesystem::path(named.file).stem().string(),
          std::move(prepared),
          values};
}

std::vector<std::string> warnings_of(const MeasuredFile& measured) {
  if (!measured.prepared.cycle)
    return {
        "No gait cycle was found; features are measured over the whole motion, without step "
        "features."};
  return measured.prepared.cycle->warnings;
}

ordered_json as_json(const MeasuredFile& measured) {
  ordered_json values = ordered_json::object();
  // Unknown values are written as null.
  for (std::size_t i = 0; i < measured.values.size(); ++i)
    values[std::string(motion::motion_features()[i].id)] = measured.values[i];
  ordered_json cycle = nullptr;
  if (const auto& found = measured.prepared.cycle)
    cycle = {{"start_frame", found->start_frame}, {"end_frame", found->end_frame}};
  ordered_json result = {{"file", measured.file},
                         {"cycle", cycle},
                         {"features", values},
                         {"warnings", warnings_of(measured)}};
  if (!measured.take.empty()) result["take"] = measured.take;
  if (!measured.person.empty()) result["person"] = measured.person;
  return result;
}

ordered_json as_json(const motion::MotionFeature& feature) {
  return {{"id", feature.id},
          {"name", feature.name},
          {"name_ja", feature.japanese},
          {"unit", motion::symbol_of(feature.unit)},
          {"group", motion::id_of(feature.group)},
          {"reconstructed", feature.reconstructed}};
}

void show_json(const std::vector<MeasuredFile>& all, const Console& console) {
  ordered_json features = ordered_json::array();
  for (const motion::MotionFeature& feature : motion::motion_features())
    features.push_back(as_json(feature));
  ordered_json motions = ordered_json::array();
  for (const MeasuredFile& one : all) motions.push_back(as_json(one));
  const ordered_json result = {{"features", features}, {"motions", motions}};
  console.out << result.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
}

struct MeasuredFeature {
  std::string motion;
  double value;
  const motion::MotionFeature& feature;
};

constexpr auto measured_columns = table_of<MeasuredFeature>(
    "features.csv", "motion and feature",
    {{"motion", "", "name of the file", [](auto& r) { return r.motion; }},
     {"feature", "", "id of the motion feature", [](auto& r) { return r.feature.id; }},
     {"value", "see unit", "empty where the motion has no steps", [](auto& r) { return r.value; }},
     {"unit", "", "unit of the value", [](auto& r) { return motion::symbol_of(r.feature.unit); }},
     {"group", "", "its group", [](auto& r) { return motion::id_of(r.feature.group); }},
     {"reconstructed", "0/1", "1: replaces a repeated or ambiguous row of the published tables",
      [](auto& r) { return r.feature.reconstructed; }},
     {"name", "", "English name", [](auto& r) { return r.feature.name; }},
     {"name_ja", "", "Japanese name", [](auto& r) { return r.feature.japanese; }}});

void show_csv(const std::vector<MeasuredFile>& all, const Console& console) {
  std::vector<MeasuredFeature> rows;
  for (const MeasuredFile& one : all)
    for (std::size_t i = 0; i < one.values.size(); ++i)
      rows.push_back({one.name, one.values[i], motion::motion_features()[i]});
  console.out << measured_columns.of(rows).csv;
}

std::string shown(double value, motion::FeatureUnit unit) {
  if (!std::isfinite(value)) return "–";
  return fmt::format("{:.{}f}", value, unit == motion::FeatureUnit::degrees ? 1 : 3);
}

void show_row(std::size_t i, const std::vector<MeasuredFile>& all, const Console& console) {
  const motion::MotionFeature& feature = motion::motion_features()[i];
  console.out << fmt::format("  {:25}", feature.id);
  for (const MeasuredFile& one : all)
    console.out << fmt::format(" {:>9}", shown(one.values[i], feature.unit));
  console.out << fmt::format(" {:3}  {}{} {}\n", motion::symbol_of(feature.unit), feature.name,
                             feature.reconstructed ? " *" : "", feature.japanese);
}

void show_table(const std::vector<MeasuredFile>& all, const Console& console) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    console.out << fmt::format("{:2}  {}\n", i + 1, all[i].file);
    for (const std::string& warning : warnings_of(all[i]))
      console.out << "    warning: " << warning << '\n';
  }
  for (int g = 0; g < motion::feature_group_count; ++g) {
    const auto group = static_cast<motion::FeatureGroup>(g);
    console.out << fmt::format("\n{:27}", motion::id_of(group));
    for (std::size_t i = 0; i < all.size(); ++i) console.out << fmt::format(" {:>9}", i + 1);
    console.out << fmt::format("      {} {}\n", motion::name_of(group),
                               motion::japanese_name_of(group));
    for (std::size_t i = 0; i < motion::motion_features().size(); ++i)
      if (motion::motion_features()[i].group == group) show_row(i, all, console);
  }
  console.out << "\n* replaces a repeated or ambiguous row of the published tables\n";
}

int show_features(const FeaturesOptions& options, const Console& console) {
  std::vector<MeasuredFile> all;
  for (const NamedRecording& named : named_recordings(options.files, options.recording))
    all.push_back(measured(named, feature_options(options), console));
  if (options.json) {
    show_json(all, console);
  } else if (options.csv) {
    show_csv(all, console);
  } else {
    show_table(all, console);
  }
  return exit_done;
}

}  // namespace

Command motion_features_command() {
  const auto options = std::make_shared<FeaturesOptions>();
  return {.name = "features",
          .summary = "Measure the 51 motion features by which motions can be specified",
          .options = all_of(
              argument("files", &options->files, "Motion files"),
              options_of_recordings(options->recording),
              option("--masses", &options->masses,
                     "Body segment masses: male, female (de Leva 1996), winter (Winter 2009)")
                  .one_of({"male", "female", "winter"})
                  .with_default(),
              option("--sideways", &options->sideways,
                     "Sign of lateral angles of arms, legs and feet: outward from the body, or all "
                     "to the left")
                  .one_of({"outward", "left"})
                  .with_default(),
              flag("--json", &options->json, "As JSON"),
              flag("--csv", &options->csv, "As a table with one row per motion and feature")
                  .excludes("--json")),
          .notes =
              "Measures the steadiest gait cycle, or the whole motion if there is none. \"mu\" is "
              "a mean, \"sigma\" a standard deviation over the cycle; fb is forward and backward, "
              "lr left and right, v up and down.\n\n"
              "Examples:\n"
              "  mien motion features walk.bvh\n"
              "  mien motion features --csv captures/*.bvh > features.csv",
          .run = [options](const Console& console) { return show_features(*options, console); }};
}

}  // namespace mien::pipeline
