#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// A number and its noun: "1 person", "2 people".
std::string counted(std::size_t count, const std::string& one, const std::string& several);

/// "5 of 6 people count"
std::string people_sentence(const Gathered& gathered);

/// One about each who did not finish, and what became of the answers.
std::vector<std::string> unfinished_sentences(const Gathered& gathered);

}  // namespace mien::pipeline
