#pragma once

#include <string>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"
#include "render/scene/scene.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/mannequin/mannequin_flesh.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// A smooth body on the bones of one skeleton.
struct Mannequin {
  SkinnedMesh mesh;  ///< uv: the place in `paint`; triangle_parts: joints of the body
  motion::JointTransforms bind;
  render::Texture paint;
};

/// Makes a mannequin on the canonical body (`is_body`) with its own bone lengths, once a shot.
///
/// Its colours are those of the stick figure: left limbs lighter, right ones darker, but less so;
/// the face stands out, so that one can read where it looks.
Mannequin make_mannequin(const motion::Skeleton& body, const MannequinOptions& options,
                         const FigureColours& colours);

/// What its surface is made of; `texture` is where its paint stands among textures.
render::Material mannequin_skin(int texture);

/// Appends the mannequin in a pose of the body that it was made for (dual quaternion skinning), its
/// parts called like the body's joints and belonging to the scene's last figure. The mannequin has
/// to outlive the scene.
void add_mannequin(render::Scene& scene, const Mannequin& mannequin, const motion::Skeleton& body,
                   const motion::Pose& pose);

/// As above, as a mesh: material 0, parts the joints of the body.
render::Mesh posed(const Mannequin& mannequin, const motion::Skeleton& body,
                   const motion::Pose& pose);

/// A mannequin that was made for that body as a GLB file (skinned_glb.h); its joints are the
/// body's. Readers of glTF skin it linearly, so that wrists and shoulders that twist get a little
/// thinner than in films. Throws Error.
std::string to_glb(const Mannequin& mannequin, const motion::Skeleton& body);

}  // namespace mien::scenes
