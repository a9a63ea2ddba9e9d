#include "pipeline/production/sheets/sheet_parts.h"

#include <algorithm>
#include <cmath>

namespace mien::pipeline {

namespace {

constexpr double rows_heading_height = 20.0;
constexpr double map_row_height = 9.4;
constexpr double part_gap = 3.2;

/// Parts of the body before the one that the joint belongs to: trunk, arms, legs.
int parts_before(int joint) {
  using namespace motion;
  int parts = 0;
  for (const int first : {LeftClavicle, RightClavicle, LeftHip, RightHip}) {
    if (joint >= first) ++parts;
  }
  return parts;
}

double row_top(const Box& block, int joint) {
  return block.y + rows_heading_height + (joint - 1) * map_row_height +
         parts_before(joint) * part_gap;
}

}  // namespace

SheetLayout sheet_layout() {
  SheetLayout page;
  const double left = 42.0;
  const double right = page.width - 42.0;
  const double split = 858.0;
  const double sidebar = 892.0;
  page.header = {left, 34.0, split - left, 50.0};
  page.figures = {left, 94.0, split - left, 304.0};
  page.heat_map = {left, 412.0, split - left, 250.0};
  page.verdict = {sidebar, 34.0, right - sidebar, 106.0};
  page.settings = {sidebar, 152.0, right - sidebar, 246.0};
  page.joint_bars = {sidebar, 412.0, right - sidebar, 250.0};
  page.curves = {left, 668.0, right - left, 112.0};
  page.footer = {left, 790.0, right - left, 24.0};
  return page;
}

Box time_column(const Box& block, int t) {
  const double width = (block.width - name_width) / motion::distance_times;
  return {block.x + name_width + t * width, block.y, width, block.height};
}

Box joint_row(const Box& block, int joint) {
  return {block.x, row_top(block, joint), block.width, map_row_height};
}

Box mean_row(const Box& block) {
  const double top = row_top(block, motion::distance_joints) + map_row_height + 2 * part_gap;
  return {block.x, top, block.width, map_row_height + 2.0};
}

double amount_limit(const motion::Distance& distance) {
  const double most = distance.by_joint_and_time.maxCoeff();
  return motion::distance_threshold_m *
         std::max(2.0, std::ceil(most / motion::distance_threshold_m));
}

}  // namespace mien::pipeline
