#include "measure/activation/report.hpp"

#include "runtime/notation/wrap_markdown.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler {
namespace {

double perFrame(std::uint64_t updatesInSecond) {
    return static_cast<double>(updatesInSecond) / static_cast<double>(framesPerSecond);
}

std::string solutionText(LevelUse const& play) {
    return play.solution.empty() ? "hands off" : play.solution;
}

std::size_t countOf(LevelUse const& play, Activity activity) {
    return static_cast<std::size_t>(
        std::count_if(play.components.begin(), play.components.end(),
                      [&](ComponentUse const& use) { return use.atEnd == activity; }));
}

// The first play of each level: these are the columns of the table of components.
std::vector<LevelUse const*> firstOfEach(std::vector<LevelUse> const& plays) {
    std::vector<LevelUse const*> first;
    for (LevelUse const& play : plays) {
        if (first.empty() || first.back()->level != play.level) {
            first.push_back(&play);
        }
    }
    return first;
}

std::string cell(ComponentUse const& use) {
    if (use.atEnd == Activity::absent) {
        return use.updates == 0 ? "" : fmt::format("{}, absent at the end", use.updates);
    }
    return use.atEnd == Activity::active ? fmt::format("**{}**", use.updates) : std::to_string(use.updates);
}

constexpr std::string_view intro = R"(# Only what a scene activates

A component is constructed only if objects in the scene activate it, and has a turn only if something that it reads has
changed. This page counts both, for every level in the repository:

    build/trembler components --levels --markdown >docs/measurements/activation.md

It holds no times: turns are the same on every machine. What a turn, a sleeping component and an absent one cost is
measured in [performance.md](performance.md). Tests check that what is absent here is never constructed, that sleeping
components have no turns, and that a level at rest does at most 5 % of what it does in motion (`Activation.*`).

)";

} // namespace

std::string activationText(std::vector<LevelUse> const& plays) {
    std::string text;
    for (LevelUse const& play : plays) {
        text += fmt::format("{}, {}: {} components of {}, {} asleep after {} frames\n"
                            "  updates per frame: {:.1f} in the busiest second, {:.1f} in the last{}\n",
                            play.level, solutionText(play), play.constructed(), play.components.size(),
                            countOf(play, Activity::asleep), play.frames, perFrame(play.busiestSecond),
                            perFrame(play.lastSecond), play.atRest ? ", at rest" : "");
        for (ComponentUse const& use : play.components) {
            if (use.atEnd != Activity::absent || use.updates > 0) {
                text += fmt::format("  {:<48} {:<7} {:>8} updates\n", title(*use.info), nameOf(use.atEnd),
                                    use.updates);
            }
        }
    }
    return text;
}

nlohmann::ordered_json activationJson(std::vector<LevelUse> const& plays) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (LevelUse const& play : plays) {
        nlohmann::ordered_json components = nlohmann::ordered_json::array();
        for (ComponentUse const& use : play.components) {
            components.push_back({{"component", title(*use.info)},
                                  {"state", nameOf(use.atEnd)},
                                  {"updates", use.updates},
                                  {"updates_in_last_second", use.updatesInLastSecond}});
        }
        all.push_back({{"level", play.level},
                       {"title", play.title},
                       {"solution", play.solution},
                       {"frames", play.frames},
                       {"at_rest", play.atRest},
                       {"busiest_second", play.busiestSecond},
                       {"last_second", play.lastSecond},
                       {"components", std::move(components)}});
    }
    nlohmann::ordered_json result;
    result["plays"] = std::move(all);
    return result;
}

std::string activationMarkdown(std::vector<LevelUse> const& plays) {
    std::string text(intro);
    if (plays.empty()) {
        return text;
    }
    std::uint64_t const seconds = plays.front().frames / framesPerSecond;
    text += fmt::format(
        "## Every level, every recorded play\n\nThe {} components after {} s, and the number of their turns "
        "in the busiest second and in the last. *At rest*: the world's state was the same, bit for "
        "bit, after every frame of the last second. The player's inputs in that second count, too.\n\n"
        "| level | play | absent | asleep | active | turns in the busiest second | in the last | |\n"
        "|---|---|---|---|---|---|---|---|\n",
        plays.front().components.size(), seconds);
    for (LevelUse const& play : plays) {
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", play.level, solutionText(play),
                            countOf(play, Activity::absent), countOf(play, Activity::asleep),
                            countOf(play, Activity::active), play.busiestSecond, play.lastSecond,
                            play.atRest ? "at rest" : "in motion");
    }
    std::vector<LevelUse const*> const first = firstOfEach(plays);
    text += fmt::format("\n## Component by component\n\nThe first play of each level: turns in {} frames; "
                        "**bold** if the component is active at the end, plain if it is asleep, nothing if "
                        "it is absent. Sound's components are constructed only if something listens: a "
                        "microphone in the level, or a loudspeaker, which none of these runs has.\n\n",
                        plays.front().frames);
    char number = 'A';
    for (LevelUse const* const play : first) {
        text += fmt::format("- {}: {}, *{}*, {}\n", number++, play->level, play->title, solutionText(*play));
    }
    text += "\n| component |";
    std::string rule = "|---|";
    for (std::size_t i = 0; i < first.size(); ++i) {
        text += fmt::format(" {} |", static_cast<char>('A' + static_cast<char>(i)));
        rule += "---|";
    }
    text += "\n" + rule + "\n";
    std::string never;
    for (std::size_t c = 0; c < plays.front().components.size(); ++c) {
        bool anywhere = false;
        std::string row = fmt::format("| {} |", title(*plays.front().components[c].info));
        for (LevelUse const* const play : first) {
            std::string const text0 = cell(play->components[c]);
            anywhere = anywhere || !text0.empty();
            row += text0.empty() ? " |" : fmt::format(" {} |", text0);
        }
        if (anywhere) {
            text += row + "\n";
        } else {
            never += (never.empty() ? "" : ", ") + title(*plays.front().components[c].info);
        }
    }
    text += fmt::format("\nIn none of these: {}.\n", never.empty() ? "none" : never);
    return wrapMarkdown(text);
}

} // namespace trembler
