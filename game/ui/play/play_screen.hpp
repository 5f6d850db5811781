// The screen of a level: building, running, watching.
#pragma once

#include "game/ui/play/mouse/pointer_reader.hpp"
#include "game/ui/play/play_parts.hpp"
#include "game/ui/play/view/fitted_view.hpp"
#include "game/ui/shared/screen.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace trembler::ui {

/// Calls its parts in order for every picture. Window thread only; the context must outlive it.
class PlayScreen final : public Screen {
public:
    /// See PlayParts.
    PlayScreen(UiContext& context, std::filesystem::path file, std::shared_ptr<GameData const> data,
               WorldOptions const& options, LevelFile const* stated = nullptr);

    std::optional<ScreenRequest> update(double seconds) override;
    /// The world stands still.
    void updateBehindMenu(double seconds) override;
    [[nodiscard]] bool still() const override;
    [[nodiscard]] bool keepsPicture() const override;
    [[nodiscard]] LoadableSolutions* loadableSolutions() override { return &parts_.loadableSolutions; }
    [[nodiscard]] bool hasSecondHand() const override { return true; }
    void draw() override;
    /// Adds the picture to the film, or keeps it by itself, if the player has asked for that.
    void pictureComplete() override;
    void keep() override;
    void leave() override;
    [[nodiscard]] CommandSet& commands() override { return commands_; }
    [[nodiscard]] std::span<Gesture const> gestures() const override;
    [[nodiscard]] std::filesystem::path const& level() const override { return parts_.file; }

    [[nodiscard]] Session const& session() const { return parts_.session; }
    [[nodiscard]] Session& session() { return parts_.session; }
    /// The level is being edited: what leads on leads back to the editor.
    void beTestPlay() { parts_.testPlay = true; }
    /// Keeps room for another card at the left of the buttons in the corner, of this width and the gap beside
    /// it, pixels at UI scale 1.
    void keepBesideCorner(float width) { parts_.besideCorner = width; }
    /// The part of the window that the cards around the level leave to the scene, see FittedView.
    [[nodiscard]] Rect const& stage() const { return fittedView_.stage(); }
    /// Whether the view is about to be fitted, as the level was opened or the window has another size.
    [[nodiscard]] bool settles() const { return fittedView_.settles(); }
    /// To be called after other code has given the session another world.
    void worldChanged() { parts_.newWorld(); }
    [[nodiscard]] std::filesystem::path const& file() const { return parts_.file; }
    [[nodiscard]] Shown const& shown() const { return parts_.shown; }
    [[nodiscard]] std::size_t hintsShown() const { return parts_.hintsShown; }
    [[nodiscard]] PlacingTool const& placing() const { return parts_.placing; }
    [[nodiscard]] WireTool const& wires() const { return parts_.wires; }
    /// The parts of the toolbox that are shown, in order.
    [[nodiscard]] std::vector<ToolboxSlot> tools() { return parts_.shownTools(); }
    [[nodiscard]] GroupTool const& group() const { return parts_.group; }
    [[nodiscard]] Speed const& speed() const { return parts_.run.speed(); }
    [[nodiscard]] RunControl& run() { return parts_.run; }
    [[nodiscard]] HandTool const& hand() const { return parts_.hand; }
    [[nodiscard]] KeyPointer const& keyPointer() const { return parts_.keyPointer; }
    [[nodiscard]] SecondPointer const& secondPointer() const { return parts_.secondPointer; }
    [[nodiscard]] HandTool const& secondHand() const { return parts_.secondHand; }
    [[nodiscard]] Inspector const& inspector() const { return parts_.inspector; }
    [[nodiscard]] ComponentsPanel const& components() const { return parts_.components; }
    [[nodiscard]] ModsPanel const& mods() const { return parts_.modsPanel; }
    [[nodiscard]] Timeline& timeline() { return parts_.timeline; }
    [[nodiscard]] WhatIfView const& whatIf() const { return *parts_.whatIf; }
    [[nodiscard]] WhyPanel const& why() const { return parts_.why; }
    [[nodiscard]] Lesson const& lesson() const { return parts_.lesson; }
    [[nodiscard]] Celebration const& celebration() const { return parts_.celebration; }
    /// nullptr: the level names no mods.
    [[nodiscard]] LiveMods* liveMods() { return parts_.liveMods.get(); }
    [[nodiscard]] budget::BudgetMode const& budget() const { return parts_.budget; }
    [[nodiscard]] render::Camera const& camera() const { return parts_.camera(); }
    /// Middle of the handle that turns the selected part, m.
    [[nodiscard]] std::optional<Vec2> handle();

private:
    void useSecondPlayer(double seconds);
    /// The name of the object on which the pointer rests.
    void lookAtHover(double seconds);
    /// The held direction of a gamepad moves the pointer or the view on.
    void holdDirection(Vec2 direction, double seconds, Pointer const& mouse);
    /// While the card of a what-if has the keyboard.
    void handleKeysBesideCard();
    /// Of a key that means nothing now: `command`, or none.
    void tellOfRefused(std::optional<std::size_t> command);
    /// Once for each speed that the computer cannot keep.
    void tellOfSlowness();

    PlayParts parts_;
    CommandsOf<PlayParts> commands_;
    PointerReader reader_;
    FittedView fittedView_;
    bool fastRefused_ = false;     // the key for fast motion is held while building
    bool dropDownWasOpen_ = false; // on that card, in the last picture
    double viewHeld_ = 0;          // s, for which a direction that moves the view has been held
    double sinceStep_ = 0;         // s, of the world
    double toldOfSlownessAt_ = 0;  // the last such speed
};

} // namespace trembler::ui
