#include "pipeline/study/questionnaire/frozen_design.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/quality_rules.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/study/questionnaire/analysis_plan.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/session_duration.h"
#include "pipeline/study/questionnaire/simulated_people.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr char hashes_path[] = "manifest-sha256.txt";
constexpr char frozen_format[] = "mien-frozen-1";

constexpr char readme[] =
    "The design of a questionnaire, frozen before data collection.\n\n"
    "design.json          study, hash of the design, participants, expected duration, analysis\n"
    "plans.csv            every trial of every participant\n"
    "balance.csv          how often each stimulus appears, in which position and after which\n"
    "scales.csv           scales used\n"
    "scale_words.csv      names of their ends in all languages\n"
    "analysis-plan.txt    planned analysis\n"
    "procedure.md         participants, procedure and analysis as in the methods section\n"
    "references.bib       works that it cites (BibTeX)\n"
    "stimuli.csv          SHA-256 of all media shown\n"
    "inputs/              the manifest and the files that it names\n"
    "inputs.csv           hashes of these and of the motions that they name\n"
    "power.txt            power analysis: result and assumptions, if one was made\n"
    "planned-tests.csv    power of the planned tests, if it was simulated\n"
    "dummy-report/        report of simulated answers\n"
    "manifest-sha256.txt  hashes of all files: sha256sum -c manifest-sha256.txt\n\n"
    "mien study report --frozen compares a study as run with this archive.\n";

/// An archive that names more participants is not compared for their number.
constexpr int most_compared_participants = 10000;

std::string sha256_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  Sha256 sha;
  std::vector<char> part(std::size_t{1} << 20U);
  while (in) {
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    sha.add({part.data(), static_cast<std::size_t>(in.gcount())});
  }
  if (!in.eof()) throw std::runtime_error(file.string() + " cannot be read");
  return sha.finish();
}

std::string hashes_text(const ZipFiles& files) {
  std::string text;
  for (const auto& [path, bytes] : files)
    if (path != hashes_path) text += sha256_of(bytes) + "  " + path + "\n";
  return text;
}

constexpr auto scales_columns = table_of<Scale>(
    "scales.csv", "scale that is asked",
    {{"scale", "", "id of the scale", [](auto& r) { return r.id; }},
     {"low", "", "name of its low end", [](auto& r) { return r.low; }},
     {"high", "", "name of its high end", [](auto& r) { return r.high; }},
     {"low_ja", "", "Japanese name of its low end", [](auto& r) { return r.japanese_low; }},
     {"high_ja", "", "Japanese name of its high end", [](auto& r) { return r.japanese_high; }},
     {"least", "", "value at the low end", [](auto& r) { return r.least; }},
     {"most", "", "value at the high end", [](auto& r) { return r.most; }}});

struct ScaleWords {
  std::string scale, language, low, high;
};

constexpr auto scale_words_columns =
    table_of<ScaleWords>("scale_words.csv", "scale in a language",
                         {{"scale", "", "id of the scale", [](auto& r) { return r.scale; }},
                          {"language", "", "language (BCP 47)", [](auto& r) { return r.language; }},
                          {"low", "", "name of its low end", [](auto& r) { return r.low; }},
                          {"high", "", "name of its high end", [](auto& r) { return r.high; }}});

std::string scale_words_csv(const std::vector<Scale>& scales) {
  std::vector<ScaleWords> rows;
  for (const Scale& scale : scales) {
    rows.push_back({scale.id, "en", scale.low, scale.high});
    if (!scale.japanese_low.empty() || !scale.japanese_high.empty())
      rows.push_back({scale.id, "ja", scale.japanese_low, scale.japanese_high});
    for (const auto& [language, ends] : scale.words)
      rows.push_back({scale.id, language, ends[0], ends[1]});
  }
  return scale_words_columns.of(rows).csv;
}

std::string design_json(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  const Questionnaire& questionnaire = questionnaire_of(manifest);
  const AnalysisPlan& analysis = questionnaire.analysis;
  const auto longest = std::ranges::max_element(plans, {}, &SessionPlan::expected_seconds);
  ordered_json design = {{"format", frozen_format},
                         {"study", manifest.study},
                         {"design", design_hash(manifest, plans)},
                         {"seed", manifest.seed},
                         {"participants", plans.size()},
                         {"expected_minutes", std::round(longest->expected_seconds / 6.0) / 10.0},
                         {"analysis",
                          {{"alpha", analysis.alpha},
                           {"correction", word_of(correction_words, analysis.correction)},
                           {"most_failed", analysis.max_failed_checks}}}};
  if (analysis.lag > 0.0) design["analysis"]["lag"] = analysis.lag;
  const FactorialPlan& factorial = analysis.factorial;
  if (!factorial.factors.empty()) design["analysis"]["factors"] = factorial.factors;
  if (!factorial.between.empty()) design["analysis"]["between"] = factorial.between;
  if (!factorial.contrasts.empty())
    design["analysis"]["contrasts"] = written(factorial.contrasts, {});
  if (factorial.random_slopes) design["analysis"]["random_slopes"] = true;
  if (!has_no_rules(analysis.quality))
    design["analysis"]["quality"] = written(analysis.quality, {});
  return design.dump(2) + "\n";
}

struct FrozenInput {
  std::string name;
  std::string hash;
};

constexpr auto inputs_columns =
    table_of<FrozenInput>("inputs.csv", "file that the manifest names",
                          {{"input", "", "path of the file", [](auto& r) { return r.name; }},
                           {"xxh3", "", "XXH3-128 of it", [](auto& r) { return r.hash; }}});

std::string inputs_csv(const Manifest& manifest) {
  std::vector<FrozenInput> rows;
  for (const auto& [name, hash] : hashes_of_inputs(manifest)) rows.push_back({name, hash});
  return inputs_columns.of(rows).csv;
}

struct FrozenMedia {
  ShownMedia media;
  std::string sha256;
};

constexpr auto media_columns = table_of<FrozenMedia>(
    "stimuli.csv", "file that is shown",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.media.stimulus; }},
     {"media", "", "the file, from the study's folder", [](auto& r) { return r.media.path; }},
     {"sha256", "", "SHA-256 of it", [](auto& r) { return r.sha256; }}});

std::string stimuli_csv(const Manifest& manifest, const fs::path& study_folder) {
  std::vector<FrozenMedia> rows;
  for (const ShownMedia& media : shown_media(manifest)) {
    const fs::path file = study_folder / media.path;
    if (const std::string error = motion::read_error(file, motion::any_size); !error.empty())
      throw Error({file.string()}, error, "make the study first: mien run");
    rows.push_back({media, sha256_of_file(file)});
  }
  return media_columns.of(rows).csv;
}

/// All files but the hashes of the media, which may not exist yet.
ZipFiles described(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  ZipFiles files;
  files["README.txt"] =
      fmt::format("{}\nThe dummy report. {}", readme, dummy_assumptions(manifest));
  files["design.json"] = design_json(manifest, plans);
  files["plans.csv"] = plans_csv(plans);
  files["balance.csv"] = balance_csv(balance_of(manifest, plans));
  files["scales.csv"] = scales_columns.of(questionnaire_scales(manifest).scales).csv;
  files["scale_words.csv"] = scale_words_csv(questionnaire_scales(manifest).scales);
  files["analysis-plan.txt"] = analysis_plan_text(manifest);
  files["inputs.csv"] = inputs_csv(manifest);
  for (const InputCopy& copy : input_copies(manifest))
    files[copy.path] = contents_of_copy(manifest, copy);
  return files;
}

ZipFiles read_frozen(const fs::path& bundle) {
  ZipFiles frozen = read_zip(bundle);
  constexpr std::size_t deepest = 16;  // nesting of design.json
  const bool is_complete = frozen.contains("design.json") && frozen.contains(hashes_path);
  if (!is_complete || motion::is_nested_deeper(frozen["design.json"], deepest) ||
      !ordered_json::accept(frozen["design.json"]))
    throw Error({bundle.string()}, "is not a frozen design", "give an archive written by --freeze");
  if (frozen[hashes_path] != hashes_text(frozen))
    throw Error({bundle.string()}, "was changed after it was written",
                "use the archive as registered");
  return frozen;
}

/// The rows of a CSV table, by their first field.
std::map<std::string, std::string> rows_of_table(const std::string& csv) {
  std::map<std::string, std::string> rows;
  const CsvTable table = parse_csv(csv, "frozen");
  for (const auto& row : table.rows)
    for (const CsvField& field : row) rows[row.front().text] += field.text + "\n";
  return rows;
}

/// Adds "stimuli: a and b", the names whose rows differ or are in one table alone.
void compare_tables(const std::string& what, const std::string& then, const std::string& now,
                    std::vector<std::string>& differences) {
  if (then == now) return;
  const auto before = rows_of_table(then), after = rows_of_table(now);
  std::vector<std::string> changed, added, removed;
  for (const auto& [name, row] : after) {
    const auto found = before.find(name);
    if (found == before.end()) added.push_back(name);
    if (found != before.end() && found->second != row) changed.push_back(name);
  }
  for (const auto& [name, row] : before)
    if (!after.contains(name)) removed.push_back(name);
  const auto tell = [&](const char* happened, const std::vector<std::string>& names) {
    if (!names.empty())
      differences.push_back(fmt::format("{}: {} {}", what, fmt::join(names, ", "), happened));
  };
  tell("changed", changed);
  tell("added", added);
  tell("removed", removed);
}

/// Adds "analysis: alpha: 0.1 instead of 0.05"; of what is nested, each entry that differs.
void compare_entries(const std::string& where, const ordered_json& before,
                     const ordered_json& after, std::vector<std::string>& differences) {
  if (before == after) return;
  if (before.is_object() && after.is_object()) {
    for (const auto& [key, value] : after.items())
      compare_entries(where + ": " + key, before.contains(key) ? before[key] : ordered_json(),
                      value, differences);
    for (const auto& [key, value] : before.items())
      if (!after.contains(key))
        differences.push_back(where + ": " + motion::excerpt(key) + ": no longer stated");
    return;
  }
  constexpr std::size_t longest = 60;
  const std::string then = before.dump(), now = after.dump();
  if (before.is_null())
    differences.push_back(where + ": not in the registered design");
  else if (then.size() > longest || now.size() > longest)
    differences.push_back(where + ": changed");
  else
    differences.push_back(fmt::format("{}: {} instead of {}", where, now, then));
}

void compare_designs(const std::string& then, const std::string& now,
                     std::vector<std::string>& differences) {
  const auto before = ordered_json::parse(then), after = ordered_json::parse(now);
  for (const auto& [key, value] : after.items()) {
    const ordered_json& old = before.contains(key) ? before[key] : ordered_json();
    if (old == value || key == "expected_minutes") continue;
    if (key == "design") {
      differences.push_back("design: what participants see differs from the registered design");
    } else {
      compare_entries(key, old, value, differences);
    }
  }
}

}  // namespace

std::vector<ShownMedia> shown_media(const Manifest& manifest) {
  std::vector<ShownMedia> media;
  const std::vector<std::string> shown = shown_stimuli(manifest);
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (std::ranges::find(shown, stimulus.id) == shown.end()) continue;
    for (const render::VideoKind kind : stimulus.output.video) {
      const std::string name = render::with_ending(stimulus.id, kind).string();
      media.push_back({stimulus.id, "videos/" + name});
    }
    if (questionnaire_of(manifest).view == ShownAs::turn)
      media.push_back({stimulus.id, "clips/" + stimulus.id + ".glb"});
  }
  return media;
}

ZipFiles frozen_design(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                       const fs::path& study_folder) {
  ZipFiles files = described(manifest, plans);
  files["stimuli.csv"] = stimuli_csv(manifest, study_folder);
  files[hashes_path] = hashes_text(files);
  return files;
}

void add_folder(ZipFiles& frozen, const fs::path& folder, const std::string& prefix) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory() && !entry.is_symlink()) continue;
    refuse_special_file(entry.path());
    const std::string path = entry.path().lexically_relative(folder).generic_string();
    frozen[prefix + "/" + path] = read_file(entry.path());
  }
  frozen[hashes_path] = hashes_text(frozen);
}

void add_dummy_answers(ZipFiles& frozen, const Manifest& manifest,
                       const std::vector<SessionPlan>& plans) {
  frozen["dummy-report/answers.csv"] = to_csv(dummy_answers(manifest, plans));
  if (asks_about_participants(manifest))
    frozen["dummy-report/participants.csv"] = simulated_people_csv(manifest, plans);
  frozen[hashes_path] = hashes_text(frozen);
}

std::vector<std::string> frozen_differences(const fs::path& bundle, const Manifest& manifest,
                                            const fs::path& study_folder) {
  ZipFiles then = read_frozen(bundle);
  std::vector<std::string> differences;
  // Whether anything else differs is seen at the registered number of participants.
  Manifest compared = manifest;
  const auto design = ordered_json::parse(then["design.json"]);
  if (const auto registered = design.find("participants");
      registered != design.end() && registered->is_number_integer()) {
    const auto participants = registered->get<std::int64_t>();
    const int planned = questionnaire_of(manifest).participants;
    if (participants != planned && participants >= 1 &&
        participants <= most_compared_participants) {
      differences.push_back(fmt::format(
          "participants: the manifest plans {} instead of the registered {}; everything that "
          "follows is compared for the registered number",
          planned, participants));
      compared.questionnaire->participants = static_cast<int>(participants);
    }
  }
  ZipFiles now = described(compared, plan_sessions(compared));
  compare_designs(then["design.json"], now["design.json"], differences);
  compare_tables("plans of participants", then["plans.csv"], now["plans.csv"], differences);
  compare_tables("scales", then["scales.csv"], now["scales.csv"], differences);
  if (stated_plan_in(then["analysis-plan.txt"]) != stated_plan_in(now["analysis-plan.txt"]))
    differences.push_back("analysis: the text of the plan differs");
  compare_tables("inputs", then["inputs.csv"], now["inputs.csv"], differences);
  if (study_folder.empty()) {
    differences.push_back("stimuli: not compared, because the study's folder was not given");
  } else {
    compare_tables("stimuli", then["stimuli.csv"], stimuli_csv(manifest, study_folder),
                   differences);
  }
  return differences;
}

}  // namespace mien::pipeline
