// The examples of functions, by the resolvers that offer them.
#pragma once

#include "lua/reference/function_examples.hpp"

#include <span>

namespace trembler::lua {

[[nodiscard]] std::span<FunctionExample const> dynamicsExamples();
[[nodiscard]] std::span<FunctionExample const> fieldExamples();
[[nodiscard]] std::span<FunctionExample const> electricityExamples();
[[nodiscard]] std::span<FunctionExample const> soundExamples();
[[nodiscard]] std::span<FunctionExample const> worldExamples();

} // namespace trembler::lua
