// The pulls and pushes by which magnets moved bodies in a run.
#pragma once

#include "runtime/trace/event.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace trembler::insight {

/// Objects that joints tie to each other move together, and their magnets act on each other in vain. Of what
/// another magnet does to such a body, the greatest pull on one of its objects and the greatest push are the
/// main ones: of a motor's spokes, the one that an electromagnet pulls up and the one that it pushes away.
/// The inverse square law makes the others insignificant (6.10.3). So is a force that is weak for the mass of
/// its object, or beside what another magnet does to the body at the same time.
class MainPulls {
public:
    using Groups = std::map<std::string, std::size_t>; ///< SceneFacts::tied

    /// To be called after every frame of a run that is traced, with the same groups.
    void look(World const& world, Groups const& tied);

    struct Pull {
        EventId event;       ///< its beginning
        std::string by;      ///< the magnet
        bool acting = false; ///< in the frame before; otherwise it is the last one of this magnet
    };
    /// The main pulls and pushes on the body of an object that can have moved it by a frame: of each magnet
    /// those of the frame before, in which their forces were computed, or else its last ones.
    [[nodiscard]] std::vector<Pull> on(std::string const& object, std::uint64_t frame) const;

    /// Whether an event is the beginning of a pull or push that was a main one at any time.
    [[nodiscard]] bool isMain(EventId event) const { return main_.contains(event); }
    /// Whether no magnet has moved anything.
    [[nodiscard]] bool empty() const { return main_.empty(); }

private:
    /// The number of its group, from 1; 0 and its name if it is alone.
    using Body = std::pair<std::size_t, std::string>;
    struct Since {
        std::uint64_t frame = 0;
        EventId pull;
        EventId push;
        bool acting = false;
        bool weak = false; ///< beside another magnet
    };
    [[nodiscard]] static Body bodyOf(std::string const& name, Groups const& tied);

    std::map<std::pair<Body, std::string>, std::vector<Since>> histories_; // by the body and the magnet
    std::set<EventId> main_;
    Groups tied_;
};

} // namespace trembler::insight
