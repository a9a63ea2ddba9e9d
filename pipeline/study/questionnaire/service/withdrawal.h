#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/study/server/session_store.h"

namespace mien::pipeline {

// Withdrawal of a participant after the session: what mien wrote of it is deleted.

/// Who withdraws: an id ("p004") or the code that the last page showed, which is the id of the
/// browser session.
struct WithdrawnParticipant {
  std::string name;     ///< as given
  std::string session;  ///< the browser session, if a session store is among the files; or empty
  std::set<std::string> ids;  ///< ids of the participant that were found; for messages

  /// Whether a row of a table is of this participant. The browser session decides where it is
  /// known, since without a server several people may have the same id.
  bool is_row(std::string_view participant, std::string_view row_session) const;
};

/// Number of the session in a store that belongs to a participant; nullopt if none does, or if it
/// has been withdrawn before.
std::optional<int> session_of(SessionStore& store, const std::string& name);

/// The browser session that sent the records of a session; empty if there are none.
std::string browser_of(SessionStore& store, int session);

/// A file without the participant, or one that names the participant and stays as it is.
struct FileWithout {
  std::filesystem::path file;
  std::string text;                    ///< its new content
  std::set<std::string> sessions;      ///< browser sessions of what is removed
  std::set<std::string> participants;  ///< ids in the removed rows
  int removed = 0;                     ///< number of removed rows or, in records, of sessions
  bool is_removed = false;             ///< the whole file is of this participant
};

/// A table (CSV) with the columns participant and session, or records of participants (JSON: the
/// export of a server, or the file saved by a page), without the participant. All that remains is
/// unchanged to the byte, except that exported JSON is written anew. Nullopt for other tables and
/// other JSON (see names_participant). Throws Error for files that cannot be read or are malformed.
std::optional<FileWithout> without_participant(const std::filesystem::path& file,
                                               const WithdrawnParticipant& who);

/// Whether a table without browser sessions, such as those of a report, has rows of one of these
/// participants. It cannot be told who they are, so that such tables must be made again. False for
/// other files.
bool names_participant(const std::filesystem::path& file, const std::set<std::string>& ids);

/// Files in which a participant may be, each once and sorted: the given ones, and in given folders
/// and the folders below them all session stores (.db), tables (.csv) and records (.json). Links in
/// folders are not followed, so that nothing outside is changed. Throws Error for what does not
/// exist and for more than 100,000 files.
std::vector<std::filesystem::path> files_of_participants(
    const std::vector<std::filesystem::path>& given);

}  // namespace mien::pipeline
