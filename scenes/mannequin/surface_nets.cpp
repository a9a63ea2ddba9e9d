#include "scenes/mannequin/surface_nets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr int block = 5;          // grid points
constexpr double distrust = 1.3;  // of distances, when they rule a block out
constexpr double gradient_step = 5e-4;
constexpr int newton_steps = 2;

/// An edge of a cube from corner `from` to corner `to`; bit 0, 1, 2 of a corner is x, y, z.
struct CubeEdge {
  int from;
  int to;
  int axis;
};

constexpr std::array<CubeEdge, 12> cube_edges = {{
    {0, 1, 0},
    {2, 3, 0},
    {4, 5, 0},
    {6, 7, 0},
    {0, 2, 1},
    {1, 3, 1},
    {4, 6, 1},
    {5, 7, 1},
    {0, 4, 2},
    {1, 5, 2},
    {2, 6, 2},
    {3, 7, 2},
}};

int edge_between(int a, int b) {
  for (int e = 0; e < 12; ++e) {
    const CubeEdge& edge = cube_edges[static_cast<size_t>(e)];
    if ((edge.from == a && edge.to == b) || (edge.from == b && edge.to == a)) return e;
  }
  return -1;
}

/// For each pattern of inside corners: which sheet each edge belongs to, −1 for edges not crossed.
using Sheets = std::array<int, 12>;

int find_root(const std::array<int, 12>& above, int edge) {
  while (above[static_cast<size_t>(edge)] != edge) edge = above[static_cast<size_t>(edge)];
  return edge;
}

/// Joins the crossed edges of one face whose corners are given in order around it.
void join_face(int inside, const std::array<int, 4>& corners, std::array<int, 12>& above) {
  const auto is_inside = [&](int k) { return (inside >> corners[static_cast<size_t>(k & 3)]) & 1; };
  const auto edge = [&](int k) {
    return edge_between(corners[static_cast<size_t>(k & 3)],
                        corners[static_cast<size_t>((k + 1) & 3)]);
  };
  const auto join = [&](int a, int b) {
    above[static_cast<size_t>(find_root(above, a))] = find_root(above, b);
  };
  std::array<int, 4> crossed{};
  int count = 0;
  for (int k = 0; k < 4; ++k) {
    if (is_inside(k) != is_inside(k + 1)) crossed[static_cast<size_t>(count++)] = edge(k);
  }
  if (count == 2) join(crossed[0], crossed[1]);
  if (count != 4) return;
  for (int k = 0; k < 4; ++k) {
    if (is_inside(k)) join(edge(k + 3), edge(k));
  }
}

Sheets sheets_of(int inside) {
  constexpr std::array<std::array<int, 4>, 6> faces = {
      {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  std::array<int, 12> above{};
  for (int e = 0; e < 12; ++e) above[static_cast<size_t>(e)] = e;
  for (const auto& face : faces) join_face(inside, face, above);
  Sheets sheets;
  sheets.fill(-1);
  std::array<int, 12> number;
  number.fill(-1);
  int count = 0;
  for (int e = 0; e < 12; ++e) {
    const CubeEdge& edge = cube_edges[static_cast<size_t>(e)];
    if (((inside >> edge.from) & 1) == ((inside >> edge.to) & 1)) continue;
    int& of_root = number[static_cast<size_t>(find_root(above, e))];
    if (of_root < 0) of_root = count++;
    sheets[static_cast<size_t>(e)] = of_root;
  }
  return sheets;
}

std::array<Sheets, 256> all_sheets() {
  std::array<Sheets, 256> table;
  for (int inside = 0; inside < 256; ++inside)
    table[static_cast<size_t>(inside)] = sheets_of(inside);
  return table;
}

/// The field at the grid's points.
struct Samples {
  const SignedDistance& field;
  const Grid& grid;
  int nx;
  int ny;
  int nz;
  std::vector<double> values;

  size_t index(int i, int j, int k) const {
    return (static_cast<size_t>(k) * static_cast<size_t>(ny) + static_cast<size_t>(j)) *
               static_cast<size_t>(nx) +
           static_cast<size_t>(i);
  }
  double at(int i, int j, int k) const { return values[index(i, j, k)]; }
  Vec3 point(int i, int j, int k) const {
    return {grid.x[static_cast<size_t>(i)], grid.y[static_cast<size_t>(j)],
            grid.z[static_cast<size_t>(k)]};
  }
};

void sample_block(Samples& samples, std::array<int, 3> first, std::array<int, 3> last) {
  const Vec3 low = samples.point(first[0], first[1], first[2]);
  const Vec3 high = samples.point(last[0], last[1], last[2]);
  const double centre = samples.field(0.5 * (low + high));
  const bool is_near = std::abs(centre) < distrust * 0.5 * (high - low).norm();
  for (int k = first[2]; k <= last[2]; ++k) {
    for (int j = first[1]; j <= last[1]; ++j) {
      for (int i = first[0]; i <= last[0]; ++i) {
        double& value = samples.values[samples.index(i, j, k)];
        value = is_near ? samples.field(samples.point(i, j, k)) : centre;
      }
    }
  }
}

Samples sample(const SignedDistance& field, const Grid& grid) {
  Samples samples{field,
                  grid,
                  static_cast<int>(grid.x.size()),
                  static_cast<int>(grid.y.size()),
                  static_cast<int>(grid.z.size()),
                  {}};
  samples.values.resize(grid.x.size() * grid.y.size() * grid.z.size());
  for (int k = 0; k < samples.nz; k += block) {
    for (int j = 0; j < samples.ny; j += block) {
      for (int i = 0; i < samples.nx; i += block) {
        sample_block(samples, {i, j, k},
                     {std::min(i + block, samples.nx) - 1, std::min(j + block, samples.ny) - 1,
                      std::min(k + block, samples.nz) - 1});
      }
    }
  }
  return samples;
}

/// The vertices that cells own, by cell and sheet.
struct Net {
  const Samples& samples;
  const std::array<Sheets, 256>& table;
  std::unordered_map<size_t, std::array<int, 4>> vertices;
  Surface surface;

  int pattern(int i, int j, int k) const {
    int inside = 0;
    for (int c = 0; c < 8; ++c) {
      if (samples.at(i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2)) < 0.0) inside |= 1 << c;
    }
    return inside;
  }
};

Vec3 crossing(const Samples& samples, std::array<int, 3> a, std::array<int, 3> b) {
  const double va = samples.at(a[0], a[1], a[2]);
  const double vb = samples.at(b[0], b[1], b[2]);
  return samples.point(a[0], a[1], a[2]) +
         va / (va - vb) * (samples.point(b[0], b[1], b[2]) - samples.point(a[0], a[1], a[2]));
}

std::array<int, 3> corner(int i, int j, int k, int c) {
  return {i + (c & 1), j + ((c >> 1) & 1), k + (c >> 2)};
}

void add_cell(Net& net, int i, int j, int k, int inside) {
  const Sheets& sheets = net.table[static_cast<size_t>(inside)];
  std::array<Vec3, 4> sums;
  sums.fill(Vec3::Zero());
  std::array<int, 4> counts{};
  for (size_t e = 0; e < 12; ++e) {
    if (sheets[e] < 0) continue;
    const auto sheet = static_cast<size_t>(sheets[e]);
    sums[sheet] += crossing(net.samples, corner(i, j, k, cube_edges[e].from),
                            corner(i, j, k, cube_edges[e].to));
    ++counts[sheet];
  }
  std::array<int, 4> vertices{-1, -1, -1, -1};
  for (size_t s = 0; s < 4; ++s) {
    if (counts[s] == 0) continue;
    vertices[s] = static_cast<int>(net.surface.positions.size());
    net.surface.positions.push_back(sums[s] / counts[s]);
  }
  net.vertices[net.samples.index(i, j, k)] = vertices;
}

/// The vertex of the sheet that crosses the edge from grid point (i, j, k) along `axis`, in the
/// cell that lies `back` (0 or 1 on each of the other axes) before it.
int vertex_at(const Net& net, std::array<int, 3> point, int axis, int back_u, int back_v) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  std::array<int, 3> cell = point;
  cell[static_cast<size_t>(u)] -= back_u;
  cell[static_cast<size_t>(v)] -= back_v;
  const int from = (back_u << u) | (back_v << v);
  const int edge = edge_between(from, from | (1 << axis));
  const int inside = net.pattern(cell[0], cell[1], cell[2]);
  const int sheet = net.table[static_cast<size_t>(inside)][static_cast<size_t>(edge)];
  return net.vertices.at(net.samples.index(cell[0], cell[1], cell[2]))[static_cast<size_t>(sheet)];
}

/// Two triangles that split the quad along its shorter diagonal.
void add_quad(Surface& surface, const std::array<int, 4>& q) {
  const auto at = [&](size_t k) { return surface.positions[static_cast<size_t>(q[k])]; };
  if ((at(0) - at(2)).squaredNorm() <= (at(1) - at(3)).squaredNorm()) {
    surface.triangles.push_back({q[0], q[1], q[2]});
    surface.triangles.push_back({q[0], q[2], q[3]});
  } else {
    surface.triangles.push_back({q[0], q[1], q[3]});
    surface.triangles.push_back({q[1], q[2], q[3]});
  }
}

void add_quads(Net& net, int i, int j, int k) {
  const std::array<int, 3> size = {net.samples.nx, net.samples.ny, net.samples.nz};
  const std::array<int, 3> point = {i, j, k};
  const bool inside = net.samples.at(i, j, k) < 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, 3> next = point;
    ++next[static_cast<size_t>(axis)];
    if (next[static_cast<size_t>(axis)] >= size[static_cast<size_t>(axis)]) continue;
    if ((net.samples.at(next[0], next[1], next[2]) < 0.0) == inside) continue;
    const auto u = static_cast<size_t>((axis + 1) % 3);
    const auto v = static_cast<size_t>((axis + 2) % 3);
    const bool at_rim =
        point[u] == 0 || point[v] == 0 || point[u] == size[u] - 1 || point[v] == size[v] - 1;
    if (at_rim) continue;
    std::array<int, 4> quad = {vertex_at(net, point, axis, 1, 1), vertex_at(net, point, axis, 0, 1),
                               vertex_at(net, point, axis, 0, 0),
                               vertex_at(net, point, axis, 1, 0)};
    if (!inside) std::swap(quad[1], quad[3]);
    add_quad(net.surface, quad);
  }
}

template <typename Visit>
void for_all(int nx, int ny, int nz, const Visit& visit) {
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) visit(i, j, k);
    }
  }
}

/// The field and its gradient from four values at the corners of a tetrahedron.
struct Slope {
  double value;
  Vec3 gradient;
};

Slope slope_at(const SignedDistance& field, const Vec3& point, double step) {
  Slope slope{0.0, Vec3::Zero()};
  for (const Vec3& corner_direction :
       {Vec3(1, -1, -1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, 1, 1)}) {
    const double value = field(point + step * corner_direction);
    slope.value += 0.25 * value;
    slope.gradient += value / (4.0 * step) * corner_direction;
  }
  return slope;
}

/// Moves a vertex onto the surface, no further than a cell's breadth.
void settle(const SignedDistance& field, double furthest, Vec3& position) {
  const Vec3 start = position;
  for (int step = 0; step < newton_steps; ++step) {
    const Slope slope = slope_at(field, position, gradient_step);
    const Vec3 next =
        position - slope.value / std::max(slope.gradient.squaredNorm(), 0.05) * slope.gradient;
    if ((next - start).norm() > furthest) return;
    position = next;
  }
}

double smallest_spacing(const Grid& grid) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::vector<double>* axis : {&grid.x, &grid.y, &grid.z}) {
    for (size_t i = 1; i < axis->size(); ++i) {
      smallest = std::min(smallest, (*axis)[i] - (*axis)[i - 1]);
    }
  }
  return smallest;
}

}  // namespace

Vec3 field_normal(const SignedDistance& field, const Vec3& point, double step) {
  const Vec3 gradient = slope_at(field, point, step).gradient;
  const double length = gradient.norm();
  return length > 1e-12 ? Vec3(gradient / length) : Vec3::UnitY();
}

Surface surface_nets(const SignedDistance& field, const Grid& grid) {
  static const std::array<Sheets, 256> table = all_sheets();
  const Samples samples = sample(field, grid);
  Net net{samples, table, {}, {}};
  for_all(samples.nx - 1, samples.ny - 1, samples.nz - 1, [&](int i, int j, int k) {
    const int inside = net.pattern(i, j, k);
    if (inside != 0 && inside != 255) add_cell(net, i, j, k, inside);
  });
  for (Vec3& position : net.surface.positions) settle(field, smallest_spacing(grid), position);
  for_all(samples.nx, samples.ny, samples.nz,
          [&](int i, int j, int k) { add_quads(net, i, j, k); });
  for (const Vec3& position : net.surface.positions) {
    net.surface.normals.push_back(field_normal(field, position, gradient_step));
  }
  return net.surface;
}

}  // namespace mien::scenes
