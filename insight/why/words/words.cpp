#include "insight/why/words/words.hpp"

#include "runtime/component/component.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <set>

namespace trembler::insight {
namespace {

std::string capitalised(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

/// Makes the sentences of a chain: from the end back, a sentence for each step with its causes, which go on
/// in the same sentence as long as there is only one.
class ChainSentences {
public:
    ChainSentences(Answer const& answer, std::string const& goal, AnswerLanguage const& language)
        : answer_(answer), goal_(goal), language_(language), written_(answer.chain.size()) {}

    [[nodiscard]] std::vector<std::string> sentences() {
        if (!answer_.chain.empty()) {
            addSentence(answer_.chain.size() - 1);
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
    void addSentence(std::size_t step) {
        if (written_[step]) {
            return;
        }
        written_[step] = true;
        std::size_t repeated = newCycle(step);
        std::string text = capitalised(clauses(step).main);
        std::vector<std::size_t> next = answer_.chain[step].step.because;
        if (next.empty() && !sentences_.empty()) {
            return; // it has been named as a cause
        }
        for (int said = 1; !next.empty(); ++said) {
            std::vector<std::string> causes;
            for (std::size_t const cause : next) {
                causes.push_back(clauses(cause).because);
                repeated = std::max(repeated, newCycle(cause));
            }
            text += ", " + fmt::format("{}", fmt::join(causes, " " + language_.fill("and", {}) + " "));
            if (next.size() > 1 || said == longest || written_[next.front()]) {
                break;
            }
            std::size_t const only = next.front();
            std::vector<std::size_t> const further = answer_.chain[only].step.because;
            if (!further.empty()) {
                written_[only] = true;
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
        for (std::size_t const cause : next) {
            addSentence(cause);
        }
    }

    Answer const& answer_;
    std::string const& goal_;
    AnswerLanguage const& language_;
    std::vector<bool> written_;
    std::set<std::size_t> cycles_; // that were told
    std::vector<std::string> sentences_;
};

std::string secondsOf(std::uint64_t frame, AnswerLanguage const& language) {
    return language.number(static_cast<double>(frame) * frameDuration, 1);
}

std::string gapText(CircuitGap const& gap, AnswerLanguage const& language) {
    return language.mix("of {} between {} and {}",
                        {{language.distance(gap.width)}, {gap.nameA, true}, {gap.nameB, true}});
}

/// Where the gaps are: "the circuit has a gap of 4 cm between the left contact and the right contact".
std::string gapsText(Miss const& miss, AnswerLanguage const& language) {
    std::vector<std::string> texts;
    for (CircuitGap const& gap : miss.gaps) {
        texts.push_back(gapText(gap, language));
    }
    std::string const joined = fmt::format("{}", fmt::join(texts, ", " + language.fill("and", {}) + " "));
    return language.fill(miss.gaps.size() == 1 ? "the circuit has a gap {}" : "the circuit has gaps {}",
                         {joined});
}

/// The moment of its condition that a miss describes.
enum class Extreme : std::uint8_t {
    nearest,  ///< of the whole run
    farthest, ///< since it held
    none,     ///< that of another miss
};

/// The sentence for a miss without a measure; about an object, if there is one.
std::string otherWayText(std::optional<Said> const& object, Extreme extreme, std::string const& when,
                         AnswerLanguage const& language) {
    if (extreme == Extreme::nearest) {
        return object ? language.mix("{} never was as it should be", {*object})
                      : language.fill("it never was as it should be", {});
    }
    if (extreme == Extreme::farthest) {
        return (object ? language.mix("{} ceased to be as it should be", {*object})
                       : language.fill("it ceased to be as it should be", {})) +
               when;
    }
    return (object ? language.mix("{} was not as it should be", {*object})
                   : language.fill("it was not as it should be", {})) +
           when;
}

/// Whether the miss only says that a condition did not hold at its moment: one of several conditions, or an
/// obstacle besides, may have been otherwise at another moment.
bool isOfItsMoment(Miss const& miss) {
    return miss.lack == Lack::change || miss.lack == Lack::steps;
}

/// What one miss says, with its moment.
std::string sentenceOf(Miss const& miss, Extreme extreme, std::string const& when,
                       AnswerLanguage const& language) {
    std::vector<std::string> const& names = miss.names;
    Said const first{names.empty() ? std::string() : names.front(), true};
    Said const second{names.size() < 2 ? std::string() : names[1], true};
    auto const amount = [&](int digits) {
        return Said{fmt::format("{} {}", language.number(miss.by, digits), unitOf(miss.lack))};
    };
    switch (miss.lack) {
    case Lack::distance: {
        Said const by{language.distance(miss.by)};
        if (names.size() < 2) {
            return language.mix(extreme == Extreme::nearest ? "{} was {} short of where it should be"
                                                            : "{} was {} away from where it should be",
                                {first, by}) +
                   when;
        }
        return (extreme == Extreme::nearest ? language.mix("{} came within {} of {}", {first, by, second})
                                            : language.mix("{} was {} away from {}", {first, by, second})) +
               when;
    }
    case Lack::gap:
        return language.mix("no current flowed through {}: {}", {first, {gapsText(miss, language)}}) + when;
    case Lack::power:
        return language.mix("{} lacked {}", {first, amount(3)}) + when;
    case Lack::force:
        return language.mix("{} pulled {} with {} less than its weight", {first, second, amount(2)}) + when;
    case Lack::lift:
        return language.mix(names.size() > 2
                                ? "{} would have lifted {} there with {} less than the weight of it "
                                  "and all that is tied to it or lies on it"
                                : "{} would have lifted {} there with {} less than its weight",
                            {first, second, amount(0)}) +
               when;
    case Lack::torque:
        return language.mix("the load turned {} with {} more than {} righted it",
                            {second, amount(0), first}) +
               when;
    case Lack::count:
        return language.mix("the number was wrong by {}", {{language.number(miss.by, 0)}}) + when;
    case Lack::ways: {
        bool const one = miss.by < 1.5;
        Said const ways{language.number(miss.by, 0)};
        return (one ? language.mix("current still flowed through {}: one connection held it", {first})
                    : language.mix("current still flowed through {}: at least {} connections held it",
                                   {first, ways})) +
               when;
    }
    case Lack::touches: {
        Said const pairs{language.number(miss.by, 0)};
        return (miss.by < 1.5
                    ? language.mix("{} still touched {}", {first, second})
                    : language.mix("{} still touched {}, one of {} such pairs", {first, second, pairs})) +
               when;
    }
    case Lack::time:
        return language.mix("it held, but for {} less than it should", {amount(2)}) + when;
    case Lack::steps:
    case Lack::change:
        return otherWayText(names.empty() ? std::nullopt : std::optional(first), extreme, when, language);
    case Lack::nothing:
        break;
    }
    return language.fill("it was met", {}) + when;
}

nlohmann::ordered_json missJson(Miss const& miss, AnswerLanguage const& language) {
    nlohmann::ordered_json made{{"frame", miss.frame},     {"what", nameOf(miss.lack)},
                                {"by", miss.by},           {"unit", unitOf(miss.lack)},
                                {"measure", miss.measure}, {"objects", miss.names}};
    nlohmann::ordered_json gaps = nlohmann::ordered_json::array();
    for (CircuitGap const& gap : miss.gaps) {
        gaps.push_back({{"between", {gap.nameA, gap.nameB}},
                        {"width", gap.width},
                        {"from", {gap.from.x, gap.from.y}},
                        {"to", {gap.to.x, gap.to.y}}});
    }
    if (!gaps.empty()) {
        made["gaps"] = gaps;
    }
    nlohmann::ordered_json besides = nlohmann::ordered_json::array();
    for (Miss const& other : miss.besides) {
        nlohmann::ordered_json one = missJson(other, language);
        if (other.frame == 0) {
            one.erase("frame"); // that of the whole
        }
        besides.push_back(std::move(one));
    }
    if (!besides.empty()) {
        made["besides"] = besides;
    }
    return made;
}

/// A sentence for the miss and for each of what stood in the way besides; with a moment, if it is another:
/// then it is of what had held (see Aftermath).
void addSentences(Miss const& miss, Extreme extreme, std::uint64_t named, AnswerLanguage const& language,
                  std::vector<std::string>& sentences) {
    bool const later = miss.frame != 0 && miss.frame != named;
    std::string const when = later ? language.fill(", at {} s", {secondsOf(miss.frame, language)}) : "";
    Extreme const now = isOfItsMoment(miss) ? Extreme::none : extreme;
    Extreme const here = later ? Extreme::farthest : now;
    sentences.push_back(capitalised(sentenceOf(miss, here, when, language)) + ".");
    for (Miss const& other : miss.besides) {
        Extreme const there = here == Extreme::nearest ? here : Extreme::none;
        addSentences(other, there, later ? miss.frame : named, language, sentences);
    }
}

} // namespace

std::vector<std::string> sentencesOf(Miss const& miss, AnswerLanguage const& language) {
    std::string const when = language.fill(", at {} s", {secondsOf(miss.frame, language)});
    bool const oneOfSeveral = miss.child != Miss::noChild;
    Extreme const extreme = oneOfSeveral && isOfItsMoment(miss) ? Extreme::none : Extreme::nearest;
    std::vector<std::string> sentences{capitalised(sentenceOf(miss, extreme, when, language)) + "."};
    for (Miss const& other : miss.besides) {
        addSentences(other, Extreme::nearest, miss.frame, language, sentences);
    }
    return sentences;
}

std::vector<std::string> sentencesOf(Answer const& answer, std::string const& goal,
                                     AnswerLanguage const& language) {
    if (!answer.happened) {
        std::vector<std::string> all{capitalised(language.fill("the goal “{}” was not met", {goal})) + "."};
        if (answer.nearest) {
            std::vector<std::string> const miss = sentencesOf(answer.nearest->nearest, language);
            all.insert(all.end(), miss.begin(), miss.end());
        }
        return all;
    }
    return ChainSentences(answer, goal, language).sentences();
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
        made["nearest_miss"] = missJson(answer.nearest->nearest, language);
    }
    return made;
}

} // namespace trembler::insight
