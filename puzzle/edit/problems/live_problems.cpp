#include "puzzle/edit/problems/live_problems.hpp"

#include "puzzle/checks/level_checks.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "puzzle/goals/reading/condition_outline.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <chrono>

namespace trembler::edit {
namespace {

struct Section {
    std::string_view key;
    Problem::About about;
};

constexpr std::array<Section, 8> sections{{{"world", Problem::About::world},
                                           {"objects", Problem::About::object},
                                           {"joints", Problem::About::joint},
                                           {"connections", Problem::About::connection},
                                           {"placing", Problem::About::placing},
                                           {"toolbox", Problem::About::tool},
                                           {"hints", Problem::About::hint},
                                           {"solutions", Problem::About::solution}}};

/// Splits the first token off a JSON pointer.
std::string_view takeToken(std::string_view& pointer) {
    if (!pointer.starts_with('/')) {
        return {};
    }
    std::size_t const end = pointer.find('/', 1);
    std::string_view const token = pointer.substr(1, end == std::string_view::npos ? end : end - 1);
    pointer = end == std::string_view::npos ? std::string_view() : pointer.substr(end);
    return token;
}

/// The characters that a token of a JSON pointer represents.
std::string unescaped(std::string_view token) {
    return token.empty() ? std::string() : Json::json_pointer("/" + std::string(token)).back();
}

} // namespace

std::string Problem::words() const {
    return diagnostic.expected.empty()
               ? diagnostic.message
               : fmt::format("{}; expected {}", diagnostic.message, diagnostic.expected);
}

Problem locateProblem(Json const& level, Diagnostic diagnostic) {
    Problem problem;
    problem.diagnostic = std::move(diagnostic);
    std::string_view rest = problem.diagnostic.path;
    std::string_view const key = takeToken(rest);
    if (key == "goals" || key == "task") {
        problem.about = key == "goals" ? Problem::About::goal : Problem::About::task;
        auto const goals = level.is_object() ? level.find(std::string(key)) : level.end();
        problem.name = goals == level.end() ? "" : conditionAround(*goals, std::string(rest));
        problem.inside = rest.substr(problem.name.size());
        return problem;
    }
    for (Section const& section : sections) {
        if (section.key != key) {
            continue;
        }
        problem.about = section.about;
        if (section.about == Problem::About::world) {
            problem.inside = rest;
            return problem;
        }
        std::string_view const token = takeToken(rest);
        std::size_t index = 0;
        auto const [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
        Json const* const list = findList(level, section.key.data());
        if (error == std::errc() && end == token.data() + token.size() && list != nullptr &&
            index < list->size()) {
            problem.index = index;
            problem.name = textOf((*list)[index], "name");
            problem.inside = rest;
            if (section.about == Problem::About::object && takeToken(rest) == "pieces") {
                problem.piece = unescaped(takeToken(rest));
            }
        }
    }
    return problem;
}

bool LiveProblems::refresh(LevelDocument const& document) {
    if (revision_ == document.revision() && readOnly_ == document.readOnly()) {
        return false;
    }
    auto const begun = std::chrono::steady_clock::now();
    revision_ = document.revision();
    readOnly_ = document.readOnly();
    std::vector<Diagnostic> found;
    playable_ = false;
    if (document.readOnly()) {
        found = document.faults();
    } else {
        try {
            LevelCheckup checkup = checkWholeLevel(document.data(), document.json());
            found = std::move(checkup.problems);
            found.insert(found.end(), checkup.lacking.begin(), checkup.lacking.end());
            playable_ = checkup.playable;
        } catch (InputError const& error) {
            found = error.diagnostics();
        }
    }
    problems_.clear();
    std::string const file = document.path().empty() ? "new level" : document.path().string();
    for (Diagnostic& diagnostic : found) {
        bool const here = diagnostic.file == file; // else it is in the definition of a part
        problems_.push_back(here ? locateProblem(document.tree(), std::move(diagnostic)) : Problem{});
        if (!here) {
            problems_.back().diagnostic = std::move(diagnostic);
        }
    }
    for (Diagnostic const& fault : document.data().ownPartFaults) {
        Problem& problem = problems_.emplace_back();
        problem.diagnostic = fault;
        problem.about = Problem::About::ownPart;
        problem.name = std::filesystem::path(fault.file).filename().string();
    }
    lastSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return true;
}

} // namespace trembler::edit
