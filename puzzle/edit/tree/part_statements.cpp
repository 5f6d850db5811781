#include "puzzle/edit/tree/part_statements.hpp"

#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/property/property_writer.hpp"

#include <algorithm>

namespace trembler::edit {
namespace {

constexpr std::size_t beforeInside = 2; // bytes of an entry's name and the blank after it

} // namespace

/// A composite part as an entry of a one-letter name becomes it.
struct PartStatements::Composite {
    Composite(GameData const& data, std::string const& part) : expander(data.parts, [](auto const&...) {}) {
        entry.name = "x";
        entry.part = part;
        made = expander.expand(entry, scope);
        for (std::size_t i = 0; i < made.objects.size(); ++i) {
            std::string const inside = made.objects[i].name.substr(beforeInside);
            names.push_back(inside);
            if (!made.objects[i].joint) {
                pieces.push_back({inside, i == made.main});
            }
        }
        for (auto const& [name, means] : made.aliases) {
            if (name.size() > beforeInside) {
                names.push_back(name.substr(beforeInside));
            }
        }
    }

    [[nodiscard]] MadeObject const* object(std::string const& piece) const {
        auto const found = std::find_if(made.objects.begin(), made.objects.end(), [&](MadeObject const& one) {
            return !one.joint && one.name.compare(beforeInside, std::string::npos, piece) == 0;
        });
        return found == made.objects.end() ? nullptr : &*found;
    }

    [[nodiscard]] std::string main() const {
        auto const found =
            std::find_if(pieces.begin(), pieces.end(), [](PartPiece const& piece) { return piece.main; });
        return found == pieces.end() ? std::string() : found->name;
    }

    LevelObject entry;
    NameTable table;
    StatementScope scope{&table, "", nullptr};
    PartExpander expander;
    ExpandedEntry made;
    std::vector<PartPiece> pieces;
    std::vector<std::string> names;
};

PartStatements::PartStatements(GameData const& data) : data_(data) {}

PartStatements::~PartStatements() = default;

PartStatements::Composite const* PartStatements::find(std::string const& part) {
    auto const [at, isNew] = composites_.try_emplace(part);
    if (isNew) {
        PartDefinition const* const known = data_.parts.find(part);
        if (known != nullptr && known->composite()) {
            at->second = std::make_unique<Composite>(data_, part);
        }
    }
    return at->second.get();
}

std::vector<PartPiece> const& PartStatements::pieces(std::string const& part) {
    static std::vector<PartPiece> const none;
    Composite const* const composite = find(part);
    return composite == nullptr ? none : composite->pieces;
}

std::string PartStatements::pieceNamed(std::string const& part, std::string const& name) {
    Composite const* const composite = find(part);
    if (composite == nullptr || name.empty()) {
        return {};
    }
    std::string means = composite->entry.name + " " + name;
    for (auto alias = composite->made.aliases.rbegin(); alias != composite->made.aliases.rend(); ++alias) {
        if (alias->first == means) { // the outermost first
            means = alias->second;
        }
    }
    std::string const piece = means.substr(beforeInside);
    return composite->object(piece) == nullptr ? std::string() : piece;
}

std::vector<std::string> const& PartStatements::namesInside(std::string const& part) {
    static std::vector<std::string> const none;
    Composite const* const composite = find(part);
    return composite == nullptr ? none : composite->names;
}

Json PartStatements::of(std::string const& part, std::string const& piece, PropertyInfo const& info) {
    PropertyValue const* value = nullptr;
    if (Composite const* const composite = find(part)) {
        if (info.text.place != PropertyPlace::properties) { // where a piece lies is not where the object does
            return {};
        }
        MadeObject const* const made =
            composite->object(piece.empty() ? composite->main() : pieceNamed(part, piece));
        StatedProperties const* const place = made == nullptr ? nullptr : made->determining(info);
        PropertyInfo const* const basis = data_.registry.objectProperty(info.text.madeFor);
        // A property that belongs to another shape, such as its drawing, is not taken from further inside.
        StatedProperties const* const other =
            place == nullptr || basis == nullptr ? nullptr : made->determining(*basis);
        bool const outdated = other != nullptr && other > place; // both are entries of one list
        value = place == nullptr || outdated ? nullptr : place->set->find(info);
    } else if (PartDefinition const* const known = data_.parts.find(part);
               known != nullptr && piece.empty()) {
        value = known->properties.find(info);
    }
    return value == nullptr ? Json() : writeProperty(*value);
}

void renameInsides(PartStatements& parts, Json const& entry, std::string const& to, NewNames& names) {
    std::string const name = textOf(entry, "name");
    for (std::string const& inside : parts.namesInside(textOf(entry, "part"))) {
        names.emplace(name + " " + inside, to + " " + inside);
    }
}

std::vector<std::string> namesOfObjectsAndPieces(GameData const& data, Json const& level) {
    std::vector<std::string> names;
    PartStatements parts(data);
    Json const* const list = findList(level, "objects");
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        std::string const name = textOf((*list)[i], "name");
        if (name.empty()) {
            continue;
        }
        names.push_back(name);
        for (PartPiece const& piece : parts.pieces(textOf((*list)[i], "part"))) {
            names.push_back(name + " " + piece.name);
        }
    }
    return names;
}

} // namespace trembler::edit
