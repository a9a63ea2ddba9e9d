#include "pipeline/study/analysis/dendrogram.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

namespace {

constexpr double page_width = 560.0;
constexpr double margin = 18.0;
constexpr double row_height = 13.5;
constexpr double cluster_gap = 9.0;
constexpr double header_height = 50.0;
constexpr double axis_height = 40.0;
constexpr double names_width = 96.0;  // of the clusters

// Dark enough for text, told apart by people with any common colour vision.
constexpr std::array<Colour, 6> cluster_colours = {from_hex(0x0a58a6), from_hex(0xb8420e),
                                                   from_hex(0x007a59), from_hex(0x8a3f8f),
                                                   from_hex(0x8a6a00), from_hex(0x3f4a55)};

Colour colour_of(int group) {
  return cluster_colours[static_cast<size_t>(group) % cluster_colours.size()];
}

/// Where everything stands.
struct TreeLayout {
  std::vector<double> y;  ///< of each leaf
  double top = 0.0;       ///< of the tree
  double bottom = 0.0;
  double labels_right = 0.0;  ///< right edge of the leaves' names
  double left = 0.0;          ///< height 0
  double right = 0.0;
  double highest = 1.0;

  double x(double height) const { return left + (right - left) * height / highest; }
};

double page_height(const Dendrogram& d) {
  return margin + header_height + row_height * d.linkage.leaves +
         cluster_gap * std::max(d.partition.groups - 1, 0) + axis_height + margin;
}

double widest_leaf(const Canvas& canvas, const Dendrogram& d) {
  double widest = 0.0;
  for (const BilingualName& leaf : d.leaves) {
    double width = canvas.text_width(leaf.english, {.size = 8.5});
    if (!leaf.japanese.empty()) width += 6.0 + canvas.text_width(leaf.japanese, {.size = 7.5});
    widest = std::max(widest, width);
  }
  return std::min(widest, 240.0);
}

TreeLayout layout_of(const Canvas& canvas, const Dendrogram& d) {
  TreeLayout layout;
  layout.y.resize(static_cast<size_t>(d.linkage.leaves));
  layout.top = margin + header_height;
  double y = layout.top;
  int group = 0;
  for (const int leaf : leaf_order(d.linkage)) {
    const int own = d.partition.group[static_cast<size_t>(leaf)];
    if (own != group) y += cluster_gap;
    group = own;
    layout.y[static_cast<size_t>(leaf)] = y + 0.5 * row_height;
    y += row_height;
  }
  layout.bottom = y;
  layout.labels_right = margin + names_width + 12.0 + widest_leaf(canvas, d);
  layout.left = layout.labels_right + 8.0;
  layout.right = page_width - margin - 6.0;
  if (!d.linkage.merges.empty() && d.linkage.merges.back().height > 0.0)
    layout.highest =
        std::max(1.04 * d.linkage.merges.back().height, cut_height(d.linkage, d.partition.groups));
  return layout;
}

void draw_header(Canvas& canvas, const Dendrogram& d) {
  canvas.text({margin, margin + 12.0}, d.title, {.size = 13.0, .bold = true, .max_width = 360.0});
  canvas.text({margin, margin + 27.0}, d.subtitle, {.size = 8.5, .colour = quiet_ink});
  if (d.simulated) draw_simulated_mark(canvas, {page_width - margin, margin});
}

void draw_leaves(Canvas& canvas, const Dendrogram& d, const TreeLayout& layout) {
  for (size_t leaf = 0; leaf < d.leaves.size(); ++leaf) {
    const double baseline = layout.y[leaf] + 3.0;
    double right = layout.labels_right;
    if (!d.leaves[leaf].japanese.empty()) {
      const TextStyle small = {.size = 7.5, .colour = quiet_ink, .align = Align::right};
      canvas.text({right, baseline}, d.leaves[leaf].japanese, small);
      right -= canvas.text_width(d.leaves[leaf].japanese, small) + 6.0;
    }
    canvas.text(
        {right, baseline}, d.leaves[leaf].english,
        {.size = 8.5, .align = Align::right, .max_width = right - margin - names_width - 10.0});
  }
}

/// Rows of a cluster, top and bottom.
Box rows_of(const Dendrogram& d, const TreeLayout& layout, int group) {
  double top = layout.bottom;
  double bottom = layout.top;
  for (size_t leaf = 0; leaf < layout.y.size(); ++leaf) {
    if (d.partition.group[leaf] != group) continue;
    top = std::min(top, layout.y[leaf] - 0.5 * row_height);
    bottom = std::max(bottom, layout.y[leaf] + 0.5 * row_height);
  }
  return {margin, top, names_width, bottom - top};
}

void draw_clusters(Canvas& canvas, const Dendrogram& d, const TreeLayout& layout) {
  for (int group = 0; group < d.partition.groups; ++group) {
    const Box rows = rows_of(d, layout, group);
    const BilingualName& name = d.clusters[static_cast<size_t>(group)];
    canvas.fill(Box{rows.right(), rows.y + 1.0, 3.0, rows.height - 2.0}, colour_of(group), 1.5);
    const bool two_lines = !name.japanese.empty() && rows.height > 20.0;
    const double middle = rows.middle() + 3.2;
    const TextStyle style = {.size = 9.5,
                             .colour = colour_of(group),
                             .bold = true,
                             .align = Align::right,
                             .max_width = names_width - 8.0};
    canvas.text({rows.right() - 7.0, two_lines ? middle - 5.5 : middle}, name.english, style);
    if (two_lines)
      canvas.text({rows.right() - 7.0, middle + 6.5}, name.japanese,
                  {.size = 8.0, .colour = quiet_ink, .align = Align::right});
  }
}

void draw_axis(Canvas& canvas, const Dendrogram& d, const TreeLayout& layout) {
  const double y = layout.bottom + 8.0;
  canvas.line({layout.left, y}, {layout.right, y}, {.width = 0.6, .colour = quiet_ink});
  for (const double tick : axis_ticks(layout.highest, 6)) {
    const double x = layout.x(tick);
    canvas.line({x, y}, {x, y + 3.0}, {.width = 0.6, .colour = quiet_ink});
    canvas.text({x, y + 12.0}, fmt::format("{:g}", tick),
                {.size = 7.5, .colour = quiet_ink, .align = Align::centre});
  }
  canvas.text({0.5 * (layout.left + layout.right), y + 25.0}, "height √(2ΔE)",
              {.size = 8.0, .colour = quiet_ink, .align = Align::centre});
  if (d.partition.groups <= 1) return;
  const double cut = layout.x(cut_height(d.linkage, d.partition.groups));
  canvas.line({cut, layout.top - 3.0}, {cut, y}, {.width = 0.9, .colour = ink, .dashed = true});
  canvas.text({cut, layout.top - 6.0}, fmt::format("cut: {} clusters", d.partition.groups),
              {.size = 8.0, .align = Align::centre});
}

void draw_tree(Canvas& canvas, const Dendrogram& d, const TreeLayout& layout) {
  struct Branch {
    double y;
    double height;
  };
  std::vector<Branch> branches;
  for (const double y : layout.y) branches.push_back({y, 0.0});
  const auto leaves = static_cast<size_t>(d.linkage.leaves);
  const size_t retained = leaves - static_cast<size_t>(d.partition.groups);
  for (size_t step = 0; step < d.linkage.merges.size(); ++step) {
    const Merge& merge = d.linkage.merges[step];
    const double at = layout.x(merge.height);
    const int group = d.partition.group[static_cast<size_t>(merge.members.front())];
    for (const int part : {merge.first, merge.second}) {
      const Branch& branch = branches[static_cast<size_t>(part)];
      const bool inside = static_cast<size_t>(part) < leaves + retained;
      const int own = part < d.linkage.leaves
                          ? d.partition.group[static_cast<size_t>(part)]
                          : d.partition.group[static_cast<size_t>(
                                d.linkage.merges[static_cast<size_t>(part) - leaves].members[0])];
      canvas.line({layout.x(branch.height), branch.y}, {at, branch.y},
                  {.width = 1.1, .colour = inside ? colour_of(own) : quiet_ink});
    }
    const double first = branches[static_cast<size_t>(merge.first)].y;
    const double second = branches[static_cast<size_t>(merge.second)].y;
    canvas.line({at, first}, {at, second},
                {.width = 1.1, .colour = step < retained ? colour_of(group) : quiet_ink});
    branches.push_back({0.5 * (first + second), merge.height});
  }
}

}  // namespace

Plot dendrogram_plot(const Dendrogram& dendrogram) {
  return {dendrogram.title, page_width, page_height(dendrogram), [dendrogram](Canvas& canvas) {
            const TreeLayout layout = layout_of(canvas, dendrogram);
            draw_header(canvas, dendrogram);
            draw_axis(canvas, dendrogram, layout);
            draw_clusters(canvas, dendrogram, layout);
            draw_leaves(canvas, dendrogram, layout);
            draw_tree(canvas, dendrogram, layout);
          }};
}

}  // namespace mien::pipeline
