#include "insight/whatif/pieces.hpp"

namespace trembler::insight {

std::vector<ObjectId> piecesWith(Store const& store, ObjectId object) {
    if (!store.alive(object)) {
        return {};
    }
    Origin const origin = store.originOf(object);
    bool const ofPart = origin.kind == Origin::Kind::object || origin.kind == Origin::Kind::placement;
    std::vector<ObjectId> all;
    for (std::uint32_t index = 0; ofPart && index < store.objects().indexBound(); ++index) {
        ObjectId const id = store.objects().at(index);
        Origin const own = id.valid() ? store.originOf(id) : Origin{};
        if (id.valid() && own.kind == origin.kind && own.number == origin.number) {
            all.push_back(id);
        }
    }
    return ofPart ? all : std::vector{object};
}

} // namespace trembler::insight
