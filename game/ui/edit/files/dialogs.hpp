// The questions of the editor, each a card over a veil: unsaved changes, recovery, read-only, a part's name.
#pragma once

#include "game/ui/shared/ui_context.hpp"
#include "puzzle/edit/recovery/autosave.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

struct EditParts;

/// One at a time. Window thread only.
class Dialogs {
public:
    enum class Shown : std::uint8_t { none, unsaved, recovery, readOnly, partName, conflict };

    [[nodiscard]] bool isOpen() const { return shown_ != Shown::none; }
    [[nodiscard]] Shown shown() const { return shown_; }
    void close() { shown_ = Shown::none; }

    /// Asks whether unsaved changes are to be saved; `then` is done afterwards, unless the designer cancels.
    void askUnsaved(std::function<void(EditParts&)> then);
    void offerRecovery(std::vector<edit::Recovery> recoveries);
    /// `lastGood`: the file is damaged, and its last good version can be taken.
    void showReadOnly(bool lastGood) {
        lastGood_ = lastGood;
        shown_ = Shown::readOnly;
    }
    void askPartName(std::string const& proposed);
    /// Another program has changed the file; `path` empty: the document's own.
    void askConflict(std::string message, std::filesystem::path path);
    /// The file to which a new level is to be saved.
    void propose(std::filesystem::path const& path) { proposed_ = path; }
    [[nodiscard]] std::filesystem::path const& proposed() const { return proposed_; }

    /// Draws the card and does what the designer decides. Between Gui::beginFrame and endFrame.
    void draw(EditParts& parts);

private:
    void drawUnsaved(EditParts& parts);
    void drawRecovery(EditParts& parts);
    void drawReadOnly(EditParts& parts);
    void drawPartName(EditParts& parts);
    void drawConflict(EditParts& parts);

    Shown shown_ = Shown::none;
    std::function<void(EditParts&)> then_;
    std::vector<edit::Recovery> recoveries_;
    std::string name_;
    std::string message_;
    std::filesystem::path path_;
    std::filesystem::path proposed_;
    bool fresh_ = false;
    bool lastGood_ = false;
};

} // namespace trembler::ui
