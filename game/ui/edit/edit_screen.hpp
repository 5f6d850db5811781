// The screen of the editor: the scene, the bar, the tools and the panel, or the test play.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/edit/keys_owner.hpp"
#include "game/ui/edit/tools/edit_mouse.hpp"
#include "game/ui/play/mouse/pointer_reader.hpp"

namespace trembler::ui {

/// Window thread only; the context must outlive it.
class EditScreen final : public Screen {
public:
    /// Opens a level file in it; an empty path: a new level.
    EditScreen(UiContext& context, std::filesystem::path const& file, EditOptions options);

    std::optional<ScreenRequest> update(double seconds) override;
    void updateBehindMenu(double seconds) override;
    [[nodiscard]] bool keepsPicture() const override;
    void draw() override;
    void pictureComplete() override;
    [[nodiscard]] bool still() const override;
    [[nodiscard]] bool mayLeaveFor(ScreenRequest const& asked) override;
    void leave() override;
    /// The commands of the test play, during it.
    [[nodiscard]] CommandSet& commands() override;
    [[nodiscard]] std::span<Gesture const> gestures() const override;
    [[nodiscard]] std::filesystem::path const& level() const override { return parts_.document.path(); }

    [[nodiscard]] EditParts& parts() { return parts_; }
    [[nodiscard]] EditMouse const& mouse() const { return mouse_; }
    /// The screen of the test play; nullptr while there is none.
    [[nodiscard]] PlayScreen* test() { return parts_.test.get(); }

private:
    void setView();
    void updateTest(double seconds);
    void drawTestCard();
    void drawDialogs();
    void handleKeys();
    void turnPages();

    EditParts parts_;
    CommandsOf<EditParts> commands_;
    CommandsOf<EditParts> testCommands_; ///< besides those of the test play
    PointerReader reader_;
    EditMouse mouse_;
    KeysOwner keysOwner_;
    bool leaveAgreed_ = false; // the designer gave the changes up
};

} // namespace trembler::ui
