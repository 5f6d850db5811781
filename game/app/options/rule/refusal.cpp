#include "game/app/options/rule/refusal.hpp"

#include "game/app/options/rule/rule.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trembler {
namespace {

CLI::App& chosenIn(CLI::App& program) {
    CLI::App* command = &program;
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
    }
    return *command;
}

/// "trembler mod check"
std::string wholeName(CLI::App const& command) {
    CLI::App const* const parent = command.get_parent();
    return parent == nullptr ? command.get_name() : wholeName(*parent) + " " + command.get_name();
}

std::vector<std::string> optionsOf(CLI::App& command) {
    std::vector<std::string> names;
    for (CLI::Option const* const option : command.get_options()) {
        for (std::string const& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

std::vector<std::string> commandsOf(CLI::App& command) {
    std::vector<std::string> names;
    for (CLI::App const* const inner : command.get_subcommands([](CLI::App*) { return true; })) {
        names.push_back(inner->get_name());
    }
    return names;
}

/// An option with a value that is itself an option, as in "--csv --svg run.svg".
std::optional<std::string> optionAsValue(CLI::App& command) {
    std::vector<std::string> const names = optionsOf(command);
    for (CLI::Option* const option : command.get_options()) {
        for (std::string const& value : option->results()) {
            if (std::find(names.begin(), names.end(), value.substr(0, value.find('='))) != names.end()) {
                return fmt::format("{} {}: {} is an option itself; expected {}", option->get_name(),
                                   shown(value), shown(value), expectedBy(*option));
            }
        }
    }
    return std::nullopt;
}

/// "--name=" as the parser would take it: without a value, or with the next argument for it.
std::optional<std::string> emptyBehindEquals(CLI::App& command, std::vector<std::string> const& arguments) {
    for (CLI::Option* const option : command.get_options()) {
        for (std::string const& name : option->get_lnames()) {
            if (std::find(arguments.begin(), arguments.end(), fmt::format("--{}=", name)) !=
                arguments.end()) {
                std::string const expected = expectedBy(*option);
                return fmt::format("--{}: the value is empty; expected {}", name,
                                   expected.empty() ? "no value" : expected);
            }
        }
    }
    return std::nullopt;
}

std::string inUnknown(CLI::App& command, std::string const& argument) {
    if (!argument.starts_with('-')) {
        return fmt::format("{}: {} takes no such argument; see {} --help", shown(argument),
                           wholeName(command), wholeName(command));
    }
    std::string const name = argument.substr(0, argument.find('='));
    return fmt::format("{}: {} has no such option{}; see {} --help", shown(name), wholeName(command),
                       didYouMean(name, optionsOf(command)), wholeName(command));
}

/// An option at the end of the arguments, whose value is missing.
std::optional<std::string> withoutValue(CLI::App& command, std::vector<std::string> const& arguments) {
    for (CLI::Option* const option : command.get_options()) {
        for (std::string const& name : option->get_lnames()) {
            if (!arguments.empty() && arguments.back() == "--" + name &&
                option->get_items_expected_max() > 0) {
                return fmt::format("--{}: the value is missing; expected {}", name, expectedBy(*option));
            }
        }
    }
    return std::nullopt;
}

/// A flag with a value, "--brief=no".
std::optional<std::string> flagWithValue(CLI::App& command, std::vector<std::string> const& arguments) {
    for (CLI::Option* const option : command.get_options()) {
        for (std::string const& name : option->get_lnames()) {
            for (std::string const& argument : arguments) {
                if (option->get_items_expected_max() == 0 && argument.starts_with("--" + name + "=")) {
                    return fmt::format("{}: expected --{} without a value", shown(argument), name);
                }
            }
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<std::string> refusalOf(CLI::App& program, std::vector<std::string> const& arguments) {
    CLI::App& command = chosenIn(program);
    if (auto fault = emptyBehindEquals(command, arguments)) {
        return fault;
    }
    if (auto fault = optionAsValue(command)) {
        return fault;
    }
    return faultIn(command);
}

std::string refusalOf(CLI::App& program, std::vector<std::string> const& arguments,
                      CLI::ParseError const& error) {
    CLI::App& command = chosenIn(program);
    std::vector<std::string> const commands = commandsOf(command);
    if (!commands.empty()) { // no command was chosen
        auto const stated =
            std::find_if(arguments.begin(), arguments.end(),
                         [&](std::string const& argument) { return argument != command.get_name(); });
        if (stated == arguments.end()) {
            return fmt::format("a command is missing; expected {}; see {} --help", listed(commands),
                               wholeName(command));
        }
        return stated->starts_with('-')
                   ? inUnknown(command, *stated)
                   : fmt::format("{}: there is no such command{}; expected {}", shown(*stated),
                                 didYouMean(*stated, commands), listed(commands));
    }
    if (auto fault = refusalOf(program, arguments)) {
        return *fault;
    }
    if (auto const fault = flagWithValue(command, arguments)) {
        return *fault;
    }
    if (dynamic_cast<CLI::ExtrasError const*>(&error) != nullptr) {
        std::vector<std::string> const rest = program.remaining(true);
        return rest.empty() ? shown(error.what()) : inUnknown(command, rest.front());
    }
    if (dynamic_cast<CLI::ArgumentMismatch const*>(&error) != nullptr) {
        if (auto const fault = withoutValue(command, arguments)) {
            return *fault;
        }
    }
    return fmt::format("{}; see {} --help", shown(error.what()), wholeName(command));
}

} // namespace trembler
