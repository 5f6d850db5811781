// The expected results: statements about electricity and forces that share no code with the simulations.
// Circuits are found by trying every path, contacts by comparing every edge with every edge, forces by
// Coulomb's law.
#pragma once

#include "tests/conventional/film.hpp"

namespace trembler::conventional {

/// Objects with a smaller gap touch, in m. Resting bodies keep a gap of this order.
inline constexpr double touchingGap = 0.012;

/// The state of a scene in a frame. Rigid bodies are taken from a run without any other physics.
class Statement {
public:
    Statement(Facts const& facts, Setting const& setting, Film const& bodies)
        : facts_(facts), setting_(setting), bodies_(bodies) {}

    /// Assumed places of objects for a question, instead of their real places.
    using Moved = std::map<std::string, Pose>;

    [[nodiscard]] bool touching(std::string const& a, std::string const& b, std::uint64_t frame,
                                Moved const& moved = {}) const;
    /// Whether a path leads from a source to an earth that passes through the object and no object twice.
    [[nodiscard]] bool inCircuit(std::string const& object, std::uint64_t frame,
                                 Moved const& moved = {}) const;
    /// The force, in N, of all magnets that are on, on an object that magnets attract and that is at a place.
    [[nodiscard]] Vec2 force(std::string const& object, Vec2 at, std::uint64_t frame,
                             Moved const& moved = {}) const;
    [[nodiscard]] Pose pose(std::string const& object, std::uint64_t frame, Moved const& moved = {}) const;
    [[nodiscard]] Facts const& facts() const { return facts_; }
    [[nodiscard]] std::uint64_t frames() const { return bodies_.poses.size() - 1; }

private:
    [[nodiscard]] std::map<std::string, std::set<std::string>> connections(std::uint64_t frame,
                                                                           Moved const& moved) const;

    [[nodiscard]] bool findCircuit(std::string const& object, std::uint64_t frame, Moved const& moved) const;

    Facts const& facts_;
    Setting const& setting_;
    Film const& bodies_;
    mutable std::map<std::pair<std::string, std::uint64_t>, bool> known_; // answers, nothing moved
};

} // namespace trembler::conventional
