#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mien::motion {

/// A node of an FBX file: a name, a list of values, and child nodes. Its values stay in the file's
/// bytes until they are asked for (fbx_values.h).
struct FbxNode {
  std::string_view name;          ///< "Model", "P", "KeyTime"
  std::string_view list;          ///< the bytes of the values, without the children
  std::uint32_t value_count = 0;  ///< of binary files; 0 in text files
  std::uint32_t end = 0;          ///< index of the first node after this one and all below it
};

/// An FBX file as a tree of nodes, in the order of the file, each before its children. Node 0
/// stands for the file itself: its children are the file's sections ("Objects", "Connections", …).
/// Views point into the bytes that were parsed, which must outlive the document.
///
/// Layout of binary files: `Kaydara FBX Binary  \0\x1a\0`, the version as uint32, then nodes:
/// offset of the end, number of values and length of their bytes (uint32 each, from version 7500 on
/// uint64), length of the name (uint8), name, values, children, and after children a record of
/// zeros. Text files are the same tree: `Name: value, value { children }`, with comments from `;`
/// to the end of the line, and arrays as `Name: *3 { a: 1,2,3 }`.
struct FbxDocument {
  std::string file;  ///< for error messages
  std::string_view bytes;
  bool is_text = false;
  int version = 0;  ///< 7400 means 7.4
  std::vector<FbxNode> nodes;
};

/// Parses a binary or text file of versions 6100 to 7700. Throws mien::Error with the byte (binary)
/// or line and column (text) if a node does not fit into its parent or the file, nodes are nested
/// more than 64 deep, there are more than four million of them, an array has more than 2^26
/// elements, arrays would inflate to more than 4 GiB, to much more than the file has
/// (`largest_inflated`, compressed_file.h) or by more than deflate can compress, or the version is
/// another one.
FbxDocument parse_fbx_document(std::string_view bytes, const std::string& file_name);

/// Whether the bytes begin like a binary FBX file.
bool is_binary_fbx(std::string_view bytes);

/// Index of the first child; equals `nodes[node].end` if there is none. The next sibling of a node
/// is at its `end`.
inline std::uint32_t first_child(std::uint32_t node) { return node + 1; }

/// The first child of that name; 0 if there is none.
std::uint32_t find_child(const FbxDocument& document, std::uint32_t node, std::string_view name);

/// Throws mien::Error at a position in the file (a pointer into its bytes).
[[noreturn]] void refuse_fbx(const FbxDocument& document, const char* position,
                             std::string_view wrong, std::string_view remedy);

/// Throws mien::Error at a node, for a file that is damaged.
[[noreturn]] void refuse_fbx(const FbxDocument& document, std::uint32_t node,
                             std::string_view wrong);

/// The remedy for a damaged file.
inline constexpr std::string_view fbx_again = "export or download the file again";

namespace fbx_limits {
inline constexpr std::size_t deepest_node = 64;
inline constexpr std::size_t most_nodes = std::size_t{1} << 22;
inline constexpr std::uint64_t most_elements = std::uint64_t{1} << 26;        ///< of one array
inline constexpr std::uint64_t most_inflated_bytes = std::uint64_t{1} << 32;  ///< of all arrays
inline constexpr std::uint64_t most_inflation = 1032;  ///< what deflate can reach
}  // namespace fbx_limits

/// Appends the nodes of a binary file to `document`, from byte 27 on.
void parse_binary_fbx(FbxDocument& document);

/// Appends the nodes of a text file to `document`.
void parse_text_fbx(FbxDocument& document);

}  // namespace mien::motion
