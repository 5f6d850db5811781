// The layout of JSON in this project's files.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace trembler::edit {

/// Widest line, in bytes, that a list or an object is put into.
inline constexpr std::size_t widestLine = 110;

/// The text of a value in one line: {"at": [1, 2]}. Numbers are the shortest that read back bit for bit;
/// bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string inOneLine(nlohmann::ordered_json const& value);

/// The text of a value: a value that fits into a line is put into one line; a longer list has one entry per
/// line, indented by two more; the members of a longer object follow each other in lines, indented by one
/// more. `indent` is that of the line in which it begins, `column` the length of that line before it.
[[nodiscard]] std::string layOut(nlohmann::ordered_json const& value, std::size_t indent = 0,
                                 std::size_t column = 0);

/// A whole file: one member per line, and a line feed at the end.
[[nodiscard]] std::string layOutFile(nlohmann::ordered_json const& value);

} // namespace trembler::edit
