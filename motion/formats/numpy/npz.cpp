#include "motion/formats/numpy/npz.h"

#include <algorithm>
#include <memory>
#include <set>

#include <archive.h>
#include <archive_entry.h>

#include "motion/text/excerpt.h"
#include "motion/text/file_kind.h"

namespace mien::motion {

namespace {

/// A header of an array that is not wanted is expected within so many bytes.
constexpr std::size_t most_header_bytes = (std::size_t{1} << 16U) + 12;
/// Memory is reserved for so many times the archive's own size; beyond that it grows with what is
/// really there.
constexpr std::uintmax_t usual_expansion = 8;

struct ArchiveFreeing {
  void operator()(archive* one) const { archive_free(one); }
};

/// Reads the members of a zip archive one after the other, by its directory.
struct NpzReader {
  std::string_view bytes;
  const std::string& file;
  std::uintmax_t most;  ///< bytes that may be unpacked
  std::uintmax_t left;
  std::unique_ptr<archive, ArchiveFreeing> zip{archive_read_new()};
};

[[noreturn]] void refuse(const NpzReader& reader, const std::string& name) {
  const char* const words = archive_error_string(reader.zip.get());
  const std::string subject = name.empty() ? "is not a readable zip archive"
                                           : "the array " + in_quotes(name) + " cannot be unpacked";
  throw Error({reader.file}, subject + (words ? " (" + excerpt(words) + ")" : ""),
              "obtain the file again");
}

[[noreturn]] void refuse_size(const NpzReader& reader) {
  throw Error({reader.file},
              "its arrays unpack to more than the " + std::to_string(reader.most >> 20U) +
                  " MiB that can be read",
              "save shorter recordings, with only the arrays of the motion");
}

void open(NpzReader& reader) {
  archive_read_support_format_zip_seekable(reader.zip.get());
  archive_read_set_options(reader.zip.get(), "zip:hdrcharset=UTF-8");
  if (archive_read_open_memory(reader.zip.get(), reader.bytes.data(), reader.bytes.size()) !=
      ARCHIVE_OK)
    refuse(reader, "");
}

/// Null after the last.
archive_entry* next_member(NpzReader& reader) {
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

/// The member's bytes, or at least the first `enough` of them.
std::string unpacked(NpzReader& reader, archive_entry* entry, const std::string& name,
                     std::uintmax_t enough) {
  const std::uintmax_t stated = stated_size(entry);
  const std::uintmax_t usual = usual_expansion * reader.bytes.size();
  std::string content;
  content.reserve(static_cast<std::size_t>(std::min({stated, enough, usual, reader.most})));
  while (content.size() < enough) {
    const void* part = nullptr;
    std::size_t count = 0;
    la_int64_t offset = 0;
    const int code = archive_read_data_block(reader.zip.get(), &part, &count, &offset);
    if (code == ARCHIVE_EOF) break;
    if (code != ARCHIVE_OK) refuse(reader, name);
    const std::uintmax_t taken = std::min<std::uintmax_t>(count, enough - content.size());
    if (taken > reader.left) refuse_size(reader);
    reader.left -= taken;
    content.append(static_cast<const char*>(part), static_cast<std::size_t>(taken));
  }
  return content;
}

bool is_wanted(const WantedArrays& wanted, std::string_view name) {
  return !wanted || std::find(wanted->begin(), wanted->end(), name) != wanted->end();
}

/// Type and shape alone.
NpyArray outline(NpzReader& reader, archive_entry* entry, const std::string& name) {
  const std::string content = unpacked(reader, entry, name, most_header_bytes);
  NpyHeader header = parse_npy_header(content, reader.file, name);
  return {name, header.type, std::move(header.shape), header.is_fortran_order, false, {}};
}

bool is_read(char kind) { return std::string_view("biufUS").find(kind) != std::string_view::npos; }

/// Throws where the sizes that the archive states exceed the limit, before anything is unpacked.
void refuse_stated_size(std::string_view bytes, const std::string& file, const WantedArrays& wanted,
                        std::uintmax_t most) {
  NpzReader reader{bytes, file, most, most};
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

}  // namespace

Npz parse_npz(std::string_view bytes, const std::string& file_name, const WantedArrays& wanted,
              std::uintmax_t most_bytes) {
  if (bytes.starts_with("\x93NUMPY"))
    throw Error({file_name}, "is a single NumPy array", "rename it to .npy");
  refuse_stated_size(bytes, file_name, wanted, most_bytes);
  NpzReader reader{bytes, file_name, most_bytes, most_bytes};
  open(reader);
  Npz npz{file_name, {}};
  while (archive_entry* const entry = next_member(reader)) {
    const std::string name = array_name(entry);
    if (name.empty()) continue;
    NpyArray array;
    if (is_wanted(wanted, name)) {
      std::string content = unpacked(reader, entry, name, any_size);
      NpyHeader header = parse_npy_header(content, file_name, name);
      array = is_read(header.type.kind)
                  ? npy_member(std::move(content), file_name, name)
                  : NpyArray{name,  header.type, std::move(header.shape), header.is_fortran_order,
                             false, {}};
    } else {
      array = outline(reader, entry, name);
    }
    npz.arrays.push_back(std::move(array));
  }
  return npz;
}

std::string npz_contents(const std::filesystem::path& path) {
  std::string bytes = read_contents(path);
  require_kind(bytes, path.string(), "npz");
  return bytes;
}

Npz read_npz(const std::filesystem::path& path, const WantedArrays& wanted) {
  return parse_npz(npz_contents(path), path.string(), wanted);
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
