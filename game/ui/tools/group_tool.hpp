// Several placed parts at once: choosing them, and moving, turning, copying and putting them back together.
#pragma once

#include "game/ui/tools/placing_tool.hpp"

#include <optional>
#include <span>
#include <vector>

namespace trembler::ui {

/// Holds the choice as long as it has at least two parts; a single one is the placing tool's selection. Every
/// edit is one step of undo. Window thread only.
class GroupTool {
public:
    /// All must outlive this.
    GroupTool(Session& session, PlacingTool& placing, render::Toasts& toasts)
        : session_(session), placing_(placing), toasts_(toasts) {}

    /// Handles one picture's mouse input, before the placing tool does. `hovered` is the placed part under
    /// the mouse. True if the mouse belongs to the group in this picture, so that it means nothing else.
    [[nodiscard]] bool update(Pointer const& pointer, std::optional<int> hovered);
    void chooseAll();
    /// Adds a part to the choice, or takes it out of it.
    void toggle(int number) { toggle(number, placing_.selected()); }
    /// Turns the parts by `steps` anticlockwise about their centre.
    void turn(int steps, bool fine);
    /// Mirrors the group from left to right.
    void flip();
    void nudge(Vec2 steps, bool fine);
    void putBack();
    /// Places another of each part in the first free place beside the group, and chooses those. Also for a
    /// single selected part. Says why if it is not possible.
    void duplicate();
    /// Puts parts that are being dragged back where they were; else forgets the choice. False if there was
    /// neither.
    bool cancel();
    void reset();

    /// The numbers of the chosen parts, ascending; none or at least two.
    [[nodiscard]] std::span<int const> chosen() const { return chosen_; }
    [[nodiscard]] bool any() const { return !chosen_.empty(); }
    [[nodiscard]] bool dragging() const { return !landings_.empty(); }
    /// Where the dragged parts go if they are released now; empty if none are dragged.
    [[nodiscard]] std::span<PlacedPart const> landings() const { return landings_; }
    /// Whether they may go there.
    [[nodiscard]] Verdict const& verdict() const { return verdict_; }
    /// Two opposite corners of the box that is being drawn, m.
    [[nodiscard]] std::optional<std::pair<Vec2, Vec2>> box() const { return box_; }

private:
    struct Press {
        int number = 0;
        Vec2 at;
        render::Point screen;
        bool member = false; // of the group
        bool toggles = false;
        std::optional<int> before; // the selection before the press
    };

    void choose(std::vector<int> numbers);
    void toggle(int number, std::optional<int> before);
    void forgetLost();
    void follow(Pointer const& pointer);
    void startDrag();
    void drop(Pointer const& pointer);
    bool updateBox(Pointer const& pointer);
    bool updatePress(Pointer const& pointer);
    void settle(std::vector<PlacedPart> wanted);
    /// Moves them there, or says in a message why they may not go there.
    void place(std::vector<PlacedPart> const& wanted);
    bool updateDragged(Pointer const& pointer);
    [[nodiscard]] std::vector<PlacedPart> parts() const;
    [[nodiscard]] std::vector<PlacedPart> turned(std::vector<PlacedPart> parts, double by) const;
    [[nodiscard]] bool isChosen(int number) const;

    Session& session_;
    PlacingTool& placing_;
    render::Toasts& toasts_;
    std::vector<int> chosen_;
    std::optional<Press> press_;
    std::vector<PlacedPart> landings_;
    Vec2 grip_; // m, from the mouse to the first landing
    Verdict verdict_;
    std::optional<std::pair<Vec2, Vec2>> box_;
};

} // namespace trembler::ui
