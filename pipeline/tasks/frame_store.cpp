#include <fstream>
#include <set>
#include <sstream>
#include <utility>

#include "pipeline/documents/files.h"
#include "pipeline/tasks/store.h"
#include "pipeline/tasks/store_state.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

std::string journal_line(const FrameReceipt& frame) {
  return frame.hash + " " + std::to_string(frame.size) + " " + frame.name + "\n";
}

}  // namespace

FrameStore::FrameStore(Store::State& store, std::string path, Hash key)
    : store_(&store), path_(std::move(path)), key_(std::move(key)) {
  folder_ = store_->internal() / "partial" / path_;
  journal_ = folder_;
  journal_ += ".journal";
  take_back_unreceipted();
  read_journal();
  if (fs::is_empty(folder_)) adopt_published();
}

/// A kill after the frames were published but before their receipt was: they are ours again.
void FrameStore::take_back_unreceipted() {
  const fs::path target = store_->folder / path_;
  if (!fs::exists(journal_) || fs::exists(folder_) || !fs::is_directory(target)) return;
  fs::rename(target, folder_);
}

/// A journal whose last line was cut off by a crash is read up to there, and then written whole.
void FrameStore::read_journal() {
  std::ifstream stream(journal_);
  std::string line;
  if (!std::getline(stream, line) || line != key_) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write_file(journal_, key_ + "\n");
    return;
  }
  fs::create_directories(folder_);
  while (std::getline(stream, line)) {
    FrameReceipt frame;
    std::istringstream fields(line);
    if (fields >> frame.hash >> frame.size >> frame.name) noted_[frame.name] = frame;
  }
  write_journal();
}

void FrameStore::write_journal() const {
  std::string journal = key_ + "\n";
  for (const auto& [name, frame] : noted_) journal += journal_line(frame);
  write_file(journal_, journal);
}

/// Takes over a published sequence of the same key, of which some frames no longer agree.
void FrameStore::adopt_published() {
  const std::optional<Receipt> receipt = read_receipt(store_->folder, path_);
  if (!receipt || receipt->key != key_ || !fs::is_directory(store_->folder / path_)) return;
  for (const FrameReceipt& frame : receipt->frames) noted_[frame.name] = frame;
  write_journal();
  fs::remove_all(folder_);
  fs::rename(store_->folder / path_, folder_);
}

std::optional<fs::path> FrameStore::find(const std::string& name) const {
  const std::optional<FrameReceipt> frame = noted(name);
  fs::path file = folder_ / name;
  if (!frame || !agrees(file, frame->hash, frame->size)) return std::nullopt;
  return file;
}

std::optional<FrameReceipt> FrameStore::noted(const std::string& name) const {
  const std::lock_guard guard(mutex_);
  const auto found = noted_.find(name);
  if (found == noted_.end()) return std::nullopt;
  return found->second;
}

void FrameStore::discard(const std::string& name) { fs::remove(folder_ / name); }

fs::path FrameStore::put(const std::string& name, const Store::Write& write,
                         const Store::Verify& verify) {
  const fs::path attempt = store_->new_attempt();
  write(attempt / name);
  verify(attempt / name);
  const FrameReceipt frame{name, hash_of_file(attempt / name), fs::file_size(attempt / name)};
  if (const auto before = noted(name)) {
    store_->compare(path_ + "/" + name, before->hash, frame.hash);
  }
  fs::rename(attempt / name, folder_ / name);
  fs::remove(attempt);
  const std::lock_guard guard(mutex_);
  std::ofstream(journal_, std::ios::app) << journal_line(frame);
  noted_[name] = frame;
  return folder_ / name;
}

Receipt FrameStore::publish(const std::vector<std::string>& names) {
  Receipt receipt{key_, path_, "", 0, {}};
  for (const std::string& name : names) {
    receipt.frames.push_back(noted_.at(name));
    receipt.size += receipt.frames.back().size;
  }
  receipt.hash = hash_of(receipt.frames);
  const std::set<std::string> wanted(names.begin(), names.end());
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    if (!wanted.contains(entry.path().filename())) fs::remove_all(entry.path());
  }
  flush_file_system(folder_);

  const fs::path target = store_->folder / path_;
  fs::create_directories(target.parent_path());
  fs::remove_all(target);
  fs::rename(folder_, target);
  flush_to_disk(target.parent_path());
  store_->write_receipt(receipt);
  fs::remove(journal_);
  return receipt;
}

}  // namespace mien::pipeline
