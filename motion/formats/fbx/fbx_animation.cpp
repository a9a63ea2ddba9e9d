#include "motion/formats/fbx/fbx_animation.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "motion/error.h"
#include "motion/formats/fbx/fbx_numbers.h"
#include "motion/formats/fbx/fbx_values.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

using Part = FbxTrack::Part;

std::optional<Part> part_of(std::string_view property) {
  if (property == "Lcl Translation") return Part::translation;
  if (property == "Lcl Rotation") return Part::rotation;
  if (property == "Lcl Scaling") return Part::scale;
  return std::nullopt;
}

/// 0, 1, 2 for "d|X", "d|Y", "d|Z" or "X", "Y", "Z"; −1 for another component.
int axis_of(std::string_view component) {
  if (component.starts_with("d|")) component.remove_prefix(2);
  if (component.size() != 1) return -1;
  const int axis = component.front() - 'X';
  return axis >= 0 && axis < 3 ? axis : -1;
}

/// The names that are taken, with the number that the next one of the same name gets.
using TakenNames = std::map<std::string, int>;

void add_take(FbxTake take, TakenNames& names, std::vector<FbxTake>& takes) {
  if (take.name.empty()) take.name = "take " + std::to_string(takes.size() + 1);
  const std::string own = take.name;
  while (names.contains(take.name)) {
    int& number = names[own];
    take.name = own + " " + std::to_string(++number);
  }
  names.emplace(take.name, 1);
  takes.push_back(std::move(take));
}

FbxTake stack_take(const FbxDocument& document, const FbxObject& object, int index) {
  FbxTake take{object.name, object.node, index, 0, 0};
  for (const FbxProperty& property : properties_of(document, object.node)) {
    if (property.name == "LocalStart") take.start = property.integer;
    if (property.name == "LocalStop") take.stop = property.integer;
  }
  return take;
}

/// What becomes an animation.
struct AnimationBuilder {
  const FbxDocument& document;
  const FbxObjects& objects;
  std::vector<int> model_of;                   ///< of each object; −1
  std::unordered_map<int, int> curve_of;       ///< of objects that were read; −1: without keys
  std::unordered_map<int, FbxTrack> track_of;  ///< of curve nodes that were read
  size_t keys = 0;
  FbxAnimation animation{};
};

void count_keys(AnimationBuilder& builder, std::uint32_t node, size_t keys) {
  constexpr size_t most_keys = size_t{1} << 26;
  builder.keys += keys;
  if (builder.keys <= most_keys) return;
  refuse_fbx(builder.document, builder.document.nodes[node].name.data(),
             "the motion has more than 67108864 keys", "cut the motion into shorter files");
}

int add_curve(AnimationBuilder& builder, FbxCurve curve) {
  if (curve.keys.empty()) return -1;
  builder.animation.curves.push_back(std::move(curve));
  return static_cast<int>(builder.animation.curves.size()) - 1;
}

/// The index of the curve of an object, which several tracks may share.
int curve_of(AnimationBuilder& builder, int object) {
  const auto known = builder.curve_of.find(object);
  if (known != builder.curve_of.end()) return known->second;
  const std::uint32_t node = builder.objects.objects[static_cast<size_t>(object)].node;
  if (const std::uint32_t times = find_child(builder.document, node, "KeyTime")) {
    count_keys(builder, node, stated_numbers_of(builder.document, times));
  }
  const int index = add_curve(builder, parse_fbx_curve(builder.document, node));
  builder.curve_of.emplace(object, index);
  return index;
}

/// Layers that share curve nodes could have far more tracks than the file has connections.
void require_few_tracks(const AnimationBuilder& builder) {
  if (builder.animation.tracks.size() < builder.objects.connections.size()) return;
  throw Error({builder.document.file}, "animation layers share too many curves",
              "merge the layers before exporting");
}

FbxTrack track_of(AnimationBuilder& builder, int curve_node) {
  const auto known = builder.track_of.find(curve_node);
  if (known != builder.track_of.end()) return known->second;
  const FbxObject& object = builder.objects.objects[static_cast<size_t>(curve_node)];
  FbxTrack track;
  for (const FbxProperty& property : properties_of(builder.document, object.node)) {
    const int axis = axis_of(property.name);
    if (axis >= 0 && property.count > 0) {
      track.constants[static_cast<size_t>(axis)] = property.numbers[0];
    }
  }
  for (const int c : builder.objects.to[static_cast<size_t>(curve_node)]) {
    const FbxConnection& connection = builder.objects.connections[static_cast<size_t>(c)];
    const int axis = axis_of(connection.property);
    const bool is_curve =
        builder.objects.objects[static_cast<size_t>(connection.child)].kind == "AnimationCurve";
    if (axis < 0 || !is_curve) continue;
    track.curves[static_cast<size_t>(axis)] = curve_of(builder, connection.child);
  }
  builder.track_of.emplace(curve_node, track);
  return track;
}

FbxLayer layer_of(const FbxDocument& document, std::uint32_t node, bool& is_muted) {
  FbxLayer layer;
  for (const FbxProperty& property : properties_of(document, node)) {
    if (property.count == 0) continue;
    if (property.name == "Weight") {
      layer.weight = std::clamp(property.numbers[0] / 100.0, 0.0, 1.0);
    }
    if (property.name == "Mute") is_muted = property.integer != 0;
    if (property.name == "BlendMode") layer.is_override = property.integer != 0;
    if (property.name == "RotationAccumulationMode") layer.adds_angles = property.integer == 1;
    if (property.name == "ScaleAccumulationMode") layer.adds_scales = property.integer == 1;
  }
  return layer;
}

void add_layer(AnimationBuilder& builder, int layer_object) {
  FbxAnimation& animation = builder.animation;
  bool is_muted = false;
  const FbxLayer layer = layer_of(
      builder.document, builder.objects.objects[static_cast<size_t>(layer_object)].node, is_muted);
  const int index = static_cast<int>(animation.layers.size());
  animation.layers.push_back(layer);
  if (is_muted) return;
  for (const int c : builder.objects.to[static_cast<size_t>(layer_object)]) {
    const int curve_node = builder.objects.connections[static_cast<size_t>(c)].child;
    if (builder.objects.objects[static_cast<size_t>(curve_node)].kind != "AnimationCurveNode") {
      continue;
    }
    for (const int p : builder.objects.from[static_cast<size_t>(curve_node)]) {
      const FbxConnection& use = builder.objects.connections[static_cast<size_t>(p)];
      const std::optional<Part> part = part_of(use.property);
      const int model = use.parent < 0 ? -1 : builder.model_of[static_cast<size_t>(use.parent)];
      if (!part || model < 0) continue;
      require_few_tracks(builder);
      FbxTrack track = track_of(builder, curve_node);
      track.model = model;
      track.part = *part;
      track.layer = index;
      animation.tracks.push_back(std::move(track));
    }
  }
}

void add_stack(AnimationBuilder& builder, int stack) {
  for (const int c : builder.objects.to[static_cast<size_t>(stack)]) {
    const int child = builder.objects.connections[static_cast<size_t>(c)].child;
    if (builder.objects.objects[static_cast<size_t>(child)].kind == "AnimationLayer") {
      add_layer(builder, child);
    }
  }
}

/// The child "Channel" of that name; 0 if there is none.
std::uint32_t channel(const FbxDocument& document, std::uint32_t node, std::string_view name) {
  for (std::uint32_t child = first_child(node); child < document.nodes[node].end;
       child = document.nodes[child].end) {
    if (document.nodes[child].name == "Channel" && text_of(document, child, 0) == name) {
      return child;
    }
  }
  return 0;
}

void add_old_tracks(AnimationBuilder& builder, std::uint32_t node, int model) {
  const FbxDocument& document = builder.document;
  const std::uint32_t transform = channel(document, node, "Transform");
  if (transform == 0) return;
  constexpr std::pair<std::string_view, Part> parts[] = {
      {"T", Part::translation}, {"R", Part::rotation}, {"S", Part::scale}};
  for (const auto& [name, part] : parts) {
    const std::uint32_t of_part = channel(document, transform, name);
    if (of_part == 0) continue;
    FbxTrack track;
    track.model = model;
    track.part = part;
    for (size_t axis = 0; axis < 3; ++axis) {
      constexpr std::string_view axes[] = {"X", "Y", "Z"};
      const std::uint32_t component = channel(document, of_part, axes[axis]);
      if (component == 0) continue;
      FbxCurve curve = parse_old_fbx_curve(document, component);
      count_keys(builder, component, curve.keys.size());
      track.curves[axis] = add_curve(builder, std::move(curve));
      if (const std::uint32_t usual = find_child(document, component, "Default")) {
        track.constants[axis] = number_of(document, usual, 0);
      }
    }
    builder.animation.tracks.push_back(track);
  }
}

void add_old_take(AnimationBuilder& builder, std::uint32_t take) {
  builder.animation.layers.push_back({});
  const FbxDocument& document = builder.document;
  for (std::uint32_t node = first_child(take); node < document.nodes[take].end;
       node = document.nodes[node].end) {
    if (document.nodes[node].name != "Model") continue;
    const int object = builder.objects.find_by_full_name(text_of(document, node, 0));
    const int model = object < 0 ? -1 : builder.model_of[static_cast<size_t>(object)];
    if (model >= 0) add_old_tracks(builder, node, model);
  }
}

Vec3& vector_of(FbxMoving& moving, Part part) {
  if (part == Part::translation) return moving.translation;
  return part == Part::rotation ? moving.rotation : moving.scale;
}

/// The vector of a track at a time; components that it does not have stay as they are.
Vec3 value_of(const FbxAnimation& animation, const FbxTrack& track, std::int64_t time, Vec3 value) {
  for (size_t axis = 0; axis < 3; ++axis) {
    double& component = value[static_cast<int>(axis)];
    if (track.curves[axis] >= 0) {
      component = value_at(animation.curves[static_cast<size_t>(track.curves[axis])], time);
    } else if (track.constants[axis]) {
      component = *track.constants[axis];
    }
  }
  return value;
}

void apply_layer(const FbxAnimation& animation, const FbxTrack& track, const FbxModel& model,
                 std::int64_t time, FbxMoving& moving) {
  const FbxLayer& layer = animation.layers[static_cast<size_t>(track.layer)];
  Vec3& below = vector_of(moving, track.part);
  if (layer.is_override) {
    const Vec3 value = value_of(animation, track, time, below);
    below += layer.weight * (value - below);
    if (track.part == Part::rotation) {
      moving.layered_rotation = slerp(moving.layered_rotation, Quat::Identity(), layer.weight);
    }
    return;
  }
  const bool is_scale = track.part == Part::scale;
  const Vec3 none = is_scale && !layer.adds_scales ? Vec3(Vec3::Ones()) : Vec3(Vec3::Zero());
  const Vec3 value = value_of(animation, track, time, none);
  if (track.part == Part::rotation && !layer.adds_angles) {
    const Quat turn = rotation_of_angles(layer.weight * value, model.rotation_order);
    moving.layered_rotation = (moving.layered_rotation * turn).normalized();
  } else if (is_scale && !layer.adds_scales) {
    below = below.cwiseProduct(none + layer.weight * (value - none));
  } else {
    below += layer.weight * value;
  }
}

}  // namespace

std::vector<FbxTake> fbx_takes(const FbxDocument& document, const FbxObjects& objects) {
  std::vector<FbxTake> takes;
  TakenNames names;
  for (size_t o = 0; o < objects.objects.size(); ++o) {
    const FbxObject& object = objects.objects[o];
    if (object.kind != "AnimationStack") continue;
    add_take(stack_take(document, object, static_cast<int>(o)), names, takes);
  }
  const std::uint32_t section = find_child(document, 0, "Takes");
  if (!takes.empty() || section == 0 || document.version >= 7000) return takes;
  for (std::uint32_t node = first_child(section); node < document.nodes[section].end;
       node = document.nodes[node].end) {
    if (document.nodes[node].name != "Take") continue;
    FbxTake take{decoded(document, text_of(document, node, 0)), node, -1, 0, 0};
    if (const std::uint32_t span = find_child(document, node, "LocalTime")) {
      take.start = integer_of(document, span, 0);
      take.stop = integer_of(document, span, 1);
    }
    add_take(std::move(take), names, takes);
  }
  return takes;
}

FbxAnimation parse_fbx_animation(const FbxDocument& document, const FbxObjects& objects,
                                 const std::vector<FbxModel>& models, const FbxTake& take) {
  AnimationBuilder builder{document, objects, std::vector<int>(objects.objects.size(), -1), {}, {}};
  for (size_t m = 0; m < models.size(); ++m) {
    builder.model_of[static_cast<size_t>(models[m].object)] = static_cast<int>(m);
  }
  if (take.object >= 0) {
    add_stack(builder, take.object);
  } else {
    add_old_take(builder, take.node);
  }
  return std::move(builder.animation);
}

bool moves(const FbxAnimation& animation, const FbxTrack& track) {
  return std::any_of(track.curves.begin(), track.curves.end(), [&](int curve) {
    return curve >= 0 && changes(animation.curves[static_cast<size_t>(curve)]);
  });
}

void apply(const FbxAnimation& animation, const std::vector<FbxModel>& models, std::int64_t time,
           std::vector<FbxMoving>& moving) {
  // Layers add to what those below them give.
  if (animation.layers.size() > 1) {
    for (size_t m = 0; m < models.size(); ++m) moving[m] = at_rest(models[m]);
  }
  for (const FbxTrack& track : animation.tracks) {
    const auto m = static_cast<size_t>(track.model);
    if (track.layer > 0) {
      apply_layer(animation, track, models[m], time, moving[m]);
      continue;
    }
    Vec3& vector = vector_of(moving[m], track.part);
    vector = value_of(animation, track, time, vector);
  }
}

}  // namespace mien::motion
