#include <algorithm>
#include <unordered_map>

#include "motion/formats/table/wide_table.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_names_in_note = 5;

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// A point and the columns of x, y, z and w that its name occurs in.
struct Candidate {
  std::string name;
  std::array<int, 4> column = {-1, -1, -1, -1};
  bool is_twice = false;

  bool is_point() const {
    return !is_twice && column[0] >= 0 && column[1] >= 0 && column[2] >= 0 && column[3] < 0 &&
           !is_other_quantity(name);
  }
};

/// The columns with coordinates, by point in order of occurrence.
class Candidates {
 public:
  void add(const AxisName& axis, int column) {
    const auto [found, is_new] = index_of_.emplace(lower_case(axis.base), all_.size());
    if (is_new) all_.emplace_back().name = std::string(axis.base);
    Candidate& candidate = all_[found->second];
    int& of_axis = candidate.column[static_cast<std::size_t>(axis.axis)];
    if (of_axis >= 0) candidate.is_twice = true;
    of_axis = column;
  }

  const std::vector<Candidate>& all() const { return all_; }

 private:
  std::vector<Candidate> all_;
  std::unordered_map<std::string, std::size_t> index_of_;
};

/// What a column is called: its own name, or the point and the axis.
std::vector<std::string> full_names(const std::vector<std::string>& names,
                                    const std::vector<std::string>& axes) {
  if (axes.empty()) return names;
  std::vector<std::string> full;
  std::string above;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (i < names.size() && !names[i].empty()) above = names[i];
    const std::optional<AxisName> axis = axis_name(axes[i]);
    const bool is_axis = axis && axis->base.empty();
    full.push_back(is_axis ? above + "_" + axes[i] : axes[i]);
  }
  return full;
}

/// Whether the column is the number or the time of the frame.
bool take_named_column(WideColumns& columns, const std::string& name, int column) {
  const NamedColumn named = named_column(name);
  if (named.use == ColumnUse::frame && columns.frame < 0) {
    columns.frame = column;
  } else if (named.use == ColumnUse::time && columns.time < 0) {
    columns.time = column;
    columns.time_column = named;
  } else {
    return false;
  }
  return true;
}

}  // namespace

WideColumns wide_columns(const std::vector<std::string>& names,
                         const std::vector<std::string>& axes) {
  const std::vector<std::string> full = full_names(names, axes);
  WideColumns columns;
  columns.width = full.size();
  Candidates candidates;
  std::vector<std::optional<LengthUnit>> units(full.size());
  std::vector<bool> is_left_out(full.size(), false);
  for (std::size_t i = 0; i < full.size(); ++i) {
    const std::optional<AxisName> axis = axis_name(full[i]);
    if (axis) {
      candidates.add(*axis, static_cast<int>(i));
      units[i] = axis->unit;
    } else if (!full[i].empty()) {
      is_left_out[i] = !take_named_column(columns, full[i], static_cast<int>(i));
    }
  }
  for (const Candidate& candidate : candidates.all()) {
    if (!candidate.is_point()) {
      for (const int column : candidate.column)
        if (column >= 0) is_left_out[static_cast<std::size_t>(column)] = true;
      continue;
    }
    const std::array<int, 3> of_axes = {candidate.column[0], candidate.column[1],
                                        candidate.column[2]};
    columns.points.push_back({candidate.name.empty() ? "point" : candidate.name, of_axes});
    const std::optional<LengthUnit>& unit = units[static_cast<std::size_t>(of_axes[0])];
    if (unit && !columns.unit) columns.unit = unit;
    for (const int column : of_axes) {
      const std::optional<LengthUnit>& other = units[static_cast<std::size_t>(column)];
      if (other && columns.unit && other->name != columns.unit->name)
        columns.has_mixed_units = true;
    }
  }
  for (std::size_t i = 0; i < full.size(); ++i)
    if (is_left_out[i]) columns.left_out.push_back(full[i]);
  return columns;
}

void refuse_two_dimensional(const std::vector<std::string>& names, const Place& place) {
  std::unordered_map<std::string, int> axes_of;
  for (const std::string& name : names) {
    const std::optional<AxisName> axis = axis_name(name);
    if (axis && axis->axis < 3) axes_of[lower_case(axis->base)] |= 1 << axis->axis;
  }
  const auto has = [&](int axes) {
    return std::ranges::any_of(axes_of, [&](const auto& of) { return (of.second & axes) == axes; });
  };
  if (!has(3) || has(4)) return;
  throw Error(place, "has x and y of points but no z: two-dimensional keypoints are not read",
              "give positions in space, as from several cameras");
}

void note_left_out(const std::vector<std::string>& left_out, std::vector<std::string>& notes) {
  if (left_out.empty()) return;
  std::vector<std::string> shown;
  for (const std::string& name : left_out) {
    shown.push_back(shown.size() < most_names_in_note ? excerpt(name) : std::string());
  }
  notes.push_back(left_out.size() == 1
                      ? "The column " + shown[0] + " is no position and was left out."
                      : "Columns that are no positions were left out: " +
                            first_of(shown, most_names_in_note) + ".");
}

}  // namespace mien::motion
