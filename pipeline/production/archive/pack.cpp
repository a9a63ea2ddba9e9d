#include "pipeline/production/archive/pack.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/production/archive/tar_archive.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/receipt.h"
#include "pipeline/tasks/stale_artifacts.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A value of bag-info.txt is one line.
std::string as_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

std::string element(const char* label, const std::string& value) {
  return value.empty() ? "" : fmt::format("{}: {}\n", label, as_line(value));
}

/// A recording as it is packed.
PayloadFile packed_recording(const RecordingRecord& recording, const RecordingPacking& packing) {
  const auto file = packing.files.find(recording.path);
  if (file == packing.files.end())
    throw Error({recording.path}, "is not where the study was made from",
                "restore it, or omit --recordings");
  if (const std::string problem = motion::read_error(file->second, motion::any_size);
      !problem.empty())
    throw Error({file->second.string()}, problem, "restore it, or omit --recordings");
  if (hash_of_file(file->second) != recording.hash)
    throw Error({file->second.string()}, "has changed since the study was made",
                "restore it, or run the study again");
  return {std::string(packed_recordings_folder) + "/" + recording.path,
          fs::file_size(file->second),
          {},
          file->second};
}

std::vector<Receipt> stale_receipts(const StudyContents& contents) {
  std::vector<std::string> kept = {"provenance.json", contents.as_run};
  for (const ArtifactRecord& record : contents.artifacts) kept.push_back(record.path);
  for (const ArtifactRecord& record : contents.inputs) kept.push_back(record.path);
  return stale_artifacts(contents.folder, {}, kept);
}

/// Collects files, those behind links too.
class Payload {
 public:
  explicit Payload(const StudyContents& contents) : folder_(contents.folder) {
    for (const Receipt& receipt : stale_receipts(contents)) {
      stale_.insert(receipt.path);
      for (const FrameReceipt& frame : receipt.frames)
        stale_.insert(receipt.path + "/" + frame.name);
    }
  }

  void add(const std::string& path) {
    const fs::path file = folder_ / path;
    if (const std::string problem = motion::read_error(file, motion::any_size); !problem.empty())
      throw Error({file.string()}, problem, "remove it: archives contain regular files only");
    sizes_[path] = fs::file_size(file);
  }

  /// All in a folder of the study; `path` is empty for its own.
  void add_below(const std::string& path) {
    for (auto entry = fs::recursive_directory_iterator(folder_ / path);
         entry != fs::recursive_directory_iterator(); ++entry) {
      const std::string found = entry->path().lexically_relative(folder_).generic_string();
      std::error_code unknown;
      const bool is_folder = entry->is_directory(unknown) && !entry->is_symlink(unknown);
      if (is_bookkeeping(found)) {
        if (is_folder) entry.disable_recursion_pending();
      } else if (!is_folder && !followed_.contains(found) && !stale_.contains(found)) {
        add(found);
      }
    }
  }

  /// A sequence of frames may lie elsewhere, behind a link.
  void add_frames(const std::string& path) {
    std::error_code unknown;
    if (!fs::is_symlink(folder_ / path, unknown) || !fs::is_directory(folder_ / path, unknown))
      return;
    followed_.insert(path);
    add_below(path + "/");
  }

  std::vector<PayloadFile> take() const {
    std::vector<PayloadFile> files;
    for (const auto& [path, size] : sizes_) files.push_back({path, size});
    return files;
  }

 private:
  const fs::path& folder_;
  std::map<std::string, std::uint64_t> sizes_;
  std::set<std::string> followed_;
  std::set<std::string> stale_;
};

/// Writes the parts of a bag in the order of their names.
class BagWriter {
 public:
  BagWriter(const StudyContents& contents, TarArchive& tar)
      : root_(contents.study + "/"), folder_(contents.folder), tar_(tar) {}

  /// A file beside data/.
  void add_tag_file(const std::string& name, const std::string& text) {
    put(name, text);
    tag_manifest_ += bag_manifest_line(sha256_of(text), name);
  }

  void add_payload(const PayloadFile& file) {
    const std::string path = "data/" + file.path;
    tar_.begin(root_ + path, file.size);
    if (!file.text.empty()) {
      tar_.add(file.text);
      manifest_ += bag_manifest_line(sha256_of(file.text), path);
      return;
    }
    const fs::path source = file.from.empty() ? folder_ / file.path : file.from;
    std::ifstream stream(source, std::ios::binary);
    Sha256 sha;
    std::string piece(1 << 20, '\0');
    std::uint64_t read = 0;
    while (stream) {
      stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
      const std::string_view bytes(piece.data(), static_cast<std::size_t>(stream.gcount()));
      tar_.add(bytes);
      sha.add(bytes);
      read += bytes.size();
    }
    if (stream.bad() || read != file.size)
      throw std::runtime_error(source.string() + ": changed while it was packed");
    manifest_ += bag_manifest_line(sha.finish(), path);
  }

  void finish() {
    add_tag_file("manifest-sha256.txt", manifest_);
    put("tagmanifest-sha256.txt", tag_manifest_);
    tar_.finish();
  }

 private:
  void put(const std::string& name, const std::string& text) {
    tar_.begin(root_ + name, text.size());
    tar_.add(text);
  }

  std::string root_;
  const fs::path& folder_;
  TarArchive& tar_;
  std::string manifest_;
  std::string tag_manifest_;
};

}  // namespace

std::vector<std::string> stale_in_study(const StudyContents& contents) {
  std::vector<std::string> paths = shown_paths(stale_receipts(contents));
  std::erase_if(paths, [&](const std::string& path) {
    std::error_code unknown;
    return !fs::exists(fs::symlink_status(contents.folder / path, unknown));
  });
  return paths;
}

std::vector<std::string> encoded_paths(const std::vector<PayloadFile>& payload) {
  std::vector<std::string> paths;
  for (const PayloadFile& file : payload)
    if (file.path.find_first_of("%\r\n") != std::string::npos) paths.push_back(file.path);
  return paths;
}

std::vector<PayloadFile> payload_of(const StudyContents& contents) {
  Payload payload(contents);
  for (const ArtifactRecord& record : contents.artifacts) {
    if (record.frames > 0) payload.add_frames(record.path);
  }
  payload.add_below("");
  std::vector<PayloadFile> files = payload.take();
  std::erase_if(files,
                [&](const PayloadFile& file) { return is_only_in_archive(contents, file.path); });
  return files;
}

PackedStudy packed_study(const StudyContents& contents, const RecordingPacking& packing) {
  PackedStudy packed;
  packed.stale = stale_in_study(contents);
  for (const PayloadFile& file : payload_of(contents)) {
    const ArtifactRecord* artifact = contents.find(file.path);
    const bool is_restricted = artifact != nullptr && !artifact->restricting.empty();
    if (!is_restricted || packing.restricted) packed.payload.push_back(file);
  }
  for (const ArtifactRecord& artifact : contents.artifacts) {
    const bool is_packed =
        std::ranges::binary_search(packed.payload, artifact.path, {}, &PayloadFile::path);
    if (!artifact.restricting.empty() && !is_packed)
      packed.recordings.left_out_files.push_back(artifact.path);
  }
  for (const RecordingRecord& recording : contents.recordings) {
    if (!recording.share && !packing.restricted) {
      packed.recordings.left_out.push_back(recording.path);
    } else if (packing.recordings) {
      packed.payload.push_back(packed_recording(recording, packing));
      packed.recordings.packed.push_back(recording.path);
    }
  }
  if (packed.recordings.empty()) return packed;
  if (packing.recordings) packed.recordings.folders = packing.folders;
  const std::string list = to_json(packed.recordings);
  packed.payload.push_back({packed_recordings_path, list.size(), {}, {}, list});
  std::ranges::sort(packed.payload, {}, &PayloadFile::path);
  return packed;
}

void refuse_archive(const StudyContents& contents, const fs::path& archive) {
  (void)compression_of(archive);
  std::error_code unknown;
  const fs::path place = fs::weakly_canonical(fs::absolute(archive), unknown);
  const fs::path below = place.lexically_relative(fs::weakly_canonical(contents.folder, unknown));
  if (!below.empty() && *below.begin() != "..") {
    throw Error({archive.string()}, "is inside the folder of the study, which it would contain",
                "save it elsewhere");
  }
  if (fs::is_directory(archive, unknown))
    throw Error({archive.string()}, "is a folder", "name a file");
}

void pack(const StudyContents& contents, const std::vector<PayloadFile>& payload,
          const BagInfo& info, const fs::path& archive, const std::stop_token& stop,
          const ShareDone& done) {
  refuse_archive(contents, archive);
  TarArchive tar(archive, compression_of(archive));
  BagWriter bag(contents, tar);
  bag.add_tag_file("bag-info.txt", bag_info_text(contents, payload, info));
  bag.add_tag_file("bagit.txt", bagit_text());
  std::uint64_t total = 1;
  for (const PayloadFile& file : payload) total += file.size;
  std::uint64_t packed = 0;
  for (const PayloadFile& file : payload) {
    if (stop.stop_requested()) throw Interrupted{};
    bag.add_payload(file);
    packed += file.size;
    if (done) done(static_cast<double>(packed) / static_cast<double>(total), file.path);
  }
  bag.finish();
}

std::string bagit_text() {
  return "BagIt-Version: 1.0\n"
         "Tag-File-Character-Encoding: UTF-8\n";
}

std::string bag_info_text(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                          const BagInfo& info) {
  std::uint64_t bytes = 0;
  for (const PayloadFile& file : payload) bytes += file.size;
  const std::string made_by = "Human motion stimuli, made by: " + contents.command;
  return element("Bag-Software-Agent", "mien " + contents.program) +
         element("Contact-Email", info.contact_email) + element("Contact-Name", info.contact_name) +
         element("External-Description", info.description.empty() ? made_by : info.description) +
         element("External-Identifier", contents.study) + element("Left-Out", info.left_out) +
         element("License", info.license) +
         element("Payload-Oxum", fmt::format("{}.{}", bytes, payload.size())) +
         element("Source-Organization", info.organization);
}

std::string bag_manifest_line(const std::string& sha256, const std::string& path) {
  std::string line = sha256 + "  ";
  for (const char c : path) {
    if (c == '\n') {
      line += "%0A";
    } else if (c == '\r') {
      line += "%0D";
    } else if (c == '%') {
      line += "%25";
    } else {
      line += c;
    }
  }
  return line + "\n";
}

}  // namespace mien::pipeline
