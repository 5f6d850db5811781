#include "runtime/notation/boxes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

std::string objectsWith(std::vector<PropertyInfo const*> const& all,
                        std::vector<PropertyInfo const*> const& any) {
    return any.empty() ? "objects with all of " + propertySet(all)
                       : "objects with any of " + propertySet(any);
}

std::string withAll(std::vector<PropertyInfo const*> const& properties) {
    return properties.empty() ? std::string("every object") : objectsWith(properties, {});
}

bool sameSet(std::vector<PropertyInfo const*> a, std::vector<PropertyInfo const*> b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
}

// One line for each field of a property.
class FieldLines final : public FieldVisitor {
public:
    explicit FieldLines(NotationBox& box) : box_(box) {}
    void boolean(FieldInfo const& info, bool&) override { add(info, "true or false"); }
    void integer(FieldInfo const& info, std::int32_t&) override { add(info, "integer"); }
    void number(FieldInfo const& info, double&) override { add(info, "number"); }
    void vector(FieldInfo const& info, Vec2&) override { add(info, "vector"); }
    void text(FieldInfo const& info, std::string&) override { add(info, "text"); }
    void object(FieldInfo const& info, ObjectId&) override { add(info, "object"); }
    void choice(FieldInfo const& info, ChoiceField field) override {
        std::string names;
        for (std::string_view const name : field.names) {
            names += (names.empty() ? "" : ", ") + std::string(name);
        }
        add(info, "one of " + names);
    }
    void list(FieldInfo const& info, ListField&) override { add(info, "list"); }

private:
    void add(FieldInfo const& info, std::string const& type) {
        std::string const unit = info.unit.empty() ? "" : fmt::format(" in {}", info.unit);
        box_.rows.push_back({std::string(info.key), fmt::format("{}{}: {}", type, unit, info.meaning)});
    }
    NotationBox& box_;
};

} // namespace

std::vector<PropertyInfo const*> allRead(ComponentInfo const& info) {
    std::vector<PropertyInfo const*> all = info.writes;
    for (PropertyInfo const* read : info.reads) {
        if (std::find(all.begin(), all.end(), read) == all.end()) {
            all.push_back(read);
        }
    }
    return all;
}

std::string propertySet(std::vector<PropertyInfo const*> const& properties) {
    if (properties.empty()) {
        return "∅";
    }
    std::string text = "{";
    for (std::size_t i = 0; i < properties.size(); ++i) {
        text += (i == 0 ? "" : ", ") + std::string(properties[i]->text.name);
    }
    return text + "}";
}

std::string activation(ComponentInfo const& info) {
    if (info.pairs) {
        return fmt::format("pairs of {} and {}", withAll(info.pairs->first), withAll(info.pairs->second));
    }
    std::string const demand = info.onDemand ? ", while the properties that it offers are read" : "";
    bool const always = info.neededAll.empty() && info.neededAny.empty();
    return (always ? "every scene" : objectsWith(info.neededAll, info.neededAny)) + demand;
}

std::string shortcutNote(Registry const& registry, ComponentInfo const& info) {
    std::string places;
    for (Shortcut const& shortcut : registry.shortcuts()) {
        for (Registration const& other : registry.components()) {
            if (shortcut.interaction == info.type && shortcut.dps == other.info->type) {
                places += (places.empty() ? "directly after the " : " or the ") + title(*other.info);
            }
        }
    }
    return places.empty() ? places : places + " (shortcut of 5.7.3)";
}

NotationBox boxOf(Registry const& registry, ComponentInfo const& info) {
    NotationBox box{title(info), {}, info.calls};
    std::vector<PropertyInfo const*> const read = allRead(info);
    switch (info.kind) {
    case ComponentKind::resolver:
        box.rows.push_back({"Resolver properties", propertySet(info.offers)});
        box.rows.push_back({"Properties read", info.writesEverything ? "everything" : propertySet(read)});
        box.rows.push_back(
            {"Properties written", info.writesEverything || (!read.empty() && sameSet(read, info.writes))
                                       ? fmt::format("≡ read({})", title(info))
                                       : propertySet(info.writes)});
        box.rows.push_back({"Work on advance()", std::string(info.text.work)});
        break;
    case ComponentKind::dps:
        box.rows.push_back({"Properties read", propertySet(read)});
        box.rows.push_back({"Derived properties", propertySet(info.offers)});
        box.rows.push_back({"Work on update()", std::string(info.text.work)});
        break;
    case ComponentKind::interaction:
        box.rows.push_back({"Properties read", propertySet(read)});
        box.rows.push_back({"Calls", std::string(info.roleName) + " Resolver"});
        box.rows.push_back({"Work on apply()", std::string(info.text.work)});
        if (std::string const note = shortcutNote(registry, info); !note.empty()) {
            box.rows.push_back({"Runs", note});
        }
        if (info.inSetup) {
            box.rows.push_back({"Runs", "in the setup, too, before the first advance (frame 0)"});
        }
        break;
    }
    if (!info.text.level.empty()) {
        box.rows.push_back({"Detail level", fmt::format("{} = {}", info.text.effect, info.text.level)});
    }
    if (info.pairs) {
        box.rows.push_back({"Pairs of", withAll(info.pairs->first)});
        box.rows.push_back({"and of", withAll(info.pairs->second)});
    } else {
        box.rows.push_back({"Activated by", activation(info)});
    }
    return box;
}

NotationBox boxOf(CompletionInfo const& info) {
    bool const always = info.neededAll.empty() && info.neededAny.empty();
    return {title(info),
            {{"Properties read", propertySet(info.reads)},
             {"Properties added", propertySet(info.adds)},
             {"Work on complete()", std::string(info.text.work)},
             {"Activated by", always ? "every object" : objectsWith(info.neededAll, info.neededAny)}}};
}

NotationBox boxOf(PropertyInfo const& info) {
    NotationBox box{std::string(info.text.name) + " Property", {{"", std::string(info.text.meaning)}}};
    if (info.makeValue != nullptr) {
        FieldLines lines(box);
        info.makeValue()->visit(lines);
    }
    return box;
}

} // namespace trembler
