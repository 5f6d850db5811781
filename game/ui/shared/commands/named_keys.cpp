#include "game/ui/shared/commands/named_keys.hpp"

#include "game/ui/shared/words.hpp"
#include "render/window/pad_keys.hpp"

#include <algorithm>
#include <array>

namespace trembler::ui {
namespace {

bool isOf(Chord const& chord, KeyDevice device) {
    return render::isPadKey(chord.key) == (device == KeyDevice::pad);
}

struct Direction {
    std::string_view command;
    SDL_Keycode arrow;
    SDL_GameControllerButton button;
};

constexpr std::array directions{
    Direction{"move-left", SDLK_LEFT, SDL_CONTROLLER_BUTTON_DPAD_LEFT},
    Direction{"move-right", SDLK_RIGHT, SDL_CONTROLLER_BUTTON_DPAD_RIGHT},
    Direction{"move-up", SDLK_UP, SDL_CONTROLLER_BUTTON_DPAD_UP},
    Direction{"move-down", SDLK_DOWN, SDL_CONTROLLER_BUTTON_DPAD_DOWN},
};

} // namespace

std::string keyOfDevice(std::string_view command, KeyDevice device, KeyBindings const& bindings) {
    for (Chord const& chord : bindings.keysOf(command)) {
        if (isOf(chord, device)) {
            return labelOf(chord);
        }
    }
    return {};
}

std::string keyOrNone(std::string_view command, KeyDevice device, KeyBindings const& bindings) {
    std::string const key = keyOfDevice(command, device, bindings);
    return key.empty() ? words::nothingStated : key;
}

std::string namedKeys(std::initializer_list<std::string_view> commands, KeyBindings const& bindings) {
    std::array<std::string, 2> labels;
    for (std::string_view const command : commands) {
        for (KeyDevice const device : {KeyDevice::keyboard, KeyDevice::pad}) {
            std::string& label = labels[static_cast<std::size_t>(device)];
            label = label.empty() ? keyOfDevice(command, device, bindings) : label;
        }
    }
    if (labels[0].empty() || labels[1].empty()) {
        std::string const only = labels[0] + labels[1];
        return only.empty() ? words::nothingStated : only;
    }
    return textWith("{} or {}", labels[0], labels[1]);
}

std::string namedDirections(KeyDevice device, KeyBindings const& bindings) {
    bool const pad = device == KeyDevice::pad;
    bool const usual = std::all_of(directions.begin(), directions.end(), [&](Direction const& one) {
        auto const keys = bindings.keysOf(one.command);
        Chord const chord{.key = pad ? render::padKey(one.button) : one.arrow};
        return std::find(keys.begin(), keys.end(), chord) != keys.end();
    });
    if (usual) {
        return text(pad ? "lesson.pad_arrows" : "lesson.arrows");
    }
    std::string all;
    for (Direction const& one : directions) {
        std::string const label = keyOfDevice(one.command, device, bindings);
        all += (all.empty() || label.empty() ? "" : ", ") + label;
    }
    return all.empty() ? words::nothingStated : all;
}

std::string shownTip(CommandInfo const& command, bool on, KeyBindings const& bindings) {
    if (on && command.whenOn.tip != nullptr) {
        return command.whenOn.tip;
    }
    if (command.tipKey.empty()) {
        return command.tip;
    }
    return textWith(command.tip.english(), namedKeys({command.tipKey}, bindings));
}

std::string tipOf(CommandInfo const& command, bool on, KeyBindings const& bindings) {
    std::string const tip = shownTip(command, on, bindings);
    auto const keys = bindings.keysOf(command.id);
    if (command.use == KeyUse::held && !keys.empty()) {
        return tip + " (" + words::hold(labelOf(keys.front())) + ")";
    }
    return withKey(tip, keys.empty() ? command.alsoBy : command.id, bindings);
}

} // namespace trembler::ui
