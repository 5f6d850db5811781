// The card that says why something happened in the player's run, or how nearly a goal was met.
#pragma once

#include "game/ui/play/why/inquiry.hpp"
#include "game/ui/shared/answer_language.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/layout.hpp"
#include "insight/timeline/marks.hpp"
#include "insight/why/words/words.hpp"
#include "puzzle/session/session.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

class LevelText;

/// Asks about the session's run as the player did it, or, while building, about the last run, and shows the
/// answer. Never changes the session. Window thread only.
class WhyPanel {
public:
    /// `session` and `said` must outlive it; for the others see Inquiry.
    WhyPanel(Registry const& registry, PartLibrary const& parts, std::shared_ptr<GameData const> data,
             Session const& session, LevelText const& said);

    // Asking. Does nothing if there is no run.
    /// Whether there is a run to ask about.
    [[nodiscard]] bool canAsk() const;
    /// Why a goal was met, or why not so far; by its id.
    void askGoal(std::string const& id);
    /// The goal after the one that was asked about last; at first the one that was not met, or else the last.
    void askNextGoal();
    /// The last event of an object up to that frame, by the object's name.
    void askObject(std::string const& name, std::uint64_t frame);
    void askMark(insight::Mark const& mark);
    /// The run is about to end; it can still be asked about.
    void runEnds();
    /// Waits for the answer, for tests.
    void wait() const { inquiry_.wait(); }

    // The card.
    [[nodiscard]] bool open() const { return open_; }
    void close();
    /// Ends a running question with its results so far; else closes the card.
    void stopOrClose();
    /// Whether the next picture may show something new without any input.
    [[nodiscard]] bool busy() const { return inquiry_.busy(); }
    /// See Inquiry::working().
    [[nodiscard]] bool working() { return inquiry_.working(); }
    /// Once per picture.
    void pass();
    /// Draws the card between Gui::beginFrame and endFrame; see Inspector::draw. Returns the moment that the
    /// player wants to see.
    [[nodiscard]] std::optional<std::uint64_t> draw(Layout& layout, SidePlace const& place);

    // The answer.
    /// nullptr: there is none.
    [[nodiscard]] insight::Answer const* answer() const { return answer_ ? &*answer_ : nullptr; }
    /// Whether nothing that can be explained has happened to the object or goal in question.
    [[nodiscard]] bool nothing() const { return nothing_; }
    /// The text of the card: each step of the chain, or the nearest miss.
    [[nodiscard]] std::vector<std::string> lines() const;
    /// The index of the step that is looked at, among the steps of lines(); a miss is step 0.
    [[nodiscard]] std::optional<std::size_t> step() const { return step_; }
    /// Looks at the next step, or the one before, around the ends, and returns its moment; nothing without an
    /// answer.
    std::optional<std::uint64_t> goToStep(bool next);

private:
    struct Subject {
        std::string goal;   ///< its id
        std::string object; ///< its name
        std::optional<insight::Mark> mark;
    };
    void ask(insight::Question question, Subject subject);
    [[nodiscard]] std::optional<RunAsked> runNow() const;
    /// Since the last run.
    [[nodiscard]] bool placedOtherwise() const;
    [[nodiscard]] std::string goalText(std::string const& id) const;
    [[nodiscard]] std::string subjectText() const;
    [[nodiscard]] std::size_t steps() const;
    [[nodiscard]] std::uint64_t frameOf(std::size_t step) const;
    void drawHead(Layout& layout, float& used);
    void drawWaiting(Layout& layout);
    [[nodiscard]] std::optional<std::uint64_t> drawSteps(Layout& layout);
    void drawNotes() const;

    Session const& session_;
    LevelText const& said_;
    Inquiry inquiry_;
    std::optional<RunAsked> last_; // the run that has ended
    std::string whyNot_;           // it cannot be repeated, in English
    bool open_ = false;
    Subject subject_;
    std::optional<insight::Answer> answer_;
    bool nothing_ = false;
    std::string fault_;
    std::optional<std::size_t> step_;
    bool toStep_ = false; // the list is to show it
};

} // namespace trembler::ui
