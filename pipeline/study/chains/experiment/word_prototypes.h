#pragma once

#include <filesystem>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/chains/experiment/chain_results.h"

namespace mien::pipeline {

/// A scale for each word, from "not <word>" to the word in each language of the pages, with the
/// word's id as its own.
ScaleSet word_scales(const Manifest& manifest);

/// Ratings of the examples on these scales, as a CSV of answers (participant, stimulus, scale,
/// value; and simulated) that `examples.ratings` takes. Each chain is a rater, named after its
/// participant or its number. The rating of an example at x is linear in the space,
///
///   t = ½ + ½ (x − c)·(p − c)/|p − c|²,   clamped to 0…1,
///
/// with p the mean of the chain's samples and c the mean of the examples, in units of the ranges:
/// ½ in the middle of the examples, 1 for what looks as much like the word as the prototype. The
/// value is that share of the scale's range. Throws Error if a chain's mean is at c. The space must
/// not be one of modifications, which has one example only.
std::string word_ratings_csv(const ChainStudy& study, const ChainResults& results,
                             const ScaleSet& scales);

/// A manifest with a stimulus for each word, made from the dimensions of its prototype (of
/// components, from the weights that they give the examples; of modifications, from their steps),
/// and a questionnaire in which participants rate these on the scales, without a title and texts of
/// its own. Its files lie beside it: scales in `scales`. Its name says whether the answers were
/// simulated.
Manifest prototype_manifest(const Manifest& source, const ChainStudy& study,
                            const ChainResults& results, const std::filesystem::path& scales);

}  // namespace mien::pipeline
