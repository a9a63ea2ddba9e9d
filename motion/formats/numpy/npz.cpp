#include "motion/formats/numpy/npz.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <set>

#include <libdeflate.h>
#include <unistd.h>
#include <zip.h>

#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_kind.h"
#include "motion/text/open_file.h"

namespace mien::motion {

namespace {

/// The header of an array is expected within so many bytes.
constexpr std::size_t most_header_bytes = (std::size_t{1} << 16U) + 12;

struct Closing {
  void operator()(zip_t* one) const { zip_discard(one); }
  void operator()(zip_file_t* one) const { zip_fclose(one); }
  void operator()(libdeflate_decompressor* one) const { libdeflate_free_decompressor(one); }
};

/// An archive in memory or, without `bytes`, in an open file.
struct Source {
  const std::string& name;
  std::string_view bytes;
  const OpenFile* file = nullptr;

  std::uintmax_t size() const { return file ? file->size() : bytes.size(); }
};

[[noreturn]] void refuse_archive(const Source& source, const std::string& words) {
  throw Error({source.name}, "is not a readable zip archive (" + excerpt(words) + ")",
              "obtain the file again");
}

[[noreturn]] void refuse_other_file(const Source& source) {
  throw Error({source.name}, "is not an .npz file: it is no zip archive", "obtain the file again");
}

[[noreturn]] void refuse_member(const Source& source, const std::string& name,
                                const std::string& words) {
  throw Error({source.name},
              "the array " + in_quotes(name) + " cannot be unpacked (" + excerpt(words) + ")",
              "obtain the file again");
}

[[noreturn]] void refuse_size(const Source& source, std::uintmax_t most) {
  throw Error(
      {source.name},
      "its arrays unpack to more than the " + std::to_string(most >> 20U) + " MiB that can be read",
      "save the arrays of a shorter recording, without compression (numpy.savez)");
}

/// The bytes of an archive as libzip reads them; null with an error.
zip_source_t* bytes_of(const Source& source, zip_error_t& error) {
  if (!source.file)
    return zip_source_buffer_create(source.bytes.data(), source.bytes.size(), 0, &error);
  // libzip closes what it is given.
  const int copy = dup(source.file->number());
  FILE* const stream = copy < 0 ? nullptr : fdopen(copy, "rb");
  if (!stream) {
    if (copy >= 0) close(copy);
    zip_error_set(&error, ZIP_ER_OPEN, errno);
    return nullptr;
  }
  zip_source_t* const bytes = zip_source_filep_create(stream, 0, -1, &error);
  if (!bytes) fclose(stream);
  return bytes;
}

using Zip = std::unique_ptr<zip_t, Closing>;

Zip open(const Source& source) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const bytes = bytes_of(source, error);
  Zip zip(bytes ? zip_open_from_source(bytes, ZIP_RDONLY, &error) : nullptr);
  const std::string words = zip_error_strerror(&error);
  const bool is_other_file = zip_error_code_zip(&error) == ZIP_ER_NOZIP;
  zip_error_fini(&error);
  if (zip) return zip;
  if (bytes) zip_source_free(bytes);
  if (is_other_file) refuse_other_file(source);
  refuse_archive(source, words);
}

/// An array in the archive.
struct ZippedArray {
  zip_uint64_t index = 0;
  std::string name;
  zip_stat_t stat{};
};

/// The first bytes of a member, at most `count`, unpacked by libzip.
std::string unpacked_by_libzip(const Source& source, zip_t* zip, const ZippedArray& member,
                               std::uintmax_t count, zip_flags_t flags = 0) {
  const std::unique_ptr<zip_file_t, Closing> file(zip_fopen_index(zip, member.index, flags));
  if (!file) refuse_member(source, member.name, zip_strerror(zip));
  std::string content(static_cast<std::size_t>(count), '\0');
  const zip_int64_t read = zip_fread(file.get(), content.data(), count);
  if (read < 0) refuse_member(source, member.name, zip_file_strerror(file.get()));
  content.resize(static_cast<std::size_t>(read));
  return content;
}

std::string inflated_member(const Source& source, const ZippedArray& member,
                            std::string_view deflated) {
  const std::unique_ptr<libdeflate_decompressor, Closing> decompressor(
      libdeflate_alloc_decompressor());
  if (!decompressor) throw std::bad_alloc();
  std::string content(static_cast<std::size_t>(member.stat.size), '\0');
  if (libdeflate_deflate_decompress(decompressor.get(), deflated.data(), deflated.size(),
                                    content.data(), content.size(), nullptr) != LIBDEFLATE_SUCCESS)
    refuse_member(source, member.name, "compressed data are damaged or not of the stated length");
  return content;
}

/// Name of the member's array; empty if the member is no array.
std::string array_name(const zip_stat_t& stat) {
  std::string_view name = stat.name ? stat.name : "";
  if (!name.ends_with(".npy")) return "";
  name.remove_suffix(4);
  return std::string(name);
}

void require_checksum(const Source& source, const ZippedArray& member, std::uint32_t checksum) {
  if (checksum != member.stat.crc) refuse_member(source, member.name, "checksum does not match");
}

/// The bytes of a stored member after the first `start`. Pieces are small enough to stay in the
/// processor's cache.
std::string stored_bytes(const Source& source, zip_t* zip, const ZippedArray& member,
                         std::size_t start) {
  const std::unique_ptr<zip_file_t, Closing> file(
      zip_fopen_index(zip, member.index, ZIP_FL_COMPRESSED));
  if (!file) refuse_member(source, member.name, zip_strerror(zip));
  std::vector<char> piece(std::size_t{1} << 16U);
  std::string content;
  content.reserve(static_cast<std::size_t>(member.stat.size));
  std::uint32_t checksum = 0;
  for (std::size_t dropped = 0;;) {
    const zip_int64_t read = zip_fread(file.get(), piece.data(), piece.size());
    if (read < 0) refuse_member(source, member.name, zip_file_strerror(file.get()));
    if (read == 0) break;
    const std::string_view bytes(piece.data(), static_cast<std::size_t>(read));
    checksum = libdeflate_crc32(checksum, bytes.data(), bytes.size());
    const std::size_t head = std::min(start - dropped, bytes.size());
    dropped += head;
    content.append(bytes.substr(head));
  }
  require_checksum(source, member, checksum);
  return content;
}

/// The bytes of a member after the first `start`. libdeflate inflates and checks more than twice as
/// fast as libzip does by zlib.
std::string unpacked(const Source& source, zip_t* zip, const ZippedArray& member,
                     std::size_t start) {
  const zip_stat_t& stat = member.stat;
  // Not before the file has so many bytes is memory reserved for them.
  if (stat.comp_size > source.size())
    refuse_member(source, member.name, "the file may be truncated");
  if (stat.comp_method == ZIP_CM_STORE && stat.comp_size == stat.size)
    return stored_bytes(source, zip, member, start);
  std::string content;
  if (stat.comp_method == ZIP_CM_DEFLATE) {
    content = inflated_member(
        source, member, unpacked_by_libzip(source, zip, member, stat.comp_size, ZIP_FL_COMPRESSED));
    require_checksum(source, member, libdeflate_crc32(0, content.data(), content.size()));
  } else {
    content = unpacked_by_libzip(source, zip, member, stat.size);
  }
  return content.erase(0, start);
}

bool is_wanted(const WantedArrays& wanted, std::string_view name) {
  return !wanted || std::find(wanted->begin(), wanted->end(), name) != wanted->end();
}

bool is_read(char kind) { return std::string_view("biufUS").find(kind) != std::string_view::npos; }

/// The array of a member; only type and shape if it is not wanted or of a kind that is not read.
NpyArray array_in(const Source& source, zip_t* zip, const ZippedArray& member,
                  const WantedArrays& wanted) {
  const std::uintmax_t beginning = std::min<std::uintmax_t>(member.stat.size, most_header_bytes);
  const std::string header_bytes = unpacked_by_libzip(source, zip, member, beginning);
  NpyHeader header = parse_npy_header(header_bytes, source.name, member.name);
  if (!is_wanted(wanted, member.name) || !is_read(header.type.kind))
    return {member.name, header.type, std::move(header.shape), header.is_fortran_order, false, {}};
  std::string content = unpacked(source, zip, member, header.start);
  return npy_member(std::move(header), std::move(content), source.name, member.name);
}

/// The arrays of the archive. Throws if two have one name or one is encrypted.
std::vector<ZippedArray> members_of(const Source& source, zip_t* zip) {
  const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(zip, 0));
  if (count > most_npz_members)
    throw Error({source.name}, "has more than " + std::to_string(most_npz_members) + " files in it",
                "save only the arrays of one motion");
  std::vector<ZippedArray> members;
  std::set<std::string> names;
  for (zip_uint64_t index = 0; index < count; ++index) {
    ZippedArray member{index, {}, {}};
    if (zip_stat_index(zip, index, 0, &member.stat) != 0) refuse_archive(source, zip_strerror(zip));
    member.name = array_name(member.stat);
    if (member.name.empty()) continue;
    if (member.stat.encryption_method != ZIP_EM_NONE)
      throw Error({source.name}, "the array " + in_quotes(member.name) + " is encrypted",
                  "save the file without a password");
    if (!names.insert(member.name).second)
      throw Error({source.name}, "two arrays are named " + in_quotes(member.name),
                  "save the file again");
    members.push_back(std::move(member));
  }
  if (members.empty())
    throw Error({source.name}, "is a zip archive without NumPy arrays (.npy)",
                "name a file that was saved by numpy.savez");
  return members;
}

/// Throws where the sizes that the archive states exceed the limit, before anything is unpacked;
/// no more than what is stated is ever unpacked.
void require_size(const Source& source, const std::vector<ZippedArray>& members,
                  const WantedArrays& wanted, std::uintmax_t most) {
  std::uintmax_t left = most;
  for (const ZippedArray& member : members) {
    if (!is_wanted(wanted, member.name)) continue;
    if (member.stat.size > left) refuse_size(source, most);
    left -= member.stat.size;
  }
}

Npz arrays_of(const Source& source, const WantedArrays& wanted, std::uintmax_t most_bytes) {
  const Zip zip = open(source);
  const std::vector<ZippedArray> members = members_of(source, zip.get());
  require_size(source, members, wanted, largest_inflated(source.size(), most_bytes));
  Npz npz{source.name, {}};
  for (const ZippedArray& member : members)
    npz.arrays.push_back(array_in(source, zip.get(), member, wanted));
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
