// The texts of the pages with the editor's studies of the level.
#pragma once

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/shared/catalog/part_catalog.hpp"
#include "insight/report/level_report.hpp"

#include <string>
#include <vector>

namespace trembler::ui::words {

// Both pages.
inline char const* const& stopStudy = editWord("Stop");
inline char const* const& stopStudyTip = editWord("What was found until then stays");
inline char const* const& stopping = editWord("Stopping …");
inline char const* const& olderState = editWord("Of an older state: the level was changed since.");
inline char const* const& stoppedEarly = editWord("Stopped: this is what was found until then.");
inline char const* const& cannotStudyText = editWord("This cannot be examined: {}");
inline char const* const& countedText = editWord("{} of {}");
inline char const* const& studyNeedsGoal =
    editWord("Without a goal nothing solves the level. Add one on the page Goals.");

// The work in progress, as insight names it.
inline char const* const& stepNeeds = editWord("what its solutions need");
inline char const* const& stepExact = editWord("how exact its solutions must be");
inline char const* const& stepDropped = editWord("single parts dropped at random");
inline char const* const& stepMaps = editWord("where each part may lie");
inline char const* const& stepWhy = editWord("why its solutions meet the goals");
inline char const* const& stepCosts = editWord("what its effects cost");
inline char const* const& stepSearch = editWord("what else solves it");

// The report.
inline char const* const& tabReport = editWord("Report");
inline char const* const& makeReport = editWord("Make the report");
inline char const* const& makeReportTip =
    editWord("Runs the level some thousand times, beside your work, on all processors");
inline char const* const& reportIntro =
    editWord("What the solutions need, how exactly parts must lie, and what falls short. The level is "
             "examined as it stands here, saved or not.");
inline char const* const& fallsShort = editWord("What falls short");
inline char const* const& nothingShort = editWord("Nothing falls short.");
inline char const* const& nothingShortYet = editWord("Nothing falls short so far.");
inline char const* const& isDemonstration =
    editWord("A demonstration: nothing is expected of it but to run.");
inline char const* const& solvesItself = editWord("An empty toolbox solves it.");
inline char const* const& solvesItselfHelp =
    editWord("Let something be missing without which nothing happens: a gap, a push, a support.");
inline char const* const& notByItself = editWord("An empty toolbox does not solve it.");
inline char const* const& noKind = editWord("No recorded solution solves it.");
inline char const* const& noKindHelp = editWord("Play it, solve it, and record the run.");
inline char const* const& oneKind = editWord("Its solutions are all of one kind.");
inline char const* const& oneKindHelp =
    editWord("Record one with other parts or other causes; the next page looks for some.");
inline char const* const& manyKindsText = editWord("Kinds of recorded solutions: {}");
inline char const* const& failsText = editWord("\"{}\" does not solve it.");
inline char const* const& failsHelp =
    editWord("Record it again, or say on the page Solutions that it need not solve it.");
inline char const* const& fragileText = editWord("\"{}\" succeeds in only {} % of its displaced runs.");
inline char const* const& fragileHelp =
    editWord("Record it with its parts in the middle of where they may lie, or leave them more room.");
inline char const* const& luckyText = editWord("{}, dropped anywhere, solves it in {} % of the tries.");
inline char const* const& luckyHelp =
    editWord("Make the area for placing larger, or the goal harder to meet by chance.");
inline char const* const& solutionsHeading = editWord("Recorded solutions");
inline char const* const& reportNoSolutions = editWord("No run is recorded.");
inline char const* const& kindText = editWord("kind {}");
inline char const* const& secondsText = editWord("{} s");
inline char const* const& percentText = editWord("{} %");
inline char const* const& solvesNot = editWord("does not solve it");
inline char const* const& solvesNotAsSaid = editWord("does not solve it, as recorded");
inline char const* const& bySurprise = editWord("solves it, though recorded as a run that does not");
inline char const* const& causesText = editWord("Causes: {}");
inline char const* const& chainHeading = editWord("Why it solves it:");
inline char const* const& chainTraced =
    editWord("Traced: not every cause was confirmed by a run without it.");
inline char const* const& kindAgainstText = editWord("Kind {} beside kind {}, the nearest to it:");
inline char const* const& onlyKindText = editWord("only kind {}: {}");
inline char const* const& leadsToText = editWord("{} leads to {}");
inline char const* const& needsText = editWord("Needs: {}");
inline char const* const& needsNothing = editWord("Needs nothing of the toolbox.");
inline char const* const& needsEffectsText = editWord("Needs the effects: {}");
inline char const* const& superfluousText = editWord("Superfluous: {}");
inline char const* const& robustText =
    editWord("With its parts displaced by up to {} cm and turned by up to {}°, {} of {} runs solve it.");
inline char const* const& robustDeedsText =
    editWord("With its deeds up to {} s earlier or later and {} cm beside, {} of {} runs solve it.");
inline char const* const& robustBothText = editWord(
    "With its parts displaced by up to {} cm and turned by up to {}°, and its deeds up to {} s earlier or "
    "later, {} of {} runs solve it.");
inline char const* const& nothingDisplaced = editWord("It has nothing that could be displaced.");
inline char const* const& watchIt = editWord("Watch it");
inline char const* const& mayLie = editWord("Where a part may lie, the others staying:");
inline char const* const& mapCaption = editWord(
    "In the scene: squares solve it, crosses do not; elsewhere the part does not fit, or nothing beside "
    "it solves it. {} cm apart.");
inline char const* const& placesText = editWord("{} of {} places");
inline char const* const& dropsHeading = editWord("A part alone, anywhere");
inline char const* const& dropText = editWord("solves it in {} of {} tries");
inline char const* const& dropNowhere = editWord("fits nowhere");
inline char const* const& costsHeading = editWord("What the effects cost");
inline char const* const& measureCosts = editWord("Measure it");
inline char const* const& measureCostsTip =
    editWord("Takes long: every recorded run at every detail level of every effect");
inline char const* const& perFrame = editWord("Time per frame, in a run of the first solution:");
inline char const* const& cheapestHeading = editWord("Cheapest with the same verdicts:");
inline char const* const& asNowText = editWord("{}, as now");
inline char const* const& insteadText = editWord("{} instead of {}");
inline char const* const& microsecondsText = editWord("{} µs");
inline char const* const& noneKeeps = editWord("none");

// The search.
inline char const* const& tabSearch = editWord("What else solves it?");
inline char const* const& searchIntro =
    editWord("Tries parts in places of interest, then changes the nearest misses. The same seed and number "
             "of runs find the same.");
inline char const* const& startSearch = editWord("Look for solutions");
inline char const* const& startSearchTip = editWord("Beside your work, on all processors");
inline char const* const& runsField = editWord("Runs:");
inline char const* const& seedField = editWord("Seed:");
inline char const* const& handsField = editWord("By hand as well");
inline char const* const& soFarText = editWord("{} of {} runs, kinds found: {}");
inline char const* const& nearestText = editWord("Nearest miss: {} (0: solved, 1: far off)");
inline char const* const& foundNothing = editWord("Nothing that was tried solves it.");
inline char const* const& foundByOneText = editWord("found in run {}; one run with these parts solves it");
inline char const* const& foundByText = editWord("found in run {}; {} runs with these parts solve it");
inline char const* const& likeText = editWord("of the kind of \"{}\"");
inline char const* const& recordedByNobody = editWord("recorded by nobody");
inline char const* const& keepIt = editWord("Keep it");
inline char const* const& keepItTip = editWord("As a recorded solution of the level");
inline char const* const& playIt = editWord("Play it");
inline char const* const& keptText = editWord("Recorded: {}");

// The deeds of a player, as kinds of solutions name them.
inline char const* const& deedGrab = editWord("dragging by hand");
inline char const* const& deedCut = editWord("cutting a wire");
inline char const* const& deedRemove = editWord("removing something");
inline char const* const& deedWire = editWord("a wire");
inline char const* const& grabText = editWord("dragging {}");
inline char const* const& cutText = editWord("cutting {} – {}");
inline char const* const& removeText = editWord("removing {}");
inline char const* const& wireText = editWord("a wire {} – {}");
inline char const* const& nothingPlaced = editWord("nothing placed");

/// A part or a deed as insight names it ("steel bar", "grab crate", "grab") in the language in use.
[[nodiscard]] std::string shownMaking(PartCatalog const& parts, std::string const& making);
[[nodiscard]] std::string shownMakings(PartCatalog const& parts, std::vector<std::string> const& makings);
/// The parts and deeds of a kind; and its interactions, "" if there are none.
[[nodiscard]] std::string shownMeans(PartCatalog const& parts, insight::CauseGraph const& graph);
[[nodiscard]] std::string shownCauses(insight::CauseGraph const& graph);
/// The difference of one kind from another; "" if there is none.
[[nodiscard]] std::string shownSide(PartCatalog const& parts, insight::GraphSide const& side);
/// In how many of its displaced runs a solution solves the level; it has such runs.
[[nodiscard]] std::string shownRobustness(insight::SolutionReport const& solution,
                                          insight::Jitter const& jitter);
/// The work in progress, and how much of it is done.
[[nodiscard]] std::string shownStep(std::string const& step, insight::WorkDone const& done);

/// A shortcoming, and the remedy.
struct ShownShortcoming {
    std::string what;
    char const* help = nullptr; ///< valid until useLanguage()
};
[[nodiscard]] ShownShortcoming shownShortcoming(PartCatalog const& parts, insight::Shortcoming const& one);

} // namespace trembler::ui::words
