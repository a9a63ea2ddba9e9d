#include "scenes/face/face_animation.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "motion/formats/gltf/gltf_accessor.h"
#include "motion/formats/gltf/gltf_track.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"
#include "motion/text/nearest_word.h"
#include "scenes/character/character_file.h"
#include "scenes/character/gltf_morphs.h"

namespace mien::scenes {

namespace {

using motion::FaceCurve;
using motion::FaceTrack;
using motion::get_it_again;
using nlohmann::json;

/// The node that animates the weight of an expression by its translation along x, and its name.
using ExpressionNodes = std::vector<std::pair<std::string, int>>;

ExpressionNodes expression_nodes(const CharacterFile& file) {
  ExpressionNodes nodes;
  const json root =
      file.json.value("/extensions/VRMC_vrm_animation/expressions"_json_pointer, json::object());
  for (const char* kind : {"preset", "custom"}) {
    const auto expressions = root.is_object() ? root.find(kind) : root.end();
    if (expressions == root.end() || !expressions->is_object()) continue;
    for (const auto& [name, given] : expressions->items()) {
      const int node = index_in(file, given, "node", file.gltf.model.nodes.size(),
                                "expression " + motion::in_quotes(name));
      if (node >= 0) nodes.emplace_back(name, node);
    }
  }
  return nodes;
}

FaceCurve::Interpolation curve_kind(const CharacterFile& file, const std::string& name) {
  if (name.empty() || name == "LINEAR") return FaceCurve::Interpolation::linear;
  if (name == "STEP") return FaceCurve::Interpolation::step;
  if (name == "CUBICSPLINE") return FaceCurve::Interpolation::cubic_spline;
  motion::refuse(file.gltf, "an interpolation that glTF does not know", get_it_again);
}

/// The curves of one channel of weights, one for each target of the node's mesh.
FaceTrack curves_of(const CharacterFile& file, const tinygltf::Animation& animation,
                    const tinygltf::AnimationChannel& channel) {
  const int index = channel.sampler;
  if (index < 0 || static_cast<std::size_t>(index) >= animation.samplers.size())
    motion::refuse(file.gltf, "a track has no sampler", get_it_again);
  const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(index)];
  const json& node = list_in(file.json, "nodes")[static_cast<std::size_t>(channel.target_node)];
  const int mesh = index_in(file, node, "mesh", list_in(file.json, "meshes").size(),
                            "node " + std::to_string(channel.target_node));
  if (mesh < 0) motion::refuse(file.gltf, "weights of a node without a mesh", get_it_again);
  FaceTrack curves;
  for (std::string& name : target_names(file, mesh))
    curves.push_back({std::move(name), curve_kind(file, sampler.interpolation), {}, {}});
  const std::vector<double> times =
      motion::accessor_numbers(file.gltf, sampler.input, 1, "key times");
  const std::vector<double> numbers =
      motion::accessor_numbers(file.gltf, sampler.output, 1, "weights");
  if (times.empty() || std::ranges::adjacent_find(times, std::greater_equal<>()) != times.end())
    motion::refuse(file.gltf, "the key times of weights do not increase", get_it_again);
  const bool is_spline = sampler.interpolation == "CUBICSPLINE";
  const std::size_t parts = is_spline ? 3 : 1;
  if (numbers.size() != times.size() * parts * curves.size())
    motion::refuse(file.gltf, "a track has more or fewer weights than keys", get_it_again);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    curves[i % curves.size()].values.push_back(numbers[i]);
  for (FaceCurve& curve : curves) curve.times = times;
  return curves;
}

/// The weight of an expression: the x of a node's translation.
FaceCurve curve_of(const std::string& name, const motion::GltfTrack& track) {
  FaceCurve curve{name, FaceCurve::Interpolation::linear, track.times, {}};
  if (track.interpolation == motion::GltfTrack::Interpolation::step)
    curve.interpolation = FaceCurve::Interpolation::step;
  if (track.interpolation == motion::GltfTrack::Interpolation::cubic_spline)
    curve.interpolation = FaceCurve::Interpolation::cubic_spline;
  for (std::size_t i = 0; i < track.numbers.size(); i += 3)
    curve.values.push_back(track.numbers[i]);
  return curve;
}

void add_new(FaceTrack& track, FaceCurve curve) {
  if (std::ranges::find(track, curve.name, &FaceCurve::name) == track.end())
    track.push_back(std::move(curve));
}

FaceTrack track_of(const CharacterFile& file, int index) {
  const tinygltf::Animation& animation =
      file.gltf.model.animations[static_cast<std::size_t>(index)];
  FaceTrack track;
  for (const tinygltf::AnimationChannel& channel : animation.channels) {
    const auto node = static_cast<std::size_t>(channel.target_node);
    if (channel.target_path != "weights" || channel.target_node < 0) continue;
    if (node >= file.gltf.model.nodes.size())
      motion::refuse(file.gltf, "a track moves a node that does not exist", get_it_again);
    for (FaceCurve& curve : curves_of(file, animation, channel)) add_new(track, std::move(curve));
  }
  const ExpressionNodes expressions = expression_nodes(file);
  if (expressions.empty()) return track;
  for (const motion::GltfTrack& moved : motion::parse_tracks(file.gltf, index)) {
    if (moved.part != motion::GltfTrack::Part::translation) continue;
    for (const auto& [name, node] : expressions)
      if (node == moved.node) add_new(track, curve_of(name, moved));
  }
  return track;
}

/// The animations with weights, by name.
std::vector<std::pair<std::string, FaceTrack>> tracks_of(const CharacterFile& file) {
  std::vector<std::pair<std::string, FaceTrack>> tracks;
  for (std::size_t a = 0; a < file.gltf.model.animations.size(); ++a) {
    const std::string& own = file.gltf.model.animations[a].name;
    FaceTrack track = track_of(file, static_cast<int>(a));
    if (!track.empty())
      tracks.emplace_back(own.empty() ? "take " + std::to_string(a + 1) : own, std::move(track));
  }
  return tracks;
}

FaceTrack chosen_track(const CharacterFile& file, const std::string& take) {
  std::vector<std::pair<std::string, FaceTrack>> tracks = tracks_of(file);
  if (tracks.empty())
    motion::refuse(file.gltf, "it has no animation of a face",
                   "export the weights of its morph targets, or give a table of weights");
  if (take.empty()) return std::move(tracks.front().second);
  std::vector<std::string> names;
  for (auto& [name, track] : tracks) {
    if (name == take) return std::move(track);
    names.push_back(name);
  }
  motion::refuse(file.gltf, "no animation of a face is called " + motion::in_quotes(take),
                 motion::did_you_mean(take, names));
}

}  // namespace

bool is_gltf_file(const std::filesystem::path& path) {
  std::string ending = motion::without_compression(path).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".gltf" || ending == ".glb" || ending == ".vrm" || ending == ".vrma";
}

FaceTrack parse_face_animation(std::string_view bytes, const std::string& file_name,
                               const std::string& take) {
  return chosen_track(parse_character_file(bytes, file_name, std::nullopt), take);
}

FaceTrack read_face_animation(const std::filesystem::path& path, const std::string& take) {
  const std::string bytes = motion::read_contents(path);
  motion::require_kind(bytes, path.string(), "gltf");
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  return chosen_track(parse_character_file(bytes, path.string(), folder), take);
}

}  // namespace mien::scenes
