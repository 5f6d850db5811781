#include "puzzle/edit/commands/own_parts.hpp"

#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/text/lay_out.hpp"
#include "puzzle/edit/tree/entry_pieces.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/references.hpp"
#include "puzzle/edit/tree/subset.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

/// All properties that an object has, from its part and its own.
Json allProperties(GameData const& data, Json const& entry) {
    Json properties = Json::object();
    for (PropertyInfo const* const info : data.registry.objectProperties()) {
        if (info->text.place == PropertyPlace::properties) {
            if (Json value = effectiveStatement(data, entry, *info); !value.is_null()) {
                properties[std::string(info->text.key)] = std::move(value);
            }
        }
    }
    return properties;
}

/// A file name made from a part's name: letters, digits and "_".
std::string fileNameOf(std::string const& part) {
    std::string name;
    for (char const c : part) {
        bool const plain =
            std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80U;
        name += plain ? static_cast<char>(std::tolower(static_cast<unsigned char>(c))) : '_';
    }
    return name;
}

} // namespace

Json partFrom(GameData const& data, Json const& level, std::vector<std::string> const& names,
              std::string const& main, PartNames const& partNames) {
    mustHaveObjects(level, names);
    mustBeName(partNames.name, "the name of a part");
    if (data.parts.find(partNames.name) != nullptr) {
        throw CommandError(fmt::format("there is already a part '{}'", partNames.name));
    }
    if (std::find(names.begin(), names.end(), main) == names.end()) {
        throw CommandError("the main object must be one of the objects that the part is made of");
    }
    Json part{{"name", partNames.name}};
    if (!partNames.title.empty() && partNames.title != partNames.name) {
        mustBeName(partNames.title, "the title of a part");
        part["title"] = partNames.title;
    }
    if (!partNames.text.empty()) {
        part["text"] = partNames.text;
    }
    if (names.size() == 1 && !isComposite(data, *findObject(level, main))) {
        part["properties"] = allProperties(data, *findObject(level, main));
        return part;
    }
    Json subset = subsetOf(data, level, names);
    shiftSubset(subset, -placeOf(*findObject(level, main)));
    part["main"] = main;
    for (char const* const key : {"objects", "joints", "connections"}) {
        if (subset.contains(key)) {
            part[key] = subset[key];
        }
    }
    return part;
}

fs::path writePart(fs::path const& folder, Json const& part) {
    std::string const name = fileNameOf(textOf(part, "name"));
    return writeNewFile(
        folder,
        [&](int number) { return number == 1 ? name + ".json" : fmt::format("{}_{}.json", name, number); },
        layOutFile(part));
}

Command replaceByPart(GameData const& data, Json const& level, std::vector<std::string> const& names,
                      std::string const& main, std::string const& part) {
    mustHaveObjects(level, names);
    if (std::find(names.begin(), names.end(), main) == names.end()) {
        throw CommandError("the main object must be one of the objects that are replaced");
    }
    bool const ofPieces = names.size() > 1 || isComposite(data, *findObject(level, main));
    return {fmt::format("Replace {} by {}", objectsInWords(names), part),
            [&data, names, main, part, ofPieces](Json& tree) {
                // Joints and connections among these objects only are in the part now.
                Json const inside = subsetOf(data, tree, names);
                for (char const* const key : {"joints", "connections"}) {
                    if (!inside.contains(key)) {
                        continue;
                    }
                    Json kept = Json::array();
                    for (Json const& entry : tree[key]) {
                        if (std::find(inside[key].begin(), inside[key].end(), entry) == inside[key].end()) {
                            kept.push_back(entry);
                        }
                    }
                    tree[key] = std::move(kept);
                    dropIfEmpty(tree, key);
                }
                std::vector<std::string> others;
                std::copy_if(names.begin(), names.end(), std::back_inserter(others),
                             [&](std::string const& name) { return name != main; });
                removeEntries(data, tree, others);
                Json& entry = objectEntry(tree, main);
                setObjectMember(entry, "part", part);
                entry.erase("properties");
                if (ofPieces) { // a composite part keeps how its objects lie
                    setAngle(entry, 0);
                    entry.erase("flipped");
                    entry.erase("pieces");
                }
            },
            {main}};
}

} // namespace trembler::edit
