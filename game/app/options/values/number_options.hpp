// Command-line options that take a number.
#pragma once

#include "game/app/options/rule/rule.hpp"
#include "game/app/options/values/numbers.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <concepts>
#include <optional>
#include <string>

namespace trembler {

/// An option with a whole number from `least` to `most`, stored in a number or an optional number; `target`
/// must live until the program is parsed. Any other text is refused with a message that states the expected
/// range.
template <class Target>
CLI::Option* addNumber(CLI::App& command, std::string const& option, Target& target, std::int64_t least,
                       std::int64_t most, std::string const& meaning) {
    auto* const added = command.add_option_function<std::string>(
        option,
        [&target, least, most](std::string const& text) {
            if (auto const number = wholeNumber(text, least, most)) {
                if constexpr (requires { typename Target::value_type; }) {
                    target = static_cast<typename Target::value_type>(*number);
                } else {
                    target = static_cast<Target>(*number);
                }
            }
        },
        meaning);
    return accepts(added->type_name(fmt::format("N in [{} - {}]", least, most)),
                   fmt::format("a whole number from {} to {}, in decimal without leading zeros", least, most),
                   [least, most](std::string const& text) {
                       return wholeNumber(text, least, most) ? Fault() : Fault("");
                   });
}

/// The same for a finite real number.
inline CLI::Option* addNumber(CLI::App& command, std::string const& option, std::optional<double>& target,
                              double least, double most, std::string const& meaning) {
    auto* const added = command.add_option_function<std::string>(
        option,
        [&target, least, most](std::string const& text) { target = decimalNumber(text, least, most); },
        meaning);
    return accepts(added->type_name(fmt::format("NUMBER in [{} - {}]", least, most)),
                   fmt::format("a number from {} to {}", least, most),
                   [least, most](std::string const& text) {
                       return decimalNumber(text, least, most) ? Fault() : Fault("");
                   });
}

} // namespace trembler
