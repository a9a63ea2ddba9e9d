#include "scenes/mannequin/largest_component.h"

#include <algorithm>
#include <numeric>

namespace mien::scenes {

namespace {

/// Vertices that triangles connect.
struct Pieces {
  std::vector<int> above;

  explicit Pieces(size_t count) : above(count) { std::iota(above.begin(), above.end(), 0); }

  int of(int vertex) {
    while (up(vertex) != vertex) vertex = up(vertex) = up(up(vertex));
    return vertex;
  }

  void join(int a, int b) { up(of(a)) = of(b); }

  int& up(int vertex) { return above[static_cast<size_t>(vertex)]; }
};

}  // namespace

Surface largest_component(Surface surface) {
  const size_t count = surface.positions.size();
  Pieces pieces(count);
  for (const auto& [a, b, c] : surface.triangles) {
    pieces.join(a, b);
    pieces.join(b, c);
  }
  std::vector<int> sizes(count, 0);
  for (size_t v = 0; v < count; ++v) ++sizes[static_cast<size_t>(pieces.of(static_cast<int>(v)))];
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  if (largest == sizes.end() || static_cast<size_t>(*largest) == count) return surface;
  const auto kept = static_cast<int>(largest - sizes.begin());
  Surface result;
  std::vector<int> place(count, -1);
  for (size_t v = 0; v < count; ++v) {
    if (pieces.of(static_cast<int>(v)) != kept) continue;
    place[v] = static_cast<int>(result.positions.size());
    result.positions.push_back(surface.positions[v]);
    result.normals.push_back(surface.normals[v]);
  }
  for (std::array<int, 3> triangle : surface.triangles) {
    for (int& vertex : triangle) vertex = place[static_cast<size_t>(vertex)];
    if (triangle[0] >= 0) result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace mien::scenes
