// The window's texts, in one place and in British English; the names of commands are in their tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace trembler::ui::words {

// The program.
inline constexpr char const* programName = "Trembler";
inline constexpr char const* looseLevels = "Levels";
inline constexpr char const* levels = "Levels";
inline constexpr char const* back = "Back";

// Running.
inline constexpr char const* allBackAsk = "Put all back?";
inline constexpr char const* allBackAgain =
    "Once more, and all parts go back into the toolbox. Undo brings them back.";
inline constexpr char const* allBackDone = "All parts are back in the toolbox";

/// Of a speed: "2×", "½×"
[[nodiscard]] std::string timesReal(double speed);
[[nodiscard]] std::string tooSlow(double asked, double reached);

// Tools.
inline constexpr char const* mySolution = "my solution";
inline constexpr char const* runBeforeSaving =
    "Run it first: what is saved is what you placed and what you did while it ran.";
inline constexpr char const* closeTip = "Close";

// Toolbox and placing.
inline constexpr char const* toolbox = "Toolbox";
inline constexpr char const* dropHere = "Let go here to put it back";

[[nodiscard]] std::string wiresLeft(int count);
inline constexpr char const* wireOfLevel = "This wire belongs to the level.";
inline constexpr char const* wireFromHere = "Drag the wire to another conductor, or click it";
[[nodiscard]] std::string conductsNot(std::string const& object);
[[nodiscard]] std::string putThisBack(std::string const& a, std::string const& b);

// Goal, hints, success.
inline constexpr char const* goal = "Goal";
inline constexpr char const* noGoal = "There is nothing to reach here. Try things out.";
inline constexpr char const* hint = "Hint";
inline constexpr char const* nextHint = "Another hint";
inline constexpr char const* noHints = "There is no hint for this level.";
inline constexpr char const* solved = "It works!";
inline constexpr char const* nextLevel = "Next level";
inline constexpr char const* watchAgain = "Watch again";
inline constexpr char const* keepPlaying = "Keep playing";
inline constexpr char const* lastLevel = "That was the last level.";

// Menu and settings.
inline constexpr char const* restart = "Start the level again";
inline constexpr char const* keys = "Keys";
inline constexpr char const* groupBuilding = "Building";
inline constexpr char const* groupRunning = "Running";
inline constexpr char const* groupLooking = "Looking";
inline constexpr char const* groupProgram = "The program";
inline constexpr char const* groupEditing = "Editing levels";

// Inspector.
inline constexpr char const* rightNow = "Right now";
inline constexpr char const* inHand = "in your hand";
inline constexpr char const* inHandMeaning = "whether you hold it";
inline constexpr char const* speed = "speed";
inline constexpr char const* speedMeaning = "of its centre of mass";
inline constexpr char const* electricity = "electricity";
inline constexpr char const* electricityOn = "on";
inline constexpr char const* electricityOff = "off";
inline constexpr char const* electricityMeaning = "whether it is part of a working circuit";
inline constexpr char const* connectedTo = "connected to";
[[nodiscard]] inline std::string connectedBy(std::string const& callers, std::string const& objects) {
    return "by " + callers + ": " + objects;
}
inline constexpr char const* touches = "touches";
inline constexpr char const* touchesMeaning = "the objects that it touches at this moment";
inline constexpr char const* weight = "weight";
inline constexpr char const* weightMeaning = "the force of gravity on it";
inline constexpr char const* potential = "potential";
inline constexpr char const* potentialMeaning = "relative to the return of its network";
inline constexpr char const* floating = "floating: not connected to a source or a return";
inline constexpr char const* current = "current";
inline constexpr char const* currentMeaning = "through it";
inline constexpr char const* power = "power";
inline constexpr char const* powerMeaning = "that becomes heat or light in it";
inline constexpr char const* shortCircuit = "short circuit";
inline constexpr char const* shortMeaning =
    "nearly all of its voltage drops inside it, or its load has hardly any resistance";
inline constexpr char const* magneticPull = "magnetic force";
inline constexpr char const* magneticMeaning = "the sum of all magnetic forces on it";
inline constexpr char const* sounds = "sounds";
inline constexpr char const* soundsMeaning = "sound level at a distance of 1 m";
inline constexpr char const* hears = "hears";
inline constexpr char const* hearsMeaning = "sound level at its position";
inline constexpr char const* silence = "silence";
inline constexpr char const* objectIsGone = "It is not in the world at the moment.";
inline constexpr char const* yes = "yes";
inline constexpr char const* no = "no";
inline constexpr char const* nothingStated = "–";

// Components.
inline constexpr char const* components = "Components";
inline constexpr char const* component = "component";
inline constexpr char const* state = "state";
inline constexpr char const* period = "every";
inline constexpr char const* periodTip = "Runs in every nth frame. Drag to change, double-click to type.";
inline constexpr char const* periodFixedTip =
    "It must run in every frame: otherwise the physics would change.";
inline constexpr char const* timePerFrame = "time, µs";
inline constexpr char const* active = "active";
inline constexpr char const* asleep = "asleep";
inline constexpr char const* absent = "absent";
inline constexpr char const* resolvers = "Resolvers";
inline constexpr char const* derivedSets = "Derived property sets";
inline constexpr char const* interactions = "Interactions";
inline constexpr char const* showAbsent = "Also show what this scene does not activate";
inline constexpr char const* automatic = "as the scene needs it";

// Mods.
inline constexpr char const* mods = "Mods";
inline constexpr char const* noMods = "This level uses no mods.";
inline constexpr char const* modsChanged =
    "Something differs from the level and the files, so this run counts as no solution.";
inline constexpr char const* scriptOn = "Switch the script off, or on again";
inline constexpr char const* scriptOff = "off";
inline constexpr char const* scriptFailed = "failed";
inline constexpr char const* bundledMod = "It came with the program.";
inline constexpr char const* trustedMod = "It is trusted: its scripts are compiled.";
inline constexpr char const* untrustedMod = "It is not trusted: its scripts are interpreted.";
inline constexpr char const* forObject = "of";
inline constexpr char const* forOthers = "all that state none";
inline constexpr char const* asStated = "As the level states it";
inline constexpr char const* parameters = "Parameters";
inline constexpr char const* noParameters = "It has no parameters.";
inline constexpr char const* scriptUses = "Uses";
inline constexpr char const* instructions = "instructions";
inline constexpr char const* memory = "memory";
inline constexpr char const* instructionsTip = "Of its last turn. Beyond its limit a script is switched off.";
inline constexpr char const* notApplied = "It has had no turn in this run.";
inline constexpr char const* scriptLog = "Log";
inline constexpr char const* failedInThisRun = "It failed and is switched off for this run";
inline constexpr char const* fileRefused = "The file as it was saved is not used";
inline constexpr char const* howItCameThere = "How it came there";

// What accuracy costs.
inline constexpr char const* effect = "effect";
inline constexpr char const* howExactly = "how exactly";
inline constexpr char const* timePerFrameOf = "time per frame";
inline constexpr char const* errorAfterASecond = "error at 1 s";
inline constexpr char const* oneWayOnly = "one level only";
inline constexpr char const* notNeeded = "nothing activates it";
inline constexpr char const* notRead = "nothing reads it";
inline constexpr char const* wholeFrame = "A frame";
inline constexpr char const* withoutBudget = "no budget";
inline constexpr char const* keepToBudget = "Keep to a time budget";
inline constexpr char const* budgetTip =
    "Levels, settings and periods are chosen, once a second, so that a frame takes no longer than this on "
    "average and "
    "the error is least. The choices become part of what you save.";
inline constexpr char const* budgetFormat = "%.2f ms";
inline constexpr char const* lessOrMore = "Less or more of it";
inline constexpr char const* budgetOff = "No time budget: levels stay as they are";
inline constexpr char const* budgetMissed = "The last second took longer than that.";
inline constexpr char const* budgetHopeless = "No allowed choice is fast enough for this budget.";
inline constexpr char const* nothingToChange = "Everything is as it should be: nothing to change.";
inline constexpr char const* budgetMeasuring = "Measuring, for a second …";

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

[[nodiscard]] std::string cannotWrite(std::string const& path, std::string const& why);
[[nodiscard]] std::string pictureTaken(std::string const& path);
[[nodiscard]] std::string solutionSaved(std::string const& path);
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
[[nodiscard]] std::string budgetIs(double microseconds);
[[nodiscard]] std::string ofBudget(double microseconds);
[[nodiscard]] std::string ofRated(double share);
[[nodiscard]] std::string idleNow(std::string const& chosen, std::string const& working);
[[nodiscard]] std::string hintOf(std::size_t shown, std::size_t total);
[[nodiscard]] std::string solvedWith(double seconds, int parts);
[[nodiscard]] std::string count(int number, char const* one, char const* many);
[[nodiscard]] std::string cutThis(std::string const& a, std::string const& b);
[[nodiscard]] std::string seconds(double time);
/// An arrow for the nearest of eight directions; `angle` in rad, anticlockwise from the right.
[[nodiscard]] std::string direction(double angle);
/// The text with an upper-case first letter.
[[nodiscard]] std::string capital(std::string text);
/// Broken into lines of at most `width` characters at spaces.
[[nodiscard]] std::string wrapped(std::string const& text, std::size_t width);

} // namespace trembler::ui::words
