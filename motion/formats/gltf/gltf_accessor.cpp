#include "motion/formats/gltf/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace mien::motion {

namespace {

using Bytes = std::span<const unsigned char>;

[[noreturn]] void refuse_use(const GltfFile& file, std::string_view use, std::string_view wrong) {
  refuse(file, std::string(use) + ": " + std::string(wrong), get_it_again);
}

const tinygltf::Accessor& accessor_at(const GltfFile& file, int index, std::string_view use) {
  if (index < 0 || static_cast<size_t>(index) >= file.model.accessors.size()) {
    refuse_use(file, use, "there is no accessor " + std::to_string(index));
  }
  return file.model.accessors[static_cast<size_t>(index)];
}

Bytes bytes_of_view(const GltfFile& file, int index, std::string_view use) {
  const auto& views = file.model.bufferViews;
  if (index < 0 || static_cast<size_t>(index) >= views.size()) {
    refuse_use(file, use, "there is no buffer view " + std::to_string(index));
  }
  const tinygltf::BufferView& view = views[static_cast<size_t>(index)];
  const auto& buffers = file.model.buffers;
  if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= buffers.size()) {
    refuse_use(file, use, "there is no buffer " + std::to_string(view.buffer));
  }
  const Bytes bytes(buffers[static_cast<size_t>(view.buffer)].data);
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
    refuse_use(file, use, "a buffer view reaches beyond its buffer");
  }
  return bytes.subspan(view.byteOffset, view.byteLength);
}

/// Elements of equal size at equal distances.
struct Elements {
  Bytes bytes;
  size_t stride = 0;

  const unsigned char* at(size_t i) const { return bytes.data() + i * stride; }
};

Elements elements_of(const GltfFile& file, Bytes view, size_t offset, size_t size, size_t stride,
                     size_t count, std::string_view use) {
  if (stride == 0) stride = size;
  const bool fits =
      count == 0 || (stride >= size && offset <= view.size() && size <= view.size() - offset &&
                     (count - 1) <= (view.size() - offset - size) / stride);
  if (!fits) refuse_use(file, use, "an accessor reaches beyond its buffer view");
  return {count == 0 ? Bytes{} : view.subspan(offset), stride};
}

template <typename T>
T value_at(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// An integer as it stands, or where integers are normalised as a share of the largest of its type.
template <typename T>
double integer_at(const unsigned char* bytes, bool normalized) {
  const double number = value_at<T>(bytes);
  return normalized ? std::max(number / std::numeric_limits<T>::max(), -1.0) : number;
}

double number_at(const unsigned char* bytes, const tinygltf::Accessor& accessor) {
  switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return value_at<float>(bytes);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return integer_at<std::int8_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return integer_at<std::uint8_t>(bytes, accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return integer_at<std::int16_t>(bytes, accessor.normalized);
    default:
      return integer_at<std::uint16_t>(bytes, accessor.normalized);
  }
}

/// Bytes of one number, or 0 when the accessor's type is not one that animations have.
size_t size_of_number(const tinygltf::Accessor& accessor) {
  const auto type = static_cast<std::uint32_t>(accessor.componentType);
  const int size = tinygltf::GetComponentSizeInBytes(type);
  const bool is_small = size == 1 || size == 2;
  return is_small || type == TINYGLTF_COMPONENT_TYPE_FLOAT ? static_cast<size_t>(size) : 0;
}

size_t components_of(const tinygltf::Accessor& accessor) {
  // Columns of shorter numbers would be padded; only floats are taken.
  const bool is_matrix = accessor.type == TINYGLTF_TYPE_MAT4 &&
                         accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  for (const int vector :
       {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4})
    if (accessor.type == vector)
      return static_cast<size_t>(
          tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(vector)));
  return is_matrix ? 16 : 0;
}

size_t size_of_index(const GltfFile& file, int type, std::string_view use) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 1;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return 2;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return 4;
  refuse_use(file, use, "indices of a type that glTF does not support");
}

size_t index_at(const unsigned char* bytes, size_t size) {
  if (size == 1) return *bytes;
  return size == 2 ? value_at<std::uint16_t>(bytes) : value_at<std::uint32_t>(bytes);
}

void copy_element(const unsigned char* bytes, const tinygltf::Accessor& accessor,
                  size_t number_size, std::span<double> element) {
  for (size_t c = 0; c < element.size(); ++c) {
    element[c] = number_at(bytes + c * number_size, accessor);
  }
}

void put_sparse_values(const GltfFile& file, const tinygltf::Accessor& accessor, size_t components,
                       std::string_view use, std::vector<double>& numbers) {
  const auto& sparse = accessor.sparse;
  // Some versions of the library count these bytes with a sign, some without.
  const auto indices_offset = static_cast<std::int64_t>(sparse.indices.byteOffset);
  const auto values_offset = static_cast<std::int64_t>(sparse.values.byteOffset);
  if (sparse.count < 0 || indices_offset < 0 || values_offset < 0) {
    refuse_use(file, use, "a sparse accessor with negative numbers");
  }
  const auto count = static_cast<size_t>(sparse.count);
  const size_t number_size = size_of_number(accessor);
  const size_t index_size = size_of_index(file, sparse.indices.componentType, use);
  const Elements indices =
      elements_of(file, bytes_of_view(file, sparse.indices.bufferView, use),
                  static_cast<size_t>(indices_offset), index_size, index_size, count, use);
  const Elements values =
      elements_of(file, bytes_of_view(file, sparse.values.bufferView, use),
                  static_cast<size_t>(values_offset), number_size * components, 0, count, use);
  for (size_t i = 0; i < count; ++i) {
    const size_t index = index_at(indices.at(i), index_size);
    if (index >= accessor.count) refuse_use(file, use, "a sparse index beyond the accessor's end");
    copy_element(values.at(i), accessor, number_size,
                 std::span(numbers).subspan(index * components, components));
  }
}

}  // namespace

size_t accessor_count(const GltfFile& file, int accessor, std::string_view use) {
  return accessor_at(file, accessor, use).count;
}

std::vector<double> accessor_numbers(const GltfFile& file, int index, size_t components,
                                     std::string_view use) {
  const tinygltf::Accessor& accessor = accessor_at(file, index, use);
  const size_t number_size = size_of_number(accessor);
  if (number_size == 0 || components_of(accessor) != components) {
    refuse_use(file, use, "an accessor of an unsuitable type");
  }
  // Without a buffer view the values are zeros, so nothing in the file bounds their number.
  constexpr size_t most_zeros = 1 << 20;
  if (accessor.bufferView < 0 && accessor.count > most_zeros) {
    refuse_use(file, use, "an accessor without a buffer view has too many elements");
  }
  Elements elements;
  if (accessor.bufferView >= 0) {
    const Bytes view = bytes_of_view(file, accessor.bufferView, use);
    const auto stride = file.model.bufferViews[static_cast<size_t>(accessor.bufferView)].byteStride;
    elements = elements_of(file, view, accessor.byteOffset, number_size * components, stride,
                           accessor.count, use);
  }
  std::vector<double> numbers(accessor.count * components, 0.0);
  for (size_t i = 0; i < accessor.count && accessor.bufferView >= 0; ++i) {
    copy_element(elements.at(i), accessor, number_size,
                 std::span(numbers).subspan(i * components, components));
  }
  if (accessor.sparse.isSparse) put_sparse_values(file, accessor, components, use, numbers);
  if (!std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); })) {
    refuse_use(file, use, "a number that is not finite");
  }
  return numbers;
}

std::vector<int> accessor_indices(const GltfFile& file, int index, size_t components,
                                  std::string_view use) {
  const tinygltf::Accessor& accessor = accessor_at(file, index, use);
  const size_t size = size_of_index(file, accessor.componentType, use);
  const bool is_plain = accessor.bufferView >= 0 && !accessor.sparse.isSparse;
  if (!is_plain || components_of(accessor) != components) {
    refuse_use(file, use, "an accessor of an unsuitable type");
  }
  const Bytes view = bytes_of_view(file, accessor.bufferView, use);
  const auto stride = file.model.bufferViews[static_cast<size_t>(accessor.bufferView)].byteStride;
  const Elements elements =
      elements_of(file, view, accessor.byteOffset, size * components, stride, accessor.count, use);
  std::vector<int> indices;
  indices.reserve(accessor.count * components);
  for (size_t i = 0; i < accessor.count; ++i) {
    for (size_t c = 0; c < components; ++c) {
      const size_t value = index_at(elements.at(i) + c * size, size);
      if (value > std::numeric_limits<int>::max()) refuse_use(file, use, "an index is too large");
      indices.push_back(static_cast<int>(value));
    }
  }
  return indices;
}

std::span<const unsigned char> buffer_view_bytes(const GltfFile& file, int view,
                                                 std::string_view use) {
  return bytes_of_view(file, view, use);
}

}  // namespace mien::motion
