#include "game/ui/play/mouse/second_player.hpp"

#include "game/ui/shared/commands/carry_out_keys.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

std::vector<SDL_Keycode> buttonsOf(KeyBindings const& bindings, std::string_view id) {
    std::vector<SDL_Keycode> buttons;
    for (Chord const& chord : bindings.keysOf(id)) {
        if (render::isPadKey(chord.key)) {
            buttons.push_back(chord.key);
        }
    }
    return buttons;
}

/// The keys of the keyboard that the second player has, if any.
class SecondPlayerKeys {
public:
    explicit SecondPlayerKeys(UiContext const& context) : context_(context) {}

    [[nodiscard]] bool any() const {
        namespace ids = second_player;
        std::array const all{ids::left, ids::right, ids::up, ids::down, ids::grab};
        return std::any_of(all.begin(), all.end(), [&](std::string_view id) {
            auto const keys = context_.keys.keysOf(id);
            return std::any_of(keys.begin(), keys.end(), onKeyboard);
        });
    }
    [[nodiscard]] bool held(std::string_view id) const {
        auto const keys = context_.keys.keysOf(id);
        return !context_.gui.wantsKeyboard() &&
               std::any_of(keys.begin(), keys.end(), [&](Chord const& chord) {
                   return onKeyboard(chord) && isHeld(context_.input, chord);
               });
    }
    /// -1, 0 or 1
    [[nodiscard]] double between(std::string_view less, std::string_view more) const {
        return (held(more) ? 1.0 : 0.0) - (held(less) ? 1.0 : 0.0);
    }

private:
    static bool onKeyboard(Chord const& chord) { return !render::isPadKey(chord.key); }

    UiContext const& context_;
};

} // namespace

render::SecondPadButtons secondPadButtons(KeyBindings const& bindings) {
    namespace ids = second_player;
    return {buttonsOf(bindings, ids::left), buttonsOf(bindings, ids::right), buttonsOf(bindings, ids::up),
            buttonsOf(bindings, ids::down), buttonsOf(bindings, ids::grab)};
}

std::optional<render::SecondPad> secondPlayerNow(UiContext const& context, bool before) {
    namespace ids = second_player;
    SecondPlayerKeys const keys(context);
    render::SecondPad now{keys.between(ids::left, ids::right), keys.between(ids::down, ids::up),
                          keys.held(ids::grab)};
    if (auto const pad = context.pads.second()) {
        return render::SecondPad{std::clamp(now.x + pad->x, -1.0, 1.0), std::clamp(now.y + pad->y, -1.0, 1.0),
                                 now.grabs || pad->grabs};
    }
    bool const uses = now.x != 0 || now.y != 0 || now.grabs;
    return uses || (before && keys.any()) ? std::optional(now) : std::nullopt;
}

} // namespace trembler::ui
