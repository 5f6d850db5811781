#include "game/app/options/rule/rule.hpp"

#include "runtime/file/cut_text.hpp"
#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace trembler {
namespace {

// The parser keeps a rule as an inactive validator, which it neither applies (a FILE that may be left out can
// turn out to be the level, see takeBack()) nor shows in --help.
constexpr char const* ruleName = "rule";
constexpr char const* keyName = "once per key";
constexpr char const* pathName = "once per path";

std::optional<CLI::Validator> kept(CLI::Option& option, std::string const& name) {
    try {
        CLI::Validator validator = *option.get_validator(name);
        validator.active();
        return validator;
    } catch (CLI::OptionNotFound const&) {
        return std::nullopt;
    }
}

CLI::Option* marked(CLI::Option* option, char const* name) {
    CLI::Validator validator([](std::string&) { return std::string(); }, "");
    validator.active(false);
    return option->check(validator, name);
}

bool isFlag(CLI::Option const& option) {
    return option.get_items_expected_max() == 0;
}

/// "." and links taken out, as far as the path is there.
std::string samePath(std::string const& path) {
    std::error_code error;
    std::filesystem::path const same = std::filesystem::weakly_canonical(path, error);
    return error ? path : same.string();
}

/// What must differ between the values of a list.
enum class Key { value, beforeEquals, path };

Key keyOf(CLI::Option& option) {
    return kept(option, keyName) ? Key::beforeEquals : kept(option, pathName) ? Key::path : Key::value;
}

std::string keyOf(std::string const& value, Key key) {
    return key == Key::beforeEquals ? value.substr(0, value.rfind('='))
           : key == Key::path       ? samePath(value)
                                    : value;
}

std::optional<std::string> faultOfRepetition(CLI::Option& option) {
    std::string const name = option.get_name();
    std::vector<std::string> const& values = option.results();
    if (isFlag(option)) {
        return values.size() > 1
                   ? std::optional(fmt::format("{}: stated {} times; expected once", name, values.size()))
                   : std::nullopt;
    }
    Key const key = keyOf(option);
    bool const list = option.get_expected_max() > 1;
    std::map<std::string, std::string> stated; // values by what must differ
    for (std::string const& value : values) {
        std::string differing = list ? keyOf(value, key) : std::string();
        if (auto const [before, isNew] = stated.try_emplace(std::move(differing), value); !isNew) {
            return fmt::format("{} {}: {} {} was stated before; expected {}", name, shown(value), name,
                               shown(before->second),
                               key == Key::beforeEquals ? fmt::format("{} once", shown(before->first))
                               : list                   ? "every value once"
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
    return marked(option, keyName);
}

CLI::Option* oncePerPath(CLI::Option* option) {
    return marked(option, pathName);
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
