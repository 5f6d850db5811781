#include "game/ui/edit/study/study_words.hpp"

#include "game/ui/shared/texts.hpp"

#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <set>
#include <string_view>

namespace trembler::ui::words {
namespace {

/// The text after a word and a blank; nothing if the text begins otherwise.
std::optional<std::string> behind(std::string const& text, std::string_view word) {
    if (text.size() > word.size() + 1 && text.starts_with(word) && text[word.size()] == ' ') {
        return text.substr(word.size() + 1);
    }
    return std::nullopt;
}

/// "cut lamp, battery plus": both ends.
std::string withEnds(char const* words, std::string const& ends) {
    std::size_t const comma = ends.find(", ");
    std::string const second = comma == std::string::npos ? std::string() : ends.substr(comma + 2);
    return filledIn(words, shownName(ends.substr(0, comma)), shownName(second));
}

} // namespace

std::string shownMaking(PartCatalog const& parts, std::string const& making) {
    if (making == "grab") {
        return deedGrab;
    }
    if (making == "cut") {
        return deedCut;
    }
    if (making == "remove") {
        return deedRemove;
    }
    if (making == "wire") {
        return deedWire;
    }
    if (auto const object = behind(making, "grab")) {
        return filledIn(grabText, shownName(*object));
    }
    if (auto const object = behind(making, "remove")) {
        return filledIn(removeText, shownName(*object));
    }
    if (auto const ends = behind(making, "cut")) {
        return withEnds(cutText, *ends);
    }
    if (auto const ends = behind(making, "wire")) {
        return withEnds(wireText, *ends);
    }
    return parts.titleOf(making);
}

std::string shownMakings(PartCatalog const& parts, std::vector<std::string> const& makings) {
    std::vector<std::string> shown;
    for (std::string const& making : makings) {
        shown.push_back(shownMaking(parts, making));
    }
    return fmt::format("{}", fmt::join(shown, ", "));
}

std::string shownMeans(PartCatalog const& parts, insight::CauseGraph const& graph) {
    std::vector<std::string> means(graph.parts.begin(), graph.parts.end());
    means.insert(means.end(), graph.deeds.begin(), graph.deeds.end());
    return means.empty() ? std::string(nothingPlaced) : shownMakings(parts, means);
}

std::string shownCauses(insight::CauseGraph const& graph) {
    std::set<std::string> interactions; // as in insight::inWords()
    for (auto const& [cause, effect] : graph.links) {
        for (std::string const& title : {cause, effect}) {
            if (title.find("<-") != std::string::npos) {
                interactions.insert(translated(title));
            }
        }
    }
    return fmt::format("{}", fmt::join(interactions, ", "));
}

std::string shownSide(PartCatalog const& parts, insight::GraphSide const& side) {
    std::vector<std::string> shown;
    for (std::string const& part : side.parts) {
        shown.push_back(shownMaking(parts, part));
    }
    for (std::string const& deed : side.deeds) {
        shown.push_back(shownMaking(parts, deed));
    }
    for (auto const& [cause, effect] : side.links) {
        shown.push_back(filledIn(leadsToText, translated(cause), translated(effect)));
    }
    return fmt::format("{}", fmt::join(shown, ", "));
}

std::string shownRobustness(insight::SolutionReport const& solution, insight::Jitter const& jitter) {
    auto const number = [](double value) { return localNumber(fmt::format("{:g}", value)); };
    std::string const distance = number(100 * jitter.distance);
    std::string const seconds = number(jitter.seconds);
    insight::Robustness const& found = solution.robustness;
    if (!solution.hasDeeds) {
        return filledIn(robustText, distance, number(jitter.angle), found.solved, found.runs);
    }
    return solution.hasParts
               ? filledIn(robustBothText, distance, number(jitter.angle), seconds, found.solved, found.runs)
               : filledIn(robustDeedsText, seconds, distance, found.solved, found.runs);
}

std::string shownStep(std::string const& step, insight::WorkDone const& done) {
    std::string shown = translated(step);
    if (done.of > 0) {
        shown += ": " + filledIn(countedText, done.done, done.of);
    }
    return shown;
}

ShownShortcoming shownShortcoming(PartCatalog const& parts, insight::Shortcoming const& one) {
    using Kind = insight::Shortcoming::Kind;
    auto const percent = std::lround(100 * one.share);
    switch (one.kind) {
    case Kind::solvesItself:
        return {solvesItself, solvesItselfHelp};
    case Kind::fewKinds:
        return one.kinds == 0 ? ShownShortcoming{noKind, noKindHelp} : ShownShortcoming{oneKind, oneKindHelp};
    case Kind::fails:
        return {filledIn(failsText, one.name), failsHelp};
    case Kind::fragile:
        return {filledIn(fragileText, one.name, percent), fragileHelp};
    case Kind::lucky:
        break;
    }
    return {filledIn(luckyText, parts.titleOf(one.name), percent), luckyHelp};
}

} // namespace trembler::ui::words
