#include "runtime/file/cut_text.hpp"

#include "runtime/file/visible_text.hpp"

#include <string_view>

namespace trembler {

std::string cutText(std::string text, std::size_t most) {
    if (text.size() <= most) {
        return text;
    }
    constexpr std::string_view sign = "...";
    text.resize(most < sign.size() ? 0 : most - sign.size());
    text.resize(text.size() - unfinishedCharacter(text));
    text += sign;
    return text;
}

} // namespace trembler
