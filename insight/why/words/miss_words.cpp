#include "insight/why/words/miss_words.hpp"

#include "runtime/component/component.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace trembler::insight {
namespace {

/// ", at 3.2 s"; ", at the start" of what that would round to no time.
std::string momentText(std::uint64_t frame, AnswerLanguage const& language) {
    double const seconds = static_cast<double>(frame) * frameDuration;
    return seconds < 0.05 ? language.fill(", at the start", {})
                          : language.fill(", at {} s", {language.number(seconds, 1)});
}

std::string gapText(CircuitGap const& gap, AnswerLanguage const& language) {
    return language.mix("of {} between {} and {}",
                        {{language.distance(gap.width)}, {gap.nameA, true}, {gap.nameB, true}});
}

/// The reason of a gap that no touch would close.
std::string reasonText(CircuitGap const& gap, AnswerLanguage const& language) {
    Said const by{gap.nameBy, true};
    switch (gap.reason) {
    case GapReason::slow:
        return language.mix("{} turned at {} degrees a second, and needs {}",
                            {by, {language.number(gap.is, 0)}, {language.number(gap.needed, 0)}});
    case GapReason::quiet:
        return language.mix("{} heard less than the {} dB that it needs",
                            {by, {language.number(gap.needed, 0)}});
    case GapReason::blown:
        return language.mix("{} had blown", {by});
    case GapReason::foreign:
        return language.mix("no current of another source passes from {} to {}",
                            {{gap.nameA, true}, {gap.nameB, true}});
    case GapReason::cut:
        return language.mix("the wire between {} and {} had been cut",
                            {{gap.nameA, true}, {gap.nameB, true}});
    case GapReason::apart:
        break;
    }
    return {};
}

/// Where the gaps are: "the circuit has a gap of 4 cm between the left contact and the right contact"; and
/// what else keeps it open, each once.
std::string gapsText(Miss const& miss, AnswerLanguage const& language) {
    std::string const comma = ", " + language.fill("and", {}) + " ";
    std::vector<std::string> apart;
    std::vector<std::string> texts;
    for (CircuitGap const& gap : miss.gaps) {
        if (gap.reason == GapReason::apart) {
            apart.push_back(gapText(gap, language));
        } else if (std::string text = reasonText(gap, language);
                   std::find(texts.begin(), texts.end(), text) == texts.end()) {
            texts.push_back(std::move(text));
        }
    }
    if (!apart.empty()) {
        texts.insert(texts.begin(),
                     language.fill(apart.size() == 1 ? "the circuit has a gap {}" : "the circuit has gaps {}",
                                   {fmt::format("{}", fmt::join(apart, comma))}));
    }
    return language.afterColon(fmt::format("{}", fmt::join(texts, comma)));
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

/// The connections that hold a current: the only one, or their number and each of them if they are few.
std::string waysText(Miss const& miss, Said const& object, AnswerLanguage const& language) {
    constexpr std::size_t few = 3;
    std::vector<std::string> texts;
    for (CurrentWay const& way : miss.ways) {
        texts.push_back(language.mix("between {} and {}", {{way.nameA, true}, {way.nameB, true}}));
    }
    if (texts.size() == 1) {
        return language.mix("current still flowed through {}: the connection {} held it",
                            {object, {texts.front()}});
    }
    std::string text = language.mix("current still flowed through {}: at least {} connections held it",
                                    {object, {language.number(miss.by, 0)}});
    if (!texts.empty() && texts.size() <= few) {
        std::string const comma = ", " + language.fill("and", {}) + " ";
        text += ", " + fmt::format("{}", fmt::join(texts, comma));
    }
    return text;
}

/// Newtons as people would round them.
int forceDigits(double newtons) {
    return newtons >= 99.5 ? 0 : newtons >= 9.95 ? 1 : 2;
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
    case Lack::source:
        return language.mix("no current flowed through {}: it has no source within reach", {first}) + when;
    case Lack::power:
        return language.mix("{} lacked {}", {first, amount(3)}) + when;
    case Lack::force:
        return language.mix("{} pulled {} with {} less than its weight",
                            {first, second, amount(forceDigits(miss.by))}) +
               when;
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
        return language.fill(miss.tooMany ? "there were {} too many" : "there were {} too few",
                             {language.number(miss.by, 0)}) +
               when;
    case Lack::ways:
        return waysText(miss, first, language) + when;
    case Lack::held:
        return language.mix("{} still held {} back", {first, second}) + when;
    case Lack::blocked:
        return language.mix("{} stood in the way of {}", {first, second}) + when;
    case Lack::unpushed:
        return language.mix("nothing pushed {}: a push of {} would have closed the contact there",
                            {first, amount(forceDigits(miss.by))}) +
               when;
    case Lack::push:
        return language.mix("{} was pushed too weakly: {} more would have closed the contact there",
                            {first, amount(forceDigits(miss.by))}) +
               when;
    case Lack::grab:
        return language.mix("you took hold of {}", {first}) + when;
    case Lack::cut:
        return language.mix("you cut the wire between {} and {}", {first, second}) + when;
    case Lack::removal:
        return language.mix("you removed {}", {first}) + when;
    case Lack::absent:
        return language.mix("there was nothing that {} could have touched", {first}) + when;
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

/// What the run without the obstacle showed about the goal.
std::string otherwiseText(Miss const& miss, AnswerLanguage const& language) {
    bool const met = miss.ifClosed == IfClosed::met;
    if (miss.lack == Lack::blocked && !miss.names.empty()) {
        return language.mix(met ? "without {}, the goal would have been met"
                                : "without {}, the run would have come nearer to the goal",
                            {{miss.names.front(), true}});
    }
    bool const deed = miss.lack == Lack::grab || miss.lack == Lack::cut || miss.lack == Lack::removal;
    if (deed) {
        return language.fill(met ? "without that, the goal would have been met"
                                 : "without that, the run would have come nearer to the goal",
                             {});
    }
    if (miss.lack == Lack::unpushed || miss.lack == Lack::push) {
        return language.fill(met ? "pushed so, the goal would have been met"
                                 : "pushed so, the run would have come nearer to the goal",
                             {});
    }
    return language.fill(met ? "with this circuit closed, the goal would have been met"
                             : "with this circuit closed, the run would have come nearer to the goal",
                         {});
}

/// A sentence for the miss and for each of what stood in the way besides; with a moment, if it is another:
/// then it is of what had held (see Aftermath).
void addSentences(Miss const& miss, Extreme extreme, std::uint64_t named, AnswerLanguage const& language,
                  std::vector<std::string>& sentences) {
    bool const later = miss.frame != 0 && miss.frame != named;
    std::string const when = later ? momentText(miss.frame, language) : "";
    Extreme const now = isOfItsMoment(miss) ? Extreme::none : extreme;
    Extreme const here = later ? Extreme::farthest : now;
    sentences.push_back(capitalised(sentenceOf(miss, here, when, language)) + ".");
    if (miss.ifClosed != IfClosed::unknown) {
        sentences.push_back(capitalised(otherwiseText(miss, language)) + ".");
    }
    for (Miss const& other : miss.besides) {
        Extreme const there = here == Extreme::nearest ? here : Extreme::none;
        addSentences(other, there, later ? miss.frame : named, language, sentences);
    }
}

} // namespace

std::vector<std::string> sentencesOf(Miss const& miss, AnswerLanguage const& language) {
    std::string const when = momentText(miss.frame, language);
    bool const oneOfSeveral = miss.child != Miss::noChild;
    Extreme const extreme = oneOfSeveral && isOfItsMoment(miss) ? Extreme::none : Extreme::nearest;
    std::vector<std::string> sentences{capitalised(sentenceOf(miss, extreme, when, language)) + "."};
    for (Miss const& other : miss.besides) {
        addSentences(other, Extreme::nearest, miss.frame, language, sentences);
    }
    return sentences;
}

} // namespace trembler::insight
