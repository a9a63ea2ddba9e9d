#include "motion/formats/fbx/fbx_model.h"

#include <array>
#include <utility>

#include "motion/error.h"

namespace mien::motion {

namespace {

constexpr size_t most_models = 131'072;

constexpr std::pair<std::string_view, Vec3 FbxModel::*> vectors[] = {
    {"Lcl Translation", &FbxModel::translation},
    {"Lcl Rotation", &FbxModel::rotation},
    {"Lcl Scaling", &FbxModel::scale},
    {"RotationOffset", &FbxModel::rotation_offset},
    {"RotationPivot", &FbxModel::rotation_pivot},
    {"PreRotation", &FbxModel::pre_rotation},
    {"PostRotation", &FbxModel::post_rotation},
    {"ScalingOffset", &FbxModel::scaling_offset},
    {"ScalingPivot", &FbxModel::scaling_pivot},
    {"GeometricTranslation", &FbxModel::geometric_translation},
    {"GeometricRotation", &FbxModel::geometric_rotation},
    {"GeometricScaling", &FbxModel::geometric_scaling},
};

void apply(const FbxDocument& document, std::uint32_t node, const FbxProperty& property,
           FbxModel& model) {
  if (property.count == 3) {
    for (const auto& [name, vector] : vectors) {
      if (property.name != name) continue;
      model.*vector = {property.numbers[0], property.numbers[1], property.numbers[2]};
      if ((model.*vector).cwiseAbs().maxCoeff() > 1e12) {
        refuse_fbx(document, node, "a number of a model is too large");
      }
      return;
    }
  }
  if (property.count == 0) return;
  if (property.name == "RotationOrder") {
    model.rotation_order =
        property.integer >= 0 && property.integer <= 5 ? static_cast<int>(property.integer) : 0;
  } else if (property.name == "RotationActive") {
    model.rotation_is_active = property.integer != 0;
  } else if (property.name == "RotationSpaceForLimitOnly") {
    model.is_for_limits_only = property.integer != 0;
  } else if (property.name == "InheritType") {
    model.inherit = property.integer == 1   ? FbxModel::Inherit::RSrs
                    : property.integer == 2 ? FbxModel::Inherit::Rrs
                                            : FbxModel::Inherit::RrSs;
  }
}

void settle_rotation(FbxModel& model) {
  if (!model.rotation_is_active || model.is_for_limits_only) {
    model.rotation_order = 0;
    return;
  }
  model.before = rotation_of_angles(model.pre_rotation, 0);
  model.after = rotation_of_angles(model.post_rotation, 0).conjugate();
}

void find_parents(const FbxObjects& objects, const std::vector<int>& model_of,
                  std::vector<FbxModel>& models) {
  for (const FbxConnection& connection : objects.connections) {
    const int child = model_of[static_cast<size_t>(connection.child)];
    const int parent =
        connection.parent < 0 ? -1 : model_of[static_cast<size_t>(connection.parent)];
    if (child < 0 || parent < 0 || !connection.property.empty()) continue;
    FbxModel& model = models[static_cast<size_t>(child)];
    if (model.parent >= 0) continue;
    model.parent = parent;
    models[static_cast<size_t>(parent)].children.push_back(child);
  }
}

void require_tree(const FbxDocument& document, const std::vector<FbxModel>& models) {
  constexpr size_t deepest = 1024;
  const std::vector<int> order = parents_first(models);
  if (order.size() != models.size()) {
    throw Error({document.file}, "models are connected in a circle", fbx_again);
  }
  std::vector<size_t> depth(models.size(), 0);
  for (const int model : order) {
    const int parent = models[static_cast<size_t>(model)].parent;
    if (parent >= 0) depth[static_cast<size_t>(model)] = depth[static_cast<size_t>(parent)] + 1;
    if (depth[static_cast<size_t>(model)] > deepest) {
      throw Error({document.file}, "models hang on each other more than 1024 deep",
                  "export the figure alone");
    }
  }
}

Quat about(const Vec3& axis, double degrees) {
  return Quat(Eigen::AngleAxisd(degrees * radians_per_degree, axis));
}

}  // namespace

FbxMoving at_rest(const FbxModel& model) {
  return {model.translation, model.rotation, model.scale, Quat::Identity()};
}

Quat rotation_of_angles(const Vec3& degrees, int order) {
  // The axis that is applied first stands first.
  constexpr std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
  Quat rotation = Quat::Identity();
  for (const int axis : orders[static_cast<size_t>(order)]) {
    rotation = about(Vec3::Unit(axis), degrees[axis]) * rotation;
  }
  return rotation.normalized();
}

FbxPlace place_below(const FbxPlace& parent, const FbxModel& model, const FbxMoving& moving) {
  const Quat rotation = model.before * rotation_of_angles(moving.rotation, model.rotation_order) *
                        moving.layered_rotation * model.after;
  const Mat3 turn = rotation.toRotationMatrix();
  const Vec3 scaled_pivot = model.scaling_pivot - moving.scale.cwiseProduct(model.scaling_pivot);
  const Vec3 local = moving.translation + model.rotation_offset + model.rotation_pivot +
                     turn * (model.scaling_offset + scaled_pivot - model.rotation_pivot);
  FbxPlace place;
  place.position = parent.position + parent.linear * local;
  place.rotation = (parent.rotation * rotation).normalized();
  place.own_scale = moving.scale;
  const Mat3 own = moving.scale.asDiagonal();
  if (model.inherit == FbxModel::Inherit::RSrs) {
    place.linear = parent.linear * turn * own;
    return place;
  }
  Mat3 inherited = parent.rotation.toRotationMatrix().transpose() * parent.linear;
  if (model.inherit == FbxModel::Inherit::Rrs) {
    for (int axis = 0; axis < 3; ++axis) {
      if (parent.own_scale[axis] != 0.0) inherited.col(axis) /= parent.own_scale[axis];
    }
  }
  place.linear = parent.rotation.toRotationMatrix() * turn * inherited * own;
  return place;
}

std::vector<FbxModel> parse_fbx_models(const FbxDocument& document, const FbxObjects& objects) {
  FbxModel usual;
  const std::uint32_t defaults = template_of(document, "Model");
  if (defaults != 0) {
    for (const FbxProperty& property : properties_of(document, defaults)) {
      apply(document, defaults, property, usual);
    }
  }
  std::vector<FbxModel> models;
  std::vector<int> model_of(objects.objects.size(), -1);
  for (size_t o = 0; o < objects.objects.size(); ++o) {
    const FbxObject& object = objects.objects[o];
    if (object.kind != "Model") continue;
    if (models.size() == most_models) {
      throw Error({document.file}, "has more than 131072 models", "export the figure alone");
    }
    FbxModel model = usual;
    model.object = static_cast<int>(o);
    model.name = object.name;
    model.kind = object.sub_kind;
    for (const FbxProperty& property : properties_of(document, object.node)) {
      apply(document, object.node, property, model);
    }
    settle_rotation(model);
    model_of[o] = static_cast<int>(models.size());
    models.push_back(std::move(model));
  }
  find_parents(objects, model_of, models);
  require_tree(document, models);
  return models;
}

std::vector<int> parents_first(const std::vector<FbxModel>& models) {
  std::vector<int> order;
  std::vector<int> open;
  for (size_t m = models.size(); m-- > 0;) {
    if (models[m].parent < 0) open.push_back(static_cast<int>(m));
  }
  while (!open.empty()) {
    const int model = open.back();
    open.pop_back();
    order.push_back(model);
    const std::vector<int>& children = models[static_cast<size_t>(model)].children;
    open.insert(open.end(), children.rbegin(), children.rend());
  }
  return order;
}

}  // namespace mien::motion
