#include "insight/miss/current/insulators.hpp"

#include "audio/effect/properties/acoustics.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/properties/electrical.hpp"

#include <algorithm>
#include <vector>

namespace trembler::insight {
namespace insulators {
namespace {

bool isConductor(World const& world, ObjectId id) {
    return world.find<Conductor>(id) != nullptr;
}

bool isInsulator(World const& world, ObjectId id) {
    return !isConductor(world, id) && world.find<Fixed>(id) == nullptr &&
           world.find<SoundSensor>(id) == nullptr;
}

} // namespace
} // namespace insulators

void Insulators::look(World const& world) {
    auto const* const contacts = world.find<Contacts>();
    if (contacts == nullptr || contacts->begun.empty()) {
        return;
    }
    std::map<ObjectId, std::vector<ObjectId>> touched; // by insulators: conductors
    for (TouchingPair const& pair : contacts->current) {
        for (auto const& [one, other] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)}) {
            if (insulators::isConductor(world, other) && insulators::isInsulator(world, one)) {
                touched[one].push_back(other);
            }
        }
    }
    for (auto& [insulator, conductors] : touched) {
        std::sort(conductors.begin(), conductors.end());
        for (std::size_t a = 0; a < conductors.size(); ++a) {
            for (std::size_t b = a + 1; b < conductors.size(); ++b) {
                across_.try_emplace({conductors[a], conductors[b]}, world.store().nameOf(insulator));
            }
        }
    }
}

void Insulators::tell(Miss& miss) const {
    for (CircuitGap& gap : miss.gaps) {
        auto const found = across_.find(std::minmax(gap.a, gap.b));
        if (gap.reason == GapReason::apart && found != across_.end()) {
            gap.nameBy = found->second;
        }
    }
    for (Miss& other : miss.besides) {
        tell(other);
    }
}

} // namespace trembler::insight
