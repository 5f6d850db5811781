#include "game/app/options/rule/rule.hpp"

#include "runtime/file/cut_text.hpp"
#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace trembler {
namespace {

// The parser keeps a rule as an inactive validator, which it neither applies (a FILE that may be left out can
// turn out to be the level, see takeBack()) nor shows in --help.
constexpr char const* ruleName = "rule";
constexpr char const* keyName = "once per key";

std::optional<CLI::Validator> kept(CLI::Option& option, std::string const& name) {
    try {
        CLI::Validator validator = *option.get_validator(name);
        validator.active();
        return validator;
    } catch (CLI::OptionNotFound const&) {
        return std::nullopt;
    }
}

bool isFlag(CLI::Option const& option) {
    return option.get_items_expected_max() == 0;
}

/// What must differ between the values of a list.
std::string keyOf(std::string const& value, bool beforeEquals) {
    return beforeEquals ? value.substr(0, value.rfind('=')) : value;
}

std::optional<std::string> faultOfRepetition(CLI::Option& option) {
    std::string const name = option.get_name();
    std::vector<std::string> const& values = option.results();
    if (isFlag(option)) {
        return values.size() > 1
                   ? std::optional(fmt::format("{}: stated {} times; expected once", name, values.size()))
                   : std::nullopt;
    }
    bool const keyed = kept(option, keyName).has_value();
    bool const list = option.get_expected_max() > 1;
    for (std::size_t i = 1; i < values.size(); ++i) {
        auto const before = std::find_if(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(i),
                                         [&](std::string const& other) {
                                             return !list || keyOf(other, keyed) == keyOf(values[i], keyed);
                                         });
        if (before != values.begin() + static_cast<std::ptrdiff_t>(i)) {
            return fmt::format("{} {}: {} {} was stated before; expected {}", name, shown(values[i]), name,
                               shown(*before),
                               keyed  ? fmt::format("{} once", shown(keyOf(values[i], true)))
                               : list ? "every value once"
                                      : "one value");
        }
    }
    return std::nullopt;
}

std::optional<std::string> faultOfValues(CLI::Option& option) {
    std::optional<CLI::Validator> const rule = kept(option, ruleName);
    for (std::string value : option.results()) {
        if (value.empty()) {
            std::string const expected = expectedBy(option);
            return fmt::format("{}: the value is empty; expected {}", option.get_name(),
                               expected.empty() ? "a value" : expected);
        }
        if (std::string const fault = rule ? (*rule)(value) : std::string(); !fault.empty()) {
            return fmt::format("{} {}: {}", option.get_name(), shown(value), fault);
        }
    }
    return std::nullopt;
}

} // namespace

CLI::Option* accepts(CLI::Option* option, std::string const& expected, Rule rule) {
    CLI::Validator validator(
        [expected, rule = std::move(rule)](std::string& value) {
            Fault const fault = rule ? rule(value) : std::nullopt;
            return !fault           ? std::string()
                   : fault->empty() ? "expected " + expected
                                    : fmt::format("{}; expected {}", *fault, expected);
        },
        expected);
    validator.active(false);
    return option->check(validator, ruleName);
}

CLI::Option* oncePerKey(CLI::Option* option) {
    CLI::Validator validator([](std::string&) { return std::string(); }, "");
    validator.active(false);
    return option->check(validator, keyName);
}

std::optional<std::string> faultIn(CLI::App& command) {
    for (auto const judge : {faultOfRepetition, faultOfValues}) {
        for (CLI::Option* const option : command.get_options()) {
            if (option->count() == 0 || option == command.get_help_ptr()) {
                continue;
            }
            if (auto fault = judge(*option)) {
                return fault;
            }
        }
    }
    return std::nullopt;
}

std::string expectedBy(CLI::Option& option) {
    auto const rule = kept(option, ruleName);
    return rule ? rule->get_description() : std::string();
}

std::string shown(std::string_view value) {
    constexpr std::size_t most = 200; // bytes
    return visible(cutText(std::string(value), most));
}

} // namespace trembler
