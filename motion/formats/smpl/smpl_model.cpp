#include "motion/formats/smpl/smpl_model.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/formats/numpy/npz.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

using Shape = std::vector<std::size_t>;

constexpr std::string_view name_model =
    "name an SMPL, SMPL-H or SMPL-X model in .npz form as body_model";

const NpyArray& required(const Npz& model, std::string_view name, std::size_t dimensions) {
  const NpyArray* const array = find_array(model, name);
  if (!array)
    throw Error({model.file}, "is no SMPL model: it has no array " + in_quotes(name), name_model);
  require_readable(*array, {model.file});
  if (array->shape.size() != dimensions)
    throw Error({model.file},
                described(*array) + " has the shape " + shape_text(*array) + ", not " +
                    std::to_string(dimensions) + " dimensions",
                name_model);
  return *array;
}

void require_shape(const Npz& model, const NpyArray& array, const Shape& wanted) {
  if (array.shape == wanted) return;
  NpyArray expected;
  expected.shape = wanted;
  throw Error(
      {model.file},
      described(array) + " has the shape " + shape_text(array) + ", not " + shape_text(expected),
      name_model);
}

std::vector<double> finite_numbers(const Npz& model, const NpyArray& array) {
  std::vector<double> numbers = numbers_of(array, {model.file});
  if (std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::abs(n) < 1e12; }))
    return numbers;
  throw Error({model.file}, described(array) + " holds numbers that are not finite", name_model);
}

/// v_template + Σ betas · shapedirs, three numbers a vertex.
std::vector<double> shaped_vertices(const Npz& model, std::span<const double> betas) {
  const NpyArray& rest = required(model, "v_template", 2);
  const std::size_t count = rest.shape[0];
  require_shape(model, rest, {count, 3});
  std::vector<double> vertices = finite_numbers(model, rest);
  const NpyArray& directions = required(model, "shapedirs", 3);
  const std::size_t coefficients = directions.shape[2];
  require_shape(model, directions, {count, 3, coefficients});
  const std::size_t used = std::min(coefficients, betas.size());
  if (used == 0) return vertices;
  const std::vector<double> shapes = finite_numbers(model, directions);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = 0; k < used; ++k) vertices[i] += betas[k] * shapes[i * coefficients + k];
  return vertices;
}

std::vector<Vec3> joints_of(const Npz& model, const std::vector<double>& vertices) {
  const NpyArray& regressor = required(model, "J_regressor", 2);
  const std::size_t count = vertices.size() / 3;
  require_shape(model, regressor, {regressor.shape[0], count});
  const std::vector<double> weights = finite_numbers(model, regressor);
  std::vector<Vec3> joints(regressor.shape[0], Vec3::Zero());
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (std::size_t v = 0; v < count; ++v) {
      const double weight = weights[j * count + v];
      if (weight == 0.0) continue;
      joints[j] += weight * Vec3(vertices[3 * v], vertices[3 * v + 1], vertices[3 * v + 2]);
    }
  return joints;
}

void require_parents(const Npz& model, const Skeleton& expected) {
  const NpyArray& table = required(model, "kintree_table", 2);
  require_shape(model, table, {2, expected.joints.size()});
  const std::vector<double> parents = numbers_of(table, {model.file});
  for (std::size_t j = 1; j < expected.joints.size(); ++j) {
    if (parents[j] == expected.joints[j].parent) continue;
    throw Error(
        {model.file},
        "its kintree_table gives joint " + std::to_string(j) + " another parent than SMPL has",
        name_model);
  }
}

WantedArrays model_arrays() {
  return WantedArrays({"v_template", "shapedirs", "J_regressor", "kintree_table"});
}

void set_proportions(Skeleton& skeleton, const Npz& model, std::span<const double> betas) {
  const std::vector<Vec3> joints = joints_of(model, shaped_vertices(model, betas));
  if (joints.size() == 22 || !is_smpl_joint_count(joints.size()))
    throw Error({model.file}, "has " + std::to_string(joints.size()) + " joints, not 24, 52 or 55",
                name_model);
  const Skeleton known = smpl_skeleton(joints.size());
  require_parents(model, known);
  for (Joint& joint : skeleton.joints) {
    const int j = find_joint(known, joint.name);
    if (j < 0)
      throw Error({model.file},
                  "is a model of " + std::string(smpl_layout_name(joints.size())) +
                      ", which has no joint " + joint.name,
                  "name a model of " + std::string(smpl_layout_name(skeleton.joints.size())) +
                      " as body_model");
    const int parent = known.joints[static_cast<std::size_t>(j)].parent;
    joint.offset = joints[static_cast<std::size_t>(j)];
    if (parent >= 0) joint.offset -= joints[static_cast<std::size_t>(parent)];
    joint.tip.reset();
  }
}

}  // namespace

void set_smpl_proportions(Skeleton& skeleton, std::string_view bytes, const std::string& file_name,
                          std::span<const double> betas) {
  set_proportions(skeleton, parse_npz(bytes, file_name, model_arrays()), betas);
}

void set_smpl_proportions(Skeleton& skeleton, const std::filesystem::path& model,
                          std::span<const double> betas) {
  if (model.extension() == ".pkl")
    throw Error({model.string()}, "holds Python objects, which are never unpickled", name_model);
  set_proportions(skeleton, read_npz(model, model_arrays()), betas);
}

}  // namespace mien::motion
