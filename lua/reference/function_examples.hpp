// Scripts that were written as examples of functions.
#pragma once

#include <span>
#include <string_view>

namespace trembler::lua {

struct FunctionExample {
    std::string_view role;
    std::string_view function;
    std::string_view script;
};

[[nodiscard]] std::span<FunctionExample const> functionExamples();

} // namespace trembler::lua
