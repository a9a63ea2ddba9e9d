#include "pipeline/production/archive/pack.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/shell_word.h"
#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/verification_text.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/archive/bids_stimuli.h"
#include "pipeline/production/archive/research_crate.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr char pack_notes[] =
    "The archive is a bag (BagIt, RFC 8493): the study in data/, with SHA-256 sums beside it for "
    "sha256sum -c manifest-sha256.txt (which does not find files with % or line ends in their "
    "names, as BagIt encodes these). The same study with the same options gives the same bytes. "
    "The study is verified first, and refused if anything is missing or changed. Stale artifacts, "
    "which other runs made in its folder, are left out and listed.\n\n"
    "data/ro-crate-metadata.json describes the study as a research object (RO-Crate). RO-Crate "
    "requires a date of publication and a licence: state --published and --license, and the author "
    "with --organization. --bids adds data/stimuli/, a folder for a BIDS dataset, with copies of "
    "the videos.\n\n"
    "Recordings are not packed unless --recordings is given. Those that the manifest marks with "
    "licence: {name: …, share: false} are left out even then, and so are the motion files in "
    "clips/ "
    "that were made from them; --restricted packs these, too. What was left out is listed, also in "
    "the archive (bag-info.txt and data/recordings.json).\n\n"
    "Examples:\n"
    "  mien pack out/my-study -o my-study.tar.zst\n"
    "  mien pack out/my-study --organization \"University of Somewhere\" --license CC-BY-4.0\n"
    "  mien verify my-study                       after tar xf my-study.tar.zst";

struct PackOptions {
  std::string study;
  std::string output;
  BagInfo info;
  bool recordings = false;
  bool restricted = false;
  bool bids = false;
  bool force = false;
  bool json = false;
};

/// Verifies a study. Throws Error if it does not match its provenance.
Verification verified_or_refused(const StudyContents& contents, const Console& console) {
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const Verification verification = verified(contents, threads, console);
  if (verification.is_sound()) return verification;
  print_result(verification, contents,
               {console.err, console.err, console.err_is_terminal, console.stop});
  throw Error({contents.folder.string()}, "differs from its provenance and is not packed",
              "mien run " + motion::shell_path(contents.provenance().string()) + " --out " +
                  motion::shell_path(fs::absolute(contents.folder).parent_path().string()) +
                  " restores what is missing or damaged; use mien clean to leave something out");
}

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Where the recordings of a study are, and how its inputs/as-run.yaml names their folders.
void locate_recordings(const StudyContents& contents, RecordingPacking& packing) {
  const Manifest manifest = load_manifest(contents.provenance(), process_environment());
  const std::map<fs::path, std::string> names = names_of_uncopied_inputs(manifest);
  std::map<fs::path, std::string> folders;
  for (const auto& [file, name] : names) {
    packing.files[name] = file;
    folders[file.parent_path()] = fs::path(name).parent_path().generic_string();
  }
  const fs::path as_run = contents.folder / contents.as_run;
  for (const auto& [text, resolved] :
       named_files(read_file(as_run), as_run, process_environment())) {
    const fs::path packed = packed_place(contents.packed, contents.folder, text);
    const fs::path place = fs::absolute(packed.empty() ? resolved : packed).lexically_normal();
    const auto whole = folders.find(place);
    const auto around = folders.find(place.parent_path());
    if (whole != folders.end()) {
      packing.folders[text] = whole->second;
    } else if (around != folders.end()) {
      packing.folders[fs::path(text).parent_path().generic_string()] = around->second;
    }
  }
}

/// What was left out, and why: path → licences.
std::map<std::string, std::string> left_out(const StudyContents& contents,
                                            const PackedRecordings& recordings) {
  std::map<std::string, std::string> paths;
  for (const std::string& name : recordings.left_out)
    paths[name] = contents.find_recording(name)->licence;
  for (const std::string& path : recordings.left_out_files)
    paths[path] = fmt::format("{}", fmt::join(contents.find(path)->restricting, ", "));
  return paths;
}

/// "1 recording and 2 motion files, which must not be shared (licence AMASS licence); …"
std::string left_out_note(const std::map<std::string, std::string>& paths,
                          const PackedRecordings& recordings) {
  if (paths.empty()) return "";
  std::set<std::string> licences;
  for (const auto& [path, licence] : paths) licences.insert(licence);
  return fmt::format(
      "{} and {}, which must not be shared (licence {}); listed in data/recordings.json",
      counted(recordings.left_out.size(), "recording"),
      counted(recordings.left_out_files.size(), "motion file"), fmt::join(licences, ", "));
}

/// Throws Error unless a text is a date of the calendar in the form of ISO 8601.
void require_date(const std::string& text) {
  static const std::regex form(R"((\d{4})-(\d{2})-(\d{2}))");
  std::smatch parts;
  bool is_date = std::regex_match(text, parts, form);
  if (is_date) {
    const auto number = [&](int part) { return static_cast<unsigned>(std::stoi(parts[part])); };
    const std::chrono::year year(static_cast<int>(number(1)));
    is_date = (year / std::chrono::month(number(2)) / std::chrono::day(number(3))).ok();
  }
  if (!is_date)
    throw Error({"--published"}, motion::in_quotes(text) + " is not a date",
                "write the year, month and day, for example 2026-11-30");
}

/// Adds files that are only in the archive: stimuli of a BIDS dataset, and the crate's metadata,
/// which describe all others.
void add_descriptions(const StudyContents& contents, const PackOptions& options,
                      const BagInfo& info, std::vector<PayloadFile>& payload,
                      const Console& console) {
  if (options.bids) {
    BidsStimuli stimuli = bids_stimuli(contents, payload, info.license);
    if (stimuli.videos == 0)
      throw Error({contents.folder.string()}, "has no videos for a BIDS dataset",
                  "omit --bids, or make videos of the kinds mp4, webm or mkv");
    for (const std::string& path : stimuli.omitted)
      console.err << motion::printable(path)
                  << ": not copied to stimuli/, which has one .mp4, .webm and .mkv per stimulus\n";
    payload.insert(payload.end(), std::make_move_iterator(stimuli.files.begin()),
                   std::make_move_iterator(stimuli.files.end()));
    std::ranges::sort(payload, {}, &PayloadFile::path);
  }
  const std::string crate = crate_metadata(contents, payload, info);
  payload.push_back({crate_path, crate.size(), {}, {}, crate});
  std::ranges::sort(payload, {}, &PayloadFile::path);
}

void warn_of_encoded_paths(const std::vector<PayloadFile>& payload, const Console& console) {
  const std::vector<std::string> paths = encoded_paths(payload);
  if (paths.empty()) return;
  console.err << fmt::format(
      "warning: data/{}{}: BagIt encodes %, line feeds and carriage returns in names, so that "
      "sha256sum -c does not find such files; check the archive with mien verify or a program for "
      "BagIt, or rename them\n",
      motion::printable(paths.front()),
      paths.size() == 1 ? "" : fmt::format(" and {} more", paths.size() - 1));
}

int run_pack(const PackOptions& options, const Console& console) {
  if (!options.info.published.empty()) require_date(options.info.published);
  const StudyContents contents = contents_of(options.study);
  const fs::path archive = options.output.empty() ? contents.study + ".tar.zst" : options.output;
  refuse_archive(contents, archive);
  if (!options.force && fs::exists(fs::symlink_status(archive)))
    throw Error({archive.string()}, "exists already; nothing was packed",
                "--force replaces it, -o names another file");
  const Verification verification = verified_or_refused(contents, console);
  RecordingPacking packing{options.recordings, options.restricted};
  if (options.recordings) locate_recordings(contents, packing);
  auto [payload, recordings, stale] = packed_study(contents, packing);
  const std::map<std::string, std::string> omitted = left_out(contents, recordings);
  BagInfo info = options.info;
  info.left_out = left_out_note(omitted, recordings);
  add_descriptions(contents, options, info, payload, console);
  warn_of_encoded_paths(payload, console);
  {
    ProgressBar bar(console.err, console.err_is_terminal);
    pack(contents, payload, info, archive, console.stop,
         [&](double share, const std::string& path) { bar.show(share, path); });
  }
  std::uint64_t bytes = 0;
  for (const PayloadFile& file : payload) bytes += file.size;
  nlohmann::ordered_json extra = nlohmann::ordered_json::array();
  for (const Finding& finding : verification.findings)
    if (finding.kind == Finding::Kind::extra) extra.push_back(finding.path);
  if (options.json) {
    const nlohmann::ordered_json result = {{"archive", archive.string()},
                                           {"size", fs::file_size(archive)},
                                           {"study", contents.study},
                                           {"files", payload.size()},
                                           {"bytes", bytes},
                                           {"extra", extra},
                                           {"recordings", recordings.packed.size()},
                                           {"left_out", omitted},
                                           {"stale", stale}};
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    console.out << result.dump(2, ' ', false, replace) << '\n';
    return exit_done;
  }
  for (const auto& path : extra)
    console.out << "also packed, though not made by mien: " << path.get<std::string>() << '\n';
  for (const auto& [path, licence] : omitted)
    console.out << fmt::format("left out  {}: licence {}\n", motion::printable(path),
                               motion::printable(licence));
  for (const std::string& path : stale)
    console.out << fmt::format(
        "left out  {}: stale, no part of the study as last made; mien clean --stale removes it\n",
        motion::printable(path));
  console.out << fmt::format("{}: {}, {} files of {}\n", archive.string(),
                             size_text(fs::file_size(archive)), payload.size(), size_text(bytes));
  if (const std::vector<std::string> lacking = lacking_of_crate(info); !lacking.empty())
    console.err << fmt::format("before publication, state {}: ro-crate-metadata.json lacks {}\n",
                               fmt::join(lacking, ", "), lacking.size() == 1 ? "it" : "them");
  return exit_done;
}

std::vector<CommandOption> info_options(BagInfo& info) {
  return {option("--organization", &info.organization,
                 "Organization that owns the study (Source-Organization of bag-info.txt)"),
          option("--contact-name", &info.contact_name, "Contact person (Contact-Name)"),
          option("--contact-email", &info.contact_email, "Contact e-mail address (Contact-Email)"),
          option("--description", &info.description,
                 "Description, instead of the command that made it (External-Description)"),
          option("--license", &info.license, "Licence, for example CC-BY-4.0 (License)"),
          option("--published", &info.published,
                 "Date of publication, for example 2026-11-30 (only in ro-crate-metadata.json)")};
}

}  // namespace

Command pack_command() {
  const auto options = std::make_shared<PackOptions>();
  return {.name = "pack",
          .summary = "Pack a finished study into one archive file",
          .options = all_of(
              argument("study", &options->study, "Folder of a study, or its provenance.json"),
              option("-o,--output", &options->output,
                     "Archive to write: .tar.zst, .tar.gz or .tar (default: <study>.tar.zst)"),
              flag("--recordings", &options->recordings,
                   "Pack the recordings, too, except those that must not be shared"),
              flag("--restricted", &options->restricted,
                   "Pack even recordings and motion files that must not be shared"),
              flag("--bids", &options->bids,
                   "Add the videos as stimuli of a BIDS dataset, with their descriptions"),
              flag("--force", &options->force, "Replace an existing archive"),
              info_options(options->info),
              flag("--json", &options->json, "List of packed files as JSON on standard output")),
          .notes = pack_notes,
          .run = [options](const Console& console) { return run_pack(*options, console); }};
}

}  // namespace mien::pipeline
