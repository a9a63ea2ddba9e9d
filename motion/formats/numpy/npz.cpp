#include "motion/formats/numpy/npz.h"

#include <algorithm>
#include <memory>
#include <set>

#include <archive.h>
#include <archive_entry.h>
#include <unistd.h>

#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_kind.h"
#include "motion/text/open_file.h"

namespace mien::motion {

namespace {

/// The header of an array is expected within so many bytes.
constexpr std::size_t most_header_bytes = (std::size_t{1} << 16U) + 12;
/// Memory is reserved for so many times the archive's own size; beyond that it grows with what is
/// really there.
constexpr std::uintmax_t usual_expansion = 8;

struct ArchiveFreeing {
  void operator()(archive* one) const { archive_free(one); }
};

/// An archive in memory or, without `bytes`, in an open file.
struct Source {
  const std::string& name;
  std::string_view bytes;
  const OpenFile* file = nullptr;

  std::uintmax_t size() const { return file ? file->size() : bytes.size(); }
};

/// Reads the members of a zip archive one after the other, by its directory.
struct NpzReader {
  Source source;
  std::uintmax_t most;  ///< bytes that may be unpacked
  std::uintmax_t left;
  std::string_view unpacked = {};  ///< of the member, not taken yet
  std::unique_ptr<archive, ArchiveFreeing> zip{archive_read_new()};
};

[[noreturn]] void refuse(const NpzReader& reader, const std::string& name) {
  const char* const words = archive_error_string(reader.zip.get());
  const std::string subject = name.empty() ? "is not a readable zip archive"
                                           : "the array " + in_quotes(name) + " cannot be unpacked";
  throw Error({reader.source.name}, subject + (words ? " (" + excerpt(words) + ")" : ""),
              "obtain the file again");
}

[[noreturn]] void refuse_size(const NpzReader& reader) {
  throw Error({reader.source.name},
              "its arrays unpack to more than the " + std::to_string(reader.most >> 20U) +
                  " MiB that can be read",
              "save the arrays of a shorter recording, without compression (numpy.savez)");
}

void open(NpzReader& reader) {
  archive_read_support_format_zip_seekable(reader.zip.get());
  archive_read_set_options(reader.zip.get(), "zip:hdrcharset=UTF-8");
  // Small enough to stay in the processor's cache until it is copied.
  constexpr std::size_t block = std::size_t{1} << 16U;
  const Source& source = reader.source;
  if (source.file) lseek(source.file->number(), 0, SEEK_SET);
  const int code =
      source.file
          ? archive_read_open_fd(reader.zip.get(), source.file->number(), block)
          : archive_read_open_memory(reader.zip.get(), source.bytes.data(), source.bytes.size());
  if (code != ARCHIVE_OK) refuse(reader, "");
}

/// Null after the last.
archive_entry* next_member(NpzReader& reader) {
  reader.unpacked = {};
  archive_entry* entry = nullptr;
  const int code = archive_read_next_header(reader.zip.get(), &entry);
  if (code == ARCHIVE_EOF) return nullptr;
  if (code != ARCHIVE_OK && code != ARCHIVE_WARN) refuse(reader, "");
  return entry;
}

/// Name of the member's array; empty if the member is no array.
std::string array_name(archive_entry* entry) {
  const char* const path = archive_entry_pathname_utf8(entry);
  std::string_view name = path ? path : "";
  if (!name.ends_with(".npy")) return "";
  name.remove_suffix(4);
  return std::string(name);
}

std::uintmax_t stated_size(archive_entry* entry) {
  const la_int64_t size = archive_entry_size_is_set(entry) != 0 ? archive_entry_size(entry) : 0;
  return size < 0 ? any_size : static_cast<std::uintmax_t>(size);
}

/// The member's next bytes; empty after the last.
std::string_view next_part(NpzReader& reader, const std::string& name) {
  while (reader.unpacked.empty()) {
    const void* part = nullptr;
    std::size_t count = 0;
    la_int64_t offset = 0;
    const int code = archive_read_data_block(reader.zip.get(), &part, &count, &offset);
    if (code == ARCHIVE_EOF) return {};
    if (code != ARCHIVE_OK) refuse(reader, name);
    reader.unpacked = {static_cast<const char*>(part), count};
  }
  return reader.unpacked;
}

/// Adds bytes of the member to `content`, until it has `enough` or there are no more.
void unpack(NpzReader& reader, const std::string& name, std::uintmax_t enough,
            std::string& content) {
  while (content.size() < enough) {
    const std::string_view part = next_part(reader, name).substr(0, enough - content.size());
    if (part.empty()) return;
    if (part.size() > reader.left) refuse_size(reader);
    reader.left -= part.size();
    reader.unpacked.remove_prefix(part.size());
    content.append(part);
  }
}

bool is_wanted(const WantedArrays& wanted, std::string_view name) {
  return !wanted || std::find(wanted->begin(), wanted->end(), name) != wanted->end();
}

bool is_read(char kind) { return std::string_view("biufUS").find(kind) != std::string_view::npos; }

/// The array of a member; only type and shape if it is not wanted or of a kind that is not read.
NpyArray array_in(NpzReader& reader, archive_entry* entry, const std::string& name,
                  const WantedArrays& wanted) {
  const std::string& file = reader.source.name;
  const std::uintmax_t left = reader.left;
  std::string content;
  unpack(reader, name, most_header_bytes, content);
  NpyHeader header = parse_npy_header(content, file, name);
  if (!is_wanted(wanted, name) || !is_read(header.type.kind)) {
    reader.left = left;
    return {name, header.type, std::move(header.shape), header.is_fortran_order, false, {}};
  }
  content.erase(0, header.start);
  const std::uintmax_t usual = usual_expansion * reader.source.size();
  content.reserve(static_cast<std::size_t>(std::min({stated_size(entry), usual, reader.most})));
  unpack(reader, name, any_size, content);
  return npy_member(std::move(header), std::move(content), file, name);
}

/// Throws where the sizes that the archive states exceed the limit, before anything is unpacked.
void refuse_stated_size(const Source& source, const WantedArrays& wanted, std::uintmax_t most) {
  const std::string& file = source.name;
  NpzReader reader{source, most, most};
  open(reader);
  std::size_t members = 0;
  std::set<std::string> names;
  while (archive_entry* const entry = next_member(reader)) {
    if (++members > most_npz_members)
      throw Error({file}, "has more than " + std::to_string(most_npz_members) + " files in it",
                  "save only the arrays of one motion");
    const std::string name = array_name(entry);
    if (name.empty()) continue;
    if (archive_entry_is_encrypted(entry) != 0)
      throw Error({file}, "the array " + in_quotes(name) + " is encrypted",
                  "save the file without a password");
    if (!names.insert(name).second)
      throw Error({file}, "two arrays are named " + in_quotes(name), "save the file again");
    if (!is_wanted(wanted, name)) continue;
    if (stated_size(entry) > reader.left) refuse_size(reader);
    reader.left -= stated_size(entry);
  }
  if (names.empty())
    throw Error({file}, "is a zip archive without NumPy arrays (.npy)",
                "name a file that was saved by numpy.savez");
}

Npz arrays_of(const Source& source, const WantedArrays& wanted, std::uintmax_t most_bytes) {
  const std::uintmax_t most = largest_inflated(source.size(), most_bytes);
  refuse_stated_size(source, wanted, most);
  NpzReader reader{source, most, most};
  open(reader);
  Npz npz{source.name, {}};
  while (archive_entry* const entry = next_member(reader)) {
    const std::string name = array_name(entry);
    if (!name.empty()) npz.arrays.push_back(array_in(reader, entry, name, wanted));
  }
  return npz;
}

}  // namespace

Npz parse_npz(std::string_view bytes, const std::string& file_name, const WantedArrays& wanted,
              std::uintmax_t most_bytes) {
  if (bytes.starts_with("\x93NUMPY"))
    throw Error({file_name}, "is a single NumPy array", "rename it to .npy");
  return arrays_of({file_name, bytes}, wanted, most_bytes);
}

Npz read_npz(const std::filesystem::path& path, const WantedArrays& wanted) {
  const std::string name = path.string();
  if (without_compression(path) != path) {
    const std::string bytes = read_contents(path);
    require_kind(bytes, name, "npz");
    return parse_npz(bytes, name, wanted);
  }
  const OpenFile file(path, max_recording_bytes);
  if (!file.error().empty()) throw Error({name}, file.error(), "give the path of a motion file");
  require_kind(file.beginning(most_header_bytes), name, "npz");
  return arrays_of({name, {}, &file}, wanted, max_recording_bytes);
}

const NpyArray* find_array(const Npz& npz, std::string_view name) {
  const auto found = std::find_if(npz.arrays.begin(), npz.arrays.end(),
                                  [&](const NpyArray& array) { return array.name == name; });
  return found == npz.arrays.end() ? nullptr : &*found;
}

std::vector<std::string> object_arrays(const Npz& npz) {
  std::vector<std::string> names;
  for (const NpyArray& array : npz.arrays)
    if (array.type.kind == 'O') names.push_back(array.name);
  return names;
}

}  // namespace mien::motion
