// A level on the screen: building, running, looking on.
#pragma once

#include "game/budget/budget_mode.hpp"
#include "game/ui/cards/play_cards.hpp"
#include "game/ui/panels/components_panel.hpp"
#include "game/ui/panels/inspector.hpp"
#include "game/ui/play/goal_areas.hpp"
#include "game/ui/play/level_audio.hpp"
#include "game/ui/play/replay.hpp"
#include "game/ui/play/sound_view.hpp"
#include "game/ui/shared/command.hpp"
#include "game/ui/shared/frame_clock.hpp"
#include "game/ui/shared/ui_context.hpp"
#include "game/ui/tools/camera_control.hpp"
#include "game/ui/tools/hand_tool.hpp"
#include "game/ui/tools/placing_tool.hpp"
#include "puzzle/session/session.hpp"
#include "render/scene/scene_view.hpp"

#include <filesystem>
#include <optional>

namespace trembler::ui {

/// What the screen cannot do by itself.
enum class PlayRequest : std::uint8_t { none, menu, levels, help, nextLevel, fullscreen };

/// Window thread only; the context must outlive it.
class PlayScreen {
public:
    /// Throws InputError if the level cannot be read or built.
    PlayScreen(UiContext& context, std::filesystem::path file, WorldOptions const& options);
    ~PlayScreen();
    PlayScreen(PlayScreen const&) = delete;
    PlayScreen& operator=(PlayScreen const&) = delete;

    /// One picture's worth of the player's doing and of the world's time: between Gui::beginFrame and draw().
    PlayRequest update(double seconds);
    /// As long as the menu is open: nothing moves.
    void updateBehindMenu();
    /// The world, into the window: after Window::beginFrame, before Gui::endFrame.
    void draw();
    /// A picture is complete: films and single pictures are taken here, before Window::present.
    void takePictures();

    /// Everything as it was when the level was opened: parts in the toolbox, the world at rest.
    void restart();
    void carryOut(Command command);

    [[nodiscard]] Session const& session() const { return session_; }
    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] std::filesystem::path const& file() const { return file_; }
    [[nodiscard]] PlayState const& state() const { return state_; }
    [[nodiscard]] PlacingTool const& placing() const { return placing_; }
    [[nodiscard]] HandTool const& hand() const { return hand_; }
    [[nodiscard]] Inspector const& inspector() const { return inspector_; }
    [[nodiscard]] ComponentsPanel const& components() const { return components_; }
    [[nodiscard]] budget::BudgetMode const& budget() const { return budget_; }
    [[nodiscard]] render::Camera const& camera() const { return view_.camera(); }
    /// Middle of the handle that turns the selected part, m.
    [[nodiscard]] std::optional<Vec2> handle() const;

private:
    [[nodiscard]] bool building() const { return session_.mode() == SessionMode::building; }
    void drawCards();
    void readKeys();
    void readControlKeys();
    void readBuildingKeys();
    [[nodiscard]] Pointer readPointer();
    void lookAround(Pointer const& pointer);
    void useTools(Pointer const& pointer, double seconds);
    void useHand(Pointer const& pointer, double seconds);
    void usePlacing(Pointer const& pointer);
    void runOrStop();
    /// A run; `asBefore`: with the levels and periods that the last one began with.
    void begin(bool asBefore);
    void stop();
    void stepOnce();
    void advance(double seconds);
    [[nodiscard]] bool fast() const;
    void watchAgain();
    void askAllBack();
    void toggleRecording();
    void saveSolution();
    void noteSuccess();
    void inspect(ObjectId object);
    void worldChanged();
    [[nodiscard]] Margins margins() const;
    [[nodiscard]] render::Extent subject() const;
    [[nodiscard]] render::Overlays overlays() const;
    void drawSelection() const;
    void drawGhost() const;
    void drawLabels() const;
    void drawBlades() const;
    /// How far the display is between the last two frames.
    [[nodiscard]] double alpha() const;

    UiContext& context_;
    std::filesystem::path file_;
    Session session_;
    Subscription patches_; // of the running world
    PlacingTool placing_;
    HandTool hand_;
    budget::BudgetMode budget_;
    Inspector inspector_;
    ComponentsPanel components_;
    CameraControl view_;
    FrameClock clock_;
    Replay replay_;
    LevelAudio audio_;
    SoundView sounds_;
    render::SceneView scene_;
    GoalAreas goals_;
    PlayState state_;
    PlayRequest request_ = PlayRequest::none;
    Pointer pointer_;
    ObjectId hovered_;
    render::Point pressedAt_;
    render::Point rightPressedAt_;
    bool rightOnPaper_ = false;
    bool leftOnPaper_ = false;
    bool counted_ = false; // this run's success has been told
    bool stepped_ = false; // the world moved on in this picture
    bool wantPicture_ = false;
    bool takenNow_ = false; // a part left the toolbox in this picture
    double askedFor_ = 0;   // s
};

} // namespace trembler::ui
