#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"
#include "motion/skeleton/skeleton.h"
#include "render/scene/scene.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/mannequin/mannequin_flesh.h"
#include "scenes/mannequin/surface_nets.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// A smooth body on the bones of one skeleton.
struct Mannequin {
  SkinnedMesh mesh;  ///< uv: coordinates in `paint`; triangle_parts: joints of the body
  /// Of the body's joints, and of its hands' (motion::with_fingers) if it has fingers.
  motion::JointTransforms bind;
  render::Texture paint;
};

enum class MannequinHands {
  one_piece,  ///< palm and fingers are one rigid piece
  fingers     ///< five fingers that bend, in smaller triangles
};

/// Makes a mannequin for `body`, which must be the canonical body (motion::is_body), with any bone
/// lengths. Expensive, so call it once per shot.
///
/// Its colours are those of the stick figure, with less difference between left and right limbs;
/// the face contrasts, so that its direction can be seen. With fingers each hand is a closed
/// surface of its own, which overlaps the forearm (hand_surface.h).
Mannequin make_mannequin(const motion::Skeleton& body, const MannequinOptions& options,
                         const FigureColours& colours, MeshDetail detail = MeshDetail::full,
                         MannequinHands hands = MannequinHands::one_piece);

/// The material of a mannequin's surface; `texture` is the index of its paint in Scene::textures.
render::Material mannequin_skin(int texture);

/// Appends the mannequin, in a pose of the body that it was made for, to the scene's last figure
/// (dual quaternion skinning). Its parts are named like the body's joints. The mannequin must
/// outlive the scene. With fingers, those of a pose without any are relaxed
/// (motion::relaxed_fingers).
void add_mannequin(render::Scene& scene, const Mannequin& mannequin, const motion::Skeleton& body,
                   const motion::Pose& pose);

/// The mannequin in a pose, as a mesh: material 0, parts are the joints of the body.
render::Mesh posed(const Mannequin& mannequin, const motion::Skeleton& body,
                   const motion::Pose& pose);

/// A mannequin that was made for this body as a GLB file (skinned_glb.h); its joints are the
/// body's, with those of fingers if it has any. glTF viewers use linear blend skinning, so twisting
/// wrists and shoulders are a little thinner than in films. Throws as `skinned_glb`.
std::string to_glb(const Mannequin& mannequin, const motion::Skeleton& body);

/// The largest connected component of a surface. Where a shape is thinner than the cells of the
/// grid, its end may become a separate component.
Surface largest_component(Surface surface);

/// The texture of a mannequin. u is the side of the body (0 right … 0.5 midline … 1 left), v the
/// signed depth inside the outline of the face, above 0.5 inside it and below 0.5 outside. Both
/// change smoothly over the surface, and the texture changes colour abruptly at fixed values of u
/// and v: the borders on the body are clean curves however large its triangles are.
render::Texture mannequin_paint(const FigureColours& colours);

/// The texture coordinates of a vertex in the bind pose.
std::array<float, 2> paint_uv(const motion::Skeleton& body, const motion::JointTransforms& pose,
                              const motion::Vec3& point, const std::vector<Influence>& influences);

}  // namespace mien::scenes
