#include "measure/accuracy/report.hpp"

#include "runtime/notation/wrap_markdown.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace trembler::accuracy {

std::string errorText(double error) {
    if (!std::isfinite(error)) {
        return "no bound";
    }
    if (error == 0) {
        return "0";
    }
    return error < 1e-3 ? fmt::format("{:.1e}", error) : fmt::format("{:.3g}", error);
}

std::string timeText(double microseconds) {
    return microseconds >= 100 ? fmt::format("{:.0f}", microseconds) : fmt::format("{:.3g}", microseconds);
}

std::string slugOf(Ladder const& ladder) {
    std::string slug = "accuracy-";
    for (char const c : ladder.effect + " " + ladder.scene) {
        bool const plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (plain) {
            slug += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else if (slug.back() != '-') {
            slug += '-';
        }
    }
    return slug;
}

namespace {

std::string capitalised(std::string text) {
    text.at(0) = static_cast<char>(std::toupper(static_cast<unsigned char>(text.at(0))));
    return text;
}

std::string placeText(Ladder const& ladder, Rung const& rung) {
    if (!ladder.rivals) {
        return "";
    }
    return rung.onFront ? "front" : "beaten by " + rung.beatenBy;
}

// The phenomena that none of a ladder's levels can represent, if they are the same for all, so that they are
// reported once; otherwise "".
std::string cannotRepresentOfAll(Ladder const& ladder) {
    if (ladder.rungs.empty()) {
        return "";
    }
    std::string const& first = ladder.rungs.front().cannotRepresent;
    bool const same = std::all_of(ladder.rungs.begin(), ladder.rungs.end(),
                                  [&](Rung const& rung) { return rung.cannotRepresent == first; });
    return same ? first : "";
}

constexpr std::string_view intro = R"(# Accuracy and its cost

Every effect has detail levels that offer the same properties, so that a level, the command line (`--detail`) or the
running game can swap one for another. This page lists the error and the time of each:

    build/trembler accuracy --runs 5 --markdown --plot docs/pictures/accuracy >docs/measurements/accuracy.md

A *ladder* is one effect in one scene. Its error is measured against something that is independent of the level: a
closed form, a sum over everything in more digits, or the level that has converged. Its time is the median over the
frames, in µs, of all components of the effect, on one thread, and the least of five runs, as other load of the machine
can only add to it. Errors are the same on every machine (the simulation is deterministic); times belong to the machine
that this was made on and are good for comparing within a table.

*Front* marks the levels on the Pareto front: no other level of the table is faster and at least as accurate. Any
other level has no use in that scene, and the text below the table explains why it exists; times within 5 % count as
equal. Tables without that column offer no choice between levels; they show the influence of one parameter on the error.

)";

void addCell(std::string& into, std::string const& text) {
    into += " ";
    for (char const c : text) {
        into += c == '|' ? std::string("\\|") : std::string(1, c);
    }
    into += " |";
}

} // namespace

std::string asText(std::vector<Ladder> const& ladders) {
    std::string text;
    for (Ladder const& ladder : ladders) {
        text += fmt::format("{}: {}\n  error: {} ({})\n  against: {}\n", ladder.effect, ladder.scene,
                            ladder.error, ladder.unit, ladder.reference);
        std::size_t widest = 5;
        for (Rung const& rung : ladder.rungs) {
            widest = std::max(widest, rung.level.size());
        }
        text += fmt::format("  {:<{}}  {:>10}  {:>10}\n", "level", widest, "us/frame", "error");
        for (Rung const& rung : ladder.rungs) {
            text += fmt::format("  {:<{}}  {:>10}  {:>10}  {}\n", rung.level, widest,
                                timeText(rung.microseconds), errorText(rung.error), placeText(ladder, rung));
        }
        std::string last;
        for (Rung const& rung : ladder.rungs) {
            if (!rung.cannotRepresent.empty() && rung.cannotRepresent != last) {
                text += fmt::format("  {} cannot represent {}\n", rung.level, rung.cannotRepresent);
                last = rung.cannotRepresent;
            }
        }
        text += "\n";
    }
    return text;
}

nlohmann::ordered_json asJson(std::vector<Ladder> const& ladders) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (Ladder const& ladder : ladders) {
        nlohmann::ordered_json levels = nlohmann::ordered_json::array();
        for (Rung const& rung : ladder.rungs) {
            nlohmann::ordered_json error; // null if unbounded: JSON has no infinity
            if (std::isfinite(rung.error)) {
                error = rung.error;
            }
            levels.push_back({{"level", rung.level},
                              {"us_per_frame", rung.microseconds},
                              {"error", error},
                              {"front", rung.onFront},
                              {"beaten_by", rung.beatenBy},
                              {"cannot_tell", rung.cannotRepresent}});
        }
        all.push_back({{"effect", ladder.effect},
                       {"scene", ladder.scene},
                       {"unit", ladder.unit},
                       {"error", ladder.error},
                       {"reference", ladder.reference},
                       {"rivals", ladder.rivals},
                       {"remark", ladder.remark},
                       {"levels", std::move(levels)}});
    }
    nlohmann::ordered_json result;
    result["ladders"] = std::move(all);
    return result;
}

std::string asMarkdown(std::vector<Ladder> const& ladders, std::string const& pictures) {
    std::string text(intro);
    std::string effect;
    for (Ladder const& ladder : ladders) {
        if (ladder.effect != effect) {
            effect = ladder.effect;
            text += fmt::format("## {}\n\n", capitalised(effect));
        }
        text += fmt::format("### {}\n\nError: {}. Reference: {}.\n\n", capitalised(ladder.scene),
                            ladder.error, ladder.reference);
        std::string const common = cannotRepresentOfAll(ladder);
        std::string heading = fmt::format("| level | µs per frame | error ({}) |", ladder.unit);
        std::string rule = "|---|---|---|";
        if (ladder.rivals) {
            heading += " |";
            rule += "---|";
        }
        if (common.empty()) {
            heading += " what it cannot represent |";
            rule += "---|";
        }
        text += heading + "\n" + rule + "\n";
        for (Rung const& rung : ladder.rungs) {
            text += "|";
            addCell(text, rung.level);
            addCell(text, timeText(rung.microseconds));
            addCell(text, errorText(rung.error));
            if (ladder.rivals) {
                addCell(text, placeText(ladder, rung));
            }
            if (common.empty()) {
                addCell(text, rung.cannotRepresent);
            }
            text += "\n";
        }
        text += "\n";
        if (!common.empty()) {
            text += "None of them can represent " + common + ".\n\n";
        }
        if (!ladder.remark.empty()) {
            text += ladder.remark + "\n\n";
        }
        if (!pictures.empty()) {
            text += fmt::format("![Error over time per frame: {}, {}]({}/{}.svg)\n\n", ladder.effect,
                                ladder.scene, pictures, slugOf(ladder));
        }
    }
    if (!text.empty()) {
        text.pop_back();
    }
    return wrapMarkdown(text);
}

} // namespace trembler::accuracy
