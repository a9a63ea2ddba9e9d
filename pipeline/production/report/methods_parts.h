#pragma once

#include "pipeline/production/report/methods_text.h"

namespace mien::pipeline {

// What the methods section tells, part by part; nothing where there is nothing to tell.

/// What the motions were made from, and what people thought of it.
void tell_examples(MethodsText& out);

/// How examples became motions, how near these came to what was asked for, and what was held.
void tell_blends(MethodsText& out);

/// What was done to motions afterwards, and which of them are foils.
void tell_modifications(MethodsText& out);

/// How the motions were shown, what films have in common, and how far motions are from each other.
void tell_pictures(MethodsText& out);

/// Every setting of films and of how their motions are interpolated that is another than it would
/// be if nothing were said, but for those that the other sentences tell of all films; and how many
/// dots point lights have, of what size.
void tell_settings(MethodsText& out);

/// Likewise of the folder of examples.
void tell_example_settings(MethodsText& out);

/// In which order guesses and matches of a matching experiment come, and what plays beside, where
/// that is another than it would be.
void tell_matching_settings(MethodsText& out);

}  // namespace mien::pipeline
