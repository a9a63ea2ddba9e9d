#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "motion/formats/fbx/fbx_writer.h"

namespace mien::test {

inline constexpr std::int64_t fbx_second = 46'186'158'000;

/// Builds files of version 7000 and later, object by object.
struct FbxSceneBuilder {
  using Numbers = std::vector<double>;

  FbxTestNode settings{"Properties70", {}, {}};
  FbxTestNode objects{"Objects", {}, {}};
  FbxTestNode connections{"Connections", {}, {}};
  std::int64_t next = 1000;

  static FbxTestNode property(const std::string& name, const Numbers& numbers) {
    FbxTestNode node{"P", {name, std::string(), std::string(), std::string()}, {}};
    for (const double number : numbers) node.values.emplace_back(number);
    return node;
  }
  static FbxTestNode setting(const std::string& name, std::int64_t integer) {
    return {"P", {name, std::string("int"), std::string(), std::string(), integer}, {}};
  }

  std::int64_t add(const std::string& kind, const std::string& name, const std::string& sub_kind,
                   std::vector<FbxTestNode> children) {
    const std::int64_t id = next++;
    const std::string full_name = name + std::string("\0\1", 2) + kind;
    objects.children.push_back({kind, {id, full_name, sub_kind}, std::move(children)});
    return id;
  }

  void connect(std::int64_t child, std::int64_t parent) {
    connections.children.push_back({"C", {std::string("OO"), child, parent}, {}});
  }
  void connect(std::int64_t child, std::int64_t parent, const std::string& name) {
    connections.children.push_back({"C", {std::string("OP"), child, parent, name}, {}});
  }

  std::int64_t model(const std::string& name, const std::string& kind, std::int64_t parent,
                     const Numbers& translation, std::vector<FbxTestNode> properties = {}) {
    properties.push_back(property("Lcl Translation", translation));
    const std::int64_t id = add("Model", name, kind, {{"Properties70", {}, std::move(properties)}});
    connect(id, parent);
    return id;
  }

  /// A stack with one layer; returns both.
  std::pair<std::int64_t, std::int64_t> take(const std::string& name, std::int64_t start = 0,
                                             std::int64_t stop = 0) {
    const std::int64_t stack =
        add("AnimationStack", name, "",
            {{"Properties70", {}, {setting("LocalStart", start), setting("LocalStop", stop)}}});
    return {stack, layer(stack, {})};
  }

  std::int64_t layer(std::int64_t stack, std::vector<FbxTestNode> properties) {
    const std::int64_t id =
        add("AnimationLayer", "Layer", "", {{"Properties70", {}, std::move(properties)}});
    connect(id, stack);
    return id;
  }

  struct Keys {
    std::vector<double> seconds;
    std::vector<float> values;
    std::vector<std::int32_t> flags = {0x4};
    std::vector<float> data = {0, 0, 0, 0};
    std::vector<std::int32_t> runs = {};
  };

  /// A curve for one component ("d|Z") of a property of a model.
  void curve(std::int64_t in_layer, std::int64_t model, const std::string& of,
             const std::string& component, Keys keys) {
    const std::int64_t node = add("AnimationCurveNode", "N", "", {});
    connect(node, in_layer);
    connect(node, model, of);
    std::vector<std::int64_t> times;
    for (const double seconds : keys.seconds) {
      times.push_back(std::llround(seconds * static_cast<double>(fbx_second)));
    }
    if (keys.runs.empty()) keys.runs = {static_cast<std::int32_t>(times.size())};
    const std::int64_t id = add("AnimationCurve", "", "",
                                {{"KeyTime", {times}, {}},
                                 {"KeyValueFloat", {keys.values}, {}},
                                 {"KeyAttrFlags", {keys.flags}, {}},
                                 {"KeyAttrDataFloat", {keys.data}, {}},
                                 {"KeyAttrRefCount", {keys.runs}, {}}});
    connect(id, node, component);
  }

  std::vector<FbxTestNode> nodes(int version = 7400) const {
    return {{"FBXHeaderExtension", {}, {{"FBXVersion", {std::int32_t{version}}, {}}}},
            {"GlobalSettings", {}, {settings}},
            objects,
            connections};
  }

  std::string binary(int version = 7400, bool deflates = true) const {
    return FbxTestWriter(version, deflates).file(nodes(version));
  }
  std::string text() const { return FbxTestTextWriter().file(nodes()); }
};

/// Upper arm and forearm with an end, 200 and 100 cm long along y; the forearm turns about z from
/// 0° to 90° in a second, and the shoulder moves from x = 0 to 400 cm.
inline FbxSceneBuilder fbx_arm() {
  FbxSceneBuilder arm;
  const std::int64_t upper = arm.model("upper", "LimbNode", 0, {0, 0, 0});
  const std::int64_t fore = arm.model("fore", "LimbNode", upper, {0, 200, 0});
  arm.model("fore_End", "LimbNode", fore, {0, 100, 0});
  const auto [stack, layer] = arm.take("bend");
  arm.curve(layer, fore, "Lcl Rotation", "d|Z", {{0, 1}, {0, 90}});
  arm.curve(layer, upper, "Lcl Translation", "d|X", {{0, 1}, {0, 400}});
  return arm;
}

}  // namespace mien::test
