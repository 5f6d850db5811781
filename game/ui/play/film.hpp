// What the player takes of the screen: a film of every frame, and single pictures.
#pragma once

#include "game/ui/shared/recorder.hpp"
#include "render/panels/toasts.hpp"

#include <functional>

namespace trembler::ui {

/// Tells the player where it goes, or why it does not. Window thread only.
class Film {
public:
    /// Both must outlive this.
    Film(Recorder& recorder, render::Toasts& toasts) : recorder_(recorder), toasts_(toasts) {}

    /// Begins a film, or ends the one that is being made.
    void toggle();
    /// Ends the film, if one is being made.
    void end();
    [[nodiscard]] bool recording() const { return recording_; }
    /// The next picture is to be kept.
    void wantPicture() { wanted_ = true; }

    /// Whether take() is going to read the present picture.
    [[nodiscard]] bool wants(bool stepped) const { return wanted_ || (recording_ && stepped); }
    /// A picture is complete. `stepped`: the world moved on in it, so it belongs to the film. `pixels` reads
    /// it, and is not called where nobody wants it.
    void take(std::function<render::Image()> const& pixels, bool stepped);

private:
    Recorder& recorder_;
    render::Toasts& toasts_;
    bool recording_ = false;
    bool wanted_ = false;
};

} // namespace trembler::ui
