// A level's texts for the player, in the language in use.
#pragma once

#include "puzzle/session/session.hpp"

#include <string>
#include <vector>

namespace trembler::ui {

/// The title, text, hints and goals of a session's level. The level itself stays as its file states it, so
/// the player may choose another language at any time. Window thread only; the session must outlive it.
class LevelText {
public:
    explicit LevelText(Session const& session) : session_(session) {}

    /// To be called when the session has another world: sentences about goals depend on where objects lie at
    /// the start.
    void newWorld();
    /// Follows the language in use. Once per picture.
    void follow();

    [[nodiscard]] std::string const& title() const { return title_; }
    [[nodiscard]] std::string const& text() const { return text_; }
    [[nodiscard]] std::vector<std::string> const& hints() const { return hints_; }
    /// In the order of GoalJudge::status().
    [[nodiscard]] std::vector<std::string> const& goals() const { return goals_; }

private:
    Session const& session_;
    std::string language_;
    std::string title_;
    std::string text_;
    std::vector<std::string> hints_;
    std::vector<std::string> goals_;
};

} // namespace trembler::ui
