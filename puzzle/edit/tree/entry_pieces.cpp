#include "puzzle/edit/tree/entry_pieces.hpp"

#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/read/read_entries.hpp"

namespace trembler::edit {

std::vector<PropertySet> piecesOf(GameData const& data, Json const& entry) {
    std::vector<PropertySet> pieces;
    try {
        std::string const text = Json::array({entry}).dump(-1, ' ', false, Json::error_handler_t::replace);
        auto const document = JsonDocument::parse(text, "entry");
        Problems problems;
        NameTable names;
        EntryReader reader(data.registry, names);
        auto const objects = reader.objects(JsonNode(*document, document->root(), "", problems));
        if (!problems.empty() || objects.size() != 1) {
            return pieces;
        }
        bool whole = true;
        PartExpander expander(data.parts, [&](auto const&...) { whole = false; });
        StatementScope const scope{&names, "", nullptr};
        ExpandedEntry const expanded = expander.expand(objects.front(), scope);
        for (MadeObject const& made : expanded.objects) {
            if (whole && !made.joint) {
                pieces.push_back(made.properties());
            }
        }
    } catch (InputError const&) { // too large
        pieces.clear();
    }
    return pieces;
}

bool isComposite(GameData const& data, Json const& entry) {
    PartDefinition const* const part = data.parts.find(textOf(entry, "part"));
    return part != nullptr && part->composite();
}

} // namespace trembler::edit
