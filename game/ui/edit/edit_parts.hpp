// The parts of the editor's screen. Its commands, its panels, its mouse and its drawing work on them.
#pragma once

#include "game/ui/edit/fields/drop_down.hpp"
#include "game/ui/edit/files/dialogs.hpp"
#include "game/ui/edit/files/file_browser.hpp"
#include "game/ui/edit/panels/command_palette.hpp"
#include "game/ui/edit/tools/selection.hpp"
#include "game/ui/edit/tools/snapping.hpp"
#include "game/ui/edit/tools/tool.hpp"
#include "game/ui/edit/view/live_goals.hpp"
#include "game/ui/play/play_screen.hpp"
#include "game/ui/shared/camera_control.hpp"
#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/document/level_document.hpp"
#include "puzzle/edit/inspect/inspector.hpp"
#include "puzzle/edit/inspect/solution_forms.hpp"
#include "puzzle/edit/problems/live_problems.hpp"
#include "puzzle/edit/recovery/autosave.hpp"
#include "puzzle/edit/world/edited_world.hpp"
#include "render/scene/scene_view.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui {

class LevelStudies;

struct EditOptions {
    /// Without mods; not nullptr.
    std::shared_ptr<GameData const> data;
    /// The data for editing a level that names mods, see GameOptions; may be empty.
    std::function<std::shared_ptr<GameData const>(std::filesystem::path const&)> levelData{};
    /// Called with the new data when the designer has made a part, so that the game can use it at once.
    std::function<void(std::shared_ptr<GameData const>)> partsMade{};
    WorldOptions world{};
    std::filesystem::path recovery{}; ///< folder for unsaved work; empty: none is kept
};

/// Facts about the selected objects that take long to compute, kept for one state of the document.
struct AboutSelection {
    std::uint64_t revision = 0;
    std::vector<std::string> names;
    std::optional<Box> box;    ///< around the selected objects that are not locked, m
    std::vector<Vec2> corners; ///< of the outline of a single polygon, m
    bool scales = false;       ///< alike in both directions
    bool stretches = false;    ///< in one direction
    bool known = false;
};
struct InspectedSelection {
    std::uint64_t revision = 0;
    std::vector<std::string> names;
    std::string piece;
    std::vector<edit::InspectedProperty> properties;
    std::vector<edit::InspectedPiece> pieces; ///< that could be selected
    bool known = false;
};

/// What the objects depend on that a wire or a joint could begin at or go to.
struct JoinablesOf {
    std::uint64_t world = 0; ///< EditedWorld::builds()
    std::uint64_t revision = 0;
    Tool tool = Tool::select;
    std::string jointForm;
    ObjectId from;
    render::Point lower; ///< of the view, m
    render::Point upper;

    bool operator==(JoinablesOf const&) const = default;
};
struct Joinables {
    std::optional<JoinablesOf> of; ///< nothing: not looked for yet
    std::vector<ObjectId> objects;
};

/// The entries of recorded solutions that the page of solutions shows.
struct ShownEntries {
    std::string solution;                     ///< whose entries are shown; empty: none
    std::map<std::string, std::size_t> first; ///< the first shown entry of a list, by its key
    std::vector<edit::EntryList> lists;       ///< that solutions may have
    GameData const* listsOf = nullptr;        ///< from whose schema `lists` was made
};

/// Each part keeps its own state; the members here concern several. Window thread only; the context must
/// outlive it.
struct EditParts {
    EditParts(UiContext& uiContext, EditOptions editOptions);
    EditParts(EditParts const&) = delete;
    EditParts& operator=(EditParts const&) = delete;

    UiContext& context;
    EditOptions const options;
    std::shared_ptr<GameData const> data; ///< of the document
    std::optional<PartCatalog> dataParts; ///< the parts of `data`
    edit::LevelDocument document;
    edit::LiveProblems problems;
    std::unique_ptr<edit::Autosave> autosave;

    Selection selection;
    edit::EditedWorld world;
    /// Of the document, as much of it as can be read. While one drags, its objects, joints, areas and goals
    /// are those from before the drag.
    LevelFile level;
    CameraControl view;
    render::SceneView scene;

    Tool tool = Tool::select;
    std::string jointForm = "hinge";
    double capsuleRadius = 0.05; ///< m
    Snapping snapping;
    std::string partInHand; ///< follows the mouse until it is put down; empty: none
    bool names = false;
    bool electricity = false;

    Tab tab = Tab::parts;
    bool panelKeys = false;          ///< the panel has the keyboard
    std::optional<Tab> panelHadKeys; ///< the page that had it in the last picture
    std::string searched;            ///< in the catalogue of parts
    mutable AboutSelection about;    ///< see edit_geometry.hpp
    mutable Joinables joinables;     ///< see join_ends.hpp
    InspectedSelection inspected;    ///< of the page of properties
    std::string goalPlace;           ///< of the chosen condition
    bool goalChosen = false;
    edit::GoalTree goalTree = edit::GoalTree::goals;   ///< which the page of goals and the scene show
    edit::GoalTree playedTree = edit::GoalTree::goals; ///< of the test play
    std::string translation;                  ///< the language of the page's translations; may be empty
    ShownEntries entries;                     ///< of the page of solutions
    std::map<std::string, int> limitedCounts; ///< what the toolbox's unlimited entries had before, by part

    DropDown dropDown;    ///< of all lists of the panels
    edit::Gesture widget; ///< of the widget that is being used: all its values are one step of undo
    std::map<std::string, std::string>
        typed; ///< texts of the fields that are being used, until they are left

    FileBrowser browser;
    CommandPalette palette;
    Dialogs dialogs;
    std::unique_ptr<PlayScreen> test;      ///< while the level is test-played
    std::string recordsOver;               ///< the solution that the next recording replaces; empty: none
    LiveGoals goals;                       ///< of the present or the last test play
    std::shared_ptr<LevelStudies> studies; ///< finished and running studies of the level; not nullptr
    Pointer pointer;                       ///< of this picture
    std::optional<ScreenRequest> request;  ///< the request of this picture to the program
    std::optional<ScreenRequest> leaving;  ///< asked for once the changes are saved or given up
    std::function<void(EditParts&)> afterSaving; ///< to be called after it; may be empty

    [[nodiscard]] edit::Json const& tree() const { return document.tree(); }
    [[nodiscard]] render::Camera const& camera() const { return view.camera(); }
    [[nodiscard]] PartCatalog& catalog() { return *dataParts; }
    /// Whether the document changed a moment ago, as it does in every picture of a drag.
    [[nodiscard]] bool changing() const { return sinceChange_ < 0.1; }
    [[nodiscard]] bool dialogOpen() const { return browser.isOpen() || palette.isOpen() || dialogs.isOpen(); }

    /// Makes a command from the present tree and runs it; the objects that it made are selected. If it is
    /// refused, the designer gets the reason. Returns whether it was done.
    bool run(std::function<edit::Command(edit::Json const&)> const& make,
             std::optional<edit::Gesture> gesture = {});
    void giveUpLeaving() {
        leaving.reset();
        afterSaving = {};
    }
    void tell(std::string text, render::ToastKind kind = render::ToastKind::News);

    /// Shows another document. Unsaved changes of the old one are lost.
    void use(edit::LevelDocument next, std::shared_ptr<GameData const> nextData);
    /// Opens a file, or reports why it cannot be opened. A path that does not exist is a new level with that
    /// name.
    void openFile(std::filesystem::path const& path);
    /// Moves the document's damaged file aside and opens its last good version.
    void takeLastGood();
    /// The data for editing a level file; reports if its mods cannot be loaded.
    [[nodiscard]] std::shared_ptr<GameData const> dataFor(std::filesystem::path const& path);
    void newLevel();
    /// Reads the parts again, the designer's own included: after one was made.
    void reloadParts();
    /// To be called once per picture: follows the document's changes and keeps unsaved work.
    /// `dragging`: the next picture is likely to bring another change, so now only the world is moved.
    void follow(double seconds, bool dragging = false);
    /// The view shows all of the level when it is to show everything, and does not leave it far behind.
    void setViewSubject();
    /// The smallest rectangle around the level, m.
    [[nodiscard]] render::Extent extent() const;
    /// The middle of the view, on the grid, m.
    [[nodiscard]] Vec2 middleOfView() const;
    /// The names of selected objects that exist.
    [[nodiscard]] std::vector<std::string> const& selected() const { return selection.objects(); }

private:
    void read();
    void followChanges(bool dragging);
    void setData(std::shared_ptr<GameData const> next);
    std::shared_ptr<GameData const> plain_;     // options.data, or the data that was read again
    std::shared_ptr<GameData const> former_;    // the data to which the shown world may still refer
    std::optional<std::uint64_t> readRevision_; // of the document in `level` and `world`
    std::optional<std::uint64_t> seenRevision_; // that `world` shows, or tried to show
    double sinceChange_ = 0;                    // s
    double sinceRead_ = 0;                      // s
    double readTook_ = 0;                       // s, the last time
};

} // namespace trembler::ui
