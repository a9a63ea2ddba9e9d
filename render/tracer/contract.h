#pragma once

#include <array>
#include <string_view>

namespace mien::render {

/// How a quantity's mean over seeds compares with its mean in pictures that are rendered by camera
/// and shadow rays alone (reference.h).
enum class Accuracy {
  exact,     ///< equal up to rounding, and without noise
  unbiased,  ///< equal
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

/// Bias as a share of the sky's light on the floor, beside spheres and round cones that touch the
/// floor.
inline constexpr BiasBound floor_sky_bias{0.07, 0.02, 0.007};

/// Bias as a share of the light on the floor, in blocks of 10 x 10 pixels of a picture of 80 x 60.
/// It arises because radiance and fading are evaluated at the pixel's centre; it is largest below
/// the horizon, where the floor fades within few pixels, and smaller in larger pictures.
inline constexpr BiasBound floor_light_bias{0.003, 0.003, 0.003};

/// Bias as a share of the sky's light on a solid, in blocks of 10 x 10 pixels: its occlusion is
/// blurred, in drafts by 3 pixels, in standard quality by 2. The largest that was found in drafts
/// is 3.4 %, between two legs of 90 pixels' height that nearly touch.
inline constexpr BiasBound figure_sky_bias{0.04, 0.02, 0.0};

/// Bias as a share of the light on a lit solid, in blocks of 10 x 10 pixels: in drafts, the edges
/// of shadows on it are blurred by 3 pixels; in drafts and standard quality, samples of a pixel are
/// shaded together.
inline constexpr BiasBound figure_light_bias{0.05, 0.01, 0.0};

/// Bias as a share of the light on the floor, in blocks of 10 x 10 pixels: in drafts and standard
/// quality, shadows are blurred by 2 and 1 pixels.
inline constexpr BiasBound floor_shadow_bias{0.02, 0.01, 0.0};

/// Every quantity of which a picture is made. The model is that of the reference: Lambert surfaces
/// with a GGX lobe, direct light of area lights and a sky. Tests named Contract cover draft,
/// standard and final quality.
inline constexpr std::array contract{
    ContractRow{"edges of solids", Accuracy::unbiased, no_bias, "camera rays",
                "Contract.HoldsPerBlock"},
    ContractRow{
        "light of the area lights on solids", Accuracy::biased, figure_light_bias,
        "shadow rays; the surface is that at the mean of up to four points; in drafts light "
        "of two points of each light, less the mean of what shadow rays of neighbouring "
        "samples of one surface find occluded, and specular highlights by shadow rays",
        "Contract.HoldsPerBlock (unshared), Contract.HoldsWhereOcclusionIsShared, "
        "SharedOcclusion.KeepsTheMeansOfLitBlocks"},
    ContractRow{"light of the sky on solids", Accuracy::biased, figure_sky_bias,
                "closed form, less what shadow rays find occluded, in drafts and standard quality "
                "the mean over neighbouring samples of one surface",
                "Contract.HoldsPerBlock (unshared), Contract.HoldsWhereOcclusionIsShared, "
                "SharedOcclusion.KeepsTheMeansOfBlocks"},
    ContractRow{"floor and backdrop without shadows", Accuracy::biased, floor_light_bias,
                "closed form at the centre of the pixel, every eighth pixel where a cubic suffices",
                "Contract.HoldsPerBlock"},
    ContractRow{"grid lines of the floor", Accuracy::biased, floor_light_bias,
                "box filter over the pixel's footprint", "Contract.HoldsPerBlock"},
    ContractRow{"static solids", Accuracy::unbiased, no_bias, "rendered once per camera",
                "StaticBackground.GivesTheMeanThatTracingAllOfItEachTimeGives"},
    ContractRow{"shadows of the area lights on the floor", Accuracy::biased, floor_shadow_bias,
                "shadow rays, in drafts and standard quality the mean over neighbouring samples",
                "Contract.HoldsPerBlock (unshared), Contract.HoldsWhereOcclusionIsShared, "
                "SharedOcclusion.KeepsTheMeansOfTheFloorsShadows"},
    ContractRow{"occlusion of the sky on the floor", Accuracy::biased, floor_sky_bias,
                "interpolated between points of a grid",
                "FloorSky.IsSmoothBesideFeetAndNotFarFromWhatItIs"},
    ContractRow{"edges under motion blur and opacity", Accuracy::unbiased, no_bias,
                "each sample by itself", "Contract.HoldsPerBlock"},
    ContractRow{"depth of field", Accuracy::unbiased, no_bias, "each sample by itself",
                "Exposing.BlursWhatIsOutOfFocusIntoADisc"},
};

}  // namespace mien::render
