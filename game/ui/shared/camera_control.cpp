#include "game/ui/shared/camera_control.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

/// Limits of the zoom, as factors of the view that shows everything.
constexpr double nearest = 30;
constexpr double farthest = 0.15;
constexpr double zoomPerNotch = 1.15;

} // namespace

void CameraControl::setView(render::Size viewport, Margins const& margins) {
    bool const same = viewport == camera_.viewport;
    double const before = camera_.viewport.width;
    camera_.viewport = viewport;
    margins_ = margins;
    held_ = held_ && same;
    if (!moved_ && !held_) {
        fit();
    } else if (!same && before > 0) {
        camera_.pixelsPerMetre *= viewport.width / before; // a larger window shows the same part of the world
        if (!limits_.empty()) {
            keepInLimits(limits_.centre());
        }
    }
}

void CameraControl::setPreferred(std::optional<render::Camera> const& preferred) {
    preferred_ = preferred;
    if (!moved_ && !held_) {
        fit();
    }
}

double CameraControl::fittingScale() const {
    bool const counts = preferred_ && preferred_->viewport == camera_.viewport;
    return counts ? preferred_->pixelsPerMetre : scaleBetweenMargins();
}

double CameraControl::scaleBetweenMargins() const {
    double const width = std::max(camera_.viewport.width - margins_.left - margins_.right, 50.0);
    double const height = std::max(camera_.viewport.height - margins_.top - margins_.bottom, 50.0);
    render::Point const half = subject_.half();
    double const scale = std::min(width / std::max(2 * half.x, 1e-3), height / std::max(2 * half.y, 1e-3));
    return std::clamp(scale, render::Camera::smallestScale, render::Camera::largestScale);
}

void CameraControl::fit() {
    moved_ = false;
    if (preferred_ && preferred_->viewport == camera_.viewport) {
        camera_ = *preferred_;
        return;
    }
    if (subject_.empty()) {
        return;
    }
    camera_.pixelsPerMetre = fittingScale();
    double const shiftX = 0.5 * (margins_.left - margins_.right) / camera_.pixelsPerMetre;
    double const shiftY = 0.5 * (margins_.bottom - margins_.top) / camera_.pixelsPerMetre;
    camera_.centre = subject_.centre() - render::Point{shiftX, shiftY};
}

void CameraControl::zoom(render::Point at, double notches) {
    double const all = subject_.empty() ? camera_.pixelsPerMetre : fittingScale();
    double const wanted = camera_.pixelsPerMetre * std::pow(zoomPerNotch, notches);
    render::Point const before = looksAt();
    camera_.zoomAt(at, std::clamp(wanted, all * farthest, all * nearest) / camera_.pixelsPerMetre);
    keepInLimits(before);
    moved_ = true;
}

void CameraControl::look(render::Point shares) {
    render::Point const before = looksAt();
    camera_.pan({-shares.x * camera_.viewport.width, shares.y * camera_.viewport.height});
    keepInLimits(before);
    moved_ = true;
}

void CameraControl::keepInLimits(render::Point before) {
    if (limits_.empty()) {
        return;
    }
    render::Extent within = limits_;
    within.add(before); // a view that is out of them already may stay there, and come back
    render::Point const now = looksAt();
    render::Point const kept{std::clamp(now.x, within.lower.x, within.upper.x),
                             std::clamp(now.y, within.lower.y, within.upper.y)};
    camera_.centre = camera_.centre + (kept - now);
}

render::Point CameraControl::middle() const {
    return {0.5 * (margins_.left + camera_.viewport.width - margins_.right),
            0.5 * (margins_.top + camera_.viewport.height - margins_.bottom)};
}

void CameraControl::drag(render::Point pixels) {
    if (panning_ && (pixels.x != 0 || pixels.y != 0)) {
        render::Point const before = looksAt();
        camera_.pan(pixels);
        keepInLimits(before);
        moved_ = true;
    }
}

} // namespace trembler::ui
