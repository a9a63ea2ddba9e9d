#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/store.h"
#include "pipeline/tasks/store_state.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A line begins with a hash of the rest, so one that was cut off or damaged is no note.
std::string note_line(const FrameReceipt& frame, const Maker& maker) {
  const std::string rest = fmt::format("{} {} {} {} {}", frame.hash, frame.size,
                                       maker.instruction_set, frame.name, maker.host);
  return hash_of(rest) + " " + rest + "\n";
}

/// Fills what a line notes; false when it is no note.
bool parse_note(const std::string& line, FrameReceipt& frame, Maker& maker) {
  const std::size_t space = line.find(' ');
  if (space == std::string::npos) return false;
  const std::string rest = line.substr(space + 1);
  if (line.substr(0, space) != hash_of(rest)) return false;
  std::istringstream fields(rest);
  fields >> frame.hash >> frame.size >> maker.instruction_set >> frame.name >> maker.host;
  return !fields.fail();
}

/// Creates a hard link to a file, or a copy if the file system has none.
void link_or_copy(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_hard_link(from, to, error);
  if (!error) return;
  fs::copy_file(from, to);
  flush_to_disk(to);
}

}  // namespace

FrameStore::FrameStore(Store::State& store, std::string path, Hash key)
    : store_(&store), path_(std::move(path)), key_(std::move(key)) {
  folder_ = store_->internal() / "partial" / path_ / key_;
}

std::optional<fs::path> FrameStore::find(const std::string& name) {
  const fs::path drawn = folder_ / "frames" / name;
  const std::vector<Note> notes = notes_of(name);
  for (const Note& note : notes) {
    if (!agrees(drawn, note.frame.hash, note.frame.size)) continue;
    remember(name, {note.frame, drawn});
    return drawn;
  }
  std::error_code none;
  if (!notes.empty() && fs::exists(drawn, none)) note_damage(name);
  const std::optional<Note> published = published_note(name);
  const fs::path file = store_->folder / path_ / name;
  if (!published) return std::nullopt;
  if (!agrees(file, published->frame.hash, published->frame.size)) {
    note_damage(name);
    return std::nullopt;
  }
  remember(name, {published->frame, file});
  return file;
}

void FrameStore::note_damage(const std::string& name) {
  store_->note_repair(
      path_ + "/" + name +
      ": was damaged, changed or removed after it was rendered, and is rendered again");
}

/// Entry of a frame in the receipt of a published sequence with this key.
std::optional<FrameStore::Note> FrameStore::published_note(const std::string& name) const {
  const std::optional<Receipt> published = read_receipt(store_->folder, path_);
  if (!published || published->key != key_ || published->path != path_) return std::nullopt;
  const auto frame = std::ranges::find(published->frames, name, &FrameReceipt::name);
  if (frame == published->frames.end()) return std::nullopt;
  return Note{*frame, published->maker};
}

void FrameStore::discard(const std::string& name) {
  std::error_code ignored;
  fs::remove(folder_ / "frames" / name, ignored);
  const std::lock_guard guard(mutex_);
  found_.erase(name);
}

fs::path FrameStore::put(const std::string& name, const Store::Write& write,
                         const Store::Verify& verify) {
  const fs::path file = folder_ / "frames" / name;
  store_->in_attempt([&](const fs::path& attempt) {
    const fs::path drawn = attempt / name;
    write(drawn);
    flush_to_disk(drawn);
    verify(drawn);
    const FrameReceipt frame{name, hash_of_file(drawn), fs::file_size(drawn)};
    compare_with_earlier(frame);
    store_->clear_path_for(file.lexically_relative(store_->folder).generic_string(), false);
    fs::rename(drawn, file);
    add_note(frame);
    remember(name, {frame, file});
  });
  return file;
}

void FrameStore::compare_with_earlier(const FrameReceipt& frame) {
  std::vector<Note> earlier = notes_of(frame.name);
  if (auto published = published_note(frame.name)) earlier.push_back(*std::move(published));
  for (const Note& note : earlier) {
    store_->compare(path_ + "/" + frame.name, note.frame.hash, note.maker, frame.hash);
  }
}

Receipt FrameStore::publish(const std::vector<std::string>& names) {
  Receipt receipt = receipt_of(names);
  store_->in_attempt([&](const fs::path& attempt) {
    const fs::path sequence = attempt / "frames";
    fs::create_directories(sequence);
    try {
      link_frames(receipt.frames, sequence);
    } catch (const fs::filesystem_error&) {
      // Another process has published the sequence and cleared away what it was made of.
      auto published = find_artifact(store_->folder, path_, key_);
      if (!published) throw;
      receipt = *std::move(published);
      return;
    }
    flush_to_disk(sequence);
    receipt = store_->publish(sequence, receipt);
  });
  drop();
  return receipt;
}

void FrameStore::link_frames(const std::vector<FrameReceipt>& frames, const fs::path& into) {
  const std::lock_guard guard(mutex_);
  for (const FrameReceipt& frame : frames) {
    const fs::path linked = into / frame.name;
    link_or_copy(found_.at(frame.name).file, linked);
    // Others may have drawn it again since, and disks forget.
    if (!agrees(linked, frame.hash, frame.size))
      throw WriteFailure(path_ + "/" + frame.name + ": was changed before it was published");
  }
}

Receipt FrameStore::receipt_of(const std::vector<std::string>& names) const {
  Receipt receipt{key_, path_, "", 0, {}, store_->self()};
  for (const std::string& name : names) {
    receipt.frames.push_back(found_.at(name).frame);
    receipt.size += receipt.frames.back().size;
  }
  receipt.hash = hash_of(receipt.frames);
  return receipt;
}

void FrameStore::drop() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  drop_other_keys();
  fs::remove(folder_.parent_path(), ignored);
}

/// Removes frames of other keys, which are obsolete unless another process is drawing them.
void FrameStore::drop_other_keys() {
  std::error_code ignored;
  for (const fs::directory_entry& sequence :
       fs::directory_iterator(folder_.parent_path(), ignored)) {
    bool is_in_use = false;
    for (const fs::directory_entry& note :
         fs::directory_iterator(sequence.path() / "notes", ignored)) {
      const auto worker = read_worker_record(store_->folder, note.path().filename());
      is_in_use = is_in_use || (worker && worker->name != store_->worker() && !is_gone(*worker));
    }
    if (!is_in_use) fs::remove_all(sequence.path(), ignored);
  }
}

std::vector<FrameStore::Note> FrameStore::notes_of(const std::string& name) {
  const std::lock_guard guard(mutex_);
  read_new_notes();
  std::vector<Note> notes;
  const auto [first, last] = notes_.equal_range(name);
  for (auto note = first; note != last; ++note) notes.push_back(note->second);
  return notes;
}

/// Reads new lines of the note files; each process appends to its own.
void FrameStore::read_new_notes() {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "notes", none)) {
    const std::uintmax_t size = fs::file_size(entry.path(), none);
    if (none) continue;
    std::uintmax_t& before = read_[entry.path().filename()];
    if (size == before) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(before));
    std::string line;
    while (std::getline(stream, line) && !stream.eof()) {
      before += line.size() + 1;
      Note note;
      if (parse_note(line, note.frame, note.maker)) notes_.emplace(note.frame.name, note);
    }
  }
}

/// Opened and closed for each note, so that other machines see it.
void FrameStore::add_note(const FrameReceipt& frame) {
  const fs::path notes = folder_ / "notes" / store_->worker();
  store_->clear_path_for(notes.lexically_relative(store_->folder).generic_string(), false);
  const std::lock_guard guard(mutex_);
  std::ofstream stream(notes, std::ios::app | std::ios::binary);
  stream << note_line(frame, store_->self()) << std::flush;
  if (!stream) throw std::system_error(errno, std::generic_category(), notes.string());
}

void FrameStore::remember(const std::string& name, Found found) {
  const std::lock_guard guard(mutex_);
  found_[name] = std::move(found);
}

}  // namespace mien::pipeline
