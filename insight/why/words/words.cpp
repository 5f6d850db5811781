#include "insight/why/words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <set>

namespace trembler::insight {
namespace {

/// Makes the sentences of a chain: from the end back, a sentence for each step with its causes, which go on
/// in the same sentence as long as there is only one, or only what one magnet does.
class ChainSentences {
public:
    ChainSentences(Answer const& answer, std::string const& goal, AnswerLanguage const& language)
        : answer_(answer), goal_(goal), language_(language), written_(answer.chain.size()) {}

    [[nodiscard]] std::vector<std::string> sentences() {
        if (!answer_.chain.empty()) {
            addSentence({answer_.chain.size() - 1});
        }
        return std::move(sentences_);
    }

private:
    /// Clauses in one sentence at most.
    static constexpr int longest = 4;

    [[nodiscard]] Clauses clauses(std::size_t step) const {
        return clausesOf(answer_.chain[step].step, answer_.facts, goal_, language_);
    }
    /// How often a step's cycle was repeated, if the sentences have not said so yet; else 0.
    std::size_t newCycle(std::size_t step) {
        ChainStep const& one = answer_.chain[step];
        return one.cycle > 0 && cycles_.insert(one.cycle).second ? one.times : 0;
    }
    /// Whether these are the pulls and pushes of one magnet, for the same reasons.
    [[nodiscard]] bool isOneMagnet(std::vector<std::size_t> const& steps) const {
        Step const& first = answer_.chain[steps.front()].step;
        return std::all_of(steps.begin(), steps.end(), [&](std::size_t i) {
            Step const& step = answer_.chain[i].step;
            return isPull(step.kind) && step.objects.back() == first.objects.back() &&
                   step.because == first.because;
        });
    }
    [[nodiscard]] bool isAnyWritten(std::vector<std::size_t> const& steps) const {
        return std::any_of(steps.begin(), steps.end(), [&](std::size_t i) { return written_[i]; });
    }
    /// Of several steps with the same causes.
    void addSentence(std::vector<std::size_t> const& steps) {
        if (isAnyWritten(steps)) {
            return;
        }
        std::size_t repeated = 0;
        std::vector<std::string> subjects;
        for (std::size_t const step : steps) {
            written_[step] = true;
            repeated = std::max(repeated, newCycle(step));
            subjects.push_back(clauses(step).main);
        }
        std::string const between = " " + language_.fill("and", {}) + " ";
        std::string text = capitalised(fmt::format("{}", fmt::join(subjects, between)));
        std::vector<std::size_t> next = answer_.chain[steps.front()].step.because;
        if (next.empty() && !sentences_.empty()) {
            return; // it has been named as a cause
        }
        for (int said = 1; !next.empty(); ++said) {
            std::vector<std::string> causes;
            for (std::size_t const cause : next) {
                causes.push_back(clauses(cause).because);
                repeated = std::max(repeated, newCycle(cause));
            }
            text += ", " + fmt::format("{}", fmt::join(causes, between));
            bool const one = next.size() == 1 || isOneMagnet(next);
            if (!one || said == longest || isAnyWritten(next)) {
                break;
            }
            std::vector<std::size_t> const further = answer_.chain[next.front()].step.because;
            for (std::size_t const cause : next) {
                written_[cause] = written_[cause] || !further.empty();
            }
            if (further.empty()) {
                next.clear();
                break;
            }
            next = further;
        }
        if (repeated > 0) {
            text += " " + language_.fill("(and so on, {} times)", {std::to_string(repeated)});
        }
        sentences_.push_back(text + ".");
        std::sort(next.rbegin(), next.rend());
        while (!next.empty()) {
            auto const others = std::stable_partition(next.begin() + 1, next.end(), [&](std::size_t other) {
                return isOneMagnet({next.front(), other});
            });
            std::vector<std::size_t> together(next.begin(), others);
            next.erase(next.begin(), others);
            std::sort(together.begin(), together.end());
            addSentence(together);
        }
    }

    Answer const& answer_;
    std::string const& goal_;
    AnswerLanguage const& language_;
    std::vector<bool> written_;
    std::set<std::size_t> cycles_; // that the sentences have named
    std::vector<std::string> sentences_;
};

} // namespace

std::vector<std::string> sentencesOf(Answer const& answer, std::string const& goal,
                                     AnswerLanguage const& language) {
    if (!answer.happened) {
        std::vector<std::string> all{capitalised(language.fill("the goal “{}” was not met", {goal})) + "."};
        if (answer.nearest) {
            std::vector<std::string> const miss =
                sentencesOf(answer.nearest->nearest, language.calling(answer.facts.spoken));
            all.insert(all.end(), miss.begin(), miss.end());
        }
        return all;
    }
    return ChainSentences(answer, goal, language).sentences();
}

std::string sourceOf(Answer const& answer, AnswerLanguage const& language) {
    std::string const runs = std::to_string(answer.runs);
    bool const one = answer.runs == 1;
    if (!answer.happened) {
        return language.fill(one ? "measured in {} run" : "measured in {} runs", {runs});
    }
    if (answer.confirmed) {
        return language.fill(one ? "confirmed in {} run" : "confirmed in {} runs", {runs});
    }
    return language.fill(one ? "traced in {} run, not confirmed in all steps"
                             : "traced in {} runs, not confirmed in all steps",
                         {runs});
}

nlohmann::ordered_json toJson(Answer const& answer, std::string const& asked, std::string const& goal,
                              AnswerLanguage const& language) {
    nlohmann::ordered_json chain = nlohmann::ordered_json::array();
    for (ChainStep const& one : answer.chain) {
        chain.push_back({{"frame", one.step.frame},
                         {"event", one.step.what},
                         {"objects", one.step.objects},
                         {"because", one.step.because},
                         {"confirmed", one.proof == Proof::confirmed || one.proof == Proof::together},
                         {"proof", nameOf(one.proof)},
                         {"traced", one.step.traced},
                         {"times", one.times},
                         {"text", clausesOf(one.step, answer.facts, goal, language).main}});
    }
    nlohmann::ordered_json made{
        {"asked", asked},
        {"happened", answer.happened},
        {"answer", fmt::format("{}", fmt::join(sentencesOf(answer, goal, language), " "))},
        {"confirmed", answer.confirmed},
        {"chain", chain},
        {"dropped", answer.dropped},
        {"runs", answer.runs}};
    if (answer.nearest) {
        made["nearest_miss"] = toJson(answer.nearest->nearest);
    }
    return made;
}

} // namespace trembler::insight
