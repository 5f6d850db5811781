// Chooses a file inside the window: folders and files of levels or solutions, by mouse, keyboard or gamepad.
#pragma once

#include "game/ui/shared/ui_context.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

/// Window thread only.
class FileBrowser {
public:
    enum class Purpose : std::uint8_t { open, saveAs, openSolution };

    /// Shows the browser. `start` is a folder, or a file whose folder is shown and whose name is proposed.
    void begin(Purpose purpose, std::filesystem::path const& start);
    void close() { open_ = false; }
    [[nodiscard]] bool isOpen() const { return open_; }
    [[nodiscard]] Purpose purpose() const { return purpose_; }
    [[nodiscard]] std::filesystem::path const& folder() const { return folder_; }

    /// Draws the card and handles its keys; returns the chosen file, and is closed then. A file that exists
    /// is proposed for saving only after the designer has agreed. Between Gui::beginFrame and endFrame.
    [[nodiscard]] std::optional<std::filesystem::path> draw(UiContext& context);

private:
    struct Entry {
        std::string name;
        bool folder = false;
    };
    void enter(std::filesystem::path const& folder);
    [[nodiscard]] std::optional<std::filesystem::path> choose(std::string const& name);
    void drawEntries(UiContext& context, std::optional<std::filesystem::path>& chosen);

    bool open_ = false;
    Purpose purpose_ = Purpose::open;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    std::string name_;     // in the field
    std::string trouble_;  // shown below the list
    bool replace_ = false; // the message that the file exists was shown
    bool fresh_ = false;   // opened in this picture
    bool names_ = false;   // the field gets the keyboard in the next picture
};

/// A text field of ImGui for a std::string of up to `longest` bytes; true when the text was changed, or with
/// `onEnter` when Enter was pressed in it.
bool textField(char const* label, std::string& text, std::size_t longest = 400, bool onEnter = false);

} // namespace trembler::ui
