#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/ratings/answers/session_end.h"
#include "pipeline/study/questionnaire/service/withdrawal.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct WithdrawOptions {
  std::string participant;  ///< the id or code
  std::vector<std::string> files;
};

/// A session store that holds the participant.
struct FileWithSession {
  fs::path file;
  int session = 0;
};

/// The session stores among the files that hold the participant; notes the browser session in
/// `who`. No file is changed.
std::vector<FileWithSession> stores_with(const std::vector<fs::path>& files,
                                         WithdrawnParticipant& who) {
  std::vector<FileWithSession> stores;
  for (const fs::path& file : files) {
    if (file.extension() != ".db") continue;
    SessionStore store(file, DatabaseUse::read);
    const std::optional<int> session = session_of(store, who.name);
    if (!session) continue;
    who.ids.insert(store.sessions().at(static_cast<std::size_t>(*session)).participant);
    const std::string browser = browser_of(store, *session);
    if (!who.session.empty() && who.session != browser)
      throw Error({file.string()},
                  fmt::format("another person than in the file before is {} here",
                              motion::in_quotes(who.name)),
                  "give the code that the participant's last page showed");
    who.session = browser;
    stores.push_back({file, *session});
  }
  return stores;
}

/// A session store that will be changed, with the participant's session in it.
struct StoreWithSession {
  std::unique_ptr<SessionStore> store;
  int session = 0;
};

std::vector<StoreWithSession> opened_stores(const std::vector<FileWithSession>& files) {
  std::vector<StoreWithSession> stores;
  for (const FileWithSession& one : files)
    stores.push_back({std::make_unique<SessionStore>(one.file), one.session});
  return stores;
}

std::vector<FileWithout> files_with(const std::vector<fs::path>& files,
                                    const WithdrawnParticipant& who) {
  std::vector<FileWithout> changed;
  for (const fs::path& file : files) {
    if (file.extension() == ".db") continue;
    std::optional<FileWithout> without = without_participant(file, who);
    if (without && without->removed > 0) changed.push_back(*std::move(without));
  }
  return changed;
}

/// Refuses an id that several people have, which happens without a server.
void refuse_shared_id(const std::vector<FileWithout>& changed, const WithdrawnParticipant& who) {
  std::set<std::string> sessions;
  for (const FileWithout& one : changed) sessions.insert(one.sessions.begin(), one.sessions.end());
  if (who.session.empty() && sessions.size() > 1 && !sessions.contains(who.name))
    throw Error(
        {},
        fmt::format("{} are {} browser sessions, perhaps of different people: {}",
                    motion::in_quotes(who.name), sessions.size(), fmt::join(sessions, ", ")),
        "give the code that the participant's last page showed");
}

/// Reads all files before anything is changed. Prints which cannot be read; throws Error if there
/// are any.
void refuse_unreadable(const std::vector<fs::path>& files, const WithdrawnParticipant& who,
                       const Console& console) {
  bool is_unreadable = false;
  for (const fs::path& file : files) {
    try {
      if (file.extension() == ".db")
        SessionStore{file, DatabaseUse::read};
      else
        without_participant(file, who);
    } catch (const Error& error) {
      is_unreadable = true;
      console.err << error.what() << '\n';
    }
  }
  if (is_unreadable)
    throw Error("nothing was deleted, because not all files can be read",
                "mend those above, or name only the others");
}

/// Prints which tables name the participant but have no browser sessions, so that they are not
/// changed, and the pages of reports with such tables. Returns the number of tables.
int print_tables_to_remake(const std::vector<fs::path>& files, const std::set<std::string>& ids,
                           const Console& console) {
  int left = 0;
  std::set<fs::path> reports;
  for (const fs::path& file : files) {
    if (!names_participant(file, ids)) continue;
    ++left;
    // A report has the tables of its results in a folder beside its page.
    const fs::path page = file.parent_path().parent_path() / "report.html";
    if (file.parent_path().filename() == "results" && fs::exists(page)) reports.insert(page);
    console.err << fmt::format(
        "{}: names {} and was not changed, since it has no browser sessions; make it again, or "
        "delete it\n",
        file.string(), fmt::join(ids, ", "));
  }
  for (const fs::path& page : reports)
    console.err << fmt::format("{}: was made from these tables; make it again, or delete it\n",
                               page.string());
  return left;
}

/// Everything is read before anything is changed.
int withdraw(const WithdrawOptions& options, const Console& console) {
  const std::vector<fs::path> files =
      files_of_participants({options.files.begin(), options.files.end()});
  WithdrawnParticipant who{.name = options.participant, .session = {}, .ids = {}};
  refuse_unreadable(files, who, console);
  const std::vector<FileWithSession> found = stores_with(files, who);
  const std::vector<FileWithout> changed = files_with(files, who);
  for (const FileWithout& one : changed)
    who.ids.insert(one.participants.begin(), one.participants.end());
  if (found.empty() && changed.empty())
    throw Error({}, motion::in_quotes(options.participant) + " is in none of these files",
                "give the participant's id, or the code that the last page showed");
  refuse_shared_id(changed, who);
  const std::vector<StoreWithSession> stores = opened_stores(found);
  for (const FileWithout& one : changed) {
    if (one.is_removed) {
      fs::remove(one.file);
      console.out << fmt::format("{}: deleted\n", one.file.string());
    } else {
      write_file(one.file, one.text);
      console.out << fmt::format("{}: {} deleted: {}\n", one.file.string(),
                                 one.file.extension() == ".csv" ? "rows" : "sessions", one.removed);
    }
  }
  for (const StoreWithSession& one : stores) {
    const int erased = one.store->erase_records(
        one.session, std::string(word_of(session_end_words, SessionEnd::withdrawn)));
    console.out << fmt::format("{}: records deleted: {}; the session is counted as withdrawn\n",
                               one.store->file().string(), erased);
  }
  const bool is_complete = print_tables_to_remake(files, who.ids, console) == 0;
  for (const StoreWithSession& one : stores)
    if (one.store->has_erased_log())
      throw Error({one.store->file().string() + "-wal"},
                  "still contains what was deleted, because the disk is full",
                  "free some space, and start and stop mien study serve with the file");
  return is_complete ? exit_done : exit_failed;
}

}  // namespace

Command study_withdraw_command() {
  const auto options = std::make_shared<WithdrawOptions>();
  return {.name = "withdraw",
          .summary = "Delete the answers of a participant who withdraws",
          .options = {argument("participant", &options->participant,
                               "Id of the participant (p004), or the code that the last page of "
                               "the questionnaire showed"),
                      argument("files", &options->files,
                               "Files of answers (.db), tables (.csv) and records (.json), or "
                               "folders that contain them")},
          .notes =
              "Deletes the participant from the file of answers of a served study and from "
              "exported tables and records.\n"
              "The file of answers keeps count of withdrawals. Stop a server that uses the file "
              "first. Tables that reports\n"
              "wrote are named, but not changed (exit code 1): make reports again. Copies "
              "elsewhere are not found.\n\n"
              "Examples:\n"
              "  mien study withdraw p004 out/emotion-study-answers.db exported/\n"
              "  mien study withdraw 3f2a90c1d4e5b687 lab.db answers.csv participants.csv",
          .run = [options](const Console& console) { return withdraw(*options, console); }};
}

}  // namespace mien::pipeline
