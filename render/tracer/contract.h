#pragma once

#include <array>
#include <string_view>

namespace mien::render {

/// How the mean over seeds of a quantity compares with its mean by camera and shadow rays alone
/// (reference.h).
enum class Accuracy {
  exact,     ///< the same, up to rounding, and without noise
  unbiased,  ///< the same
  biased     ///< differs by at most the bound
};

/// Largest bias, as a share of the light that the quantity is a part of.
struct BiasBound {
  double draft;
  double standard;
  double final;
};

/// What the fast renderer promises about one quantity of a picture.
struct ContractRow {
  std::string_view quantity;
  Accuracy accuracy;
  BiasBound bound;        ///< 0 unless biased
  std::string_view how;   ///< in which way it is computed
  std::string_view test;  ///< suite and name of the test that holds it
};

inline constexpr BiasBound no_bias{0.0, 0.0, 0.0};

/// Of the sky's light on the floor: beside spheres and round cones that touch it. Elsewhere it is
/// below 0.001.
inline constexpr BiasBound floor_sky_bias{0.06, 0.02, 0.006};

/// Of the light on the floor, between the centres of pixels: radiance is taken at the centre.
inline constexpr BiasBound floor_light_bias{0.0005, 0.0005, 0.0005};

/// Every quantity of which a picture is made. What is not in this list has no approximation: the
/// model (Lambert surfaces with a GGX lobe under area lights and a sky, direct light) is that of
/// the reference, too.
inline constexpr std::array contract{
    ContractRow{"edges of solids", Accuracy::unbiased, no_bias, "camera rays",
                "Contract.HoldsPerBlock"},
    ContractRow{"light of the area lights on solids", Accuracy::unbiased, no_bias,
                "shadow rays; in drafts shared by two neighbouring pixels",
                "Contract.HoldsPerBlock"},
    ContractRow{"light of the sky on solids", Accuracy::unbiased, no_bias,
                "closed form, less what shadow rays find occluded", "Contract.HoldsPerBlock"},
    ContractRow{"floor and backdrop without shadows", Accuracy::biased, floor_light_bias,
                "closed form at the centre of the pixel, every eighth pixel where a cubic suffices",
                "Contract.HoldsPerBlock"},
    ContractRow{"lines of the floor", Accuracy::biased, floor_light_bias,
                "box filter of the pixel's footprint; exact in the mean over areas",
                "Contract.HoldsPerBlock"},
    ContractRow{"static solids", Accuracy::unbiased, no_bias, "rendered once per camera",
                "StaticBackground.GivesTheMeanThatTracingAllOfItEachTimeGives"},
    ContractRow{"shadows of the area lights on the floor", Accuracy::unbiased, no_bias,
                "line samples, shared by up to 4 x 4 pixels in wide penumbrae; else shadow rays",
                "Contract.HoldsPerBlock"},
    ContractRow{"occlusion of the sky on the floor", Accuracy::biased, floor_sky_bias,
                "interpolated between points of a grid",
                "FloorSky.IsSmoothBesideFeetAndNotFarFromWhatItIs"},
    ContractRow{"motion blur, depth of field, opacity", Accuracy::unbiased, no_bias,
                "each sample by itself", "Contract.HoldsPerBlock"},
};

}  // namespace mien::render
