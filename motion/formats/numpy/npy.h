#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/error.h"

namespace mien::motion {

/// The type of an array's elements, as in NumPy's type strings ("<f4", ">i8", "<U7").
struct NpyType {
  /// 'f' real, 'i' integer, 'u' unsigned, 'b' boolean, 'U' Unicode text, 'S' bytes of text. Others
  /// are not read: 'O' Python objects, 'c' complex, 'M' and 'm' times, 'V' records.
  char kind = 'f';
  std::size_t bytes = 8;  ///< of an element: 4 for f4, 28 for U7
  bool is_big_endian = false;
};

/// A NumPy array.
struct NpyArray {
  std::string name;  ///< of the array in an .npz file; empty in an .npy file
  NpyType type;
  std::vector<std::size_t> shape;  ///< empty: a single element
  bool is_fortran_order = false;   ///< the first index varies fastest
  bool is_present = true;          ///< whether `bytes` was read (see `parse_npz`)
  std::string bytes;               ///< the elements, as in the file

  std::size_t size() const;  ///< number of elements
};

/// The header of an .npy file.
struct NpyHeader {
  NpyType type;
  std::vector<std::size_t> shape;
  bool is_fortran_order = false;
  std::size_t start = 0;  ///< where the elements begin, bytes
};

/// Reads a header of version 1, 2 or 3 (numpy.lib.format): the magic string, the version, the
/// length of the text in 2 or 4 bytes, and a Python dictionary with `descr`, `fortran_order` and
/// `shape`, of which exactly this form is accepted. The elements need not be there. Throws
/// mien::Error naming the file, the array unless `name` is empty, and the byte.
NpyHeader parse_npy_header(std::string_view bytes, const std::string& file_name,
                           std::string_view name = {});

/// Reads an .npy file. Throws mien::Error if it is none, is cut short or has bytes after the
/// elements, or if its elements are of a kind that is not read, in particular Python objects, which
/// are never unpickled.
NpyArray parse_npy(std::string_view bytes, const std::string& file_name);
NpyArray read_npy(const std::filesystem::path& path);

/// As `parse_npy`, for a member of an .npz file: the array of a header and the bytes that follow
/// it.
NpyArray npy_member(NpyHeader header, std::string elements, const std::string& file_name,
                    std::string_view name);

/// The elements as numbers, the last index varying fastest, whatever the order in the file. At most
/// 2²⁹ numbers of 8 to 64 bits or booleans; throws mien::Error at `place` for others.
std::vector<double> numbers_of(const NpyArray& array, const Place& place);

/// The elements of an array of text ('U' or 'S') in UTF-8, without zeros at their ends. Throws
/// mien::Error at `place` for others.
std::vector<std::string> texts_of(const NpyArray& array, const Place& place);

/// The shape as NumPy writes it: "(300, 22, 3)".
std::string shape_text(const NpyArray& array);

/// `the array "poses"`, or `the array` if it has no name.
std::string described(const NpyArray& array);

/// Throws mien::Error at `place` unless elements of this kind are read.
void require_readable(const NpyArray& array, const Place& place);

/// Arrays of numbers (f8 or f4) or of a single text; little endian, last index fastest.
NpyArray array_of(std::span<const double> numbers, std::vector<std::size_t> shape);
NpyArray array_of_floats(std::span<const double> numbers, std::vector<std::size_t> shape);
NpyArray array_of_text(std::string_view ascii);

/// The array as an .npy file of version 1, as NumPy writes it.
std::string to_npy(const NpyArray& array);

}  // namespace mien::motion
