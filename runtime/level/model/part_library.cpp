#include "runtime/level/model/part_library.hpp"

#include "runtime/level/json/refuse_file.hpp"
#include "runtime/object/without.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler {
Prototype PartDefinition::prototype() const {
    Prototype made;
    made.name = name;
    made.composite = composite();
    Without without;
    for (PropertySet::Entry const& entry : properties.entries()) {
        if (entry.value) {
            made.values.push_back(entry.value->clone());
        } else {
            without.keys.emplace_back(entry.info->text.key); // ascending, as the entries are
        }
    }
    if (!without.keys.empty()) {
        made.values.push_back(std::make_unique<ValueOf<Without>>(std::move(without)));
    }
    return made;
}

void PartLibrary::add(PartDefinition part) {
    auto const at = parts_.find(part.name);
    if (at != parts_.end()) {
        std::string const other = at->second.document ? at->second.document->file() : "another";
        std::string const message = fmt::format("there is already a part '{}', in {}", part.name, other);
        if (part.document) {
            throw InputError({part.document->diagnostic("/name", message, "a unique name")});
        }
        refuseFile("(part)", message, "");
    }
    std::string const name = part.name;
    parts_.emplace(name, std::move(part));
}

PartDefinition const* PartLibrary::find(std::string const& name) const {
    auto const at = parts_.find(name);
    return at == parts_.end() ? nullptr : &at->second;
}

std::vector<PartDefinition const*> PartLibrary::all() const {
    std::vector<PartDefinition const*> all;
    for (auto const& [name, part] : parts_) {
        all.push_back(&part);
    }
    return all;
}

std::vector<std::string> PartLibrary::names() const {
    std::vector<std::string> names;
    for (auto const& [name, part] : parts_) {
        names.push_back(name);
    }
    return names;
}

} // namespace trembler
