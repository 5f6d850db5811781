// Pictures of the world that the player keeps: a clip of a run, and single pictures.
#pragma once

#include "game/ui/shared/kept/pending_writes.hpp"
#include "game/ui/shared/kept/recorder.hpp"
#include "render/gl/webp.hpp"
#include "render/panels/toasts.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace trembler::ui {

/// Shows a message with the place of the files, or with the reason why they cannot be written; then they are
/// kept in memory and tried again. Window thread only.
class Film {
public:
    /// A clip shows every second frame of the world, and ends by itself after this many frames.
    static constexpr std::uint64_t framesPerPicture = 2;
    static constexpr std::uint64_t mostFrames = 60 * 60;
    /// Pictures of a clip are halved in size until they are no wider than this, pixels.
    static constexpr int mostWidth = 1280;

    /// All must outlive this.
    Film(Recorder& recorder, render::Toasts& toasts, PendingWrites& pending)
        : recorder_(recorder), toasts_(toasts), pending_(pending) {}

    /// Begins a clip, or ends the one that is being made.
    void toggle();
    /// Ends the clip, if one is being made, and writes it.
    void end();
    [[nodiscard]] bool recording() const { return recording_; }
    /// How much of the world the clip has so far, s.
    [[nodiscard]] double seconds() const { return static_cast<double>(frames_) / 60; }
    /// Asks for the next picture to be kept.
    void wantPicture() { wanted_ = true; }

    /// Whether take() is going to read the present picture. Single pictures are kept as they are seen.
    [[nodiscard]] bool wants(bool stepped) const {
        return wanted_ || (recording_ && stepped && frames_ % framesPerPicture == 0);
    }
    /// To be called for every picture, when the world is drawn and no card lies over it. `stepped`: the world
    /// moved on by a frame. `pixels` reads the picture; it is called only if the picture is to be kept.
    void take(std::function<render::Image()> const& pixels, bool stepped);

private:
    void add(render::Image image);
    void giveUp(std::string const& why);
    void writePicture(render::Image const& image);

    Recorder& recorder_;
    render::Toasts& toasts_;
    PendingWrites& pending_;
    std::unique_ptr<render::AnimatedWebp> clip_; // nullptr before the first picture
    render::Size size_;
    std::uint64_t frames_ = 0; // of the world
    bool recording_ = false;
    bool wanted_ = false;
};

/// The picture at half its width and height, each pixel the mean of four.
[[nodiscard]] render::Image halved(render::Image const& image);

} // namespace trembler::ui
