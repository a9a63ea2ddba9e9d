#include "pipeline/study/questionnaire/service/withdrawal.h"

#include <algorithm>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/text/file_contents.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The lines of a table, each with its line end: rows, whose quoted fields may hold line ends, and
/// empty lines.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  bool is_quoted = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"') is_quoted = !is_quoted;
    if (text[at] != '\n' || is_quoted) continue;
    lines.push_back(text.substr(begin, at + 1 - begin));
    begin = at + 1;
  }
  if (begin < text.size()) lines.push_back(text.substr(begin));
  return lines;
}

bool is_empty_line(std::string_view line) { return line == "\n" || line == "\r\n"; }

std::optional<FileWithout> table_without(const fs::path& file, std::string_view text,
                                         const WithdrawnParticipant& who) {
  const CsvTable table = parse_csv(text, file.string());
  const int participant = find_column(table, "participant"),
            session = find_column(table, "session");
  if (participant < 0 || session < 0) return std::nullopt;
  FileWithout without{.file = file};
  std::size_t row = 0;
  bool is_header = true;
  for (const std::string_view line : lines_of(text)) {
    bool is_removed = false;
    if (!is_empty_line(line) && !std::exchange(is_header, false)) {
      const std::vector<CsvField>& fields = table.rows.at(row++);
      const std::string& row_session = fields[static_cast<std::size_t>(session)].text;
      is_removed = who.is_row(fields[static_cast<std::size_t>(participant)].text, row_session);
      if (is_removed) {
        without.sessions.insert(row_session);
        without.participants.insert(fields[static_cast<std::size_t>(participant)].text);
      }
    }
    if (is_removed)
      ++without.removed;
    else
      without.text += line;
  }
  return without;
}

std::string text_in(const ordered_json& object, const char* member) {
  const auto found = object.find(member);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The browser session of an exported session.
std::string browser_of(const ordered_json& session) {
  const auto records = session.find("records");
  if (records == session.end() || !records->is_array() || records->empty()) return "";
  return records->front().is_object() ? text_in(records->front(), "session") : "";
}

/// The browser session of records that a page saved, in a folder or to JATOS; empty for other JSON.
std::string session_of_page(const ordered_json& records) {
  if (!records.contains("participant") || !records.contains("records")) return "";
  return records.contains("session") ? text_in(records, "session") : text_in(records, "name");
}

std::optional<FileWithout> records_without(const fs::path& file, const std::string& text,
                                           const WithdrawnParticipant& who) {
  ordered_json records = ordered_json::parse(text, nullptr, false);
  if (!records.is_object()) return std::nullopt;
  FileWithout without{.file = file};
  // As a page saves them.
  if (const std::string browser = session_of_page(records); !browser.empty()) {
    without.is_removed = who.is_row(text_in(records, "participant"), browser);
    without.removed = without.is_removed ? 1 : 0;
    if (without.is_removed) {
      without.sessions.insert(browser);
      without.participants.insert(text_in(records, "participant"));
    }
    return without;
  }
  if (text_in(records, "format") != "mien-answers-1" || !records["sessions"].is_array())
    return std::nullopt;
  ordered_json kept = ordered_json::array();
  for (ordered_json& session : records["sessions"]) {
    const std::string browser = browser_of(session);
    const bool is_removed =
        !browser.empty() && who.is_row(text_in(session, "participant"), browser);
    if (is_removed) {
      ++without.removed;
      without.sessions.insert(browser);
      without.participants.insert(text_in(session, "participant"));
    } else {
      kept.push_back(std::move(session));
    }
  }
  records["sessions"] = std::move(kept);
  without.text = records.dump(1) + "\n";
  return without;
}

}  // namespace

bool WithdrawnParticipant::is_row(std::string_view participant,
                                  std::string_view row_session) const {
  if (!session.empty()) return row_session == session;
  return row_session == name || participant == name;
}

std::string browser_of(SessionStore& store, int session) {
  const std::vector<StoredRecord> records = store.records_of(session);
  if (records.empty()) return "";
  return text_in(ordered_json::parse(records.front().content), "session");
}

std::optional<int> session_of(SessionStore& store, const std::string& name) {
  for (const StoredSession& session : store.sessions()) {
    const std::string browser = browser_of(store, session.index);
    if (!browser.empty() && (session.participant == name || browser == name)) return session.index;
  }
  return std::nullopt;
}

std::optional<FileWithout> without_participant(const fs::path& file,
                                               const WithdrawnParticipant& who) {
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_table_bytes);
  if (!reading.bytes) throw Error({file.string()}, reading.error, "check the file");
  if (file.extension() == ".csv") return table_without(file, *reading.bytes, who);
  return records_without(file, *reading.bytes, who);
}

bool names_participant(const fs::path& file, const std::set<std::string>& ids) {
  if (file.extension() != ".csv") return false;
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_table_bytes);
  if (!reading.bytes) throw Error({file.string()}, reading.error, "check the file");
  const CsvTable table = parse_csv(*reading.bytes, file.string());
  const int participant = find_column(table, "participant");
  if (participant < 0 || find_column(table, "session") >= 0) return false;
  return std::ranges::any_of(table.rows, [&](const std::vector<CsvField>& row) {
    const std::string& id = row[static_cast<std::size_t>(participant)].text;
    return ids.contains(id.substr(0, id.find('/')));
  });
}

std::vector<fs::path> files_of_participants(const std::vector<fs::path>& given) {
  constexpr std::size_t most_files = 100'000;
  std::set<fs::path> files;
  const auto is_ours = [](const fs::path& file) {
    return file.extension() == ".db" || file.extension() == ".csv" || file.extension() == ".json";
  };
  for (const fs::path& named : given) {
    std::error_code unknown;
    const fs::path path = fs::canonical(named, unknown);
    if (unknown) throw Error({named.string()}, "does not exist", "check the name");
    if (!fs::is_directory(path)) {
      files.insert(path);
      continue;
    }
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied)) {
      const bool is_file = entry.is_regular_file() && !entry.is_symlink();
      if (is_file && is_ours(entry.path())) files.insert(entry.path());
      if (files.size() > most_files)
        throw Error({path.string()}, "holds more than 100,000 files", "name the files");
    }
  }
  return {files.begin(), files.end()};
}

}  // namespace mien::pipeline
