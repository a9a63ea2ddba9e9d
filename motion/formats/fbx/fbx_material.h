#pragma once

#include <string>
#include <vector>

#include "motion/formats/fbx/fbx_scene.h"

namespace mien::motion {

/// A surface. Objects are indices in `FbxObjects::objects`, −1 for none.
struct FbxMaterial {
  std::string name;
  Vec3 colour = Vec3(0.8, 0.8, 0.8);  ///< "DiffuseColor", linear as stated
  double factor = 1.0;                ///< "DiffuseFactor", of the colour or its texture, 0 … 1
  int colour_texture = -1;            ///< object of the texture that takes the place of the colour
  int normal_texture = -1;            ///< object of the tangent-space normal map
  bool is_transparent = false;
};

/// A picture on a surface.
struct FbxTexture {
  /// File names of the picture as in the file: first the one that is relative to it; may be empty.
  std::vector<std::string> files;
  int video = -1;               ///< object of the kind "Video" that may hold the picture
  std::string uv_set;           ///< name of its set of texture coordinates; empty: the first
  bool is_transformed = false;  ///< whether it is moved, turned or scaled on the surface
};

/// The material of an object of the kind "Material". Numbers outside 0 … 1 are clamped.
FbxMaterial fbx_material(const FbxScene& scene, int object);

/// The texture of an object of the kind "Texture".
FbxTexture fbx_texture(const FbxScene& scene, int object);

/// The bytes of the picture that an object of the kind "Video" holds; empty if it holds none. In
/// text files they are in base64 (RFC 4648); what is not valid counts as none.
std::string fbx_picture(const FbxScene& scene, int video);

}  // namespace mien::motion
