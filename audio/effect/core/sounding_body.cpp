#include "audio/effect/core/sounding_body.hpp"

#include "audio/effect/core/mode_shapes.hpp"
#include "audio/effect/properties/decibel.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/shapes/shape_order.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double slender = 6;         // length over height from which on a body is a bar
constexpr double answeringLength = 2; // m of a built-in body that vibrate with an impact
constexpr double builtInDecay = 40;   // 1/s, by which a built-in body loses its vibration to the ground
constexpr double thickest = 0.4; // share of its short side, of a plate; thicker bodies are blocks that shear
constexpr double sixtyDecibels = 6.907755278982137; // ln 1000
constexpr double bellTone = 440;                    // Hz m: the prime of a church bell times its diameter

struct Extent {
    Vec2 centre;
    double width = 0;
    double height = 0;
};

Extent extentOf(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
        return {{}, 2 * piece.radius, 2 * piece.radius};
    case ShapeForm::box:
        return {{}, piece.width, piece.height};
    case ShapeForm::capsule:
        return {{}, piece.width, 2 * piece.radius};
    case ShapeForm::polygon:
        break;
    }
    Vec2 low = piece.corners.front();
    Vec2 high = low;
    for (Vec2 const corner : piece.corners) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    return {0.5 * (low + high), high.x - low.x, high.y - low.y};
}

ShapePiece const& mainPiece(Shape const& shape) {
    return *std::max_element(shape.pieces.begin(), shape.pieces.end(),
                             [](ShapePiece const& a, ShapePiece const& b) { return areaOf(a) < areaOf(b); });
}

} // namespace

SoundingBody::SoundingBody(BodyFacts const& facts, int count) : mass_(facts.mass) {
    AcousticMaterial const& material = acousticMaterial(facts.material);
    Shape const shape = inOrder(*facts.shape);
    ShapePiece const& piece = mainPiece(shape);
    place(piece);
    double const volume = areaOf(shape) * worldDepth;
    movedAir_ = facts.fixed ? 0 : 1.5 * volume;
    SoundingForm const asked = facts.acoustics == nullptr ? SoundingForm::automatic : facts.acoustics->form;
    builtIn_ = facts.fixed && facts.acoustics == nullptr;
    if (builtIn_) {
        keepNear();
    }
    if (asked == SoundingForm::automatic) {
        form_ = facts.material == Material::water ? Form::drops
                : piece.form == ShapeForm::circle ? Form::ball
                : length_ >= slender * height_    ? Form::bar
                                                  : Form::plate;
    } else {
        form_ = asked == SoundingForm::bar     ? Form::bar
                : asked == SoundingForm::plate ? Form::plate
                : asked == SoundingForm::ball  ? Form::ball
                                               : Form::bell;
    }
    switch (form_) {
    case Form::bar:
        addBarModes(material);
        break;
    case Form::plate:
        addPlateModes(material);
        break;
    case Form::ball:
        addBallModes(material);
        break;
    case Form::bell:
        addBellModes();
        break;
    case Form::drops:
        addDrops();
        break;
    }
    if (facts.acoustics != nullptr) {
        tune(*facts.acoustics);
    }
    damp(material, facts);
    keepAudible(count);
}

void SoundingBody::place(ShapePiece const& piece) {
    Extent const extent = extentOf(piece);
    centre_ = piece.at + rotated(extent.centre, piece.angle);
    bool const upright = extent.height > extent.width;
    angle_ = piece.angle + (upright ? pi / 2 : 0);
    length_ = std::max(extent.width, extent.height);
    height_ = std::min(extent.width, extent.height);
}

// An impact on a long floor excites only the floor around it.
void SoundingBody::keepNear() {
    answering_ = {std::min(1.0, answeringLength / length_), std::min(1.0, answeringLength / height_)};
    length_ *= answering_.x;
    height_ *= answering_.y;
    mass_ *= answering_.x * answering_.y;
}

void SoundingBody::addBarModes(AcousticMaterial const& material) {
    surface_ = 2 * length_ * worldDepth;
    double const gyration = height_ / std::sqrt(12.0);
    double const scale = gyration * material.rodSpeed() / (2 * pi * length_ * length_);
    for (int n = 1;; ++n) {
        double const root = barRoot(n);
        // Waves shorter than twice the thickness do not bend a bar; modes above the audible range are left
        // out.
        if (n > 1 && (root * height_ > pi * length_ || root * root * scale > highestAudible)) {
            break;
        }
        modes_.push_back({.frequency = root * root * scale, .m = n});
    }
}

void SoundingBody::addPlateModes(AcousticMaterial const& material) {
    constexpr int mostLines = 12;
    surface_ = 2 * length_ * height_;
    double const thickness = std::min(worldDepth, thickest * height_);
    double const stiffness =
        material.rodSpeed() / std::sqrt(12 * (1 - material.poissonRatio * material.poissonRatio));
    for (int m = 0; m <= mostLines; ++m) {
        for (int n = 0; n <= mostLines; ++n) {
            if (m + n >= 2) {
                double const factor = plateFactor(m, n, length_, height_, material.poissonRatio);
                modes_.push_back({.frequency = pi / 2 * thickness * stiffness * factor, .m = m, .n = n});
            }
        }
    }
}

void SoundingBody::addBallModes(AcousticMaterial const& material) {
    double const radius = 0.5 * height_;
    surface_ = 4 * pi * radius * radius;
    for (BallMode const& mode : ballModes()) {
        // A ball is struck at the pole of the mode's pattern; half of the motion is along the surface.
        modes_.push_back({.frequency = mode.root * material.shearSpeed() / (2 * pi * radius),
                          .weight = std::sqrt((2 * mode.degree + 1) / 2.0),
                          .m = mode.degree});
    }
}

void SoundingBody::addBellModes() {
    surface_ = 2 * length_ * height_ + 2 * (length_ + height_) * worldDepth;
    for (BellPartial const& partial : bellPartials()) {
        modes_.push_back({.frequency = partial.ratio * bellTone / length_, .weight = partial.weight});
    }
}

// Air bubbles of 8 mm to 0.8 mm: Minnaert's frequency, damping and strength as in van den Doel, Physically
// based models for liquid sounds (ACM Trans. Applied Perception 2, 2005). The number of bubbles in a splash
// is an estimate.
void SoundingBody::addDrops() {
    constexpr int sizes = 16;
    constexpr double largest = 0.008;   // m
    constexpr double smallest = 0.0008; // m
    constexpr double loudest = 0.2;     // Pa at 1 m, of the largest, for 1 N s
    for (int i = 0; i < sizes; ++i) {
        double const radius = largest * std::pow(smallest / largest, i / (sizes - 1.0));
        modes_.push_back({.frequency = 3.26 / radius,
                          .decay = 0.13 / radius + 0.0072 / (radius * std::sqrt(radius)),
                          .radiation = loudest * std::pow(radius / largest, 1.5)});
    }
}

void SoundingBody::tune(Acoustics const& acoustics) {
    auto const byFrequency = [](Mode const& a, Mode const& b) { return a.frequency < b.frequency; };
    double const lowest = std::min_element(modes_.begin(), modes_.end(), byFrequency)->frequency;
    double const reference =
        form_ == Form::bell ? 2 * lowest : lowest; // the hum lies an octave below the prime
    double const scale = acoustics.frequency > 0 ? acoustics.frequency / reference : 1;
    if (!acoustics.partials.empty()) {
        Mode const model{.frequency = scale * reference, .m = -1};
        modes_.clear();
        for (double const ratio : acoustics.partials) {
            modes_.push_back(model);
            modes_.back().frequency *= ratio;
        }
        return;
    }
    for (Mode& mode : modes_) {
        mode.frequency *= scale;
    }
}

void SoundingBody::damp(AcousticMaterial const& material, BodyFacts const& facts) {
    std::stable_sort(modes_.begin(), modes_.end(),
                     [](Mode const& a, Mode const& b) { return a.frequency < b.frequency; });
    if (form_ == Form::drops) {
        return;
    }
    for (Mode& mode : modes_) {
        // A small body radiates long waves weakly: the radiation efficiency of a breathing ball of that
        // surface (Kinsler et al., Fundamentals of Acoustics, 2000, Section 7.1).
        double const wave = 2 * pi * mode.frequency / speedOfSound;
        double const size = wave * wave * surface_ / (4 * pi);
        double const radiating = size / (1 + size) * surface_;
        mode.radiation = airImpedance * std::sqrt(radiating / (4 * pi));
        mode.decay = pi * mode.frequency * material.lossFactor + airImpedance * radiating / (2 * mass_);
        if (builtIn_) {
            mode.decay += builtInDecay;
        }
    }
    if (facts.acoustics != nullptr && facts.acoustics->ringing > 0) {
        double const scale = sixtyDecibels / facts.acoustics->ringing / modes_.front().decay;
        for (Mode& mode : modes_) {
            mode.decay *= scale;
        }
    }
}

void SoundingBody::keepAudible(int count) {
    std::erase_if(modes_, [](Mode const& mode) {
        return !(mode.frequency >= lowestAudible && mode.frequency <= highestAudible);
    });
    modes_.resize(std::min(modes_.size(), static_cast<std::size_t>(std::clamp(count, 1, mostModes))));
    for (Mode& mode : modes_) {
        mode.audibility = aWeighting(mode.frequency);
    }
}

Vec2 SoundingBody::sourceOf(Vec2 point, Vec2 normal) const {
    constexpr double outside = 0.02; // m
    if (builtIn_) {
        return point - outside * normal;
    }
    double const half = 0.5 * std::max(0.0, length_ / answering_.x - height_ / answering_.y);
    double const along = std::clamp(rotated(point - centre_, -angle_).x, -half, half);
    return centre_ + rotated({along, 0}, angle_);
}

double SoundingBody::mobility(Mode const& mode, Vec2 point, Vec2 normal) const {
    Vec2 const inFrame = rotated(point - centre_, -angle_);
    double const x = std::clamp(inFrame.x / length_ * answering_.x + 0.5, 0.0, 1.0);
    double const y = std::clamp(inFrame.y / height_ * answering_.y + 0.5, 0.0, 1.0);
    if (form_ == Form::drops) {
        return 1;
    }
    if (mode.m < 0) { // stated partials, whose shapes are unknown
        return 1 / mass_;
    }
    switch (form_) {
    case Form::bar: {
        // Only an impact across the bar bends it. No impact is exactly along the bar, so each bends it a
        // little.
        constexpr double least = 0.1;
        double const across = rotated(normal, -angle_).y;
        double const bending = std::copysign(std::max(std::abs(across), least), across);
        return barShape(mode.m, x) * bending / mass_;
    }
    case Form::plate:
        return plateShape(mode.m, x) * plateShape(mode.n, y) / mass_;
    case Form::bell: {
        // A bell sounds where its wall vibrates most: at the rim, the lower side of its shape.
        double const down = std::clamp(0.5 - (point.y - centre_.y) / std::max(length_, height_), 0.0, 1.0);
        return mode.weight * (0.4 + 0.8 * down) / mass_;
    }
    default:
        return mode.weight / mass_;
    }
}

} // namespace trembler
