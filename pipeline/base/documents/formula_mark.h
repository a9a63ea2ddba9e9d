#pragma once

#include <string>
#include <string_view>

namespace mien::pipeline {

// Spreadsheets take a field of a table that begins with = + - @ (wide ones, a tab and a line end
// too) for a formula, and run it when the table is opened (OWASP, CSV injection). Texts of
// participants may be anything: such a field is written with an apostrophe before it, which
// spreadsheets take for "this is text". Reading takes it off again, so that any text comes back as
// it was, one with apostrophes of its own too. Numbers, and two with "–" between them, are no
// formulas and stay as they are.
// pipeline/study/page/src/questionnaire/rows.ts does the same.

/// Whether it has to be marked: whatever apostrophes and blanks it begins with are passed over.
bool is_like_formula(std::string_view field);

std::string with_formula_mark(std::string field);
std::string without_formula_mark(std::string field);

}  // namespace mien::pipeline
