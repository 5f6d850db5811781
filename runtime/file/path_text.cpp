#include "runtime/file/path_text.hpp"

#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <optional>

namespace trembler {
namespace {

std::optional<unsigned> digitOf(char letter) {
    if (letter >= '0' && letter <= '9') {
        return static_cast<unsigned>(letter - '0');
    }
    if (letter >= 'a' && letter <= 'f') {
        return static_cast<unsigned>(letter - 'a') + 10U;
    }
    return std::nullopt;
}

} // namespace

std::string pathAsText(std::string_view path) {
    std::string text;
    text.reserve(path.size());
    while (!path.empty()) {
        std::size_t const length = characterLength(path);
        if (length == 0) {
            text += '\0';
            text += fmt::format("{:02x}", static_cast<unsigned char>(path.front()));
        } else {
            text += path.substr(0, length);
        }
        path.remove_prefix(length == 0 ? 1 : length);
    }
    return text;
}

std::string pathFromText(std::string_view text) {
    std::string path;
    path.reserve(text.size());
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '\0' && at + 2 < text.size()) {
            auto const high = digitOf(text[at + 1]);
            auto const low = digitOf(text[at + 2]);
            if (high && low) {
                path += static_cast<char>(*high * 16U + *low);
                at += 2;
                continue;
            }
        }
        path += text[at];
    }
    return path;
}

} // namespace trembler
