#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/c3d/c3d_bytes.h"

namespace mien::motion {

/// A parameter of a C3D file: an array of characters, bytes, 16-bit integers or floats.
struct C3dParameter {
  int type = 0;                         ///< −1 characters, 1 bytes, 2 integers, 4 floats
  std::vector<std::size_t> dimensions;  ///< the first varies fastest; empty: a single value
  std::string_view data;                ///< of the file's bytes
};

/// The bytes of a C3D file and its parameters by group and name in capitals, as in "POINT:USED".
/// Does not own the bytes.
struct C3dFile {
  std::string_view bytes;
  std::string name;  ///< for messages
  C3dProcessor processor = C3dProcessor::intel;
  std::map<std::string, C3dParameter, std::less<>> parameters;
};

/// Reads the parameter section. If a parameter is defined twice, the first one counts; parameters
/// of a group that has no name are ignored. Throws mien::Error for bytes that are not a C3D file
/// and for a section that leads out of the file.
C3dFile parse_c3d_parameters(std::string_view bytes, const std::string& file_name);

/// Throws mien::Error; the byte at which the fault lies becomes part of the text.
[[noreturn]] void fail_c3d(const C3dFile& file, std::size_t byte, std::string_view wrong,
                           std::string_view remedy);

const C3dParameter* find_c3d_parameter(const C3dFile& file, std::string_view name);

/// A value of a parameter, if the parameter exists, is numeric and has so many: `c3d_number`
/// with integers from −32,768 to 32,767, `c3d_count` with integers from 0 to 65,535 and only for
/// whole numbers below 2^32.
std::optional<double> c3d_number(const C3dFile& file, std::string_view name, std::size_t index = 0);
std::optional<std::size_t> c3d_count(const C3dFile& file, std::string_view name,
                                     std::size_t index = 0);

/// The texts of a parameter of characters, without blanks and zero bytes at their ends; at most
/// 65,536. Empty if there is no such parameter.
std::vector<std::string> c3d_texts(const C3dFile& file, std::string_view name);

/// As `c3d_texts`, continued by the parameters NAME2, NAME3, …: a parameter holds at most 255.
std::vector<std::string> c3d_all_texts(const C3dFile& file, std::string_view name);

}  // namespace mien::motion
