// Pictures of the screen that the player keeps: a film of every frame, and single pictures.
#pragma once

#include "game/ui/shared/recorder.hpp"
#include "render/panels/toasts.hpp"

#include <functional>

namespace trembler::ui {

/// Shows a message with the place of the files, or with the reason why they cannot be written. Window thread
/// only.
class Film {
public:
    /// Both must outlive this.
    Film(Recorder& recorder, render::Toasts& toasts) : recorder_(recorder), toasts_(toasts) {}

    /// Begins a film, or ends the one that is being made.
    void toggle();
    /// Ends the film, if one is being made.
    void end();
    [[nodiscard]] bool recording() const { return recording_; }
    /// Asks for the next picture to be kept.
    void wantPicture() { wanted_ = true; }

    /// Whether take() is going to read the present picture.
    [[nodiscard]] bool wants(bool stepped) const { return wanted_ || (recording_ && stepped); }
    /// To be called when a picture is complete. `stepped`: the world moved on in it, so it belongs to the
    /// film. `pixels` reads the picture; it is called only if the picture is to be kept.
    void take(std::function<render::Image()> const& pixels, bool stepped);

private:
    Recorder& recorder_;
    render::Toasts& toasts_;
    bool recording_ = false;
    bool wanted_ = false;
};

} // namespace trembler::ui
