#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "scenes/sets/set_plan.h"

namespace mien::pipeline {

// The fields of a set file. All of them except `name` affect the picture.

inline constexpr Words<scenes::Side> side_words = {{"left", scenes::Side::left},
                                                   {"right", scenes::Side::right},
                                                   {"front", scenes::Side::front},
                                                   {"back", scenes::Side::back}};

/// `background:` one colour, or the colours of horizon and zenith.
struct BackgroundForm {
  static void read(const DocumentValue& given, render::Sky& sky);
  static nlohmann::ordered_json write(const render::Sky& sky, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("horizon");
    names.add("zenith");
  }
};

/// `fade: [from, to]`
struct FadeForm {
  static void read(const DocumentValue& given, render::Ground& ground);
  static nlohmann::ordered_json write(const render::Ground& ground, const WritingOptions&);
};

void fields_of(auto&& field, MaybeConst<render::Ground> auto& ground) {
  field("colour", ground.albedo, concerns::picture);
  field.group("lines", [&](auto& lines) {
    lines("colour", ground.line_albedo, concerns::picture);
    lines("every", ground.line_spacing, concerns::picture);
    lines("width", ground.line_width, concerns::picture);
    lines("major_every", ground.major_every, concerns::picture);
    lines("major_colour", ground.major_albedo, concerns::picture);
  });
  field.by("fade", ground, concerns::picture, FadeForm());
}

/// A ground, without lines unless its map defines them.
struct GroundForm {
  static void read(const DocumentValue& given, std::optional<render::Ground>& ground);
  static nlohmann::ordered_json write(const std::optional<render::Ground>& ground,
                                      const WritingOptions& how);
  static void walk(auto& names) { names.template of<render::Ground>(); }
};

void fields_of(auto&& field, MaybeConst<scenes::KeyLight> auto& light) {
  field("azimuth", light.azimuth_degrees, concerns::picture);
  field("elevation", light.elevation_degrees, concerns::picture);
  field("distance", light.distance_m, concerns::picture);
  field("size", light.side_m, concerns::picture);
  field("strength", light.strength, concerns::picture);
  field("colour", light.colour, concerns::picture);
}

void fields_of(auto&& field, MaybeConst<scenes::Wall> auto& wall) {
  field("at", wall.side, concerns::picture | concerns::required, side_words);
  field("distance", wall.distance_m, concerns::picture);
  field("height", wall.height_m, concerns::picture);
  field("length", wall.length_m, concerns::picture);
  field("colour", wall.albedo, concerns::picture);
}

void fields_of(auto&& field, MaybeConst<scenes::Box> auto& box) {
  field("centre", box.centre, concerns::picture | concerns::required);
  field("size", box.size, concerns::picture | concerns::required);
  field("colour", box.albedo, concerns::picture);
}

void fields_of(auto&& field, MaybeConst<scenes::Belt> auto& belt) {
  field("width", belt.width_m, concerns::picture);
  field("length", belt.length_m, concerns::picture);
  field("colour", belt.albedo, concerns::picture);
  field.group("stripes", [&](auto& stripes) {
    stripes("colour", belt.stripe_albedo, concerns::picture);
    stripes("every", belt.stripe_every_m, concerns::picture);
    stripes("width", belt.stripe_width_m, concerns::picture);
  });
}

void fields_of(auto&& field, MaybeConst<scenes::Stool> auto& stool) {
  field("width", stool.width_m, concerns::picture);
  field("depth", stool.depth_m, concerns::picture);
  field("colour", stool.albedo, concerns::picture);
}

void fields_of(auto&& field, MaybeConst<scenes::SetPlan> auto& set) {
  field("name", set.name, concerns::nothing);
  field("in_place", set.in_place, concerns::picture);
  field.by("background", set.sky, concerns::picture, BackgroundForm());
  field.group("sky", [&](auto& sky) {
    sky("zenith", set.sky.zenith, concerns::picture);
    sky("horizon", set.sky.horizon, concerns::picture);
    sky("below", set.sky.below, concerns::picture);
  });
  field.by("ground", set.ground, concerns::picture, GroundForm());
  field("lights", set.lights, concerns::picture);
  field("walls", set.walls, concerns::picture);
  field("boxes", set.boxes, concerns::picture);
  field("belt", set.belt, concerns::picture);
  field("stool", set.stool, concerns::picture);
}

}  // namespace mien::pipeline
