#pragma once

#include <filesystem>

#include "pipeline/commands/study/frozen_archive.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/chains/experiment/chain_study.h"

namespace mien::pipeline {

/// Builds the preregistration archive of an adaptive experiment:
///
///     README.txt           description of the archive, with the hash of the design
///     procedure.md         method, words, dimensions and chains, as in the methods section
///     references.bib       works that it cites
///     analysis.txt         when the experiment ends, and how its answers are analysed
///     plans.csv            every trial of every participant
///     experiment.json      all sessions, with the starts of the chains
///     inputs/…             the manifest and the files that it names
///     dummy-report/…       simulated answers and their analysis
///     manifest-sha256.txt  hashes of all other files
///
/// Throws Error if `file` exists with other bytes. Writes nothing to disk. The same study results
/// in the same bytes.
FrozenArchive frozen_chains(const Manifest& manifest, Motions& motions, const ChainStudy& study,
                            const std::filesystem::path& file);

}  // namespace mien::pipeline
