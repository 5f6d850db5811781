// One player at one level: placing parts, running the world, undoing changes.
#pragma once

#include "puzzle/session/lasting_object.hpp"
#include "puzzle/session/placements.hpp"
#include "puzzle/session/playback.hpp"
#include "puzzle/session/ready_level.hpp"
#include "puzzle/session/run.hpp"
#include "puzzle/session/wiring.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

enum class SessionMode : std::uint8_t {
    building, ///< parts can be placed; the world stands at frame 0
    running,
    paused,
};

/// Headless: the window, the command line and the tests all use it. It consists of the placements
/// (Placements), a run (LevelRun), and the inputs and changes that are fed to the run (Playback). The run is
/// built again from the level and the placements whenever these change, so stop() puts everything back
/// exactly as it was placed. Not thread-safe.
class Session {
public:
    /// `registry` and `parts` must outlive the session. Throws InputError if the level cannot be built.
    Session(Registry const& registry, PartLibrary const& parts, LevelFile level, WorldOptions options = {});
    /// The same of a level whose world is built already, which becomes that of the first run.
    Session(Registry const& registry, PartLibrary const& parts, ReadyLevel ready);
    Session(Session const&) = delete;
    Session& operator=(Session const&) = delete;

    [[nodiscard]] LevelFile const& level() const { return level_; }
    [[nodiscard]] PartLibrary const& parts() const { return parts_; }
    [[nodiscard]] SessionMode mode() const;
    /// The world as it is now; while building, as it will start. Valid until the next call that changes
    /// anything. For reading, and for subscriptions (World::want()). Make changes with feed() and change(),
    /// which record them.
    [[nodiscard]] World const& world() const { return run_->world(); }

    // Building. Unless mode() is building, these do nothing and report failure.
    [[nodiscard]] std::vector<PlacedPart> const& placed() const { return placements_.now(); }
    [[nodiscard]] std::vector<ToolboxSlot> toolbox() const { return placements_.toolbox(); }
    /// All objects in world() that a placed part became, its joints included; empty if it is not placed.
    [[nodiscard]] std::vector<ObjectId> objectsOf(int number) const;
    /// The object in world() that a placed part became, or an invalid id; of a composite, its main piece.
    [[nodiscard]] ObjectId objectOf(int number) const;
    /// The placed part that an object in world() came from, whichever of its pieces it is.
    [[nodiscard]] std::optional<int> numberOf(ObjectId object) const;
    /// Identifies an object of world() in all worlds of this session; default-constructed for an invalid id.
    [[nodiscard]] LastingObject lasting(ObjectId object) const;
    /// The object in world() with that identity; an invalid id if it was put back or does not exist (any
    /// more).
    [[nodiscard]] ObjectId find(LastingObject const& object) const;
    /// Whether a part may be placed there. `ignoring` is a placed part that is being moved.
    [[nodiscard]] Verdict check(Placement const& placement, std::optional<int> ignoring = {}) const;
    /// Places a part from the toolbox; returns its number, or nothing if check() refuses it.
    std::optional<int> place(Placement const& placement);
    /// Moves or turns a placed part, and mirrors it or not, if `flipped` is stated. False if check() refuses
    /// it; the part then stays where it was.
    bool move(int number, Vec2 at, double angle, std::optional<bool> flipped = {});
    /// Mirrors a placed part about its own vertical axis, before it is turned. False as move().
    bool flip(int number);
    /// Puts a placed part back into the toolbox.
    bool putBack(int number);
    bool putAllBack();
    // Several parts, in one step of undo: all of them or, if one is refused, none.
    /// Whether placed parts may be at these other places. They are checked against everything else; as to one
    /// another they must lie as they do now. A part with a number that is not placed is a new one.
    [[nodiscard]] Verdict checkAll(std::span<PlacedPart const> moved) const;
    bool moveAll(std::span<PlacedPart const> moved);
    bool putBackAll(std::span<int const> numbers);
    /// Places new parts, which must lie as to one another as placed ones do; returns their numbers.
    std::vector<int> placeAll(std::span<Placement const> added);
    // Wires. They are edits like those of parts, with the same undo; a wire is removed with a part at its
    // end.
    [[nodiscard]] std::vector<LaidWire> const& wires() const { return wires_.now(); }
    /// How many more wires the toolbox has; may be unlimitedCount.
    [[nodiscard]] int wiresLeft() const { return leftOf(level_.wires, static_cast<int>(wires().size())); }
    /// Whether a wire may be laid between two objects of world().
    [[nodiscard]] Verdict checkWire(ObjectId a, ObjectId b) const;
    /// False if checkWire() refuses it.
    bool layWire(ObjectId a, ObjectId b);
    /// Puts a wire back that the player has laid; false if there is none.
    bool takeWire(ObjectId a, ObjectId b);
    /// Goes back by up to mostUndo changes; by fewer, but at least leastUndo, if there are so many parts that
    /// the states have more than mostUndoneEntries together.
    bool undo();
    static constexpr std::size_t mostUndo = 1000;
    static constexpr std::size_t leastUndo = 10;
    static constexpr std::size_t mostUndoneEntries = 1'000'000; ///< placements and wires
    bool redo();
    [[nodiscard]] bool canUndo() const { return building() && placements_.canUndo(); }
    [[nodiscard]] bool canRedo() const { return building() && placements_.canRedo(); }

    // Running.
    void start();
    void pause();
    void resume();
    /// Ends the run: everything is back as it was placed.
    void stop();
    /// Computes one frame, after feeding the inputs and changes that the loaded solution, or play(), has for
    /// it. Starts the run if it has not begun.
    void step();
    /// Records a player input and passes it to the running world.
    void feed(PlayerInput const& input);
    /// All inputs of this run, with the frames that see them.
    [[nodiscard]] std::span<RecordedInput const> inputs() const { return run_->inputs(); }
    /// Changes how exactly the running world is computed from its next frame on, and records the change with
    /// that frame. Does not affect later runs. Does nothing while building. Throws std::invalid_argument, see
    /// change_fault.hpp.
    void change(RecordedChange change);
    /// All such changes of this run, those of setDetail() and setPeriod() among them.
    [[nodiscard]] std::span<RecordedChange const> changes() const { return run_->changes(); }
    /// Restarts the current or last run with its initial detail levels and periods.
    void startAgain();
    /// All inputs and changes of this run, by the player or by a solution, for play() in a run that repeats
    /// it.
    [[nodiscard]] Playback done() const;
    /// Feeds the playback to the current run until the run ends, in place of a loaded solution. Does nothing
    /// while building.
    void play(Playback playback);
    /// Ends the playback that play() began: the rest of the run gets its inputs from feed() alone.
    void takeOver();
    /// Whether play() feeds this run.
    [[nodiscard]] bool playing() const { return played_.has_value() && !takenOver_; }

    /// Changes the world as it is now in a way that no level and no solution can state, see
    /// LevelRun::alter(). It is not done again in other worlds of the session.
    void alter(std::string why, std::function<void(World&)> const& make = {}) {
        run_->alter(std::move(why), make);
    }
    /// Why the run counts as no solution, although it may reach the goals; nothing if it counts.
    [[nodiscard]] std::optional<std::string> const& altered() const { return run_->altered(); }
    /// Is called whenever the session has built another world, at its frame 0; may be empty.
    void whenBuilt(std::function<void()> call) { built_ = std::move(call); }
    /// Why the world could not be built again as it is placed now, in the words of the first problem, such as
    /// a script that no longer has a parameter that an object states; nothing if it can.
    [[nodiscard]] std::optional<std::string> whyNotBuilt() const;
    /// Builds the world again as it is placed. While building only. Throws InputError, see whyNotBuilt().
    void rebuild();

    [[nodiscard]] bool solved() const { return judge().solved(); }
    [[nodiscard]] GoalJudge const& judge() const { return run_->judge(); }

    /// Why a solution cannot state the run: it began with a detail level, requested on the command line, that
    /// is other physics, or with a period that changes more than accuracy, or it was altered, see alter().
    /// Nothing if it can.
    [[nodiscard]] std::optional<std::string> whyNotRecorded() const { return run_->whyNotRecorded(); }
    /// The placements, inputs and changes so far as a solution that can be recorded in the level. The changes
    /// begin with those from the level's detail levels and periods to the run's initial ones.
    [[nodiscard]] Solution record(std::string name) const;
    /// Ends the run and places the solution's parts. Every run feeds the solution's inputs and makes its
    /// changes in their frames, until the player changes a placement. Throws InputError if the solution does
    /// not fit; the placements then stay as they were.
    void load(Solution const& solution);

    /// Change a detail level or a period of the running world, recorded as by change(), and of all later
    /// worlds. Throw std::invalid_argument like change(). setPeriod() also accepts a component's name without
    /// its kind.
    void setDetail(std::string const& effect, std::string const& level);
    void setPeriod(std::string const& component, int period);
    /// Why setDetail() would refuse the level; nothing if it would accept it.
    [[nodiscard]] std::optional<std::string> whyNotDetail(std::string const& effect,
                                                          std::string const& level) const;

private:
    [[nodiscard]] bool building() const { return !run_->begun(); }
    [[nodiscard]] std::unique_ptr<LevelRun> runOf(Placements::List const& placed,
                                                  std::vector<LaidWire> const& wires) const;
    /// The same, or nullptr if no world can be built; `why` then says why not, in words.
    [[nodiscard]] std::unique_ptr<LevelRun> runIfBuilt(Placements::List const& placed,
                                                       std::vector<LaidWire> const& wires,
                                                       std::optional<std::string>* why = nullptr) const;
    /// Makes an edit of parts, if a world can be built from it; wires that lose an end go, too.
    bool keep(std::optional<Placements::List> next) { return keep(std::move(next), wires()); }
    bool keep(std::optional<Placements::List> next, std::vector<LaidWire> wires);
    /// The wires of a solution. Throws InputError if the level does not allow them.
    [[nodiscard]] std::vector<LaidWire> wiresOf(Solution const& solution,
                                                Placements::List const& placements) const;
    /// Limits the memory of undo().
    void forgetOldest();
    /// Rebuilds the run after undo and redo.
    void placedOtherwise();
    void use(std::unique_ptr<LevelRun> run);

    Registry const& registry_;
    PartLibrary const& parts_;
    LevelFile level_;
    WorldOptions options_; // for later runs
    Placements placements_;
    History<std::vector<LaidWire>> wires_; // a state for each of placements_
    std::unique_ptr<LevelRun> run_;        // never null; while building, a run that has not begun
    std::function<void()> built_;
    bool paused_ = false;
    std::optional<WorldOptions> lastBegunWith_; // the initial options of the last run
    Playback solution_;                         // of a loaded solution
    std::optional<Playback> played_;            // for this run, in place of solution_
    bool takenOver_ = false;                    // played_ is empty since takeOver()
};

} // namespace trembler
