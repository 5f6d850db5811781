// Buttons for commands: icon, words, key, availability and state come from the command table.
#pragma once

#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/layout.hpp"
#include "render/panels/buttons.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace trembler::ui {

/// Properties of a button that are not part of its command.
struct CommandButtonOptions {
    std::string_view item{}; ///< name of the button in Layout; "": the command's id with spaces for hyphens
    char const* label = nullptr;                         ///< large buttons only; nullptr: the command's name
    render::ButtonLook look = render::ButtonLook::Quiet; ///< large buttons only
    float width = 0;                                     ///< large buttons only, see render::ButtonOptions
    bool withIcon = true;                                ///< large buttons only
    bool withTip = true; ///< large buttons only: false where the label says everything
};

/// For the cards of one picture; call between Gui::beginFrame and endFrame, inside a card. No command runs
/// while cards are drawn: the caller runs asked() afterwards. Throws std::invalid_argument for an id that the
/// screen does not have.
class CommandButtons {
public:
    /// All arguments must outlive this.
    CommandButtons(Layout& layout, KeyBindings const& bindings, CommandSet const& commands)
        : layout_(layout), bindings_(bindings), commands_(commands) {}

    /// A square button; a switch is drawn pressed while it is on.
    void icon(std::string_view id, CommandButtonOptions const& options = {});
    void big(std::string_view id, CommandButtonOptions const& options = {});
    [[nodiscard]] Layout& layout() const { return layout_; }
    [[nodiscard]] bool available(std::string_view id) const {
        return commands_.available(commands_.indexOf(id));
    }
    /// The label of its first key; "" if it has none.
    [[nodiscard]] std::string keyOf(std::string_view id) const;
    /// The tip of the command, for other widgets than these buttons.
    [[nodiscard]] std::string tip(std::string_view id) const;
    /// The command whose button was pressed last.
    [[nodiscard]] std::optional<std::size_t> asked() const { return asked_; }

private:
    void note(bool clicked, std::size_t index, std::string item);

    Layout& layout_;
    KeyBindings const& bindings_;
    CommandSet const& commands_;
    std::optional<std::size_t> asked_;
};

} // namespace trembler::ui
