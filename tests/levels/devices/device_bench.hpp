// A bench for testing parts: a floor, a supply of 12 V, and the objects that a test adds.
#pragma once

#include "tests/support/experiment.hpp"

#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// Poses of a part for one intention of the player: exact, 2 cm off, and 2° off, each way.
struct SlightlyOff {
    double x = 0;        ///< m
    double angleDeg = 0; ///< degrees
};
[[nodiscard]] std::vector<SlightlyOff> slightlyOff();

/// Builds a level as text, entry by entry, and runs it. The supply's poles are "plus" and "minus".
class DeviceBench : public Experiment {
protected:
    /// Adds an object made from a part of the game; `more` are further members of its entry, such as
    /// `"properties": {...}`.
    void put(std::string const& name, std::string const& part, Vec2 at, double angleDeg = 0,
             std::string const& more = "");
    /// Adds an object by its properties.
    void make(std::string const& name, Vec2 at, std::string const& properties);
    /// Adds a block of wood with that mass, 0.2 m wide.
    void weigh(std::string const& name, Vec2 at, double kilograms);
    /// Adds a lamp of 24 ohm between an object and the supply's minus pole.
    void lampAfter(std::string const& name, std::string const& terminal);
    void wire(std::string const& a, std::string const& b);
    /// Records an input, for example `"grab": "weight", "at": [0, 1]`.
    void input(std::uint64_t frame, std::string const& what);
    /// Builds the world of everything that was added, and restarts.
    void start();

    /// The frames up to a given one in which the object was on, of those in which it could be.
    [[nodiscard]] int framesOn(std::string const& name, std::uint64_t until);

private:
    std::vector<std::string> objects_;
    std::vector<std::string> wires_;
    std::vector<std::string> inputs_;
};

} // namespace trembler
