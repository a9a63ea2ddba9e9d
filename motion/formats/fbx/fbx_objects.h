#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/fbx/fbx_document.h"

namespace mien::motion {

/// An object of the section "Objects".
struct FbxObject {
  std::uint32_t node = 0;     ///< in the document
  std::string_view kind;      ///< "Model", "AnimationCurve"
  std::string name;           ///< without its class: "Hips" of "Model::Hips"
  std::string_view sub_kind;  ///< "LimbNode"
};

/// A connection of a child to its parent, or to a property of the parent.
struct FbxConnection {
  int child = 0;              ///< index of the object
  int parent = -1;            ///< index of the object; −1: the scene
  std::string_view property;  ///< "Lcl Rotation"; empty for connections of whole objects
};

/// The objects of a file and how they are connected. Objects are known by numbers in files of
/// version 7000 and later, and by "Class::Name" in older ones.
struct FbxObjects {
  std::vector<FbxObject> objects;
  std::vector<FbxConnection> connections;  ///< in the order of the file
  std::vector<std::vector<int>> from;      ///< of each object, the connections in which it is child
  std::vector<std::vector<int>> to;        ///< of each object, those in which it is parent

  /// Index of an object by its name in full, as in the sections of files before version 7000;
  /// −1 if there is none.
  int find_by_full_name(std::string_view full_name) const;

  std::vector<std::pair<std::string_view, int>> by_full_name;  ///< sorted
};

/// The objects and connections of a document. Connections of unknown objects are omitted. Throws
/// mien::Error if there are no objects.
FbxObjects parse_fbx_objects(const FbxDocument& document);

/// "Hips" of "Model::Hips" (text) or "Hips\0\1Model" (binary).
std::string name_without_class(const FbxDocument& document, std::string_view full_name);

/// A property of an object ("Properties70", or "Properties60" in old files).
struct FbxProperty {
  std::string_view name;
  int count = 0;                    ///< of `numbers`
  std::array<double, 3> numbers{};  ///< its first values, if they are finite numbers
  std::int64_t integer = 0;         ///< the first value, exact
};

/// The properties that are set in an object's own node, or in any node that holds a list of them.
std::vector<FbxProperty> properties_of(const FbxDocument& document, std::uint32_t node);

/// The node that holds the default properties of a kind of object (section "Definitions"); 0 if
/// there is none.
std::uint32_t template_of(const FbxDocument& document, std::string_view kind);

}  // namespace mien::motion
