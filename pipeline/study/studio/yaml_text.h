#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

/// A value as YAML on one line: {a: 1, b: [x, "2"]}. Texts that would be read as something else are
/// quoted, and "${" does not begin a variable.
std::string yaml_line(const nlohmann::ordered_json& value);

/// A text in quotes: "…" or, where `quote` is ', '…' if it can be.
std::string quoted_yaml(const std::string& text, char quote);

/// Members or elements below each other, each line but the first behind `indent` spaces. What is
/// empty or no collection, and what fits in `width` bytes, stands on its line.
std::string yaml_lines(const nlohmann::ordered_json& value, std::size_t indent, std::size_t width);

/// Lines are no longer than this, if that can be.
inline constexpr std::size_t yaml_width = 100;

/// "name: value", the name `column` bytes from the line's begin; a long value stands below it.
std::string yaml_member(const std::string& name, const nlohmann::ordered_json& value,
                        std::size_t column);

/// An element of a list behind its dash, `column` bytes from the line's begin: of a map, a member
/// a line.
std::string yaml_element(const nlohmann::ordered_json& value, std::size_t column);

}  // namespace mien::pipeline
