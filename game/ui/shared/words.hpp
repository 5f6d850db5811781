// The window's texts, in one place and in British English, from which every other language is looked up; the
// names of commands are in their tables.
#pragma once

#include "game/ui/shared/texts.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace trembler::ui::words {

// The program.
inline constexpr char const* programName = "Trembler";
inline char const* const& looseLevels = said("Levels");
inline constexpr Phrase levels = "Levels";
inline constexpr Phrase back = "Back";

// Running.
inline char const* const& allBackAsk = said("Put all back?");
inline char const* const& allBackAgain =
    said("Press again to put all parts back into the toolbox. Undo brings them back.");
inline char const* const& allBackDone = said("All parts are back in the toolbox");

/// Of a speed: "2×", "½×"
[[nodiscard]] std::string timesReal(double speed);
[[nodiscard]] std::string tooSlow(double asked, double reached);
/// A frame of the simulation took long, most of it in the component of that name.
[[nodiscard]] std::string slowFrame(std::uint64_t frame, double seconds, std::string_view component);

// Tools.
inline constexpr char const* mySolution = "my solution";
inline char const* const& runBeforeSaving =
    said("Run it first: what is saved is what you placed and what you did while it ran.");
inline char const* const& closeTip = said("Close");

// Toolbox and placing.
inline char const* const& toolbox = said("Toolbox");
inline char const* const& dropHere = said("Let go here to put it back");

inline char const* const& noSuchPart = said("No part is called that.");
inline char const* const& allParts = said("All parts");
/// Of the field in which a part is sought; the key may be empty.
[[nodiscard]] std::string seekPart(std::string const& key);
/// Of a button; `count` may be unlimitedCount.
[[nodiscard]] std::string wiresLeft(int count);
inline char const* const& noWires = said("There are no wires to lay in this level.");
inline char const* const& noWireLeft = said("There is no wire left in the toolbox.");
inline char const* const& nothingInHand = said("Take a part first, or select one.");
inline char const* const& selectFirst = said("Select a part first.");
inline char const* const& nothingToUndo = said("There is nothing to undo.");
inline char const* const& nothingToRedo = said("There is nothing to redo.");
inline char const* const& allThere = said("No part is placed.");
inline char const* const& allInSight = said("This toolbox has few parts, and all of them are in sight.");
inline char const* const& wireOfLevel = said("This wire belongs to the level.");
inline char const* const& wireBegins = said("Click a pole or another conductor: the wire begins there");
inline char const* const& wireFromHere = said("Drag the wire to another conductor, or click it");
[[nodiscard]] std::string conductsNot(std::string const& object);
[[nodiscard]] std::string putThisBack(std::string const& a, std::string const& b);

// Goal, hints, success.
inline char const* const& goal = said("Goal");
inline char const* const& goals = said("Goals"); ///< several
inline char const* const& noGoal = said("There is nothing to reach here. Try things out.");
inline constexpr Phrase hint = "Hint";
inline char const* const& nextHint = said("Another hint");
inline char const* const& foldHints = said("Fold the hints");
inline char const* const& hintBefore = said("The hint before");
inline char const* const& hintAfter = said("The next hint");
inline char const* const& moreStory = said("More"); ///< the story of the level is shown, where room is scarce
inline char const* const& lessStory = said("Less");
inline char const* const& noHints = said("There is no hint for this level.");
inline char const* const& solved = said("It works!");
inline constexpr Phrase nextLevel = "Next level";
inline constexpr Phrase watchAgain = "Watch again";
inline constexpr Phrase keepPlaying = "Keep playing";
inline char const* const& lastLevel = said("That was the last level.");

// The keyboard on the screen.
inline char const* const& blankKey = said("Space");

// Menu and settings.
inline constexpr Phrase restart = "Start the level again";
inline constexpr Phrase keys = "Keys";
inline char const* const& groupBuilding = said("Building");
inline char const* const& groupRunning = said("Running");
inline char const* const& groupSecondPlayer = said("The second player");
inline char const* const& groupLooking = said("Looking");
inline char const* const& groupProgram = said("The program");
inline char const* const& groupEditing = said("Editing levels");
inline char const* const& groupMenus = said("Menus and lists");

// Inspector.
inline char const* const& rightNow = said("Right now");
inline char const* const& inHand = said("in your hand");
inline char const* const& inHandMeaning = said("whether you hold it");
inline char const* const& speed = said("speed");
inline char const* const& speedMeaning = said("of its centre of mass");
inline char const* const& electricity = said("electricity");
inline char const* const& electricityOn = said("on");
inline char const* const& electricityOff = said("off");
inline char const* const& electricityMeaning = said("whether it is part of a working circuit");
inline char const* const& connectedTo = said("connected to");
[[nodiscard]] std::string connectedBy(std::string const& callers, std::string const& objects);
inline char const* const& touches = said("touches");
inline char const* const& touchesMeaning = said("the objects that it touches at this moment");
inline char const* const& weight = said("weight");
inline char const* const& weightMeaning = said("the force of gravity on it");
inline char const* const& potential = said("potential");
inline char const* const& potentialMeaning = said("relative to the return of its network");
inline char const* const& floating = said("floating: not connected to a source or a return");
inline char const* const& current = said("current");
inline char const* const& currentMeaning = said("through it");
inline char const* const& power = said("power");
inline char const* const& powerMeaning = said("that becomes heat or light in it");
inline char const* const& shortCircuit = said("short circuit");
inline char const* const& shortMeaning =
    said("nearly all of its voltage drops inside it, or its load has hardly any resistance");
inline char const* const& magneticPull = said("magnetic force");
inline char const* const& magneticMeaning = said("the sum of all magnetic forces on it");
inline char const* const& sounds = said("sounds");
inline char const* const& soundsMeaning = said("sound level at a distance of 1 m");
inline char const* const& hears = said("hears");
inline char const* const& hearsMeaning = said("sound level at its position");
inline char const* const& silence = said("silence");
inline char const* const& whyObjectTip = said("Ask what made it as it is");
inline char const* const& objectIsGone = said("It is not in the world at the moment.");
inline char const* const& yes = said("yes");
inline char const* const& no = said("no");
inline constexpr char const* nothingStated = "–";

// Components.
inline constexpr Phrase components = "Components";
inline char const* const& component = said("component");
inline char const* const& state = said("state");
inline char const* const& period = said("every");
inline char const* const& periodTip = said("Runs in every nth frame. Drag to change, double-click to type.");
inline char const* const& periodFixedTip =
    said("It must run in every frame: otherwise the physics would change.");
inline char const* const& timePerFrame = said("time, µs");
inline char const* const& active = said("active");
inline char const* const& asleep = said("asleep");
inline char const* const& absent = said("absent");
inline char const* const& resolvers = said("Resolvers");
inline char const* const& derivedSets = said("Derived property sets");
inline char const* const& interactions = said("Interactions");
inline char const* const& showAbsent = said("Also show what this scene does not activate");
inline char const* const& automatic = said("as the scene needs it");

// Mods.
inline constexpr Phrase mods = "Mods";
inline char const* const& noMods = said("This level uses no mods.");
inline char const* const& modsChanged =
    said("Something differs from the level and the files, so this run counts as no solution.");
inline char const* const& scriptOn = said("Switch the script off, or on again");
inline char const* const& scriptOff = said("off");
inline char const* const& scriptFailed = said("failed");
inline char const* const& bundledMod = said("It came with the program.");
inline char const* const& trustedMod = said("It is trusted: its scripts are compiled.");
inline char const* const& untrustedMod = said("It is not trusted: its scripts are interpreted.");
inline char const* const& forObject = said("of");
inline char const* const& forOthers = said("all that state none");
inline char const* const& asStated = said("As the level states it");
inline char const* const& parameters = said("Parameters");
inline char const* const& noParameters = said("It has no parameters.");
inline char const* const& scriptUses = said("Uses");
inline char const* const& instructions = said("instructions");
inline char const* const& memory = said("memory");
inline char const* const& instructionsTip =
    said("Of the last frame in which it had a turn. Beyond its limit a script is switched off.");
inline char const* const& notApplied = said("It has had no turn in this run.");
inline char const* const& scriptLog = said("Log");
inline char const* const& failedInThisRun = said("It failed and is switched off for this run");
inline char const* const& fileRefused = said("The file as it was saved is not used");
inline char const* const& howItCameThere = said("How it came there");

// The cost of accuracy.
inline char const* const& effect = said("effect");
inline char const* const& howExactly = said("how exactly");
inline char const* const& timePerFrameOf = said("time per frame");
inline char const* const& errorAfterASecond = said("error at 1 s");
inline char const* const& oneWayOnly = said("one level only");
inline char const* const& notNeeded = said("nothing activates it");
inline char const* const& notRead = said("nothing reads it");
inline char const* const& wholeFrame = said("A frame");
inline char const* const& withoutBudget = said("no budget");
inline char const* const& keepToBudget = said("Keep to a time budget");
inline char const* const& budgetTip = said(
    "Levels, settings and periods are chosen, once a second, so that a frame takes no longer than this on "
    "average and "
    "the error is least. The choices become part of what you save.");
inline char const* const& lessOrMore = said("Less or more of it");
inline char const* const& budgetOff = said("No time budget: detail levels stay as they are");
inline char const* const& budgetMissed = said("The last second took longer than that.");
inline char const* const& budgetHopeless = said("No allowed choice is fast enough for this budget.");
inline char const* const& nothingToChange = said("Everything is as it should be: nothing to change.");
inline char const* const& budgetMeasuring = said("Measuring, for a second …");

/// For the toolbox; the key names may be empty.
[[nodiscard]] std::string toolboxHint(std::string const& turnLeft, std::string const& turnRight);
/// "hold Tab"
[[nodiscard]] std::string hold(std::string const& key);
[[nodiscard]] std::string keyIsTaken(std::string const& key, std::string const& command);
[[nodiscard]] std::string keepsItsKey(std::string const& command);
// Problems with the keys of a profile; commands by their ids.
[[nodiscard]] std::string noSuchCommand(std::string const& id);
[[nodiscard]] std::string notAKey(std::string const& id, std::string const& text);
[[nodiscard]] std::string keysNotTaken(std::string const& id, std::string const& why);
[[nodiscard]] std::string keysNotRead(std::string const& what);

[[nodiscard]] std::string pictureTaken(std::string const& path);
[[nodiscard]] std::string andMore(std::size_t count);
/// Of a mod: "wind 1.0, by the Trembler project, MIT"
[[nodiscard]] std::string modLine(std::string const& name, std::string const& version,
                                  std::string const& author, std::string const& licence);
[[nodiscard]] std::string levelsOfMod(std::string const& title);
[[nodiscard]] std::string modFrom(std::string const& folder);
/// "1 234 of 20 000"
[[nodiscard]] std::string ofMost(std::uint64_t count, std::uint64_t most);
/// "84 kB of 4.2 MB"
[[nodiscard]] std::string bytesOf(std::size_t bytes, std::size_t most);
/// "in frame 12: ..."
[[nodiscard]] std::string inFrame(std::uint64_t frame, std::string const& text);
/// Of a run with other scripts or parameters than the level's.
[[nodiscard]] std::string worksButAltered(std::string const& why);
[[nodiscard]] std::string automaticNow(std::string const& level);
[[nodiscard]] std::string sceneNeeds(std::string const& why);
[[nodiscard]] std::string nothingHas(std::string_view property);
/// µs
[[nodiscard]] std::string duration(double microseconds);
/// m
[[nodiscard]] std::string howFarOff(double metres);
[[nodiscard]] std::string errorTip(double metres, double share, std::string const& of,
                                   std::string const& source);
/// "2.00 ms"
[[nodiscard]] std::string budgetOf(double milliseconds);
[[nodiscard]] std::string budgetIs(double microseconds);
[[nodiscard]] std::string ofBudget(double microseconds);
[[nodiscard]] std::string ofRated(double share);
[[nodiscard]] std::string idleNow(std::string const& chosen, std::string const& working);
[[nodiscard]] std::string hintOf(std::size_t shown, std::size_t total);
[[nodiscard]] std::string solvedWith(double seconds, int parts);
[[nodiscard]] std::string cutThis(std::string const& a, std::string const& b);
[[nodiscard]] std::string seconds(double time);
/// An arrow for the nearest of eight directions; `angle` in rad, anticlockwise from the right.
[[nodiscard]] std::string direction(double angle);
/// The text with an upper-case first letter.
[[nodiscard]] std::string capital(std::string text);
/// Broken into lines of at most `width` characters at spaces.
[[nodiscard]] std::string wrapped(std::string const& text, std::size_t width);

} // namespace trembler::ui::words
