// Buttons that ask for commands: icon, words, key, availability and state all come from the table.
#pragma once

#include "game/ui/commands/key_bindings.hpp"
#include "game/ui/shared/layout.hpp"
#include "render/panels/buttons.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace trembler::ui {

/// What a table cannot know of a button.
struct CommandButtonOptions {
    std::string_view item{};     ///< what Layout calls it; "": the command's id with spaces for hyphens
    char const* label = nullptr; ///< large ones; nullptr: the command's name
    render::ButtonLook look = render::ButtonLook::Quiet; ///< large ones
    float width = 0;                                     ///< large ones, as render::ButtonOptions has it
    bool withIcon = true;                                ///< large ones
    bool withTip = true;                                 ///< large ones: false where the label says it all
};

/// For the cards of one picture; between Gui::beginFrame and endFrame, inside a card. Nothing is carried out
/// while cards are drawn: what was asked for is asked of it afterwards. Throws std::invalid_argument for an
/// id that the screen has not.
class CommandButtons {
public:
    /// All must outlive this.
    CommandButtons(Layout& layout, KeyBindings const& bindings, CommandSet const& commands)
        : layout_(layout), bindings_(bindings), commands_(commands) {}

    /// A square one; a switch is shown pressed in while it is on.
    void icon(std::string_view id, CommandButtonOptions const& options = {});
    void big(std::string_view id, CommandButtonOptions const& options = {});
    [[nodiscard]] Layout& layout() const { return layout_; }
    [[nodiscard]] bool available(std::string_view id) const {
        return commands_.available(commands_.indexOf(id));
    }
    /// What a button other than these would say of the command.
    [[nodiscard]] std::string tip(std::string_view id) const;
    /// The command that was asked for last.
    [[nodiscard]] std::optional<std::size_t> asked() const { return asked_; }

private:
    void note(bool clicked, std::size_t index, std::string item);

    Layout& layout_;
    KeyBindings const& bindings_;
    CommandSet const& commands_;
    std::optional<std::size_t> asked_;
};

} // namespace trembler::ui
