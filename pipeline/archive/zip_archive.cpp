#include "pipeline/archive/zip_archive.h"

#include <memory>
#include <stdexcept>

#include <archive.h>
#include <archive_entry.h>

#include "motion/error.h"
#include "motion/text/file_contents.h"
#include "pipeline/archive/utf8_names.h"

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
  throw Error({name}, words != nullptr ? words : "this is no zip archive", "give a whole one");
}

bool leads_out(const std::string& path) {
  const std::filesystem::path given(path);
  if (path.empty() || given.is_absolute()) return true;
  for (const auto& part : given) {
    if (part == "..") return true;
  }
  return false;
}

std::string content_of(archive* zip, const std::string& name, std::size_t& total) {
  std::string content;
  char part[65536];
  for (;;) {
    const la_ssize_t count = archive_read_data(zip, part, sizeof part);
    if (count < 0) refuse_zip(name, zip);
    if (count == 0) return content;
    total += static_cast<std::size_t>(count);
    if (total > most_zip_bytes)
      throw Error({name}, "unpacks to more than 4 GiB", "give the archive that mien wrote");
    content.append(part, static_cast<std::size_t>(count));
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
  const ZipHandle zip(archive_read_new());
  archive_read_support_format_zip(zip.get());
  archive_read_set_options(zip.get(), "zip:hdrcharset=UTF-8");
  if (archive_read_open_memory(zip.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    refuse_zip(name, zip.get());
  ZipFiles files;
  std::size_t total = 0;
  for (archive_entry* entry = nullptr;;) {
    const int code = archive_read_next_header(zip.get(), &entry);
    if (code == ARCHIVE_EOF) return files;
    if (code != ARCHIVE_OK && code != ARCHIVE_WARN) refuse_zip(name, zip.get());
    const char* given = archive_entry_pathname(entry);
    const std::string path = given != nullptr ? given : "";
    if (leads_out(path))
      throw Error({name}, "a path in it leads out of it", "give the archive that mien wrote");
    if (archive_entry_filetype(entry) != AE_IFREG) continue;
    files[path] = content_of(zip.get(), name, total);
  }
}

ZipFiles read_zip(const std::filesystem::path& file) {
  const motion::FileReading read = motion::bytes_of_file(file, most_zip_bytes);
  if (!read.bytes) throw Error({file.string()}, read.hindrance, "name a zip archive");
  return unzipped(*read.bytes, file.string());
}

}  // namespace mien::pipeline
