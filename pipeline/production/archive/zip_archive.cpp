#include "pipeline/production/archive/zip_archive.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include <archive.h>
#include <archive_entry.h>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/safe_name.h"
#include "pipeline/production/archive/utf8_names.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_zip_bytes = std::size_t{4} << 30U;

struct ZipFreeing {
  void operator()(archive* one) const { archive_free(one); }
  void operator()(archive_entry* one) const { archive_entry_free(one); }
};
using ZipHandle = std::unique_ptr<archive, ZipFreeing>;
using ZipEntry = std::unique_ptr<archive_entry, ZipFreeing>;

void require_written(archive* zip, la_ssize_t code) {
  if (code >= ARCHIVE_OK) return;
  const char* words = archive_error_string(zip);
  throw std::runtime_error(words != nullptr ? words : "the zip archive cannot be written");
}

la_ssize_t append_bytes(archive*, void* text, const void* bytes, std::size_t count) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), count);
  return static_cast<la_ssize_t>(count);
}

void write_entry(archive* zip, const std::string& path, const std::string& bytes) {
  const ZipEntry entry(archive_entry_new());
  archive_entry_set_pathname(entry.get(), path.c_str());
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
  archive_entry_set_mtime(entry.get(), 0, 0);
  require_written(zip, archive_write_header(zip, entry.get()));
  if (!bytes.empty()) require_written(zip, archive_write_data(zip, bytes.data(), bytes.size()));
}

[[noreturn]] void refuse_zip(const std::string& name, archive* zip) {
  const char* words = archive_error_string(zip);
  throw Error({name}, words != nullptr ? words : "this is not a zip archive",
              "give a complete one");
}

/// What is stored in an archive of that size, and room for one that somebody has compressed. mien
/// compresses none.
std::uint64_t most_unpacked(std::size_t archive_bytes) {
  constexpr std::uint64_t least = std::uint64_t{256} << 20U;
  constexpr std::uint64_t times = 20;
  return std::clamp<std::uint64_t>(times * archive_bytes, least, most_zip_bytes);
}

[[noreturn]] void refuse_size(const std::string& name, std::uint64_t most) {
  throw Error({name}, "unpacks to more than " + std::to_string(most >> 20U) + " MiB",
              "give an archive written by mien");
}

/// The files of an archive, one after the other.
class ZipReader {
 public:
  ZipReader(const std::string& bytes, const std::string& name) : name_(name) {
    // By its directory alone: without one, passing over a file takes unpacking it.
    archive_read_support_format_zip_seekable(zip_.get());
    archive_read_set_options(zip_.get(), "zip:hdrcharset=UTF-8");
    if (archive_read_open_memory(zip_.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
      refuse_zip(name_, zip_.get());
  }

  /// Null after the last.
  archive_entry* next() {
    archive_entry* entry = nullptr;
    const int code = archive_read_next_header(zip_.get(), &entry);
    if (code == ARCHIVE_EOF) return nullptr;
    if (code != ARCHIVE_OK && code != ARCHIVE_WARN) refuse_zip(name_, zip_.get());
    return entry;
  }

  /// Of the file that came last. `left`: bytes that all files may still have.
  std::string content(std::uint64_t& left, std::uint64_t most) {
    std::string content;
    char part[65536];
    for (;;) {
      const la_ssize_t count = archive_read_data(zip_.get(), part, sizeof part);
      if (count < 0) refuse_zip(name_, zip_.get());
      if (count == 0) return content;
      if (static_cast<std::uint64_t>(count) > left) refuse_size(name_, most);
      left -= static_cast<std::uint64_t>(count);
      content.append(part, static_cast<std::size_t>(count));
    }
  }

 private:
  const std::string& name_;
  ZipHandle zip_{archive_read_new()};
};

/// Throws where the sizes that the archive states exceed `most` bytes, before anything is unpacked.
void refuse_stated_size(const std::string& bytes, const std::string& name, std::uint64_t most) {
  ZipReader reader(bytes, name);
  std::uint64_t left = most;
  while (archive_entry* const entry = reader.next()) {
    const la_int64_t stated_size =
        archive_entry_size_is_set(entry) != 0 ? archive_entry_size(entry) : 0;
    if (stated_size < 0 || static_cast<std::uint64_t>(stated_size) > left) refuse_size(name, most);
    left -= static_cast<std::uint64_t>(stated_size);
  }
}

}  // namespace

std::string zip_of(const ZipFiles& files) {
  const Utf8Names names;
  std::string text;
  const ZipHandle zip(archive_write_new());
  require_written(zip.get(), archive_write_set_format_zip(zip.get()));
  // The same bytes whatever zlib there is.
  require_written(zip.get(), archive_write_set_options(
                                 zip.get(), "zip:compression=store,zip:hdrcharset=UTF-8"));
  archive_write_set_bytes_in_last_block(zip.get(), 1);
  require_written(zip.get(), archive_write_open(zip.get(), &text, nullptr, append_bytes, nullptr));
  for (const auto& [path, bytes] : files) write_entry(zip.get(), path, bytes);
  require_written(zip.get(), archive_write_close(zip.get()));
  return text;
}

ZipFiles unzipped(const std::string& bytes, const std::string& name) {
  const Utf8Names names;
  const std::uint64_t most = most_unpacked(bytes.size());
  refuse_stated_size(bytes, name, most);
  ZipReader reader(bytes, name);
  ZipFiles files;
  std::uint64_t left = most;
  while (archive_entry* const entry = reader.next()) {
    const char* given = archive_entry_pathname(entry);
    std::string path = given != nullptr ? given : "";
    const bool is_file = archive_entry_filetype(entry) == AE_IFREG;
    if (!is_file && path.ends_with('/')) path.pop_back();
    if (const std::string fault = motion::fault_of_names(path); !fault.empty())
      throw Error({name}, "the path " + motion::in_quotes(path) + " in it " + fault,
                  "give an archive written by mien");
    if (!is_file) continue;
    files[path] = reader.content(left, most);
  }
  return files;
}

ZipFiles read_zip(const std::filesystem::path& file) {
  const motion::FileReading read = motion::bytes_of_file(file, most_zip_bytes);
  if (!read.bytes) throw Error({file.string()}, read.error, "name a zip archive");
  return unzipped(*read.bytes, file.string());
}

}  // namespace mien::pipeline
