// Short messages that appear at the edge of the window and disappear by themselves.
#pragma once

#include "render/panels/rect.hpp"

#include <cstdint>
#include <deque>
#include <span>
#include <string>

namespace trembler::render {

enum class ToastKind : std::uint8_t { News, Success, Trouble };

/// Window thread only.
class Toasts {
public:
    /// Shown for `seconds` (0.5 to 60, else clamped), under the toasts that are shown already. The oldest is
    /// removed when there are five. Of a longer text the first 1,000 bytes are shown.
    void add(std::string text, ToastKind kind = ToastKind::News, double seconds = 4);

    /// Draws them near the top of the window and lets `seconds` pass; between Gui::beginFrame and endFrame.
    /// Each is as high in the window as it can be without lying on a rectangle of `kept` or on an earlier
    /// toast, and is broken into shorter lines where that helps; it lies on `kept` only where there is no
    /// other room.
    void draw(double seconds, std::span<Rect const> kept = {});

    [[nodiscard]] std::size_t count() const { return toasts_.size(); }
    /// The text of the newest toast that is shown; "" if there is none.
    [[nodiscard]] std::string newest() const { return toasts_.empty() ? std::string() : toasts_.back().text; }
    /// Trouble whose reason is on the screen already, beside what it is about: it is counted, so that it is
    /// heard, but not said again.
    void countTrouble() { ++troubles_; }
    /// How much trouble has been reported so far, in toasts or by countTrouble().
    [[nodiscard]] std::uint64_t troubles() const { return troubles_; }

private:
    struct Toast {
        std::string text;
        ToastKind kind;
        double left;
        double age;
    };
    std::deque<Toast> toasts_;
    std::uint64_t troubles_ = 0;
};

} // namespace trembler::render
