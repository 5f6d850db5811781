#include "insight/why/words.hpp"

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
class Teller {
public:
    Teller(Answer const& answer, std::string const& goal, Tongue const& tongue)
        : answer_(answer), goal_(goal), tongue_(tongue), told_(answer.chain.size()) {}

    [[nodiscard]] std::vector<std::string> sentences() {
        if (!answer_.chain.empty()) {
            tell(answer_.chain.size() - 1);
        }
        return std::move(sentences_);
    }

private:
    /// Clauses in one sentence at most.
    static constexpr int longest = 4;

    [[nodiscard]] Clauses clauses(std::size_t step) const {
        return clausesOf(answer_.chain[step].step, answer_.facts, goal_, tongue_);
    }
    /// How often a step's cycle was repeated, if the sentences have not said so yet; else 0.
    std::size_t newCycle(std::size_t step) {
        ChainStep const& one = answer_.chain[step];
        return one.cycle > 0 && cycles_.insert(one.cycle).second ? one.times : 0;
    }
    void tell(std::size_t step) {
        if (told_[step]) {
            return;
        }
        told_[step] = true;
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
            text += ", " + fmt::format("{}", fmt::join(causes, " " + tongue_.fill("and", {}) + " "));
            if (next.size() > 1 || said == longest || told_[next.front()]) {
                break;
            }
            std::size_t const only = next.front();
            std::vector<std::size_t> const further = answer_.chain[only].step.because;
            if (!further.empty()) {
                told_[only] = true;
            }
            if (further.empty()) {
                next.clear();
                break;
            }
            next = further;
        }
        if (repeated > 0) {
            text += " " + tongue_.fill("(and so on, {} times)", {std::to_string(repeated)});
        }
        sentences_.push_back(text + ".");
        std::sort(next.rbegin(), next.rend());
        for (std::size_t const cause : next) {
            tell(cause);
        }
    }

    Answer const& answer_;
    std::string const& goal_;
    Tongue const& tongue_;
    std::vector<bool> told_;
    std::set<std::size_t> cycles_; // that were told
    std::vector<std::string> sentences_;
};

std::string secondsOf(std::uint64_t frame, Tongue const& tongue) {
    return tongue.number(static_cast<double>(frame) * frameDuration, 1);
}

std::string gapText(CircuitGap const& gap, Tongue const& tongue) {
    return tongue.mix("of {} between {} and {}",
                      {{tongue.distance(gap.width)}, {gap.nameA, true}, {gap.nameB, true}});
}

/// Where the gaps are: "the circuit has a gap of 4 cm between the left contact and the right contact".
std::string gapsText(Miss const& miss, Tongue const& tongue) {
    std::vector<std::string> texts;
    for (CircuitGap const& gap : miss.gaps) {
        texts.push_back(gapText(gap, tongue));
    }
    std::string const joined = fmt::format("{}", fmt::join(texts, ", " + tongue.fill("and", {}) + " "));
    return tongue.fill(miss.gaps.size() == 1 ? "the circuit has a gap {}" : "the circuit has gaps {}",
                       {joined});
}

/// Which moment of what it is about a miss tells.
enum class Extreme : std::uint8_t {
    nearest,  ///< of the whole run
    farthest, ///< since it held
    none,     ///< that of another miss
};

/// What no measure tells how nearly; of an object, if there is one.
std::string otherWayText(std::optional<Said> const& object, Extreme extreme, std::string const& when,
                         Tongue const& tongue) {
    if (extreme == Extreme::nearest) {
        return object ? tongue.mix("{} never was as it should be", {*object})
                      : tongue.fill("it never was as it should be", {});
    }
    if (extreme == Extreme::farthest) {
        return (object ? tongue.mix("{} ceased to be as it should be", {*object})
                       : tongue.fill("it ceased to be as it should be", {})) +
               when;
    }
    return (object ? tongue.mix("{} was not as it should be", {*object})
                   : tongue.fill("it was not as it should be", {})) +
           when;
}

/// Whether it only tells that something was not so at its moment: one of several conditions, or what stood in
/// the way besides, may have been so at another moment.
bool isOfItsMoment(Miss const& miss) {
    return miss.lack == Lack::change || miss.lack == Lack::steps;
}

/// What one miss says, with its moment.
std::string sentenceOf(Miss const& miss, Extreme extreme, std::string const& when, Tongue const& tongue) {
    std::vector<std::string> const& names = miss.names;
    Said const first{names.empty() ? std::string() : names.front(), true};
    Said const second{names.size() < 2 ? std::string() : names[1], true};
    auto const amount = [&](int digits) {
        return Said{fmt::format("{} {}", tongue.number(miss.by, digits), unitOf(miss.lack))};
    };
    switch (miss.lack) {
    case Lack::distance: {
        Said const by{tongue.distance(miss.by)};
        if (names.size() < 2) {
            return tongue.mix(extreme == Extreme::nearest ? "{} was {} short of where it should be"
                                                          : "{} was {} away from where it should be",
                              {first, by}) +
                   when;
        }
        return (extreme == Extreme::nearest ? tongue.mix("{} came within {} of {}", {first, by, second})
                                            : tongue.mix("{} was {} away from {}", {first, by, second})) +
               when;
    }
    case Lack::gap:
        return tongue.mix("no current flowed through {}: {}", {first, {gapsText(miss, tongue)}}) + when;
    case Lack::power:
        return tongue.mix("{} lacked {}", {first, amount(3)}) + when;
    case Lack::force:
        return tongue.mix("{} pulled {} with {} less than its weight", {first, second, amount(2)}) + when;
    case Lack::lift:
        return tongue.mix(names.size() > 2
                              ? "{} would have lifted {} there with {} less than the weight of it "
                                "and all that is tied to it or lies on it"
                              : "{} would have lifted {} there with {} less than its weight",
                          {first, second, amount(0)}) +
               when;
    case Lack::torque:
        return tongue.mix("the load turned {} with {} more than {} righted it", {second, amount(0), first}) +
               when;
    case Lack::count:
        return tongue.mix("the number was wrong by {}", {{tongue.number(miss.by, 0)}}) + when;
    case Lack::ways: {
        bool const one = miss.by < 1.5;
        Said const ways{tongue.number(miss.by, 0)};
        return (one ? tongue.mix("current still flowed through {}: one connection held it", {first})
                    : tongue.mix("current still flowed through {}: at least {} connections held it",
                                 {first, ways})) +
               when;
    }
    case Lack::time:
        return tongue.mix("it held, but for {} less than it should", {amount(2)}) + when;
    case Lack::steps:
    case Lack::change:
        return otherWayText(names.empty() ? std::nullopt : std::optional(first), extreme, when, tongue);
    case Lack::nothing:
        break;
    }
    return tongue.fill("it was met", {}) + when;
}

nlohmann::ordered_json missJson(Miss const& miss, Tongue const& tongue) {
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
        nlohmann::ordered_json one = missJson(other, tongue);
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
void addSentences(Miss const& miss, Extreme extreme, std::uint64_t told, Tongue const& tongue,
                  std::vector<std::string>& sentences) {
    bool const later = miss.frame != 0 && miss.frame != told;
    std::string const when = later ? tongue.fill(", at {} s", {secondsOf(miss.frame, tongue)}) : "";
    Extreme const now = isOfItsMoment(miss) ? Extreme::none : extreme;
    Extreme const here = later ? Extreme::farthest : now;
    sentences.push_back(capitalised(sentenceOf(miss, here, when, tongue)) + ".");
    for (Miss const& other : miss.besides) {
        Extreme const there = here == Extreme::nearest ? here : Extreme::none;
        addSentences(other, there, later ? miss.frame : told, tongue, sentences);
    }
}

} // namespace

std::vector<std::string> sentencesOf(Miss const& miss, Tongue const& tongue) {
    std::string const when = tongue.fill(", at {} s", {secondsOf(miss.frame, tongue)});
    bool const oneOfSeveral = miss.child != Miss::noChild;
    Extreme const extreme = oneOfSeveral && isOfItsMoment(miss) ? Extreme::none : Extreme::nearest;
    std::vector<std::string> sentences{capitalised(sentenceOf(miss, extreme, when, tongue)) + "."};
    for (Miss const& other : miss.besides) {
        addSentences(other, Extreme::nearest, miss.frame, tongue, sentences);
    }
    return sentences;
}

std::vector<std::string> sentencesOf(Answer const& answer, std::string const& goal, Tongue const& tongue) {
    if (!answer.happened) {
        std::vector<std::string> all{capitalised(tongue.fill("the goal “{}” was not met", {goal})) + "."};
        if (answer.nearest) {
            std::vector<std::string> const miss = sentencesOf(answer.nearest->nearest, tongue);
            all.insert(all.end(), miss.begin(), miss.end());
        }
        return all;
    }
    return Teller(answer, goal, tongue).sentences();
}

nlohmann::ordered_json toJson(Answer const& answer, std::string const& asked, std::string const& goal,
                              Tongue const& tongue) {
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
                         {"text", clausesOf(one.step, answer.facts, goal, tongue).main}});
    }
    nlohmann::ordered_json made{
        {"asked", asked},
        {"happened", answer.happened},
        {"answer", fmt::format("{}", fmt::join(sentencesOf(answer, goal, tongue), " "))},
        {"confirmed", answer.confirmed},
        {"chain", chain},
        {"dropped", answer.dropped},
        {"runs", answer.runs}};
    if (answer.nearest) {
        made["nearest_miss"] = missJson(answer.nearest->nearest, tongue);
    }
    return made;
}

} // namespace trembler::insight
