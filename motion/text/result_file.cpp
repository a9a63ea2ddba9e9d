#include "motion/text/result_file.h"

#include <cerrno>
#include <mutex>
#include <set>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mien {

namespace {

const char* remedy_of(const std::error_code& code) {
  if (code == std::errc::no_space_on_device || code == std::error_code(EDQUOT, code.category()))
    return "; free some space, and try again";
  if (code == std::errc::no_such_file_or_directory) return "; create its folder first";
  if (code == std::errc::permission_denied || code == std::errc::operation_not_permitted ||
      code == std::errc::read_only_file_system)
    return "; name a writable folder";
  if (code == std::errc::is_a_directory) return "; name a file";
  return "";
}

std::error_code last_error() { return {errno, std::generic_category()}; }

}  // namespace

WriteFailure cannot_be_written(const std::filesystem::path& file, std::error_code code) {
  return WriteFailure(
      file.string() + ": cannot be written (" + code.message() + ")" + remedy_of(code), code);
}

namespace motion {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 255;  ///< bytes, on the file systems that are in use

/// The drafts of this process. A program that is stopped at once has to know them, wherever in it
/// they are being written: the one thing here that is not passed on by parameters.
struct Drafts {
  std::mutex mutex;
  std::set<fs::path> paths;
  unsigned count = 0;
};

Drafts& drafts() {
  static Drafts all;
  return all;
}

/// A file that is open for writing, and closes itself.
class OpenForWriting {
 public:
  OpenForWriting(const fs::path& file, int flags, mode_t mode = 0666)
      : number_(::open(file.c_str(), flags | O_WRONLY | O_CLOEXEC, mode)) {}
  ~OpenForWriting() {
    if (number_ >= 0) ::close(number_);
  }
  OpenForWriting(const OpenForWriting&) = delete;
  OpenForWriting& operator=(const OpenForWriting&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

  /// Some disks on the network say only now that they are full.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

/// The end of a chain of links, whether it exists or not.
fs::path end_of_links(const fs::path& target) {
  constexpr int most_links = 40;
  fs::path place = target;
  std::error_code error;
  for (int link = 0; link < most_links && fs::is_symlink(place, error); ++link) {
    const fs::path next = fs::read_symlink(place, error);
    if (error) break;
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  return place;
}

fs::path draft_beside(const fs::path& place) {
  Drafts& all = drafts();
  const std::lock_guard guard(all.mutex);
  const std::string mark =
      ".mien-" + std::to_string(::getpid()) + "-" + std::to_string(++all.count);
  std::string name = mark + "-" + place.filename().string();
  if (name.size() > longest_name) name = mark + place.extension().string();
  fs::path draft = place.parent_path() / name;
  all.paths.insert(draft);
  return draft;
}

void forget(const fs::path& draft) {
  Drafts& all = drafts();
  const std::lock_guard guard(all.mutex);
  all.paths.erase(draft);
}

/// Others that share the folder may have a process of that number, and left its draft.
fs::path new_draft(const fs::path& target, const fs::path& place, const struct stat* before) {
  for (;;) {
    fs::path draft = draft_beside(place);
    const OpenForWriting file(draft, O_CREAT | O_EXCL,
                              before != nullptr ? before->st_mode & 0777 : 0666);
    if (file.is_open()) {
      if (before != nullptr) (void)::fchmod(file.number(), before->st_mode & 07777);
      return draft;
    }
    const std::error_code why = last_error();
    forget(draft);
    if (why != std::errc::file_exists) throw cannot_be_written(target, why);
  }
}

/// False with errno set.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

/// A folder that cannot be flushed, as on some disks of the network, is none of the file's faults.
void flush_folder(const fs::path& folder) {
  const int number = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (number < 0) return;
  (void)::fsync(number);
  ::close(number);
}

void write_to(const fs::path& file, const fs::path& shown_as, int flags, std::string_view bytes) {
  OpenForWriting stream(file, flags);
  if (!stream.is_open() || !write_all(stream.number(), bytes) || !stream.close())
    throw cannot_be_written(shown_as, last_error());
}

}  // namespace

ResultFile::ResultFile(fs::path target)
    : target_(std::move(target)), place_(end_of_links(target_)), draft_(place_) {
  struct stat before {};
  const bool is_there = ::stat(place_.c_str(), &before) == 0;
  if (is_there && S_ISDIR(before.st_mode))
    throw cannot_be_written(target_, std::make_error_code(std::errc::is_a_directory));
  if (is_there && !S_ISREG(before.st_mode)) return;
  draft_ = new_draft(target_, place_, is_there ? &before : nullptr);
  is_own_ = true;
}

ResultFile::~ResultFile() {
  if (!is_own_) return;
  std::error_code ignored;
  fs::remove(draft_, ignored);
  forget(draft_);
}

std::string ResultFile::with_target_name(std::string message) const {
  const std::string draft = draft_.string();
  for (std::size_t at = message.find(draft); is_own_ && at != std::string::npos;
       at = message.find(draft, at + target_.string().size()))
    message.replace(at, draft.size(), target_.string());
  return message;
}

void ResultFile::publish() {
  if (!is_own_) return;
  OpenForWriting file(draft_, 0);
  if (!file.is_open() || ::fsync(file.number()) != 0 || !file.close())
    throw cannot_be_written(target_, last_error());
  if (::rename(draft_.c_str(), place_.c_str()) != 0) throw cannot_be_written(target_, last_error());
  is_own_ = false;
  forget(draft_);
  flush_folder(place_.parent_path());
}

void write_result(const fs::path& target, std::string_view bytes) {
  ResultFile result(target);
  write_to(result.draft(), target, O_TRUNC, bytes);
  result.publish();
}

void write_in_place(const fs::path& file, std::string_view bytes) {
  write_to(file, file, O_CREAT | O_TRUNC, bytes);
}

void remove_unfinished_results() noexcept {
  Drafts& all = drafts();
  const std::lock_guard guard(all.mutex);
  for (const fs::path& draft : all.paths) ::unlink(draft.c_str());
}

}  // namespace motion
}  // namespace mien
