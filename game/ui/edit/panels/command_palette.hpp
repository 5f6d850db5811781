// Finds any command, part or kind of joint by typing a piece of its name.
#pragma once

#include "game/ui/shared/commands/command.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler::ui {

/// Something that is found besides the commands.
struct PaletteEntry {
    enum class Kind : std::uint8_t { part, joint };
    Kind kind = Kind::part;
    std::string id;          ///< found by typing, too
    std::string name;        ///< as it is shown
    std::string kindInWords; ///< at the right, where commands have their keys
    std::string tip;         ///< may be empty; found by typing, too
};

/// Window thread only.
class CommandPalette {
public:
    void begin();
    void close() { open_ = false; }
    [[nodiscard]] bool isOpen() const { return open_; }
    /// Draws the card and handles its keys: arrows choose, Enter runs, Esc closes. Returns the chosen command
    /// or, from commands.size() on, the chosen one of the others, and is closed then. Between Gui::beginFrame
    /// and endFrame.
    [[nodiscard]] std::optional<std::size_t> draw(UiContext& context, CommandSet const& commands,
                                                  std::span<PaletteEntry const> others = {});

private:
    struct Row {
        std::size_t index = 0;
        std::string name;
        std::string right;
        std::string tip;
        std::string item; ///< its name on the screen
    };
    [[nodiscard]] std::vector<Row> rows(UiContext const& context, CommandSet const& commands,
                                        std::span<PaletteEntry const> others) const;
    std::optional<std::size_t> drawRows(UiContext& context, std::vector<Row> const& rows, bool moved);

    bool open_ = false;
    bool fresh_ = false;
    std::string typed_;
    std::size_t chosen_ = 0;
};

/// Whether every word of `typed` occurs in the text, in upper or lower case.
[[nodiscard]] bool fitsSearch(std::string const& text, std::string const& typed);

} // namespace trembler::ui
