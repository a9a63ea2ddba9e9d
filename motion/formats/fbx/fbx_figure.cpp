#include "motion/formats/fbx/fbx_figure.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "motion/error.h"
#include "motion/formats/reading/chosen_figure.h"

namespace mien::motion {

namespace {

bool is_limb(const FbxModel& model) {
  return model.kind == "LimbNode" || model.kind == "Limb" || model.kind == "Root";
}

bool is_device(const FbxModel& model) {
  return model.kind.starts_with("Camera") || model.kind.starts_with("Light");
}

std::vector<int> models_of_objects(const FbxScene& scene) {
  std::vector<int> model_of(scene.objects.objects.size(), -1);
  for (size_t m = 0; m < scene.models.size(); ++m) {
    model_of[static_cast<size_t>(scene.models[m].object)] = static_cast<int>(m);
  }
  return model_of;
}

/// The bones of each skin.
std::vector<std::vector<int>> bones_of_skins(const FbxScene& scene) {
  const FbxObjects& objects = scene.objects;
  const std::vector<int> model_of = models_of_objects(scene);
  std::vector<std::vector<int>> skins;
  // Clusters that skins share could make them larger than the file.
  size_t left = objects.connections.size();
  for (size_t o = 0; o < objects.objects.size(); ++o) {
    if (objects.objects[o].sub_kind != "Skin") continue;
    std::vector<int> bones;
    for (const int c : objects.to[o]) {
      if (left == 0) break;
      const int cluster = objects.connections[static_cast<size_t>(c)].child;
      for (const int b : objects.to[static_cast<size_t>(cluster)]) {
        const int bone =
            model_of[static_cast<size_t>(objects.connections[static_cast<size_t>(b)].child)];
        if (bone >= 0 && left > 0) bones.push_back(bone);
        if (left == 0) break;
        --left;
      }
    }
    if (!bones.empty()) skins.push_back(std::move(bones));
  }
  return skins;
}

std::vector<int> depths(const FbxScene& scene) {
  std::vector<int> depth(scene.models.size(), 0);
  for (const int m : scene.parents_first) {
    const int parent = scene.models[static_cast<size_t>(m)].parent;
    if (parent >= 0) depth[static_cast<size_t>(m)] = depth[static_cast<size_t>(parent)] + 1;
  }
  return depth;
}

int common_ancestor(const FbxScene& scene, const std::vector<int>& depth, int a, int b) {
  while (a >= 0 && b >= 0 && a != b) {
    int& deeper = depth[static_cast<size_t>(a)] >= depth[static_cast<size_t>(b)] ? a : b;
    deeper = scene.models[static_cast<size_t>(deeper)].parent;
  }
  return a == b ? a : -1;
}

/// Marks the models that connect the bones of each skin.
void mark_common_roots(const FbxScene& scene, std::vector<bool>& is_root) {
  const std::vector<int> depth = depths(scene);
  for (const std::vector<int>& bones : bones_of_skins(scene)) {
    int root = bones.front();
    for (const int bone : bones) {
      if (root >= 0) root = common_ancestor(scene, depth, root, bone);
    }
    if (root >= 0) is_root[static_cast<size_t>(root)] = true;
  }
}

/// For each model the root of the figure that it belongs to, −1 if it is in none.
std::vector<int> roots_of(const FbxScene& scene, const std::vector<bool>& is_joint) {
  std::vector<bool> is_root = is_joint;
  mark_common_roots(scene, is_root);
  std::vector<int> root(scene.models.size(), -1);
  for (const int m : scene.parents_first) {
    const int parent = scene.models[static_cast<size_t>(m)].parent;
    int& own = root[static_cast<size_t>(m)];
    if (parent >= 0) own = root[static_cast<size_t>(parent)];
    if (own < 0 && is_root[static_cast<size_t>(m)]) own = m;
  }
  return root;
}

/// The root of the figure that is asked for, else of the one with the most joints.
int chosen_root(const FbxScene& scene, const std::vector<bool>& is_joint,
                const std::vector<int>& root, const std::optional<std::string>& wanted,
                Recording& recording) {
  std::vector<int> sizes(scene.models.size(), 0);
  for (size_t m = 0; m < scene.models.size(); ++m) {
    if (is_joint[m] && root[m] >= 0) ++sizes[static_cast<size_t>(root[m])];
  }
  const auto largest = std::ranges::max_element(sizes);
  if (largest == sizes.end() || *largest == 0) {
    throw Error({scene.document.file}, "holds no skeleton and nothing that moves",
                "export the skeleton with its motion");
  }
  std::vector<int> roots;
  std::vector<std::string> names;
  for (const int m : scene.parents_first) {
    if (m != largest - sizes.begin() && sizes[static_cast<size_t>(m)] < 2) continue;
    roots.push_back(m);
    names.push_back(scene.models[static_cast<size_t>(m)].name);
  }
  const auto first = std::ranges::find(roots, static_cast<int>(largest - sizes.begin()));
  return roots[chosen_figure({scene.document.file}, names,
                             static_cast<size_t>(first - roots.begin()), wanted, recording)];
}

/// An end as exporters of bones write it: "HeadTop_End", "Bip01 ToeNub".
bool is_called_end(std::string_view name) {
  std::string lower;
  for (const char c : name) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string_view ending : {"end", "nub", "tip", "site"}) {
    if (lower.ends_with(ending)) return true;
  }
  return false;
}

void keep(const std::vector<bool>& kept, FbxFigure& figure) {
  std::vector<int> index(figure.joints.size(), -1);
  FbxFigure left{figure.above, {}, {}};
  for (size_t j = 0; j < figure.joints.size(); ++j) {
    if (!kept[j]) continue;
    index[j] = static_cast<int>(left.joints.size());
    left.joints.push_back(figure.joints[j]);
    const int parent = figure.parents[j];
    left.parents.push_back(parent < 0 ? -1 : index[static_cast<size_t>(parent)]);
  }
  figure = std::move(left);
}

bool has_geometry(const FbxScene& scene, int model) {
  const int object = scene.models[static_cast<size_t>(model)].object;
  const auto& to = scene.objects.to[static_cast<size_t>(object)];
  return std::any_of(to.begin(), to.end(), [&](int c) {
    const int child = scene.objects.connections[static_cast<size_t>(c)].child;
    return scene.objects.objects[static_cast<size_t>(child)].kind == "Geometry";
  });
}

}  // namespace

std::vector<bool> fbx_joints(const FbxScene& scene, const std::vector<bool>& moved) {
  std::vector<bool> is_joint(scene.models.size(), false);
  for (size_t m = 0; m < scene.models.size(); ++m) is_joint[m] = is_limb(scene.models[m]);
  for (const std::vector<int>& bones : bones_of_skins(scene)) {
    for (const int bone : bones) is_joint[static_cast<size_t>(bone)] = true;
  }
  if (std::ranges::find(is_joint, true) != is_joint.end()) return is_joint;
  for (const int m : scene.parents_first) {
    const FbxModel& model = scene.models[static_cast<size_t>(m)];
    const bool is_below = model.parent >= 0 && is_joint[static_cast<size_t>(model.parent)];
    is_joint[static_cast<size_t>(m)] =
        !is_device(model) && (is_below || moved[static_cast<size_t>(m)]);
  }
  return is_joint;
}

FbxFigure fbx_figure(const FbxScene& scene, const std::vector<bool>& is_joint,
                     const std::optional<std::string>& wanted, Recording& recording) {
  const std::vector<int> root = roots_of(scene, is_joint);
  const int chosen = chosen_root(scene, is_joint, root, wanted, recording);
  std::vector<bool> kept(scene.models.size(), false);
  for (auto m = scene.parents_first.rbegin(); m != scene.parents_first.rend(); ++m) {
    const auto index = static_cast<size_t>(*m);
    if (root[index] != chosen) continue;
    if (is_joint[index] || *m == chosen) kept[index] = true;
    const int parent = scene.models[index].parent;
    if (kept[index] && *m != chosen) kept[static_cast<size_t>(parent)] = true;
  }
  FbxFigure figure;
  std::vector<int> joint_of(scene.models.size(), -1);
  for (const int m : scene.parents_first) {
    if (!kept[static_cast<size_t>(m)]) continue;
    const int parent = scene.models[static_cast<size_t>(m)].parent;
    joint_of[static_cast<size_t>(m)] = static_cast<int>(figure.joints.size());
    figure.parents.push_back(m == chosen ? -1 : joint_of[static_cast<size_t>(parent)]);
    figure.joints.push_back(m);
  }
  for (int m = scene.models[static_cast<size_t>(chosen)].parent; m >= 0;
       m = scene.models[static_cast<size_t>(m)].parent) {
    figure.above.push_back(m);
  }
  std::reverse(figure.above.begin(), figure.above.end());
  return figure;
}

void drop_ends(const FbxScene& scene, const std::vector<bool>& moved, FbxFigure& figure) {
  std::vector<bool> kept(figure.joints.size(), true);
  for (size_t j = 1; j < figure.joints.size(); ++j) {
    const int model = figure.joints[j];
    const int parent = scene.models[static_cast<size_t>(model)].parent;
    kept[j] = !(is_called_end(scene.models[static_cast<size_t>(model)].name) &&
                fbx_tip(scene, moved, parent) == model);
  }
  keep(kept, figure);
}

int fbx_tip(const FbxScene& scene, const std::vector<bool>& moved, int joint) {
  const std::vector<int>& children = scene.models[static_cast<size_t>(joint)].children;
  if (children.size() != 1) return -1;
  const int child = children.front();
  const FbxModel& model = scene.models[static_cast<size_t>(child)];
  const bool is_end = model.children.empty() && !is_device(model) &&
                      !moved[static_cast<size_t>(child)] && !has_geometry(scene, child);
  return is_end ? child : -1;
}

}  // namespace mien::motion
