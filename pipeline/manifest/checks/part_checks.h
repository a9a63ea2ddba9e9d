#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/vocabulary.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/reading/resolved_manifest.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

/// What a schema cannot say: ids that occur twice, files that are missing, sizes that no encoder
/// takes, values that need examples or ratings where there are none, sheets of one motion, looks
/// and questionnaires that contradict themselves. No check needs that others went before.
std::vector<Fault> check_meaning(const ResolvedManifest& resolved);

/// Folders, ratings, scales and keytimes that are missing or do not go together.
std::vector<Fault> check_examples(const Manifest& manifest);

/// Stimuli whose values need examples or ratings where there are none, clips that are missing, and
/// options of another method of interpolation.
std::vector<Fault> check_stimuli(const Manifest& manifest);

/// Finds what cannot be walked in a stimulus' `path:`, if it has one: moods that are none, steps
/// that contradict themselves, points that are too near, and what would take too long.
void check_walk_path(const Stimulus& stimulus, FaultList& list);

/// What a schema cannot say of modifications: keys that exclude each other or belong to another
/// method, poses and styles that need examples or files where there are none.
std::vector<Fault> check_modifications(const Manifest& manifest);

/// Examples that modifications name and that do not exist.
std::vector<Fault> check_modification_names(const Manifest& manifest, const Vocabulary& vocabulary);

/// Overlays and sheets whose parts do not go together.
std::vector<Fault> check_overlays(const Manifest& manifest);
std::vector<Fault> check_sheets(const Manifest& manifest);

/// Ids and names of videos that occur twice.
std::vector<Fault> check_ids(const Manifest& manifest);

/// Adjectives, features, weights, modifications and sheets that name what does not exist.
std::vector<Fault> check_names(const Manifest& manifest, const Vocabulary& vocabulary);

/// Stimuli, scales and factors that are not there, and settings that exclude each other. The
/// study's scales must have been read.
std::vector<Fault> check_questionnaire(const Manifest& manifest);

/// Stimuli that a questionnaire shows as videos and that are written in no kind that browsers play:
/// one fault for all of them.
std::vector<Fault> check_shown_videos(const Manifest& manifest);

/// What a questionnaire may ask for, and yet hardly means: attention checks that can leave nobody
/// out, or that do not come. The manifest must have no faults.
std::vector<Fault> questionnaire_warnings(const Manifest& manifest);

/// Targets, adjectives and features that are not there, a manifest without targets, or with a
/// questionnaire beside. The study's scales must have been read.
std::vector<Fault> check_matching(const Manifest& manifest);

/// Files that the manifest reads out of `folder`, in which its run writes: it would replace them.
std::vector<Fault> check_sources(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace mien::pipeline
