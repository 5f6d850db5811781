// The base of the tests of the thesis's experiments: plays a level with a recorded solution and finds objects
// by name.
#pragma once

#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace trembler {

class Experiment : public ::testing::Test {
protected:
    /// Loads a level of levels/experiments by its file's name.
    [[nodiscard]] static LevelFile load(std::string const& file);
    /// Opens it with one of its recorded solutions, or without player input ("").
    void open(std::string const& file, std::string const& solution = "", bool trace = false);
    void open(LevelFile level, std::string const& solution = "", bool trace = false);
    void step() { session_->step(); }
    void runTo(std::uint64_t frame);
    /// Runs up to that frame and returns the frames in which the two objects began to touch, even briefly.
    [[nodiscard]] std::vector<std::uint64_t> hits(std::string const& a, std::string const& b,
                                                  std::uint64_t frame);

    [[nodiscard]] Session& session() { return *session_; }
    [[nodiscard]] World const& world() const { return session_->world(); }
    [[nodiscard]] ObjectId id(std::string const& name) const;
    [[nodiscard]] Vec2 at(std::string const& name) const;
    [[nodiscard]] double angle(std::string const& name) const; ///< rad
    [[nodiscard]] double spin(std::string const& name) const;  ///< rad/s
    [[nodiscard]] bool on(std::string const& name) const;
    [[nodiscard]] bool touching(std::string const& a, std::string const& b) const;

    /// The events of that name that concern all these objects, in order.
    [[nodiscard]] std::vector<Event const*> events(std::string const& event,
                                                   std::vector<std::string> const& objects) const;
    /// The first such event from a frame on; fails the test if there is none.
    [[nodiscard]] Event const& first(std::string const& event, std::vector<std::string> const& objects,
                                     std::uint64_t frame = 0) const;
    /// Whether one event caused another.
    [[nodiscard]] bool led(Event const& from, Event const& to) const;

private:
    std::unique_ptr<Session> session_;
};

/// Arithmetic mean, and standard deviation relative to it.
[[nodiscard]] double mean(std::vector<double> const& values);
[[nodiscard]] double relativeDeviation(std::vector<double> const& values);
/// The differences of adjacent values.
[[nodiscard]] std::vector<double> intervals(std::vector<std::uint64_t> const& frames);

} // namespace trembler
