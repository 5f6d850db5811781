// The bodies that sound, and their places: the resolver property that loudness, loudspeakers and drawing
// read.
#pragma once

#include "runtime/math/vec2.hpp"
#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/property/news.hpp"
#include "runtime/trace/event.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace trembler {

/// All pressures are those at a distance of 1 m in free air. Sound has no travel time.
struct Sounds {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Sounds", "sounds",
        "The current sounds and their places: ringing modes, impacts, rubbing, recordings."};
    static constexpr Coverage coverage = hashed;

    /// A mode of a body that rings.
    struct Ring {
        double frequency = 0;  ///< Hz
        double decay = 0;      ///< 1/s, of the amplitude
        double meanSquare = 0; ///< Pa², at the end of the frame
        double weight = 1;     ///< the ear's factor on its mean square pressure (A-weighting)
    };
    /// A body that sounds, or sounded until a moment ago.
    struct Body {
        ObjectId object;
        Vec2 local;              ///< m, the source of the sound in the body's frame
        Vec2 at;                 ///< m, the same in the world
        Vec2 velocity;           ///< m/s
        double loudness = 0;     ///< Pa², A-weighted, smoothed over 125 ms ("fast", IEC 61672-1)
        double brightness = 0;   ///< Hz, the mean frequency of that loudness
        std::vector<Ring> rings; ///< its modes, ascending by frequency
        EventId event;           ///< the latest impact; none without tracing
    };
    /// An impact in this frame, or in the part of it that is reported.
    struct Impact {
        ObjectId object;
        ObjectId other;
        Vec2 at;                  ///< m, in the world
        double since = 0;         ///< s after the beginning of the frame, or of the part
        double meanSquare = 0;    ///< Pa², A-weighted, of its modes at their beginning and of its click
        double clickPressure = 0; ///< Pa, amplitude of the click
        double clickTime = 0;     ///< s, its one period
        std::uint32_t first = 0;  ///< `amplitudes` from here on are those of the body's modes, one each
        std::uint32_t count = 0;
    };
    /// A noise that drives a body's modes throughout the frame, or the part of it.
    struct Scrape {
        ObjectId object;
        ObjectId other;
        Vec2 at;
        std::uint32_t first = 0; ///< `amplitudes` from here on, in Pa/√s, are those of the body's modes: the
                                 ///< contribution of a white noise of unit power
        std::uint32_t count = 0;
    };
    /// A recording that plays.
    struct Recording {
        ObjectId object;
        std::string file;
        Vec2 at;
        Vec2 velocity;
        double meanSquare = 0;    ///< Pa²
        double loudness = 0;      ///< Pa², smoothed
        double elapsed = 0;       ///< s since it began, at the end of the frame
        double duration = 0;      ///< s, of one play
        bool held = false;        ///< repeated
        std::uint64_t serial = 0; ///< differs for each play
        EventId event;
    };

    std::vector<Body> bodies;          ///< ascending by object
    std::vector<Impact> impacts;       ///< of this frame only
    std::vector<Scrape> scrapes;       ///< of this frame only
    std::vector<double> amplitudes;    ///< of impacts (Pa) and scrapes (Pa/√s)
    std::vector<Recording> recordings; ///< ascending by object and serial
    std::uint64_t frame = 0;           ///< the last in which anything was computed
    std::uint64_t recordingsEver = 0;

    /// For a frame in parts: the sounds at its end, with the impacts and scrapes of all parts.
    static void gather(Sounds& frame, Sounds const& part, PartSpan span);

    [[nodiscard]] bool silent() const { return bodies.empty() && recordings.empty(); }
};

} // namespace trembler
