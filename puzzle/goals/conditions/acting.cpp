#include "puzzle/goals/conditions/acting.hpp"

#include "physics/dynamics/properties/contacts.hpp"
#include "physics/magnetism/properties.hpp"

#include <algorithm>

namespace trembler {

void collectActing(World const& world, std::vector<ObjectId> const& ids, std::vector<EventId>& events) {
    auto const isOne = [&](ObjectId id) { return std::binary_search(ids.begin(), ids.end(), id); };
    if (auto const* const contacts = world.find<Contacts>()) {
        for (TouchingPair const& pair : contacts->current) {
            if (isOne(pair.a) || isOne(pair.b)) {
                events.push_back(pair.event);
            }
        }
    }
    if (auto const* const magnetic = world.find<MagneticForce>()) {
        for (MagneticForce::Action const& action : magnetic->actions) {
            if (isOne(action.object)) {
                events.push_back(action.event);
            }
        }
    }
}

} // namespace trembler
