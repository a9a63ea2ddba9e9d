#include "motion/formats/gltf/gltf_humanoid.h"

#include <cstdint>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

/// A member of an object; null if the value is no object or has none of that name.
const nlohmann::json& member(const nlohmann::json& value, std::string_view name) {
  static const nlohmann::json none;
  if (!value.is_object()) return none;
  const auto found = value.find(name);
  return found == value.end() ? none : *found;
}

[[noreturn]] void refuse_bone(const std::string& file, const std::string& bone,
                              std::string_view wrong) {
  throw Error({file}, "VRM bone " + in_quotes(bone) + " " + std::string(wrong),
              "export the file again");
}

class BoneList {
 public:
  BoneList(size_t nodes, const std::string& file) : nodes_(nodes), file_(file) {}

  void add(const std::string& bone, const nlohmann::json& node) {
    if (node.is_number_integer() && !node.is_number_unsigned()) return;  // −1: not in this figure
    if (!node.is_number_unsigned()) refuse_bone(file_, bone, "has no node");
    const auto index = node.get<std::uint64_t>();
    if (index >= nodes_) refuse_bone(file_, bone, "is a node that does not exist");
    if (!names_.insert(bone).second) refuse_bone(file_, bone, "is given twice");
    if (!taken_.insert(index).second) refuse_bone(file_, bone, "is the node of another bone");
    bones.push_back({bone, static_cast<int>(index)});
  }

  std::vector<HumanBone> bones;

 private:
  size_t nodes_;
  const std::string& file_;
  std::set<std::string> names_;
  std::set<std::uint64_t> taken_;
};

}  // namespace

std::vector<HumanBone> human_bones(const nlohmann::json& document, size_t nodes,
                                   const std::string& name) {
  const nlohmann::json& extensions = member(document, "extensions");
  BoneList list(nodes, name);
  for (const char* extension : {"VRMC_vrm_animation", "VRMC_vrm"}) {
    const nlohmann::json& bones =
        member(member(member(extensions, extension), "humanoid"), "humanBones");
    if (!bones.is_object()) continue;
    for (const auto& [bone, value] : bones.items()) list.add(bone, member(value, "node"));
    return std::move(list.bones);
  }
  const nlohmann::json& bones = member(member(member(extensions, "VRM"), "humanoid"), "humanBones");
  if (!bones.is_array()) return {};
  for (const nlohmann::json& value : bones) {
    const nlohmann::json& bone = member(value, "bone");
    if (bone.is_string()) list.add(bone.get<std::string>(), member(value, "node"));
  }
  return std::move(list.bones);
}

}  // namespace mien::motion
