#include "scenes/character/vrm_expressions.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "motion/text/excerpt.h"

namespace mien::scenes {

namespace {

using nlohmann::json;

struct VrmPreset {
  std::string_view vrm_0;
  std::string_view vrm_1;
};

constexpr VrmPreset vrm_presets[] = {
    {"joy", "happy"},
    {"angry", "angry"},
    {"sorrow", "sad"},
    {"fun", "relaxed"},
    {"a", "aa"},
    {"i", "ih"},
    {"u", "ou"},
    {"e", "ee"},
    {"o", "oh"},
    {"blink", "blink"},
    {"blink_l", "blinkLeft"},
    {"blink_r", "blinkRight"},
    {"lookup", "lookUp"},
    {"lookdown", "lookDown"},
    {"lookleft", "lookLeft"},
    {"lookright", "lookRight"},
    {"neutral", "neutral"},
};

/// The member of an object; null without one.
const json* vrm_member(const json* object, const char* key) {
  if (object == nullptr || !object->is_object()) return nullptr;
  const auto found = object->find(key);
  return found == object->end() ? nullptr : &*found;
}

std::string vrm_text(const json& object, const char* key) {
  const json* text = vrm_member(&object, key);
  return text != nullptr && text->is_string() ? text->get<std::string>() : "";
}

/// How a version of VRM binds an expression to morph targets.
struct VrmBinding {
  const char* placed_by;  ///< "node" or "mesh"
  const char* list;       ///< of binds
  double full_weight;
};

constexpr VrmBinding vrm_1_binding = {"node", "morphTargetBinds", 1.0};
constexpr VrmBinding vrm_0_binding = {"mesh", "binds", 100.0};

/// The index under a key; none if it is not one below `count`.
std::optional<int> vrm_index(const json& object, const char* key, std::size_t count) {
  const json* index = vrm_member(&object, key);
  if (index == nullptr || !index->is_number_unsigned() || index->get<std::uint64_t>() >= count)
    return std::nullopt;
  return index->get<int>();
}

class VrmReader {
 public:
  VrmReader(const CharacterFile& file, const std::vector<PlacedMesh>& placed,
            const GltfMorphs& morphs, const VrmBinding& binding, std::vector<std::string>& warnings)
      : file_(file), placed_(placed), morphs_(morphs), binding_(binding), warnings_(warnings) {}

  FaceControl control(const std::string& name, const json& given) const {
    FaceControl control;
    control.name = name;
    const json* binary = vrm_member(&given, "isBinary");
    control.is_binary = binary != nullptr && *binary == true;
    bool is_whole = true;
    for (const json& bind : list_in(given, binding_.list)) is_whole &= add(bind, control);
    if (!is_whole)
      warnings_.push_back("The expression " + motion::in_quotes(name) +
                          " refers to morph targets that do not exist, which are omitted.");
    return control;
  }

 private:
  /// Whether the bind is valid.
  bool add(const json& bind, FaceControl& control) const {
    const bool is_by_node = binding_.placed_by == vrm_1_binding.placed_by;
    const std::size_t count = list_in(file_.json, is_by_node ? "nodes" : "meshes").size();
    const std::optional<int> place = vrm_index(bind, binding_.placed_by, count);
    const json* weight = vrm_member(&bind, "weight");
    if (!place || weight == nullptr || !weight->is_number()) return false;
    const double share = weight->get<double>() / binding_.full_weight;
    if (!(share >= 0.0 && share <= 1.0)) return false;
    bool is_valid = true;
    for (std::size_t m = 0; m < placed_.size(); ++m) {
      if ((is_by_node ? placed_[m].node : placed_[m].mesh) != *place) continue;
      const std::optional<int> target = vrm_index(bind, "index", morphs_.names[m].size());
      if (target) control.morphs.emplace_back(morphs_.first[m] + *target, share);
      is_valid &= target.has_value();
    }
    return is_valid;
  }

  const CharacterFile& file_;
  const std::vector<PlacedMesh>& placed_;
  const GltfMorphs& morphs_;
  const VrmBinding& binding_;
  std::vector<std::string>& warnings_;
};

std::string name_of_group(const json& group) {
  const std::string preset = vrm_text(group, "presetName");
  for (const VrmPreset& known : vrm_presets)
    if (known.vrm_0 == preset) return std::string(known.vrm_1);
  return vrm_text(group, "name");
}

}  // namespace

std::vector<FaceControl> vrm_expressions(const CharacterFile& file,
                                         const std::vector<PlacedMesh>& placed,
                                         const GltfMorphs& morphs,
                                         std::vector<std::string>& warnings) {
  std::vector<FaceControl> controls;
  const json* extensions = vrm_member(&file.json, "extensions");
  const json* vrm_1 = vrm_member(vrm_member(extensions, "VRMC_vrm"), "expressions");
  const VrmReader reader_1(file, placed, morphs, vrm_1_binding, warnings);
  for (const char* kind : {"preset", "custom"}) {
    const json* expressions = vrm_member(vrm_1, kind);
    if (expressions == nullptr || !expressions->is_object()) continue;
    for (const auto& [name, given] : expressions->items())
      controls.push_back(reader_1.control(name, given));
  }
  const json* vrm_0 = vrm_member(vrm_member(extensions, "VRM"), "blendShapeMaster");
  if (vrm_0 == nullptr) return controls;
  const VrmReader reader_0(file, placed, morphs, vrm_0_binding, warnings);
  for (const json& group : list_in(*vrm_0, "blendShapeGroups")) {
    const std::string name = name_of_group(group);
    if (!name.empty()) controls.push_back(reader_0.control(name, group));
  }
  return controls;
}

}  // namespace mien::scenes
