// Answers about the thesis's experiments, compared with its accounts, for tests.
#pragma once

#include "insight/why/words/words.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace trembler::insight {

inline LevelFile experiment(std::string const& name) {
    return loadLevel(gameData().registry, gameData().home / "levels/experiments" / (name + ".json"));
}

/// About a recorded solution of an experiment; `task`: with its task for its goal, as the game has it.
inline Answer answerIn(std::string const& name, std::string const& solution, Question const& question = {},
                       std::uint64_t frames = 0, bool task = false) {
    LevelFile const level = task ? asPlayed(experiment(name), "") : experiment(name);
    LevelRuns const runs(gameData(), level);
    Solution const& asked = *level.findSolution(solution);
    AskOptions options;
    options.frames = frames > 0 ? frames : LevelRuns::framesFor(asked);
    return why(runs, asked, question, options);
}

inline Question ofObject(std::string const& object, double at) {
    Question question;
    question.object = object;
    question.at = at;
    return question;
}

/// The place of a step with all these objects; the chain's length if there is none.
inline std::size_t placeIn(Answer const& answer, StepKind kind, std::vector<std::string> const& objects) {
    auto const at = std::find_if(answer.chain.begin(), answer.chain.end(), [&](ChainStep const& one) {
        return one.step.kind == kind && std::all_of(objects.begin(), objects.end(), [&](auto const& name) {
                   auto const& all = one.step.objects;
                   return std::find(all.begin(), all.end(), name) != all.end();
               });
    });
    return static_cast<std::size_t>(at - answer.chain.begin());
}

inline bool isSure(Answer const& answer, std::size_t place) {
    return place < answer.chain.size() &&
           (answer.chain[place].proof == Proof::confirmed || answer.chain[place].proof == Proof::together);
}

inline std::string told(Answer const& answer) {
    std::string all;
    for (std::string const& sentence : sentencesOf(answer, answer.goal, AnswerLanguage())) {
        all += sentence + " ";
    }
    return all;
}

/// No cause comes after its effect, and no magnet moves anything before the next frame.
inline void expectEarlierCauses(Answer const& answer) {
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        for (std::size_t const cause : answer.chain[i].step.because) {
            ASSERT_LT(cause, i);
            Step const& before = answer.chain[cause].step;
            EXPECT_LE(before.frame + (isPull(before.kind) ? 1 : 0), answer.chain[i].step.frame);
        }
    }
}

using Account = std::vector<std::pair<StepKind, std::vector<std::string>>>;

/// All of these steps are in the answer and proven, none later than the next.
inline void expectInOrder(Answer const& answer, Account const& account) {
    expectEarlierCauses(answer);
    std::uint64_t before = 0;
    for (auto const& [kind, objects] : account) {
        std::size_t const place = placeIn(answer, kind, objects);
        ASSERT_LT(place, answer.chain.size()) << objects.front() << ": " << told(answer);
        EXPECT_TRUE(isSure(answer, place)) << objects.front();
        EXPECT_GE(answer.chain[place].step.frame, before) << objects.front();
        before = answer.chain[place].step.frame;
    }
}

/// The same, and all of them led to the last one.
inline void expectChain(Answer const& answer, Account const& account) {
    expectInOrder(answer, account);
    std::size_t const last = placeIn(answer, account.back().first, account.back().second);
    ASSERT_LT(last, answer.chain.size());
    std::vector<bool> leads(answer.chain.size());
    leads[last] = true;
    for (std::size_t i = answer.chain.size(); i-- > 0;) {
        for (std::size_t const cause : answer.chain[i].step.because) {
            leads[cause] = leads[cause] || leads[i];
        }
    }
    for (auto const& [kind, objects] : account) {
        std::size_t const place = placeIn(answer, kind, objects);
        EXPECT_TRUE(place < leads.size() && leads[place]) << objects.front() << ": " << told(answer);
    }
}

} // namespace trembler::insight
