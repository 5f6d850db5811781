#include "game/ui/shared/commands/key_help.hpp"

#include "game/ui/shared/commands/named_keys.hpp"
#include "game/ui/shared/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cctype>

namespace trembler::ui {
namespace {

/// All labels, each between two marks, separated by commas.
std::string joined(std::span<Chord const> keys, char const* mark) {
    std::string all;
    for (Chord const& chord : keys) {
        all += (all.empty() ? "" : ", ") + std::string(mark) + labelOf(chord) + mark;
    }
    return all;
}

/// Adds a row, or adds the keys to the last row if its description is the same.
void append(std::vector<HelpLine>& lines, std::string const& keys, std::string const& does) {
    if (!lines.empty() && lines.back().does == does) {
        lines.back().keys += ", " + keys;
    } else {
        lines.push_back({keys, does});
    }
}

/// "Pause; go on": the description, and for a switch also that of its on state.
std::string doesOf(CommandInfo const& command, KeyBindings const& bindings) {
    std::string does = shownTip(command, false, bindings);
    if (command.whenOn.tip != nullptr) {
        std::string other = command.whenOn.tip;
        other[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(other[0])));
        does += "; " + other;
    }
    return does;
}

/// Calls `heading` for each group and then `line` for each of its commands.
template <class Heading, class Line>
std::string grouped(KeyBindings const& bindings, Heading&& heading, Line&& line) {
    std::string text;
    CommandInfo const* before = nullptr;
    for (CommandInfo const* command : bindings.inGroups()) {
        if (before == nullptr || before->group != command->group) {
            text += (before == nullptr ? "" : "\n") + heading(titleOf(command->group));
        }
        before = command;
        text += line(*command);
    }
    return text;
}

} // namespace

char const* titleOf(CommandGroup group) {
    switch (group) {
    case CommandGroup::building:
        return words::groupBuilding;
    case CommandGroup::running:
        return words::groupRunning;
    case CommandGroup::secondPlayer:
        return words::groupSecondPlayer;
    case CommandGroup::looking:
        return words::groupLooking;
    case CommandGroup::editing:
        return words::groupEditing;
    case CommandGroup::menus:
        return words::groupMenus;
    case CommandGroup::program:
        break;
    }
    return words::groupProgram;
}

std::string labelsOf(std::span<Chord const> keys) {
    return joined(keys, "");
}

std::vector<HelpLine> helpLines(CommandSet const& commands, std::span<Gesture const> gestures,
                                KeyBindings const& bindings) {
    std::vector<HelpLine> lines;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        CommandInfo const& command = commands.info(i);
        auto const gesturesHere = [&](bool shared) {
            for (Gesture const& gesture : gestures) {
                if (gesture.beside == command.id &&
                    (command.help.english() == std::string_view(gesture.does.english())) == shared) {
                    append(lines, gesture.with, gesture.does);
                }
            }
        };
        gesturesHere(true);
        if (auto const keys = bindings.keysOf(command.id); !keys.empty()) {
            append(lines, labelsOf(keys), command.help);
        }
        gesturesHere(false);
    }
    return lines;
}

std::string keysMarkdown(KeyBindings const& bindings) {
    return grouped(
        bindings,
        [](char const* group) {
            return fmt::format("### {}\n\n| what it does | keys | name in the profile |\n|---|---|---|\n",
                               group);
        },
        [&](CommandInfo const& command) {
            std::string const keys = joined(bindings.keysOf(command.id), "`");
            std::string const shown = keys.empty()                  ? words::nothingStated
                                      : command.use == KeyUse::held ? words::hold(keys)
                                                                    : keys;
            return fmt::format("| {} | {} | `{}` |\n", doesOf(command, bindings), shown, command.id);
        });
}

std::string gesturesMarkdown(std::span<Gesture const> gestures) {
    std::string text;
    for (CommandGroup const group :
         {CommandGroup::building, CommandGroup::running, CommandGroup::secondPlayer, CommandGroup::looking,
          CommandGroup::program, CommandGroup::editing, CommandGroup::menus}) {
        std::string rows;
        for (Gesture const& gesture : gestures) {
            if (gesture.group == group) {
                rows += fmt::format("| {} | {} |\n", gesture.does, gesture.with);
            }
        }
        if (!rows.empty()) {
            text += fmt::format("{}| {} | |\n|---|---|\n{}", text.empty() ? "" : "\n", titleOf(group), rows);
        }
    }
    return text;
}

std::string keysText(KeyBindings const& bindings) {
    return grouped(
        bindings, [](char const* group) { return fmt::format("{}\n", group); },
        [&](CommandInfo const& command) {
            std::string const keys = labelsOf(bindings.keysOf(command.id));
            return fmt::format("  {:<14} {:<24} {}\n", command.id, keys.empty() ? words::nothingStated : keys,
                               doesOf(command, bindings));
        });
}

nlohmann::ordered_json keysJson(KeyBindings const& bindings) {
    nlohmann::ordered_json commands = nlohmann::ordered_json::array();
    for (CommandInfo const* const command : bindings.inGroups()) {
        nlohmann::ordered_json keys = nlohmann::ordered_json::array();
        for (Chord const& chord : bindings.keysOf(command->id)) {
            keys.push_back(nameOf(chord));
        }
        commands.push_back({{"id", std::string(command->id)},
                            {"group", titleOf(command->group)},
                            {"does", doesOf(*command, bindings)},
                            {"keys", std::move(keys)},
                            {"held", command->use == KeyUse::held}});
    }
    nlohmann::ordered_json all;
    all["commands"] = std::move(commands);
    return all;
}

} // namespace trembler::ui
