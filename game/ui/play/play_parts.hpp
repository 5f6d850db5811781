// The parts of a level's screen. Its commands, its cards and its drawing work on them.
#pragma once

#include "game/budget/budget_mode.hpp"
#include "game/ui/cards/celebration.hpp"
#include "game/ui/cards/level_text.hpp"
#include "game/ui/cards/toolbox_view.hpp"
#include "game/ui/panels/components_panel.hpp"
#include "game/ui/panels/inspector.hpp"
#include "game/ui/panels/mods_panel.hpp"
#include "game/ui/play/keeping/film.hpp"
#include "game/ui/play/keeping/loadable_solutions.hpp"
#include "game/ui/play/lesson/lesson.hpp"
#include "game/ui/play/mouse/field_mouse.hpp"
#include "game/ui/play/mouse/key_pointer.hpp"
#include "game/ui/play/mouse/second_pointer.hpp"
#include "game/ui/play/mouse/turn_handle.hpp"
#include "game/ui/play/run/level_audio.hpp"
#include "game/ui/play/run/run_control.hpp"
#include "game/ui/play/run/touch_sounds.hpp"
#include "game/ui/play/timeline/timeline.hpp"
#include "game/ui/play/view/cut_view.hpp"
#include "game/ui/play/view/goal_areas.hpp"
#include "game/ui/play/view/hover_name.hpp"
#include "game/ui/play/view/shown.hpp"
#include "game/ui/play/view/sound_view.hpp"
#include "game/ui/play/view/spark_view.hpp"
#include "game/ui/play/view/squash_view.hpp"
#include "game/ui/play/why/why_panel.hpp"
#include "game/ui/shared/commands/asked_twice.hpp"
#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"
#include "game/ui/tools/group_tool.hpp"
#include "game/ui/tools/wire_tool.hpp"
#include "puzzle/campaign/kept_builds.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace trembler::ui {

class WhatIfTool;
class WhatIfView;

/// The side on which the inspector has opened: it stays there while it shows that object in a window of that
/// size, wherever the view is moved.
struct InspectorSide {
    std::optional<LastingObject> of; ///< nothing: it is closed
    render::Size window;
    bool left = false;
};

/// The same of the card that says why, while something is built: for these objects.
struct WhySide {
    std::vector<ObjectId> of;
    render::Size window;
    double top = 0;    ///< of the card, pixels
    double bottom = 0; ///< the same; a card has its final height some pictures after its words have changed
    bool left = false;
    bool chosen = false; ///< for all of these
};

/// Each part keeps its own state, which is not copied; here is only state that concerns several parts. Window
/// thread only; the context must outlive it.
struct PlayParts {
    /// `levelData` is the data with which the level is played if it names mods, else nullptr: then that of
    /// the context. Throws InputError if the level cannot be read or built. `stated` is the level if it was
    /// not read from the file; nullptr: it is read.
    PlayParts(UiContext& uiContext, std::filesystem::path levelFile,
              std::shared_ptr<GameData const> levelData, WorldOptions const& options,
              LevelFile const* stated = nullptr);
    PlayParts(PlayParts const&) = delete;
    PlayParts& operator=(PlayParts const&) = delete;

    UiContext& context;
    std::filesystem::path const file;
    std::string const id;                       ///< under which builds and solutions are kept
    bool const ofGallery;                       ///< a demonstration: its goals are a task
    std::shared_ptr<GameData const> const data; ///< nullptr: the level names no mods
    std::optional<PartCatalog> modParts;        ///< the parts of `data`
    Session session;
    PlacingTool placing;
    GroupTool group;
    WireTool wires;
    ToolboxView toolbox;
    HandTool hand;
    HandTool secondHand;
    budget::BudgetMode budget;
    Inspector inspector;
    ComponentsPanel components;
    CameraControl view;
    render::SceneView scene;
    SoundView sounds;
    SparkView sparks;
    SquashView squash;
    CutView cuts;
    GoalAreas goals;
    Timeline timeline;
    std::shared_ptr<WhatIfView> const whatIf;     ///< never null
    std::shared_ptr<WhatIfTool> const whatIfTool; ///< never null
    std::vector<int> goalCounts; ///< how often each goal needs something, see goal_counts.hpp
    LevelText said;              ///< the level's texts
    WhyPanel why;
    LevelAudio audio;
    TouchSounds touches;
    RunControl run;
    Celebration celebration;
    Lesson lesson;
    BuildKeeper keeper; ///< the parts that the player has placed, for the next time
    Film film;
    LoadableSolutions loadableSolutions;
    KeyPointer keyPointer;
    SecondPointer secondPointer;
    Picking picking;
    HoverName hoverName;
    FieldMouse mouse;
    std::unique_ptr<LiveMods> liveMods; ///< nullptr: the level names no mods
    ModsPanel modsPanel;
    bool goalAside = false; ///< the goal card is hidden: a part is held, and may be placed where the card was
    bool movesView = false; ///< arrow keys and the directional pad move the view
    AskedTwice allBack;     ///< whether all parts are to be put back
    Shown shown;
    std::size_t hintsShown = 0;    ///< for which the player has asked
    std::size_t hintAt = 0;        ///< the one that is shown, from 0
    bool hintsFolded = false;      ///< none is shown at present
    bool hintsHidden = false;      ///< other cards have left no room for the one that would be shown
    std::optional<bool> storyOpen; ///< the player's choice, see GoalCardLook
    InspectorSide inspectorSide;
    WhySide whySide;
    bool fitWanted = false; ///< the view is to show everything beside all cards, see FittedView
    bool testPlay = false;  ///< of a level that is being edited
    float besideCorner = 0; ///< width of what else stands beside the buttons in the corner, at UI scale 1
    Pointer pointer;        ///< of this picture
    std::optional<ScreenRequest> request; ///< the request of this picture to the program

    [[nodiscard]] render::Camera const& camera() const { return view.camera(); }
    /// Which buttons of a gamepad are meant.
    [[nodiscard]] PadPhase phase() const;
    [[nodiscard]] bool hasMods() const { return liveMods != nullptr; }
    /// Writes the placed parts, if that is due; reports to the player if it cannot be written.
    void keepBuild(double seconds);
    [[nodiscard]] PartCatalog& catalog() { return modParts ? *modParts : context.catalog; }
    /// The parts of the toolbox that are shown, in order.
    [[nodiscard]] std::vector<ToolboxSlot> shownTools() {
        return toolbox.shown(session.toolbox(), catalog());
    }
    /// Takes a part out of the toolbox by a key: it follows the pointer until the next press.
    void takeByKey(std::string const& part);
    /// Reports messages of scripts and saved script files to the player; `seconds` have passed. Between
    /// frames.
    void passMods(double seconds);
    /// To be called when the session has another world: forgets all state of the old one.
    void newWorld();
    /// Ends the run and places a solution; the next run repeats its inputs. Throws InputError if it does not
    /// fit; then nothing is placed otherwise.
    void load(Solution const& solution);
    /// Everything as it was when the level was opened: parts in the toolbox, the world at rest.
    void restart();
    /// The world that is shown: the session's, or the past.
    [[nodiscard]] World const& shownWorld() const { return timeline.world(); }
    /// How far the display is between the last two frames, 0 to 1.
    [[nodiscard]] double alpha() const { return timeline.looksBack() ? 1 : run.alpha(); }
    /// Asks why, about the object that is selected or pointed at, or else about a goal.
    void askWhy();
    /// Pauses, so that the past can be looked at, and shows the timeline.
    void lookAtPast();
    /// Shows a moment of the run, if there is a run.
    void lookAt(std::uint64_t frame);
    /// Lets the run go on from the frame of the past that is shown; it is computed again up to there.
    void continueHere();
    /// Shows the wire falling that the hand has just cut, if it has.
    void showCut();
    /// The handle that turns the selected part, if there is one at present.
    [[nodiscard]] std::optional<TurnHandle> handle();
    /// Shows the next hint, or, if hints are folded, the one that was shown; after the last one folds them.
    void showHint();

private:
    [[nodiscard]] RunEvents runEvents();
    void stepped();
    /// Warns the player, before the first frame, of bodies in one place that make each frame long.
    void tellOfCrowd();
    void solvedLevel(std::string const& id);
    bool reportedAltered_ = false; // whether the player knows that the reached goals of this run do not count
    [[nodiscard]] render::Extent subject() const;
};

} // namespace trembler::ui
