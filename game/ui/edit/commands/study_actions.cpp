#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "puzzle/edit/commands/solutions.hpp"
#include "puzzle/goals/words/goal_text.hpp"
#include "runtime/level/build/build_world.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trembler::ui::actions {
namespace {

using render::ToastKind;

/// The goals as they are played, in the language in use.
std::map<std::string, std::string> goalsInWords(GameData const& data, LevelFile const& level) {
    LevelFile const played = asPlayed(level, "");
    auto const world = buildWorld(data.registry, played, data.parts);
    GoalJudge const judge(played, *world);
    std::vector<std::string> const texts = goalSentences(played, *world, speechInUse());
    std::map<std::string, std::string> goals;
    for (std::size_t i = 0; i < texts.size() && i < judge.status().size(); ++i) {
        goals.emplace(judge.status()[i].id, texts[i]);
    }
    return goals;
}

/// The level as it stands in the editor; nothing, and a message, if it cannot be examined.
std::optional<StudiedLevel> studiedNow(EditParts& parts) {
    try {
        StudiedLevel now{parts.data, parts.document.level(), parts.document.name()};
        if (now.level.goals.is_null() && now.level.task.is_null()) {
            parts.tell(words::studyNeedsGoal, ToastKind::Trouble);
            return std::nullopt;
        }
        now.goals = goalsInWords(*now.data, now.level);
        return now;
    } catch (InputError const& error) {
        std::vector<Diagnostic> const& all = error.diagnostics();
        parts.tell(words::filledIn(words::cannotStudyText,
                                   all.empty() ? shownError(error) : translated(all.front().message)),
                   ToastKind::Trouble);
        parts.tab = Tab::problems;
        return std::nullopt;
    }
}

} // namespace

std::string const& stateOf(EditParts const& parts, bool withSolutions) {
    StateTexts& known = parts.studies->stateTexts;
    if (!known.revision || *known.revision != parts.document.revision()) {
        edit::Json tree = parts.tree();
        if (tree.is_object()) {
            tree.erase("editor");
        }
        known.whole = tree.dump();
        if (tree.is_object()) {
            tree.erase("solutions");
        }
        known.withoutSolutions = tree.dump();
        known.revision = parts.document.revision();
    }
    return withSolutions ? known.whole : known.withoutSolutions;
}

bool isReporting(EditParts const& parts) {
    return parts.studies->report().running();
}

bool isSearching(EditParts const& parts) {
    return parts.studies->searched().running();
}

void makeReport(EditParts& parts) {
    parts.tab = Tab::report;
    if (isReporting(parts)) {
        return parts.studies->report().work->stop();
    }
    if (auto now = studiedNow(parts)) {
        parts.studies->makeReport(std::move(*now), stateOf(parts, true));
    }
}

void measureCosts(EditParts& parts) {
    if (parts.studies->costs().running()) {
        return parts.studies->costs().work->stop();
    }
    if (auto now = studiedNow(parts)) {
        parts.studies->measureCosts(std::move(*now), stateOf(parts, true));
    }
}

void searchSolutions(EditParts& parts) {
    parts.tab = Tab::search;
    if (isSearching(parts)) {
        return parts.studies->searched().work->stop();
    }
    if (auto now = studiedNow(parts)) {
        parts.studies->search(std::move(*now), stateOf(parts, false), parts.studies->request);
    }
}

void keepFound(EditParts& parts, std::size_t found) {
    auto const shown = parts.studies->searched().result();
    if (shown == nullptr || found >= shown->search.found.size()) {
        return;
    }
    Solution const solution =
        insight::solutionForFile(*shown->of->data, shown->of->level, shown->search.found[found], found + 1);
    if (parts.run([&](edit::Json const& level) { return edit::addSolution(level, solution); })) {
        parts.tell(words::filledIn(words::keptText, solution.name), ToastKind::Success);
    }
}

} // namespace trembler::ui::actions
