// The kinds of files that commands write, and the endings of their names.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace trembler {

/// A name with another ending would lie about the contents, and programs that go by it would not open the
/// file; a name without any ending is right for every kind but one that states so. Text of any kind may be in
/// a .txt file.
struct FileKind {
    std::string_view name;                       ///< "a PNG picture"
    std::span<std::string_view const> endings{}; ///< in small letters, the usual one first; none: any
    bool needsEnding = false;
    bool toTerminal = true; ///< whether "-" may be stated for standard output
};

namespace file_kinds {

namespace endings {
inline constexpr std::string_view json[]{".json", ".txt"};
inline constexpr std::string_view jsonLines[]{".jsonl", ".ndjson", ".json", ".txt"};
inline constexpr std::string_view markdown[]{".md", ".markdown", ".txt"};
inline constexpr std::string_view csv[]{".csv", ".txt"};
inline constexpr std::string_view netlist[]{".cir", ".sp", ".spice", ".net", ".ckt", ".txt"};
inline constexpr std::string_view svg[]{".svg"};
inline constexpr std::string_view png[]{".png"};
inline constexpr std::string_view webp[]{".webp"};
inline constexpr std::string_view wav[]{".wav"};
inline constexpr std::string_view level[]{".json"};
} // namespace endings

inline constexpr FileKind json{"JSON", endings::json};
inline constexpr FileKind jsonLines{"lines of JSON", endings::jsonLines};
inline constexpr FileKind markdown{"Markdown", endings::markdown};
inline constexpr FileKind csv{"comma-separated values", endings::csv};
inline constexpr FileKind netlist{"a netlist", endings::netlist};
inline constexpr FileKind svg{"an SVG picture", endings::svg};
inline constexpr FileKind png{"a PNG picture", endings::png};
inline constexpr FileKind webp{"an animated WebP", endings::webp};
inline constexpr FileKind wav{"a sound", endings::wav, true, false};
/// What --resume adds its work to. Its form is the program's own and has no usual ending.
inline constexpr FileKind journal{
    .name = "finished work", .endings = {}, .needsEnding = false, .toTerminal = false};
/// A level that the editor makes.
inline constexpr FileKind level{"a level", endings::level, true, false};

} // namespace file_kinds

/// "the name of a file that can be written, ending in .csv or .txt, or "-" for the terminal"
[[nodiscard]] std::string expectedOf(FileKind const& kind);
/// Whether the ending of the name is one of the kind's, in small or capital letters.
[[nodiscard]] bool hasEndingOf(std::filesystem::path const& name, FileKind const& kind);

} // namespace trembler
