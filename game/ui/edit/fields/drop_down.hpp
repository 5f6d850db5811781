// A list that drops down, and is searched by typing: all lists of the editor's panels.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

struct EditParts;

/// Keeps what was typed into the list that is open; at most one is. Letters narrow a long list down and go to
/// the first fit in a short one, the arrows, Page and Home and End move the mark, Enter chooses, Esc closes.
/// Window thread only.
class DropDown {
public:
    struct Entry {
        std::string shown;
        std::string id;     ///< of its item on the screen, and found by typing, too
        std::string tip{};  ///< may be empty
        std::string part{}; ///< whose picture stands before it; may be empty
    };
    using Entries = std::function<std::vector<Entry>()>;

    /// Draws the field, `shown` in it, under the name `item` on the screen, and the list while it is open;
    /// `entries` is called only then. The index of the entry that was chosen in this picture. `current`: the
    /// index of the present one, marked at first.
    std::optional<std::size_t> draw(EditParts& parts, std::string const& item, std::string const& shown,
                                    Entries const& entries,
                                    std::function<bool(Entry const&)> const& current = {});
    /// Whether a list was open in this picture or the last one.
    [[nodiscard]] bool open() const;

private:
    /// Reads what was typed in this picture. Whether it changed.
    bool readLetters();
    void markFit(std::vector<Entry> const& all, std::vector<std::size_t> const& shown);
    /// Moves the mark by the keys of this picture; true if they choose it.
    bool readKeys(EditParts const& parts, std::size_t count);
    std::optional<std::size_t> drawEntries(EditParts& parts, std::string const& item,
                                           std::vector<Entry> const& all,
                                           std::vector<std::size_t> const& shown, bool moved);

    std::string typed_;
    double sinceTyped_ = 0;  // s
    std::size_t marked_ = 0; // among the entries that are shown
    int openIn_ = -2;        // the picture in which one was open last
    bool long_ = false;
    bool erased_ = false; // a letter, in this picture
};

/// A part's picture in a square of the window that is being drawn, pixels.
void drawPartPicture(EditParts& parts, std::string const& part, ImVec2 at, float side);
/// The tip that is drawn next, for the item that was drawn last, stands beside their window.
void placeTipBeside();
/// A tip for the entry of a list or menu that was drawn last, beside the list, so that it covers no entry.
void tipBeside(std::string const& text);

} // namespace trembler::ui
