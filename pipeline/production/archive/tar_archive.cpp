#include "pipeline/production/archive/tar_archive.h"

#include <stdexcept>
#include <system_error>
#include <utility>

#include <archive.h>
#include <archive_entry.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/archive/utf8_names.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct FreeEntry {
  void operator()(archive_entry* one) const { archive_entry_free(one); }
};

constexpr char zstd_level[] = "9";

}  // namespace

struct TarArchive::Writer {
  struct Free {
    void operator()(archive* one) const { archive_write_free(one); }
  };

  motion::ResultFile file;
  std::unique_ptr<archive, Free> out{archive_write_new()};
  std::uint64_t left = 0;  ///< bytes of the file that was begun

  explicit Writer(fs::path target) : file(std::move(target)) {}

  void require(int code, const std::string& doing) {
    if (code >= ARCHIVE_OK) return;
    const char* words = archive_error_string(out.get());
    const int reason = archive_errno(out.get());
    if (reason > 0) throw cannot_be_written(file.target(), {reason, std::generic_category()});
    throw std::runtime_error(file.target().string() + ": " + doing + ": " +
                             (words != nullptr ? words : "the archive cannot be written"));
  }

  void compress(Compression compression) {
    if (compression == Compression::gzip) {
      require(archive_write_add_filter_gzip(out.get()), "gzip");
      require(archive_write_set_filter_option(out.get(), "gzip", "timestamp", nullptr), "gzip");
    }
    if (compression == Compression::zstd) {
      require(archive_write_add_filter_zstd(out.get()), "zstd");
      require(archive_write_set_filter_option(out.get(), "zstd", "compression-level", zstd_level),
              "zstd");
    }
  }

  void open(Compression compression) {
    require(archive_write_set_format_pax_restricted(out.get()), "tar");
    compress(compression);
    require(archive_write_open_filename(out.get(), file.draft().c_str()), "opening");
  }
};

Compression compression_of(const fs::path& archive) {
  const std::string name = archive.filename().string();
  if (name.ends_with(".tar.zst")) return Compression::zstd;
  if (name.ends_with(".tar.gz") || name.ends_with(".tgz")) return Compression::gzip;
  if (name.ends_with(".tar")) return Compression::none;
  throw Error({archive.string()}, "this archive format is not supported",
              "use the extension .tar.zst, .tar.gz or .tar");
}

TarArchive::TarArchive(fs::path file, Compression compression)
    : writer_(std::make_unique<Writer>(std::move(file))) {
  writer_->open(compression);
}

TarArchive::~TarArchive() = default;

void TarArchive::begin(const std::string& path, std::uint64_t size) {
  const Utf8Names names;
  const std::unique_ptr<archive_entry, FreeEntry> entry(archive_entry_new());
  archive_entry_set_pathname(entry.get(), path.c_str());
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(size));
  archive_entry_set_mtime(entry.get(), 0, 0);
  writer_->require(archive_write_header(writer_->out.get(), entry.get()), path);
  writer_->left = size;
}

void TarArchive::add(std::string_view bytes) {
  if (bytes.size() > writer_->left) throw std::runtime_error("a file grew while it was packed");
  writer_->left -= bytes.size();
  while (!bytes.empty()) {
    const la_ssize_t count = archive_write_data(writer_->out.get(), bytes.data(), bytes.size());
    if (count <= 0) writer_->require(ARCHIVE_FATAL, "writing");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void TarArchive::finish() {
  writer_->require(archive_write_close(writer_->out.get()), "closing");
  writer_->file.publish();
}

std::string archive_library() {
  const int number = archive_version_number();
  return std::to_string(number / 1000000) + "." + std::to_string(number / 1000 % 1000) + "." +
         std::to_string(number % 1000);
}

}  // namespace mien::pipeline
