// The name of the object on which the mouse rests.
#pragma once

#include "runtime/math/vec2.hpp"
#include "runtime/object/object_id.hpp"

#include <algorithm>

namespace trembler::ui {

/// A name appears once the pointer has rested on an object for a moment, so that names do not flicker along
/// its way. Plain data; window thread.
class HoverName {
public:
    static constexpr double patience = 0.5; ///< s

    /// Once for each picture: what the pointer is on, if a name may be shown, else an invalid id. `moved`:
    /// pixels, in this picture.
    void look(ObjectId hovered, double moved, double seconds) {
        bool const same = hovered.valid() && hovered == object_ && (moved <= 1 || shown());
        rested_ = same ? std::min(rested_ + std::max(seconds, 0.0), patience) : 0;
        object_ = hovered;
    }
    /// The object whose name is shown; an invalid id: none is.
    [[nodiscard]] ObjectId object() const { return shown() ? object_ : ObjectId{}; }
    /// A picture is due in which the name appears.
    [[nodiscard]] bool waiting() const { return object_.valid() && !shown(); }

private:
    [[nodiscard]] bool shown() const { return rested_ >= patience; }

    ObjectId object_;
    double rested_ = 0; // s
};

} // namespace trembler::ui
