// The page of a level's solutions: load, rename, delete, open a file from elsewhere.
#pragma once

#include "game/ui/edit/files/file_browser.hpp"
#include "game/ui/play/keeping/loadable_solutions.hpp"
#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/ui_context.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace trembler::ui {

/// Window thread only.
class SolutionsPage {
public:
    enum class Choice : std::uint8_t { stay, back, loaded };

    /// To be called when the page is opened.
    void open(LoadableSolutions& loadable);
    /// Call between Gui::beginFrame and endFrame.
    Choice draw(UiContext& context, LoadableSolutions& loadable);
    /// A name is being typed: keys have no other meaning.
    [[nodiscard]] bool typing() const { return renamed_.has_value(); }
    /// A file is being chosen: the page itself is not shown.
    [[nodiscard]] bool browsing() const { return browser_.isOpen(); }
    /// The folder whose files are shown while one is chosen.
    [[nodiscard]] std::filesystem::path const& browsed() const { return browser_.folder(); }
    /// Ends the typing, or the choice of a file, without a change. False if there is neither.
    bool cancel();

private:
    void startRenaming(LoadableSolutions const& loadable, std::size_t index);
    Choice drawRow(UiContext& context, LoadableSolutions& loadable, std::size_t index);
    void drawName(UiContext& context, LoadableSolutions& loadable, std::size_t index);
    Choice drawBrowser(UiContext& context, LoadableSolutions& loadable);

    FileBrowser browser_;
    std::filesystem::path folder_;       // of the file that was opened last; empty: none was
    std::optional<std::size_t> renamed_; // the row whose name is being typed
    std::optional<std::size_t> asked_;   // the row that is to be deleted, if the player says so again
    bool focuses_ = false;               // the text field gets the keys in the next picture
    std::array<char, 101> name_{};
};

/// Instead of an empty list: how a solution is saved, with the first key that saves it, if there is one.
[[nodiscard]] std::string noSolutionsYet(KeyBindings const& keys);

} // namespace trembler::ui
