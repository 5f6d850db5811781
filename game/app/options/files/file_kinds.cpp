#include "game/app/options/files/file_kinds.hpp"

#include "runtime/file/lower_case.hpp"

#include <algorithm>

namespace trembler {

std::string expectedOf(FileKind const& kind) {
    std::string text = "the name of a file that can be written";
    if (!kind.endings.empty()) {
        text += kind.needsEnding ? ", ending in " : ", ending in ";
        for (std::size_t i = 0; i < kind.endings.size(); ++i) {
            text += i == 0 ? "" : i + 1 == kind.endings.size() ? " or " : ", ";
            text += kind.endings[i];
        }
        text += kind.needsEnding ? "" : ", or without an ending";
    }
    return text + (kind.toTerminal ? "; or \"-\", the terminal" : "");
}

bool hasEndingOf(std::filesystem::path const& name, FileKind const& kind) {
    std::string const ending = inLowerCase(name.extension().string());
    if (kind.endings.empty() || (ending.empty() && !kind.needsEnding)) {
        return true;
    }
    return std::find(kind.endings.begin(), kind.endings.end(), ending) != kind.endings.end();
}

} // namespace trembler
