#pragma once

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/look/face_form.h"
#include "pipeline/manifest/look/look.h"

namespace mien::pipeline {

// The fields of a manifest's `look:`. All of them affect the picture. A stimulus's figure, face or
// camera replaces the manifest's as a whole; a stimulus's scene replaces the manifest's set and
// background.

void fields_of(auto&&, MaybeConst<scenes::StickOptions> auto&) {}

void fields_of(auto&& field, MaybeConst<scenes::MannequinOptions> auto& mannequin) {
  field("build", mannequin.build, concerns::picture);
  field("sex", mannequin.sex, concerns::picture);
}

/// `joints:` of a point-light figure: a keyword or a list.
struct JointsForm {
  static void read(const DocumentValue& given, scenes::PointLightOptions& dots);
  static nlohmann::ordered_json write(const scenes::PointLightOptions& dots,
                                      const WritingOptions& how);
};

/// `size_mm:` of markers, in millimetres as laboratories give it.
struct MillimetresForm {
  static void read(const DocumentValue& given, std::optional<double>& metres);
  static nlohmann::ordered_json write(const std::optional<double>& metres, const WritingOptions&);
};

inline constexpr Words<bool> gap_words = {{"dark", false}, {"fill", true}};

inline constexpr Words<bool> polarity_words = {{"light-on-dark", false}, {"dark-on-light", true}};

/// The options of dots that are the same for joints and markers.
void dot_fields(auto&& field, MaybeConst<scenes::PointLightOptions> auto& dots) {
  field("polarity", dots.dark_on_light, concerns::picture, polarity_words);
  field("contrast", dots.contrast, concerns::picture);
  field("colour", dots.colour, concerns::picture);
  field("background", dots.background, concerns::picture);
  field("lifetime", dots.lifetime, concerns::picture);
  field("inverted", dots.inverted, concerns::picture);
  field("mirrored", dots.mirrored, concerns::picture);
  field("rotated", dots.rotated_degrees, concerns::picture);
  field("scrambled", dots.scrambled, concerns::picture);
  field("reversed", dots.reversed, concerns::picture);
  field("constant_speed", dots.constant_speed, concerns::picture);
  field("phase_scrambled", dots.phase_scrambled, concerns::picture);
  field("noise", dots.noise, concerns::picture);
  field("mask", dots.mask, concerns::picture);
  field("seed", dots.seed, concerns::picture);
}

void fields_of(auto&& field, MaybeConst<scenes::PointLightOptions> auto& dots) {
  field.by("joints", dots, concerns::picture, JointsForm());
  field("size", dots.size_px, concerns::picture);
  field("size_m", dots.size_m, concerns::picture);
  dot_fields(field, dots);
}

void fields_of(auto&& field, MaybeConst<scenes::MarkersOptions> auto& markers) {
  field("show", markers.show, concerns::picture);
  field("pairs", markers.pairs, concerns::picture);
  field("gaps", markers.fills_gaps, concerns::picture, gap_words);
  field("size", markers.dots.size_px, concerns::picture);
  field.by("size_mm", markers.dots.size_m, concerns::picture, MillimetresForm());
  dot_fields(field, markers.dots);
}

/// A Figure or BodyFigure: a name, or a map of one figure to its options.
template <class Figures>
struct FigureForm {
  static void read(const DocumentValue& given, Figures& figure);
  static nlohmann::ordered_json write(const Figures& figure, const WritingOptions& how);
  static void walk(auto& names) {
    scenes::for_each_kind<Figures>(
        [&](auto options) { names(options.kind.name, options, concerns::picture); });
  }
};

/// `poses:` of a trail. It is always written, because its default depends on other options: none if
/// onion skin or traces are given.
struct PosesForm {
  static void read(const DocumentValue& given, scenes::TrailOptions& trail);
  static nlohmann::ordered_json write(const scenes::TrailOptions& trail, const WritingOptions&);
  static void walk(auto&) {}
};

void fields_of(auto&& field, MaybeConst<scenes::TrailOptions> auto& trail) {
  field.by("figure", trail.figure, concerns::picture, FigureForm<scenes::BodyFigure>());
  field("poses", trail.poses, concerns::picture);
  field("before", trail.before, concerns::picture);
  field("after", trail.after, concerns::picture);
  field("every", trail.every_s, concerns::picture);
  field("min_opacity", trail.min_opacity, concerns::picture);
  field("traces", trail.traces, concerns::picture);
  field("trace_width", trail.trace_width_m, concerns::picture);
  field.inside(trail, concerns::picture | concerns::required, PosesForm());
}

void fields_of(auto&& field, MaybeConst<scenes::CameraKey> auto& key) {
  field("at", key.seconds, concerns::picture | concerns::required);
  field("position", key.position, concerns::picture | concerns::required);
  field("target", key.target, concerns::picture | concerns::required);
}

void fields_of(auto&& field, MaybeConst<scenes::ScreenSettings> auto& screen) {
  field("distance_cm", screen.distance_cm, concerns::picture | concerns::required);
  field("width_cm", screen.width_cm, concerns::picture | concerns::required);
  field("degrees", screen.degrees, concerns::picture);
}

void fields_of(auto&& field, MaybeConst<scenes::DepthOfField> auto& lens) {
  field("aperture", lens.aperture_m, concerns::picture);
  field("focus", lens.focus_m, concerns::picture);
}

/// `stereo: {separation: 0.063}`, in metres; 0.063 m is the default.
struct StereoForm {
  static void read(const DocumentValue& given, std::optional<double>& separation_m);
  static nlohmann::ordered_json write(const std::optional<double>& separation_m,
                                      const WritingOptions&);
  static void walk(auto& names) { names.add("separation"); }
};

inline constexpr Words<scenes::CameraSubject> camera_subject_words = {
    {"whole-body", scenes::CameraSubject::whole_body},
    {"upper-body", scenes::CameraSubject::upper_body},
    {"head", scenes::CameraSubject::head}};

void fields_of(auto&& field, MaybeConst<scenes::CameraSettings> auto& camera) {
  field("view", camera.view, concerns::picture | concerns::alone);
  field("frame", camera.subject, concerns::picture, camera_subject_words);
  field("orthographic", camera.orthographic, concerns::picture);
  field("fov", camera.fov_degrees, concerns::picture);
  field("position", camera.position, concerns::picture);
  field("target", camera.target, concerns::picture);
  field("path", camera.path, concerns::picture);
  field.by("stereo", camera.stereo_separation_m, concerns::picture, StereoForm());
  field("screen", camera.screen, concerns::picture);
  field("figure_px", camera.figure_px, concerns::picture);
  field("depth_of_field", camera.depth_of_field, concerns::picture);
}

/// `scene:` a set, a file, or {set, background}.
struct SceneForm {
  static void read(const DocumentValue& given, Look& look);
  static nlohmann::ordered_json write(const Look& look, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("set");
    names.add("background");
  }
};

inline constexpr Words<Colours> colours_words = {{"neutral", Colours::neutral},
                                                 {"role", Colours::role}};

inline constexpr Words<scenes::Hands> hands_words = {{"auto", scenes::Hands::automatic},
                                                     {"drawn", scenes::Hands::drawn},
                                                     {"hidden", scenes::Hands::hidden}};

/// `hands:` of a person, who has those of the stimulus if none are given.
struct PersonHandsForm {
  static void read(const DocumentValue& given, std::optional<scenes::Hands>& hands);
  static nlohmann::ordered_json write(const std::optional<scenes::Hands>& hands,
                                      const WritingOptions&);
  static void walk(auto&) {}
};

void fields_of(auto&& field, MaybeConst<Look> auto& look) {
  field.by("scene", look, concerns::picture, SceneForm());
  field.by("figure", look.figure, concerns::picture, FigureForm<scenes::Figure>());
  field.by("face", look.face, concerns::picture, FaceForm());
  field("hands", look.hands, concerns::picture, hands_words);
  field.whole("camera", look.camera, concerns::picture);
  field("colours", look.colours, concerns::picture, colours_words);
}

}  // namespace mien::pipeline
