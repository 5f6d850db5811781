// The hand that changes things at the moment of a what-if: moves, turns and removes objects, cuts wires,
// pulls.
#pragma once

#include "game/ui/play/whatif/what_if.hpp"
#include "game/ui/shared/pointer.hpp"
#include "render/scene/objects/wires.hpp"

#include <optional>
#include <string>
#include <utility>

namespace trembler::ui {

/// Window thread only.
class WhatIfTool {
public:
    /// Both must outlive this.
    WhatIfTool(Timeline const& timeline, WhatIfView& view) : timeline_(timeline), view_(view) {}

    /// Where a dragged object is at present.
    struct Drag {
        std::string object;
        Vec2 grip; ///< m, from the object's origin to the place that was taken hold of
        Vec2 at;   ///< m, of its origin
        double angle = 0;
        Vec2 from;         ///< m, the place that was taken hold of
        bool pull = false; ///< it is pulled, not put there
        bool moved = false;
        render::Point pressedAt; ///< pixels
    };

    /// Handles one picture's input. `pulling`: an object that is dragged is pulled by a hand for a second.
    /// True if it uses the pointer, which then means nothing else.
    bool update(Pointer const& pointer, bool pulling);
    void setCutting(bool cutting) { cutting_ = cutting; }
    [[nodiscard]] bool cutting() const { return cutting_; }
    /// The wire that a click would cut; both ids invalid if there is none.
    [[nodiscard]] render::Link const& wireUnderBlades() const { return wire_; }
    /// The object that commands act on, by name; "": none.
    [[nodiscard]] std::string const& chosen() const { return chosen_; }
    [[nodiscard]] std::optional<Drag> const& drag() const { return drag_; }

    /// Whether the card of the what-if has the keyboard, and the buttons of a gamepad: arrows move a ring
    /// among its elements.
    [[nodiscard]] bool cardHasKeys() const { return cardKeys_ && view_.active(); }
    void giveCardKeys(bool give) { cardKeys_ = cardKeysNew_ = give; }
    /// Whether the ring has to be put on the card; once after giveCardKeys().
    [[nodiscard]] bool takeCardKeysNew() { return std::exchange(cardKeysNew_, false); }

    void turn(int steps, bool fine);
    void nudge(Vec2 steps, bool fine);
    void remove();
    void reset();

private:
    /// The world at the moment, as it is with the changes so far.
    [[nodiscard]] World const& world() const;
    void grip(Pointer const& pointer, bool pulling);
    struct Place {
        Vec2 at;
        double angle = 0;
    };
    /// As it is at the moment, with the changes so far; nothing if nothing is chosen.
    [[nodiscard]] std::optional<Place> placeOfChosen() const;
    void put(std::string const& object, Vec2 at, double angle);

    Timeline const& timeline_;
    WhatIfView& view_;
    std::string chosen_;
    std::optional<Drag> drag_;
    bool cutting_ = false;
    bool cardKeys_ = false;
    bool cardKeysNew_ = false;
    render::Link wire_;
};

} // namespace trembler::ui
