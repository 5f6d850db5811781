// Positions of the cards of a picture: for hit tests with the mouse, and for tests that nothing overlaps.
#pragma once

#include "render/panels/cards.hpp"
#include "render/panels/rect.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

using render::Rect;

/// A named item on the screen: a card, or a button on one.
struct Placed {
    std::string name;
    Rect rect;
    /// Pixels by which a card's content is wider or higher than the card, or by which a button is cut off
    /// where its list ends.
    double overflow = 0;
};

/// Cards and buttons of the last complete picture and of the current one. Window thread only.
class Layout {
public:
    void beginFrame();
    /// Calls render::beginCard and records the card's position: of a bare card, that of its content.
    void beginCard(char const* name, char const* title, render::CardOptions const& options = {});
    void endCard();
    /// Records the last ImGui item under this name.
    void item(std::string name);

    /// Cards of the last complete picture.
    [[nodiscard]] std::vector<Placed> const& cards() const { return cards_; }
    [[nodiscard]] std::vector<Placed> const& items() const { return items_; }
    [[nodiscard]] std::optional<Rect> card(std::string_view name) const { return find(cards_, name); }
    [[nodiscard]] std::optional<Rect> item(std::string_view name) const { return find(items_, name); }
    /// The card under a point, "" if there is none.
    [[nodiscard]] std::string_view cardAt(render::Point point) const;

private:
    static std::optional<Rect> find(std::vector<Placed> const& all, std::string_view name);

    std::string open_;
    bool bare_ = false;
    std::vector<Placed> cards_;
    std::vector<Placed> items_;
    std::vector<Placed> nextCards_;
    std::vector<Placed> nextItems_;
};

} // namespace trembler::ui
