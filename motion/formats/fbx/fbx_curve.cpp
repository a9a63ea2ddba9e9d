#include "motion/formats/fbx/fbx_curve.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

#include "motion/formats/fbx/fbx_numbers.h"
#include "motion/formats/fbx/fbx_values.h"

namespace mien::motion {

namespace {

using To = FbxKey::To;

namespace flag {
constexpr std::int64_t constant = 0x2;
constexpr std::int64_t linear = 0x4;
constexpr std::int64_t cubic = 0x8;
constexpr std::int64_t automatic = 0x100;  // of constant keys: the next key's value
constexpr std::int64_t by_tension = 0x200;
constexpr std::int64_t clamped = 0x1000 | 0x4000;
constexpr std::int64_t right_weighted = 0x1000000;
constexpr std::int64_t next_left_weighted = 0x2000000;
}  // namespace flag

/// How a key's slopes are found.
struct KeyForm {
  std::int64_t flags = 0;
  std::array<float, 4> data{};
};

To to_of(std::int64_t flags) {
  if (flags & flag::cubic) return To::cubic;
  if (flags & flag::linear) return To::linear;
  return (flags & flag::automatic) != 0 ? To::constant_next : To::constant;
}

double seconds_between(const FbxKey& a, const FbxKey& b) {
  return static_cast<double>(b.time - a.time) / static_cast<double>(fbx_ticks_per_second);
}

double slope_between(const FbxKey& a, const FbxKey& b) {
  const double seconds = seconds_between(a, b);
  return seconds > 0.0 ? (double{b.value} - double{a.value}) / seconds : 0.0;
}

/// The slope of an automatic key: 0 at the ends.
double automatic_slope(const std::vector<FbxKey>& keys, size_t k, bool is_clamped) {
  if (k == 0 || k + 1 >= keys.size()) return 0.0;
  const double slope = slope_between(keys[k - 1], keys[k + 1]);
  if (!is_clamped) return slope;
  const double before = slope_between(keys[k - 1], keys[k]);
  const double after = slope_between(keys[k], keys[k + 1]);
  if (before * after <= 0.0) return 0.0;
  // A tangent that takes a third of the time may not go beyond the next key.
  const double most = 3.0 * std::min(std::abs(before), std::abs(after));
  return std::clamp(slope, -most, most);
}

struct Slopes {
  double left = 0.0;
  double right = 0.0;
};

/// Kochanek and Bartels 1984, for slopes per second.
Slopes tension_slopes(const std::vector<FbxKey>& keys, size_t k, const KeyForm& form) {
  const double before = k > 0 ? slope_between(keys[k - 1], keys[k]) : 0.0;
  const double after = k + 1 < keys.size() ? slope_between(keys[k], keys[k + 1]) : before;
  const double first = k > 0 ? before : after;
  const double half = 0.5 * (1.0 - form.data[0]);
  const double continuity = form.data[1];
  const double bias = form.data[2];
  return {half * ((1.0 + bias) * (1.0 - continuity) * first +
                  (1.0 - bias) * (1.0 + continuity) * after),
          half * ((1.0 + bias) * (1.0 + continuity) * first +
                  (1.0 - bias) * (1.0 - continuity) * after)};
}

float weight_of(unsigned bits) {
  return std::clamp(static_cast<float>(bits) / 9999.0f, 0.0f, 1.0f);
}

/// The tangents that a form states.
FbxTangents stated_tangents(const KeyForm& form) {
  FbxTangents tangents;
  if (form.flags & flag::by_tension) return tangents;
  const auto bits = std::bit_cast<std::uint32_t>(form.data[2]);
  if (form.flags & flag::right_weighted) tangents.right_weight = weight_of(bits & 0xFFFF);
  if (form.flags & flag::next_left_weighted) tangents.next_left_weight = weight_of(bits >> 16);
  tangents.right_slope = form.data[0];
  tangents.next_left_slope = form.data[1];
  return tangents;
}

/// Sets the tangents beside a cubic key. Slopes that are worked out replace those in the file.
void shape_cubic(FbxCurve& curve, size_t k, const KeyForm& form) {
  curve.tangents[k] = stated_tangents(form);
  Slopes slopes;
  if (form.flags & flag::by_tension) {
    slopes = tension_slopes(curve.keys, k, form);
  } else if (form.flags & flag::automatic) {
    slopes.left = slopes.right = automatic_slope(curve.keys, k, (form.flags & flag::clamped) != 0);
  } else {
    return;
  }
  curve.tangents[k].right_slope = static_cast<float>(slopes.right);
  if (k > 0) curve.tangents[k - 1].next_left_slope = static_cast<float>(slopes.left);
}

/// Shapes the curve between the keys; `form_of` returns the form of a key.
template <class FormOf>
void shape(FbxCurve& curve, FormOf form_of) {
  for (size_t k = 0; k < curve.keys.size(); ++k) {
    const KeyForm& form = form_of(k);
    curve.keys[k].to = to_of(form.flags);
    if (curve.keys[k].to != To::cubic) continue;
    if (curve.tangents.empty()) curve.tangents.resize(curve.keys.size());
    shape_cubic(curve, k, form);
  }
}

void require_usable(const FbxDocument& document, std::uint32_t node,
                    const std::vector<FbxKey>& keys) {
  constexpr std::int64_t latest = std::int64_t{1} << 60;
  for (size_t k = 0; k < keys.size(); ++k) {
    if (std::abs(keys[k].time) > latest || (k > 0 && keys[k].time < keys[k - 1].time)) {
      refuse_fbx(document, node, "the times of a curve's keys decrease or are too large");
    }
    if (!(std::abs(keys[k].value) < 1e12f)) {
      refuse_fbx(document, node, "a curve holds a number that is too large");
    }
  }
}

void require_finite(const FbxDocument& document, std::uint32_t node,
                    const std::vector<FbxTangents>& tangents) {
  for (const FbxTangents& each : tangents) {
    if (std::isfinite(each.right_slope) && std::isfinite(each.next_left_slope)) continue;
    refuse_fbx(document, node, "a curve holds a number that is too large");
  }
}

/// Run lengths of forms, as one form for each key.
std::vector<KeyForm> parse_forms(const FbxDocument& document, std::uint32_t node) {
  const std::uint32_t flags_node = find_child(document, node, "KeyAttrFlags");
  const std::uint32_t data_node = find_child(document, node, "KeyAttrDataFloat");
  if (flags_node == 0) return {};
  const std::vector<std::int64_t> flags = integers_of(document, flags_node);
  std::vector<float> data;
  if (data_node != 0) data = floats_of(document, data_node);
  std::vector<KeyForm> forms(flags.size());
  for (size_t i = 0; i < flags.size(); ++i) {
    forms[i].flags = flags[i];
    for (size_t d = 0; d < 4 && 4 * i + d < data.size(); ++d) forms[i].data[d] = data[4 * i + d];
  }
  return forms;
}

/// The letter of a value; 0 if it is none.
char letter_of(const std::optional<FbxValue>& value) {
  if (!value || value->text.size() != 1) return 0;
  const char c = value->text.front();
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ? c : '\0';
}

/// The values of an old list of keys.
struct OldKeys {
  FbxValueCursor cursor;
  std::optional<FbxValue> value;

  void advance() { value = next_value(cursor); }
  double number() {
    if (!value || letter_of(value) != 0) return 0.0;
    const double read = value->number;
    advance();
    return read;
  }
};

/// After a cubic key's value: its tangents and weights.
KeyForm parse_old_cubic(OldKeys& list) {
  KeyForm form{flag::cubic, {}};
  const char tangents = letter_of(list.value);
  list.advance();
  if (tangents == 's' || tangents == 'b') {
    form.data[0] = static_cast<float>(list.number());
    form.data[1] = static_cast<float>(list.number());
  } else if (tangents == 't') {
    form.flags |= flag::by_tension;
    for (size_t i = 0; i < 3; ++i) form.data[i] = static_cast<float>(list.number());
  } else {
    form.flags |= flag::automatic | (tangents == 'p' ? flag::clamped : 0);
  }
  // Weights, then velocities: none, left, right, or all.
  for (int list_of = 0; list_of < 2; ++list_of) {
    const char given = letter_of(list.value);
    if (given == 0) break;
    list.advance();
    std::uint32_t weights[2] = {3333, 3333};
    const bool right = given == 'a' || given == 'r';
    const bool left = given == 'a' || given == 'l';
    if (right) weights[0] = static_cast<std::uint32_t>(std::clamp(list.number(), 0.0, 1.0) * 9999);
    if (left) weights[1] = static_cast<std::uint32_t>(std::clamp(list.number(), 0.0, 1.0) * 9999);
    if (list_of > 0 || (form.flags & flag::by_tension)) continue;
    form.flags |= (right ? flag::right_weighted : 0) | (left ? flag::next_left_weighted : 0);
    form.data[2] = std::bit_cast<float>(weights[0] | weights[1] << 16);
  }
  return form;
}

/// The first key after a time. Keys are mostly evenly spaced, so that it is guessed first.
std::vector<FbxKey>::const_iterator first_after(const std::vector<FbxKey>& keys,
                                                std::int64_t time) {
  const auto span = static_cast<double>(keys.back().time - keys.front().time);
  const auto share = static_cast<double>(time - keys.front().time) / span;
  if (share >= 0.0 && share < 1.0) {
    const auto guess = static_cast<size_t>(share * static_cast<double>(keys.size() - 1));
    if (keys[guess].time <= time && time < keys[guess + 1].time) {
      return keys.begin() + static_cast<std::ptrdiff_t>(guess) + 1;
    }
  }
  return std::upper_bound(keys.begin(), keys.end(), time,
                          [](std::int64_t wanted, const FbxKey& key) { return wanted < key.time; });
}

double cubic_value(const FbxKey& from, const FbxKey& to, const FbxTangents& tangents,
                   double share) {
  const double seconds = seconds_between(from, to);
  const double x1 = tangents.right_weight;
  const double x2 = 1.0 - tangents.next_left_weight;
  const double y1 = from.value + tangents.right_slope * x1 * seconds;
  const double y2 = to.value - tangents.next_left_slope * tangents.next_left_weight * seconds;
  // The parameter at which the Bézier curve reaches the share of the time, which it does once.
  double low = 0.0;
  double high = 1.0;
  double t = share;
  for (int step = 0; step < 60 && high - low > 1e-14; ++step) {
    const double u = 1.0 - t;
    const double x = 3.0 * u * u * t * x1 + 3.0 * u * t * t * x2 + t * t * t;
    if (std::abs(x - share) < 1e-15) break;
    (x < share ? low : high) = t;
    const double slope = 3.0 * u * u * x1 + 6.0 * u * t * (x2 - x1) + 3.0 * t * t * (1.0 - x2);
    t = slope > 1e-9 ? t - (x - share) / slope : low;
    if (!(t > low && t < high)) t = 0.5 * (low + high);
  }
  const double u = 1.0 - t;
  return u * u * u * from.value + 3.0 * u * u * t * y1 + 3.0 * u * t * t * y2 +
         t * t * t * to.value;
}

}  // namespace

FbxCurve parse_fbx_curve(const FbxDocument& document, std::uint32_t node) {
  const std::uint32_t times_node = find_child(document, node, "KeyTime");
  const std::uint32_t values_node = find_child(document, node, "KeyValueFloat");
  FbxCurve curve;
  if (times_node == 0 || values_node == 0) return curve;
  const std::vector<std::int64_t> times = integers_of(document, times_node);
  const std::vector<float> values = floats_of(document, values_node);
  if (times.size() != values.size()) {
    refuse_fbx(document, node,
               "a curve has " + std::to_string(times.size()) + " times, but " +
                   std::to_string(values.size()) + " values");
  }
  curve.keys.resize(times.size());
  for (size_t k = 0; k < times.size(); ++k) {
    curve.keys[k].time = times[k];
    curve.keys[k].value = values[k];
  }
  require_usable(document, node, curve.keys);
  const std::vector<KeyForm> forms = parse_forms(document, node);
  std::vector<std::int64_t> runs;
  if (const std::uint32_t counts = find_child(document, node, "KeyAttrRefCount")) {
    runs = integers_of(document, counts);
  }
  size_t form = 0;
  std::int64_t left = runs.empty() ? 0 : runs.front();
  const KeyForm usual{flag::linear, {}};
  shape(curve, [&](size_t) -> const KeyForm& {
    if (forms.empty()) return usual;
    while (left <= 0 && form + 1 < std::min(forms.size(), runs.size())) left = runs[++form];
    if (left > 0) --left;
    return forms[form];
  });
  require_finite(document, node, curve.tangents);
  return curve;
}

FbxCurve parse_old_fbx_curve(const FbxDocument& document, std::uint32_t node) {
  FbxCurve curve;
  const std::uint32_t list_node = find_child(document, node, "Key");
  const std::uint32_t count_node = find_child(document, node, "KeyCount");
  if (list_node == 0 || count_node == 0) return curve;
  OldKeys list{values_of(document, list_node), {}};
  list.advance();
  std::vector<KeyForm> forms;
  while (list.value && letter_of(list.value) == 0) {
    FbxKey key;
    key.time = list.value->integer;
    list.advance();
    key.value = static_cast<float>(list.number());
    const char kind = letter_of(list.value);
    list.advance();
    KeyForm form{flag::linear, {}};
    if (kind == 'C') {
      const char held = letter_of(list.value);
      if (held != 0) list.advance();
      form.flags = flag::constant | (held == 'n' ? flag::automatic : 0);
    } else if (kind == 'U') {
      form = parse_old_cubic(list);
    } else if (kind != 'L') {
      break;
    }
    curve.keys.push_back(key);
    forms.push_back(form);
  }
  const std::int64_t stated = integer_of(document, count_node, 0);
  if (list.value || static_cast<std::int64_t>(curve.keys.size()) != stated) {
    refuse_fbx(document, list_node,
               "a curve states " + std::to_string(stated) + " keys, but " +
                   std::to_string(curve.keys.size()) + " of a known form can be read");
  }
  require_usable(document, list_node, curve.keys);
  shape(curve, [&](size_t k) -> const KeyForm& { return forms[k]; });
  require_finite(document, list_node, curve.tangents);
  return curve;
}

double value_at(const FbxCurve& curve, std::int64_t time) {
  // Frame times such as those of NTSC are rounded to ticks.
  constexpr std::int64_t tolerance = fbx_ticks_per_second / 1'000'000;
  const std::vector<FbxKey>& keys = curve.keys;
  const auto after = first_after(keys, time + tolerance);
  if (after == keys.begin()) return keys.front().value;
  const FbxKey& from = *(after - 1);
  if (after == keys.end() || time <= from.time || from.to == To::constant) return from.value;
  if (from.to == To::constant_next) return after->value;
  const double share =
      static_cast<double>(time - from.time) / static_cast<double>(after->time - from.time);
  const double value = from.value;
  if (from.to == To::linear) return value + share * (after->value - value);
  const auto k = static_cast<size_t>(after - keys.begin()) - 1;
  return cubic_value(from, *after, curve.tangents[k], share);
}

bool changes(const FbxCurve& curve) {
  return std::any_of(curve.keys.begin(), curve.keys.end(),
                     [&](const FbxKey& key) { return key.value != curve.keys.front().value; });
}

}  // namespace mien::motion
