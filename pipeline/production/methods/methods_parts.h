#pragma once

#include "pipeline/production/methods/methods_text.h"

namespace mien::pipeline {

// The parts of the methods section. A part that has no subject in the study writes nothing.

/// What the motions were made from, and what people thought of it.
void describe_examples(MethodsText& out);

/// How examples became motions, how near these came to what was asked for, and what was held.
void describe_blends(MethodsText& out);

/// What was done to motions afterwards, and which of them are foils.
void describe_modifications(MethodsText& out);

/// How the motions were shown, what films have in common, and how far motions are from each other.
void describe_pictures(MethodsText& out);

/// Every setting of films and of the interpolation of their motions that differs from its default,
/// without those that other sentences give for all films; and number and size of point lights.
void describe_settings(MethodsText& out);

/// The settings of the folder of examples that differ from their defaults.
void describe_example_settings(MethodsText& out);

/// The order of guesses and matches of a matching experiment and the films beside them, where these
/// differ from their defaults.
void describe_matching_settings(MethodsText& out);

}  // namespace mien::pipeline
