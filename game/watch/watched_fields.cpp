#include "game/watch/watched_fields.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace trembler::watch {
namespace {

bool isScalar(FieldType type) {
    return type != FieldType::list;
}

std::string shownUnit(std::string_view unit) {
    return unit == "rad" ? "deg" : unit == "rad/s" ? "deg/s" : std::string(unit);
}

/// Collects the fields of a value and those of the entries in its lists.
class Gatherer final : public FieldVisitor {
public:
    Gatherer(PropertyInfo const& property, std::vector<WatchedField>& into)
        : property_(property), into_(into) {}

    void boolean(FieldInfo const& info, bool&) override { add(info, FieldType::boolean); }
    void integer(FieldInfo const& info, std::int32_t&) override { add(info, FieldType::integer); }
    void number(FieldInfo const& info, double&) override { add(info, FieldType::number); }
    void vector(FieldInfo const& info, Vec2&) override { add(info, FieldType::vector); }
    void text(FieldInfo const& info, std::string&) override { add(info, FieldType::text); }
    void object(FieldInfo const& info, ObjectId&) override { add(info, FieldType::object); }
    void choice(FieldInfo const& info, ChoiceField) override { add(info, FieldType::choice); }
    void list(FieldInfo const& info, ListField& field) override {
        if (property_.kind == PropertyKind::object || !list_.empty() || !field.elementsHaveFields()) {
            return;
        }
        field.resize(1); // of a copy, to visit the fields of one element
        std::vector<WatchedField> found;
        Gatherer entry(property_, found);
        entry.list_ = info.key;
        field.visitElement(0, entry);
        if (!found.empty() && found.front().type == FieldType::object) {
            into_.insert(into_.end(), found.begin() + 1, found.end());
        }
    }

private:
    void add(FieldInfo const& info, FieldType type) {
        if (isScalar(type)) {
            into_.push_back(
                {&property_, list_, std::string(info.key), type, shownUnit(info.unit), info.adds});
        }
    }

    PropertyInfo const& property_;
    std::vector<WatchedField>& into_;
    std::string list_;
};

/// "Angular velocity" as a key in a file: "angular_velocity".
std::string asWord(std::string_view name) {
    std::string word;
    for (char const c : name) {
        word += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return word;
}

std::string joined(std::string_view property, std::string const& key) {
    return std::string(property) + (key == "value" ? "" : "." + key);
}

} // namespace

std::string WatchedField::name() const {
    return joined(property->text.key, key);
}

std::string WatchedField::spokenName() const {
    return joined(asWord(property->text.name), key);
}

std::vector<WatchedField> watchedFields(Registry const& registry) {
    std::map<std::string_view, PropertyInfo const*> properties;
    for (PropertyInfo const* info : registry.objectProperties()) {
        properties.emplace(info->text.key, info);
    }
    for (Registration const& registration : registry.components()) {
        for (PropertyInfo const* info : registration.info->offers) {
            properties.emplace(info->text.key, info);
        }
    }
    std::vector<WatchedField> all;
    for (auto const& [key, info] : properties) {
        Gatherer gatherer(*info, all);
        if (info->kind == PropertyKind::object) {
            info->makeValue()->visit(gatherer);
        } else {
            info->makeSlot()->visitCopy(gatherer);
        }
    }
    return all;
}

} // namespace trembler::watch
