#include "game/ui/shared/readable_number.hpp"

#include "game/ui/shared/texts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trembler::ui {

std::string readable(double value) {
    double const size = std::abs(value);
    if (size < 1e-9) {
        return "0";
    }
    if (size >= 1e7 || size < 1e-3) {
        return fmt::format(numberLocale(), "{:.3Lg}", value);
    }
    std::string text =
        fmt::format("{:.{}f}", value, size >= 1000 ? 0 : (size >= 100 ? 1 : (size >= 10 ? 2 : 3)));
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return text == "-0" ? "0" : localNumber(text);
}

} // namespace trembler::ui
