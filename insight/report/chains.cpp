#include "insight/report/chains.hpp"

#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"
#include "insight/why/words/answer_text.hpp"
#include "puzzle/goals/words/goal_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::insight {

std::vector<ReportedGoal> goalsOf(LevelUnderTest const& level) {
    GoalJudge const judge(level.level(), level.world());
    std::vector<std::string> const texts = goalSentences(level.level(), level.world(), englishSpeech());
    std::vector<ReportedGoal> goals;
    for (std::size_t i = 0; i < judge.status().size(); ++i) {
        goals.push_back({judge.status()[i].id, i < texts.size() ? texts[i] : judge.status()[i].id});
    }
    return goals;
}

std::vector<std::vector<Answer>> chainsOf(LevelUnderTest const& level, LevelRuns const& runs,
                                          std::vector<Solution const*> const& solutions,
                                          std::vector<ReportedGoal> const& goals, Workers& workers) {
    std::vector<std::string> keys;
    for (Solution const* const solution : solutions) {
        for (ReportedGoal const& goal : goals) {
            keys.push_back(fmt::format("chain/{}/{}/{}/{}", level.identity(), identityOf(*solution),
                                       solution->name, goal.id));
        }
    }
    std::size_t const each = std::max<std::size_t>(1, goals.size());
    auto const results = workers.share(keys, [&](std::size_t index) {
        Solution const& solution = *solutions[index / each];
        Question question;
        question.goal = goals[index % each].id;
        AskOptions options;
        options.frames = framesOf(solution);
        options.threads = 1; // the pieces of work run side by side
        return toText(why(runs, solution, question, options));
    });
    std::vector<std::vector<Answer>> chains(solutions.size());
    for (std::size_t index = 0; index < results.size(); ++index) {
        if (!results[index]) {
            continue;
        }
        if (Answer answer = answerFrom(*results[index]); answer.happened) {
            chains[index / each].push_back(std::move(answer));
        }
    }
    return chains;
}

} // namespace trembler::insight
