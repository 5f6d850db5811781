// The problems of a level while it is edited: the same that verify finds before it runs the level.
#pragma once

#include "puzzle/edit/document/level_document.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

/// A problem and the thing in the level to be selected for it.
struct Problem {
    enum class About {
        level, ///< the file as a whole: title, texts, mods
        world,
        object,
        joint,
        connection,
        placing,
        tool,
        goal,
        task, ///< a condition of the demonstration's task
        hint,
        solution,
        ownPart, ///< a file of the author's own parts, whether the level uses it or not
    };
    Diagnostic diagnostic; ///< with its place in LevelDocument::text()
    About about = About::level;
    /// In the list of the section; for goals and the task, not used.
    std::optional<std::size_t> index;
    /// Of the object, the joint or the solution, if it has one; of a goal, its place as in
    /// commands/goals.hpp.
    std::string name;
    /// Of an object: the piece of it that the problem is about, as "pieces" of its entry states it; may be
    /// empty.
    std::string piece;
    /// The place inside the entry, as a JSON pointer: "/properties/mass". The property's key is its second
    /// token.
    std::string inside;

    /// In one line for a list, without the file: "no object 'bal' (did you mean 'ball'?); expected ..."
    [[nodiscard]] std::string words() const;
};

/// The problem of a diagnostic, with the entry of the level that its path refers to.
[[nodiscard]] Problem locateProblem(Json const& level, Diagnostic diagnostic);

/// Keeps the problems of a document up to date: those of the level, then those of the author's own parts,
/// which are found when the data are read. Everything is checked again after a change, by levelProblems() of
/// puzzle/checks/, so no change can be missed: a level of a hundred objects takes some milliseconds; call
/// refresh() when the author pauses for levels that take longer, see lastSeconds().
class LiveProblems {
public:
    /// Checks the document if it has changed since the last call; false if it has not. A read-only document
    /// has the faults with which it was opened. Never throws for faults of the level.
    bool refresh(LevelDocument const& document);
    [[nodiscard]] std::vector<Problem> const& all() const { return problems_; }
    [[nodiscard]] bool empty() const { return problems_.empty(); }
    /// Whether the level can be played: it can be read, its world can be built and its goals can be judged.
    [[nodiscard]] bool playable() const { return playable_; }
    /// How long the last check took, s. For deciding when to check, nothing else depends on it.
    [[nodiscard]] double lastSeconds() const { return lastSeconds_; }

private:
    std::optional<std::uint64_t> revision_;
    std::vector<Problem> problems_;
    bool readOnly_ = false;
    bool playable_ = false;
    double lastSeconds_ = 0;
};

} // namespace trembler::edit
