#include "runtime/level/read/read_pieces.hpp"

#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/read/read_entries.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

void readPieces(MemberReader& reader, Registry const& registry, PartDefinition& part) {
    EntryReader entries(registry, part.names);
    auto const objects = reader.optional("objects");
    auto const joints = reader.optional("joints");
    auto const connections = reader.optional("connections");
    auto const main = reader.optional("main");
    if (!objects) {
        for (auto const* const without : {&joints, &connections, &main}) {
            if (*without) {
                (*without)->complain("is stated for a part without pieces", "pieces under \"objects\"");
            }
        }
        return;
    }
    part.objects = entries.objects(*objects);
    if (objects->value().is_array() && objects->size() == 0) {
        objects->complain("is empty", "at least one piece");
    }
    if (joints) {
        part.joints = entries.joints(*joints);
    }
    if (connections) {
        part.connections = entries.connections(*connections);
    }
    if (!main) {
        return;
    }
    part.main = main->name("the name of a piece").value_or("");
    std::vector<std::string> names;
    for (LevelObject const& object : part.objects) {
        names.push_back(object.name);
    }
    if (!part.main.empty() && std::find(names.begin(), names.end(), part.main) == names.end()) {
        main->complain(fmt::format("there is no piece '{}'{}", part.main, didYouMean(part.main, names)),
                       listed(names));
        part.main.clear();
    }
}

} // namespace trembler
