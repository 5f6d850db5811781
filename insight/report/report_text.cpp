#include "insight/report/report_text.hpp"

#include "insight/why/words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace trembler::insight {
namespace {

std::string listed(std::vector<std::string> const& list) {
    return list.empty() ? "–" : fmt::format("{}", fmt::join(list, ", "));
}

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

/// In a table's cell.
std::string inCell(std::string const& text) {
    std::string cell;
    for (char const c : text) {
        cell += c == '|' ? std::string("\\|") : std::string(1, c);
    }
    return cell;
}

Drop const* luckiest(LevelReport const& report) {
    auto const most = std::max_element(report.drops.begin(), report.drops.end(),
                                       [](Drop const& a, Drop const& b) { return a.share() < b.share(); });
    return most == report.drops.end() || most->solved == 0 ? nullptr : &*most;
}

/// In percent; "–" if nothing in any solution could be displaced.
std::string leastRobust(LevelReport const& report) {
    std::optional<double> least;
    for (SolutionReport const& solution : report.solutions) {
        if (solution.expected && solution.needs.solves && solution.robustness.runs > 0) {
            least = std::min(least.value_or(1), solution.robustness.share());
        }
    }
    return least ? percent(*least) : "–";
}

/// The sentences of a chain, and whether each was confirmed.
std::string toldChain(LevelReport const& report, Answer const& answer) {
    return fmt::format("{}{}",
                       fmt::join(sentencesOf(answer, goalText(report, answer.goal), AnswerLanguage()), " "),
                       answer.confirmed ? "" : " (Traced, not confirmed in all steps.)");
}

/// "only with kind 2: ...; only with kind 1: ...".
std::string toldComparison(KindComparison const& one) {
    std::string text;
    for (auto const& [kind, side] :
         {std::pair(one.kind, &one.difference.here), {one.with, &one.difference.there}}) {
        if (side->size() > 0) {
            text += fmt::format("{}only with kind {}: {}", text.empty() ? "" : "; ", kind, inWords(*side));
        }
    }
    return text;
}

std::string tableRow(LevelReport const& report) {
    Drop const* const lucky = luckiest(report);
    auto const solving = std::count_if(report.solutions.begin(), report.solutions.end(),
                                       [](SolutionReport const& one) { return one.needs.solves; });
    std::string const faults =
        report.demonstration ? "a demonstration" : fmt::format("{}", fmt::join(shortcomings(report), "; "));
    return fmt::format(
        "| {} | {} | {} | {} | {} | {} |\n", inCell(report.level + (report.task ? " (task)" : "")), solving,
        report.kinds, leastRobust(report),
        lucky == nullptr ? "–" : fmt::format("{}, {}", inCell(lucky->part), percent(lucky->share())),
        inCell(faults));
}

/// Why each solution solves it, and how the kinds differ, as a list.
std::string chainList(LevelReport const& report) {
    std::string text;
    for (SolutionReport const& one : report.solutions) {
        for (Answer const& answer : one.chains) {
            text += fmt::format("- *{}*: {}\n", one.name, toldChain(report, answer));
        }
    }
    for (KindComparison const& one : report.comparisons) {
        text += fmt::format("- Kind {} differs from kind {}: {}.\n", one.kind, one.with, toldComparison(one));
    }
    return text.empty() ? text : "\n" + text;
}

/// "312, –497"
std::string toldEnds(std::vector<RunEnd> const& ends) {
    std::string text;
    for (RunEnd const& end : ends) {
        text += fmt::format("{}{}{}", text.empty() ? "" : ", ", end.solved ? "" : "–", end.frame);
    }
    return text;
}

std::string section(LevelReport const& report) {
    bool const displaced = std::any_of(report.solutions.begin(), report.solutions.end(),
                                       [](SolutionReport const& one) { return one.robustness.runs > 0; });
    std::string text = fmt::format("\n### {}\n\n", report.level);
    text += "| solution | kind | needs parts | needs deeds | needs effects | superfluous |";
    text += displaced ? " displaced runs that succeed |\n|---|---|---|---|---|---|---|\n"
                      : "\n|---|---|---|---|---|---|\n";
    for (SolutionReport const& one : report.solutions) {
        if (!one.needs.solves) {
            continue;
        }
        text += fmt::format("| {} | {}: {} | {} | {} | {} | {} |", inCell(one.name), one.kind,
                            inCell(inWords(one.graph)), inCell(listed(one.needs.parts)),
                            inCell(listed(one.needs.deeds)), inCell(listed(one.needs.effects)),
                            inCell(listed(one.needs.superfluous)));
        bool const none = one.robustness.runs == 0;
        text += !displaced ? "\n"
                : none     ? " – |\n"
                           : fmt::format(" {} of {} |\n", one.robustness.solved, one.robustness.runs);
    }
    text += chainList(report);
    for (SolutionReport const& one : report.solutions) {
        for (PlaceMap const& map : one.maps) {
            text += fmt::format(
                "\nWhere *{}* may lie in *{}*, in steps of {:.0f} cm ({} runs):\n\n```\n{}\n```\n", map.part,
                one.name, 100 * map.step, map.runs, fmt::join(map.rows, "\n"));
        }
    }
    if (report.search) {
        text += fmt::format("\nA search of {} runs solved it {} times:\n\n", report.search->runs,
                            report.search->solved);
        for (std::size_t i = 0; i < report.search->found.size(); ++i) {
            FoundSolution const& found = report.search->found[i];
            text += fmt::format("- run {}: {}{}\n", found.run, inWords(found.graph),
                                report.foundAs[i].empty() ? ", recorded by nobody"
                                                          : fmt::format(", as '{}'", report.foundAs[i]));
        }
    }
    return text;
}

/// The cheapest of the ways to compute an effect that keep all verdicts.
std::string cheapestWays(LevelReport const& report) {
    std::string text;
    std::vector<std::string> effects;
    for (WayToCompute const& way : report.ways) {
        std::string const what =
            way.effect + (way.level.find("substep") == std::string::npos ? "" : ", substeps");
        if (std::find(effects.begin(), effects.end(), what) == effects.end()) {
            effects.push_back(what);
        }
    }
    for (std::string const& what : effects) {
        WayToCompute const* best = nullptr;
        for (WayToCompute const& way : report.ways) {
            bool const substeps = way.level.find("substep") != std::string::npos;
            bool const mine = what == way.effect + (substeps ? ", substeps" : "");
            if (mine && way.keepsAll && (best == nullptr || way.microseconds < best->microseconds)) {
                best = &way;
            }
        }
        text += best == nullptr ? fmt::format("  {}: none keeps every verdict\n", what)
                                : fmt::format("  {}: {} ({:.1f} us a frame in all){}\n", what, best->level,
                                              best->microseconds, best->present ? ", as it is" : "");
    }
    return text;
}

} // namespace

std::string goalText(LevelReport const& report, std::string const& id) {
    auto const at = std::find_if(report.goals.begin(), report.goals.end(),
                                 [&](ReportedGoal const& goal) { return goal.id == id; });
    return at == report.goals.end() ? id : at->text;
}

std::string toMarkdownTable(std::vector<LevelReport> const& reports) {
    std::string text = "| level | solutions | kinds | least robust | luckiest single part | falls short |\n"
                       "|---|---|---|---|---|---|\n";
    for (LevelReport const& report : reports) {
        text += tableRow(report);
    }
    return text;
}

std::string toMarkdownSections(std::vector<LevelReport> const& reports) {
    std::string text;
    for (LevelReport const& report : reports) {
        text += section(report);
    }
    return text;
}

std::string toMarkdownRuns(std::vector<LevelReport> const& reports) {
    std::string text = "| level | displaced, or dropped alone | runs |\n|---|---|---|\n";
    for (LevelReport const& report : reports) {
        auto const row = [&](std::string const& what, std::vector<RunEnd> const& ends) {
            if (!ends.empty()) {
                text += fmt::format("| {} | {} | {} |\n", inCell(report.level), inCell(what), toldEnds(ends));
            }
        };
        for (SolutionReport const& one : report.solutions) {
            row(fmt::format("*{}*", one.name), one.robustness.ends);
        }
        for (Drop const& drop : report.drops) {
            row(drop.part + " alone", drop.ends);
        }
    }
    return text;
}

std::string toMarkdown(std::vector<LevelReport> const& reports) {
    return toMarkdownTable(reports) + toMarkdownSections(reports);
}

std::string toWords(LevelReport const& report) {
    std::string text = fmt::format("{}{}\n", report.level, report.complete ? "" : " (stopped: incomplete)");
    text +=
        fmt::format("  an empty toolbox {}\n", report.emptyToolboxSolves ? "solves it" : "does not solve it");
    for (SolutionReport const& one : report.solutions) {
        if (!one.needs.solves) {
            text += fmt::format("  '{}' does not solve it{}\n", one.name,
                                one.expected ? ", although it was recorded as a solution" : ", as recorded");
            continue;
        }
        text += fmt::format("  '{}', kind {}: {}\n    needs {}; effects {}; superfluous {}\n", one.name,
                            one.kind, inWords(one.graph), listed(one.needs.parts), listed(one.needs.effects),
                            listed(one.needs.superfluous));
        if (one.robustness.runs > 0) {
            text +=
                fmt::format("    displaced by up to {:.1f} cm, {:.1f} degrees and {:.2f} s it succeeds in {} "
                            "of {} runs\n",
                            100 * report.jitter.distance, report.jitter.angle, report.jitter.seconds,
                            one.robustness.solved, one.robustness.runs);
        }
        for (Answer const& answer : one.chains) {
            text += fmt::format("    why: {}\n", toldChain(report, answer));
        }
        for (PlaceMap const& map : one.maps) {
            text += fmt::format("    where {} may lie, in steps of {:.0f} cm ({} runs):\n", map.part,
                                100 * map.step, map.runs);
            for (std::string const& row : map.rows) {
                text += "      " + row + "\n";
            }
        }
    }
    for (KindComparison const& one : report.comparisons) {
        text += fmt::format("  kind {} differs from kind {}: {}\n", one.kind, one.with, toldComparison(one));
    }
    for (Drop const& drop : report.drops) {
        if (drop.solved > 0) {
            text += fmt::format("  {} alone, dropped at random, solves it in {} of {} runs\n", drop.part,
                                drop.solved, drop.runs);
        }
    }
    if (!report.costs.empty()) {
        double all = 0;
        text += "  cost per frame:";
        for (EffectCost const& cost : report.costs) {
            text += fmt::format(" {} {:.1f} us", cost.effect, cost.microseconds);
            all += cost.microseconds;
        }
        text += fmt::format("; {:.1f} us in all\n", all);
    }
    if (!report.ways.empty()) {
        text += "  the cheapest that keeps every verdict:\n" + cheapestWays(report);
    }
    if (report.search) {
        for (std::size_t i = 0; i < report.search->found.size(); ++i) {
            text += fmt::format("  found in run {}: {}{}\n", report.search->found[i].run,
                                inWords(report.search->found[i].graph),
                                report.foundAs[i].empty() ? "" : fmt::format(", as '{}'", report.foundAs[i]));
        }
    }
    for (std::string const& fault : shortcomings(report)) {
        text += fmt::format("  falls short: {}\n", fault);
    }
    return text;
}

} // namespace trembler::insight
