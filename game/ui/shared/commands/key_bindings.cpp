#include "game/ui/shared/commands/key_bindings.hpp"

#include "game/ui/shared/words.hpp"
#include "render/window/gamepad.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

std::vector<Chord> defaultsOf(CommandInfo const& command) {
    std::vector<Chord> keys;
    for (Chord const& chord : command.keys) {
        if (chord.any()) {
            keys.push_back(chord);
        }
    }
    if (command.pad.any()) {
        keys.push_back(command.pad);
    }
    return keys;
}

bool holds(std::vector<Chord> const& keys, Chord const& chord) {
    return std::find(keys.begin(), keys.end(), chord) != keys.end();
}

bool holdsKey(std::vector<Chord> const& keys, SDL_Keycode key) {
    return std::any_of(keys.begin(), keys.end(), [&](Chord const& chord) { return chord.key == key; });
}

/// Whether the two could mean the same button of a gamepad at the same time.
bool phasesMeet(CommandInfo const& a, CommandInfo const& b) {
    if (a.padPhase == PadPhase::secondPlayer || b.padPhase == PadPhase::secondPlayer) {
        return a.padPhase == b.padPhase; // the second player has a gamepad of their own
    }
    return a.padPhase == b.padPhase || a.padPhase == PadPhase::always || b.padPhase == PadPhase::always;
}

/// How well a command fits the present meaning of buttons; negative: not at all.
int padRank(CommandSet const& commands, std::size_t index) {
    PadPhase const own = commands.info(index).padPhase;
    PadPhase const now = commands.phase();
    if (own == PadPhase::secondPlayer) {
        return -1; // a button of the second player gives no key
    }
    if (own == PadPhase::always || now == PadPhase::always || now != PadPhase::past) {
        return own == PadPhase::always || now == PadPhase::always || own == now ? 0 : -1;
    }
    switch (own) {
    case PadPhase::past:
        return commands.available(index) ? 2 : -1;
    case PadPhase::building:
        return commands.available(index) ? 1 : -1;
    case PadPhase::view:
        return -1;
    default:
        return 0;
    }
}

} // namespace

KeyBindings::KeyBindings(std::vector<CommandList> screens) : screens_(std::move(screens)) {
    for (CommandList const& screen : screens_) {
        for (CommandInfo const* command : screen.commands) {
            if (keys_.try_emplace(command->id, defaultsOf(*command)).second) {
                commands_.push_back(command);
            }
        }
    }
}

CommandInfo const* KeyBindings::known(std::string_view id) const {
    auto const found = std::find_if(commands_.begin(), commands_.end(),
                                    [&](CommandInfo const* command) { return command->id == id; });
    return found == commands_.end() ? nullptr : *found;
}

bool KeyBindings::shareAScreen(CommandInfo const& a, CommandInfo const& b) const {
    return std::any_of(screens_.begin(), screens_.end(), [&](CommandList const& screen) {
        auto const there = [&](CommandInfo const& wanted) {
            return std::any_of(screen.commands.begin(), screen.commands.end(),
                               [&](CommandInfo const* command) { return command->id == wanted.id; });
        };
        return there(a) && there(b);
    });
}

CommandInfo const* KeyBindings::owner(CommandInfo const& asking, Chord const& chord) const {
    for (CommandInfo const* command : commands_) {
        // A command that leads back acts with any modifiers.
        std::vector<Chord> const& keys = keys_.at(command->id);
        bool const same = command->leads || asking.leads ? holdsKey(keys, chord.key) : holds(keys, chord);
        if (command->id != asking.id && same && shareAScreen(*command, asking) &&
            (!render::isPadKey(chord.key) || phasesMeet(*command, asking))) {
            return command;
        }
    }
    return nullptr;
}

std::span<Chord const> KeyBindings::keysOf(std::string_view id) const {
    auto const found = keys_.find(id);
    return found == keys_.end() ? std::span<Chord const>() : std::span<Chord const>(found->second);
}

std::optional<std::string> KeyBindings::whyNot(CommandInfo const& command, Chord const& chord) const {
    if (CommandInfo const* const other = owner(command, chord)) {
        return words::keyIsTaken(labelOf(chord), other->name);
    }
    return std::nullopt;
}

std::optional<std::string> KeyBindings::bind(CommandInfo const& command, Chord const& chord) {
    auto why = whyNot(command, chord);
    if (!why) {
        std::vector<Chord>& keys = keys_[command.id];
        bool const pad = render::isPadKey(chord.key); // a gamepad's button replaces no key
        std::erase_if(keys, [&](Chord const& old) { return render::isPadKey(old.key) == pad; });
        keys.insert(pad ? keys.end() : keys.begin(), command.leads ? Chord{.key = chord.key} : chord);
    }
    return why;
}

std::optional<std::string> KeyBindings::unbind(CommandInfo const& command) {
    if (command.essential) {
        return words::keepsItsKey(command.name);
    }
    keys_[command.id].clear();
    return std::nullopt;
}

bool KeyBindings::lacksKeys(CommandInfo const& command) const {
    auto const kindsOf = [](std::vector<Chord> const& keys, bool pad) {
        return std::any_of(keys.begin(), keys.end(),
                           [&](Chord const& chord) { return render::isPadKey(chord.key) == pad; });
    };
    auto const usual = defaultsOf(command);
    auto const& now = keys_.at(command.id);
    return command.essential &&
           ((kindsOf(usual, false) && !kindsOf(now, false)) || (kindsOf(usual, true) && !kindsOf(now, true)));
}

void KeyBindings::reset() {
    for (CommandInfo const* command : commands_) {
        keys_[command->id] = defaultsOf(*command);
    }
}

StatedKeys KeyBindings::stated() const {
    StatedKeys all;
    for (CommandInfo const* command : commands_) {
        std::vector<Chord> const& keys = keys_.at(command->id);
        if (keys == defaultsOf(*command)) {
            continue;
        }
        auto& names = all[std::string(command->id)];
        for (Chord const& chord : keys) {
            names.push_back(nameOf(chord));
        }
    }
    return all;
}

std::optional<std::vector<Chord>> KeyBindings::read(CommandInfo const& command,
                                                    std::vector<std::string> const& names,
                                                    std::vector<std::string>& troubles) const {
    std::vector<Chord> keys;
    for (std::string const& name : names) {
        auto const chord = chordFrom(name);
        if (!chord) {
            troubles.push_back(words::notAKey(std::string(command.id), name));
            return std::nullopt;
        }
        if (!holds(keys, *chord)) {
            keys.push_back(*chord);
        }
    }
    return keys;
}

void KeyBindings::settleConflicts(StatedKeys const& stated, std::vector<std::string>& troubles) {
    // A command that falls back to its default keys may now conflict with another stated command, so check
    // again; each pass resets a command, so there are at most as many passes as stated commands.
    bool again = true;
    while (again) {
        again = false;
        for (auto const& [id, names] : stated) {
            CommandInfo const* const found = known(id);
            if (found == nullptr || keys_.at(id) == defaultsOf(*found)) {
                continue;
            }
            CommandInfo const& command = *found;
            for (Chord const& chord : keys_.at(id)) {
                if (auto const why = whyNot(command, chord)) {
                    troubles.push_back(words::keysNotTaken(id, *why));
                    keys_[command.id] = defaultsOf(command);
                    again = true;
                    break;
                }
            }
        }
    }
}

std::vector<std::string> KeyBindings::load(StatedKeys const& stated) {
    reset();
    std::vector<std::string> troubles;
    for (auto const& [id, names] : stated) {
        CommandInfo const* const found = known(id);
        if (found == nullptr) {
            troubles.push_back(words::noSuchCommand(id));
        } else if (auto keys = read(*found, names, troubles)) {
            keys_[found->id] = std::move(*keys);
            if (lacksKeys(*found)) {
                troubles.push_back(words::keysNotTaken(id, words::keepsItsKey(found->name)));
                keys_[found->id] = defaultsOf(*found);
            }
        }
    }
    settleConflicts(stated, troubles);
    return troubles;
}

std::optional<std::size_t> KeyBindings::find(CommandSet const& commands, SDL_Keysym const& pressed) const {
    Chord const asked = chordOf(pressed);
    std::optional<std::size_t> best;
    int most = -1;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        CommandInfo const& info = commands.info(i);
        int const rank = render::isPadKey(pressed.sym) ? padRank(commands, i) : 0;
        if (rank < 0) {
            continue; // the button means something else now
        }
        for (Chord const& chord : keysOf(info.id)) {
            if (chord.key != asked.key || info.use == KeyUse::held) {
                continue;
            }
            if (info.leads) {
                return i;
            }
            bool const fits =
                chord.ctrl == asked.ctrl && (!chord.shift || asked.shift) && (!chord.alt || asked.alt);
            int const modifiers = (chord.shift ? 1 : 0) + (chord.alt ? 1 : 0) + rank;
            if (fits && modifiers > most) {
                most = modifiers;
                best = i;
            }
        }
    }
    return best;
}

std::vector<CommandInfo const*> KeyBindings::inGroups() const {
    auto all = commands_;
    std::stable_sort(all.begin(), all.end(),
                     [](CommandInfo const* a, CommandInfo const* b) { return a->group < b->group; });
    return all;
}

std::string withKey(std::string const& text, std::string_view id, KeyBindings const& bindings) {
    auto const keys = bindings.keysOf(id);
    return keys.empty() ? text : text + " (" + labelOf(keys.front()) + ")";
}

} // namespace trembler::ui
