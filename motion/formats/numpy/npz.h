#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/numpy/npy.h"
#include "motion/text/file_contents.h"

namespace mien::motion {

/// The arrays of an .npz file, in the order of the file.
struct Npz {
  std::string file;  ///< name for error messages
  std::vector<NpyArray> arrays;
};

/// Largest number of files in an .npz file.
inline constexpr std::size_t most_npz_members = 4096;

/// Names of arrays whose elements are read; empty: all arrays.
using WantedArrays = std::optional<std::vector<std::string_view>>;

/// Reads an .npz file: a zip archive (stored or deflated, also zip64) of .npy files, each named
/// after its array. Files with other endings are passed over. Of an array that is not `wanted`, or
/// whose elements are of a kind that is not read, only type and shape are read (`is_present` is
/// false).
///
/// Throws mien::Error naming the file and the array if the archive is damaged, encrypted or has
/// more than `most_npz_members` files, if two arrays have one name, if the wanted arrays unpack to
/// more than `most_bytes`, or to much more than the archive has (`largest_inflated`,
/// compressed_file.h; checked before unpacking by the sizes that the archive states, and while
/// unpacking), or if an array is invalid.
Npz parse_npz(std::string_view bytes, const std::string& file_name,
              const WantedArrays& wanted = std::nullopt,
              std::uintmax_t most_bytes = max_recording_bytes);

/// As `parse_npz`, from a file, of which only the directory and the wanted arrays are read. Throws
/// mien::Error also if the file cannot be read or is clearly another one.
Npz read_npz(const std::filesystem::path& path, const WantedArrays& wanted = std::nullopt);

/// The array of that name; null if there is none.
const NpyArray* find_array(const Npz& npz, std::string_view name);

/// The names of all arrays that are held as Python objects, which are never unpickled.
std::vector<std::string> object_arrays(const Npz& npz);

/// An array with the name that it has in an .npz file.
struct NamedArray {
  std::string name;
  NpyArray array;
};

enum class NpzCompression { stored, deflated };

/// The arrays as an .npz file. Without times, users and extra fields: the same arrays always
/// produce the same bytes, when deflated with one version of zlib. Throws mien::Error if the file
/// would have 4 GiB or more.
std::string to_npz(std::span<const NamedArray> arrays,
                   NpzCompression compression = NpzCompression::stored);

}  // namespace mien::motion
