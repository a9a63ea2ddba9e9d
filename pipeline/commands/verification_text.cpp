#include "pipeline/commands/verification_text.h"

#include <array>
#include <map>

#include <fmt/format.h>

#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr std::array finding_kinds = {Finding::Kind::missing, Finding::Kind::changed,
                                      Finding::Kind::extra, Finding::Kind::not_kept,
                                      Finding::Kind::left_out};

/// "1 missing, 2 changed, 3 extra"; kinds that do not affect the result only if present.
std::string counts_text(const Verification& verification) {
  std::string text;
  for (const Finding::Kind kind : finding_kinds) {
    const int count = verification.count(kind);
    const bool decides = kind == Finding::Kind::missing || kind == Finding::Kind::changed;
    if (count == 0 && !decides) continue;
    text += (text.empty() ? "" : ", ") + fmt::format("{} {}", count, name_of(kind));
  }
  return text;
}

std::string counted(int count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// A note on recordings and characters, which are not copied to the study's folder.
std::string elsewhere_text(const StudyContents& contents) {
  const int count = contents.inputs_elsewhere;
  return count == 0 ? "" : fmt::format(" ({} elsewhere, not checked)", count);
}

/// Prints intentionally removed files by folder: "not kept  metrics: 23 files".
void print_removed(const Verification& verification, const Console& console) {
  std::map<std::string, int> by_folder;
  for (const Finding& finding : verification.findings)
    if (finding.kind == Finding::Kind::not_kept)
      ++by_folder[finding.path.substr(0, finding.path.find('/'))];
  for (const auto& [folder, count] : by_folder)
    console.out << fmt::format("not kept  {}: {}\n", folder, counted(count, "artifact"));
}

}  // namespace

Verification verified(const StudyContents& contents, int threads, const Console& console) {
  ProgressBar bar(console.err, console.err_is_terminal);
  return verify(contents, threads, console.stop,
                [&](double share, const std::string& path) { bar.show(share, path); });
}

void print_result(const Verification& verification, const StudyContents& contents,
                  const Console& console) {
  for (const Finding& finding : verification.findings) {
    if (finding.kind == Finding::Kind::not_kept) continue;
    console.out << fmt::format("{:<9} {}{}{}\n", name_of(finding.kind), finding.path,
                               finding.what.empty() ? "" : ": ", finding.what);
  }
  print_removed(verification, console);
  console.out << fmt::format("{}: {} and {}, {}; {} and {} decoded: {}\n", contents.folder.string(),
                             counted(verification.artifacts, "artifact"),
                             counted(verification.inputs, "input") + elsewhere_text(contents),
                             size_text(verification.bytes), counted(verification.videos, "video"),
                             counted(verification.pictures, "picture"), counts_text(verification));
}

ordered_json as_json(const Verification& verification, const StudyContents& contents) {
  ordered_json result = {
      {"folder", contents.folder.string()}, {"study", contents.study},
      {"sound", verification.is_sound()},   {"artifacts", verification.artifacts},
      {"inputs", verification.inputs},      {"inputs_elsewhere", contents.inputs_elsewhere},
      {"bytes", verification.bytes},        {"videos", verification.videos},
      {"pictures", verification.pictures}};
  for (const Finding::Kind kind : finding_kinds) {
    const std::string key = kind == Finding::Kind::not_kept   ? "not_kept"
                            : kind == Finding::Kind::left_out ? "left_out"
                                                              : std::string(name_of(kind));
    result[key] = ordered_json::array();
    for (const Finding& finding : verification.findings)
      if (finding.kind == kind)
        result[key].push_back({{"path", finding.path}, {"what", finding.what}});
  }
  return result;
}

std::string size_text(std::uint64_t bytes) {
  constexpr std::array units = {"bytes", "kB", "MB", "GB", "TB"};
  auto size = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; size >= 1000.0 && unit + 1 < units.size(); ++unit) size /= 1000.0;
  return unit == 0 ? fmt::format("{} bytes", bytes) : fmt::format("{:.1f} {}", size, units[unit]);
}

}  // namespace mien::pipeline
