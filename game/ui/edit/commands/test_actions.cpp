#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/solutions.hpp"

namespace trembler::ui::actions {
namespace {

using render::ToastKind;

/// A screen for the document as it is; nullptr, and a message, if it cannot be played.
std::unique_ptr<PlayScreen> playScreenFor(EditParts& parts) {
    parts.autosave->flush(parts.document);
    if (parts.data != nullptr && !parts.data->mods.empty()) {
        parts.studies->stopAll(); // the scripts that its worlds run can be changed while playing
    }
    try {
        // A demonstration is played with its task, as in the game.
        LevelFile const level = asPlayed(parts.document.level(), "");
        bool const task = parts.document.level().demonstration && !level.demonstration;
        parts.playedTree = task ? edit::GoalTree::task : edit::GoalTree::goals;
        // Not the document's own path: a test play marks no level as solved.
        std::filesystem::path const name =
            "test of " + (parts.document.path().empty() ? std::string("a new level.json")
                                                        : parts.document.path().filename().string());
        std::vector<std::string> places;
        for (edit::GoalLine const& line : edit::goalLines(parts.tree(), parts.playedTree)) {
            places.push_back(line.place);
        }
        parts.goals.begin(level, std::move(places));
        auto screen =
            std::make_unique<PlayScreen>(parts.context, name, parts.data, parts.options.world, &level);
        screen->beTestPlay();
        screen->updateBehindMenu(0); // it is drawn before its first update
        return screen;
    } catch (InputError const& error) {
        std::vector<Diagnostic> const& all = error.diagnostics();
        parts.tell(words::cannotTest(all.empty() ? shownError(error) : translated(all.front().message)),
                   ToastKind::Trouble);
        parts.tab = Tab::problems;
        return nullptr;
    }
}

/// Plays the solution, or with `over` places its parts and waits for a new recording, which replaces the
/// solution of that name.
void beginRun(EditParts& parts, std::unique_ptr<PlayScreen> screen, Solution const& solution,
              std::string const& over) {
    try {
        screen->session().load(solution);
    } catch (InputError const& error) {
        std::vector<Diagnostic> const& all = error.diagnostics();
        parts.tell(words::cannotTest(all.empty() ? shownError(error) : translated(all.front().message)),
                   ToastKind::Trouble);
        return;
    }
    parts.test = std::move(screen);
    parts.test->worldChanged();
    parts.recordsOver = over;
    if (over.empty()) {
        parts.test->commands().run("run");
    }
}

} // namespace

void testPlay(EditParts& parts) {
    parts.recordsOver.clear();
    parts.test = playScreenFor(parts);
}

void playSolution(EditParts& parts, std::string const& name, bool again) {
    parts.recordsOver.clear();
    auto screen = playScreenFor(parts);
    if (screen == nullptr) {
        return;
    }
    if (Solution const* const solution = screen->session().level().findSolution(name)) {
        beginRun(parts, std::move(screen), *solution, again ? name : "");
    }
}

void playRun(EditParts& parts, Solution const& solution) {
    parts.recordsOver.clear();
    if (auto screen = playScreenFor(parts)) {
        beginRun(parts, std::move(screen), solution, "");
    }
}

void endTest(EditParts& parts) {
    if (parts.test != nullptr) {
        parts.goals.end();
        parts.test->leave();
        parts.test.reset();
        parts.recordsOver.clear();
    }
}

bool isTesting(EditParts const& parts) {
    return parts.test != nullptr;
}

void recordSolution(EditParts& parts) {
    if (parts.test == nullptr) {
        return;
    }
    Session& session = parts.test->session();
    if (session.mode() == SessionMode::building) {
        parts.tell(words::runFirst);
        return;
    }
    if (auto const why = session.whyNotRecorded()) {
        parts.tell(*why, ToastKind::Trouble);
        return;
    }
    Solution solution = session.record(parts.recordsOver.empty() ? words::newSolution : parts.recordsOver);
    solution.solves = session.solved();
    std::string const over = parts.recordsOver;
    bool const done = parts.run([&](edit::Json const& level) {
        return over.empty() ? edit::addSolution(level, solution) : edit::recordAgain(level, over, solution);
    });
    if (done) {
        parts.tell(solution.solves ? words::recordedSolved : words::recordedUnsolved, ToastKind::Success);
        parts.tab = Tab::solutions;
    }
}

} // namespace trembler::ui::actions
