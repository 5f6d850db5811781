// Cards that lie on the paper: the background of every panel that a player sees, and the goal card.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <string>

namespace trembler::render {

/// The corner, edge or middle of the window at which a card stays.
enum class Anchor : std::uint8_t {
    TopLeft,
    Top,
    TopRight,
    Left,
    Middle,
    Right,
    BottomLeft,
    Bottom,
    BottomRight
};

struct CardOptions {
    Anchor anchor = Anchor::TopLeft;
    ImVec2 offset{16, 16}; ///< from that corner inwards, pixels at UI scale 1
    float width = 0.F;     ///< pixels at UI scale 1; 0 fits the content
    bool bare = false;     ///< no card drawn, content only (rows of buttons)
};

/// Starts a card; its height fits the content. `title` may be empty. Always call endCard afterwards.
void beginCard(char const* id, char const* title, CardOptions const& options = {});
void endCard();

/// A line of a goal card.
struct GoalLine {
    enum class State : std::uint8_t { Open, Met, Failed };
    std::string text;
    State state = State::Open;
    float progress = -1.F; ///< 0..1 draws a bar ("for two seconds"); negative for none
};

/// The goal in words, each line with its box to tick. Inside a card.
void goalLines(std::span<GoalLine const> lines);

/// Wrapped text in the colour of less important text. Inside a card.
void caption(char const* text);
/// The same in the small font.
void smallCaption(char const* text);

} // namespace trembler::render
