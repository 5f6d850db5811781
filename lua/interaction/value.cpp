#include "lua/interaction/value.hpp"

#include <cmath>

namespace trembler::lua {

std::string_view kindOf(Value const& value) {
    switch (value.index()) {
    case 0:
        return "a boolean";
    case 1:
        return "a number";
    case 2:
        return "a vector";
    default:
        return "a text";
    }
}

bool isFinite(Value const& value) {
    if (double const* const number = std::get_if<double>(&value)) {
        return std::isfinite(*number);
    }
    if (Vec2 const* const vector = std::get_if<Vec2>(&value)) {
        return std::isfinite(vector->x) && std::isfinite(vector->y);
    }
    return true;
}

} // namespace trembler::lua
