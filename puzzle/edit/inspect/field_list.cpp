#include "puzzle/edit/inspect/field_list.hpp"

#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trembler::edit {
namespace {

/// "motor_speed_deg" -> "Motor speed".
std::string nameForPeople(std::string_view key) {
    std::string name(key.ends_with("_deg") ? key.substr(0, key.size() - 4) : key);
    for (char& c : name) {
        c = c == '_' ? ' ' : c;
    }
    if (!name.empty() && name.front() >= 'a' && name.front() <= 'z') {
        name.front() = static_cast<char>(name.front() - 'a' + 'A');
    }
    return name;
}

std::string unitForPeople(std::string_view unit) {
    return unit == "rad" ? "°" : (unit == "rad/s" ? "°/s" : std::string(unit));
}

/// The names that a field may refer to.
struct NamesToChoose {
    GameData const& data;
    Json const& level;

    [[nodiscard]] std::vector<std::string> of(FieldInfo const& info) const {
        return info.key.starts_with("joint_") ? joints() : namesOfObjectsAndPieces(data, level);
    }
    /// Joints are referred to by names that they state.
    [[nodiscard]] std::vector<std::string> joints() const {
        std::vector<std::string> names;
        Json const* const list = findList(level, "joints");
        for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
            if (std::string name = textOf((*list)[i], "name"); !name.empty()) {
                names.push_back(std::move(name));
            }
        }
        return names;
    }
};

/// Lists every field that it visits, with the file's statement about it.
class FieldLister final : public FieldVisitor {
public:
    FieldLister(NamesToChoose const& choices, NameTable const& names, Json const* stated, std::string around,
                bool bare)
        : choices_(choices), names_(names), stated_(stated), around_(std::move(around)), bare_(bare) {}

    std::vector<InspectedField> fields;

    void boolean(FieldInfo const& info, bool& value) override { add(info, FieldType::boolean, value); }
    void integer(FieldInfo const& info, std::int32_t& value) override {
        add(info, FieldType::integer, value);
    }
    void number(FieldInfo const& info, double& value) override {
        add(info, FieldType::number, inFile(info, value));
    }
    void vector(FieldInfo const& info, Vec2& value) override {
        add(info, FieldType::vector, Json::array({inFile(info, value.x), inFile(info, value.y)}));
    }
    void text(FieldInfo const& info, std::string& value) override { add(info, FieldType::text, value); }
    void object(FieldInfo const& info, ObjectId& value) override {
        std::string const name = names_.nameOf(value);
        add(info, FieldType::object, name.empty() ? Json() : Json(name)).choices = choices_.of(info);
    }
    void choice(FieldInfo const& info, ChoiceField field) override {
        add(info, FieldType::choice, field.names[static_cast<std::size_t>(field.index)])
            .choices.assign(field.names.begin(), field.names.end());
    }
    void list(FieldInfo const& info, ListField& field) override {
        Json const* const here = statedFor(info);
        InspectedField& made = add(info, FieldType::list, here == nullptr ? Json::array() : *here);
        std::string const place = made.place;
        std::vector<InspectedField> entries;
        for (std::size_t i = 0; i < field.size(); ++i) {
            bool const struct_ = field.elementsHaveFields();
            Json const* const entry =
                here != nullptr && here->is_array() && i < here->size() ? &(*here)[i] : nullptr;
            std::string const inner = fmt::format("{}/{}", place, i);
            FieldLister lister(choices_, names_, entry, inner, !struct_);
            lister.listInfo_ = struct_ ? nullptr : &info;
            field.visitElement(i, lister);
            if (!struct_ && !lister.fields.empty()) {
                lister.fields.front().name = fmt::format("{}", i + 1);
                entries.push_back(std::move(lister.fields.front()));
                continue;
            }
            InspectedField whole{inner, fmt::format("{}", i + 1), {}, std::string(info.meaning)};
            whole.type = FieldType::list;
            whole.stated = entry != nullptr;
            whole.value = entry == nullptr ? Json() : *entry;
            whole.entries = std::move(lister.fields);
            entries.push_back(std::move(whole));
        }
        fields.back().entries = std::move(entries);
    }

private:
    /// An entry without fields has the range and the unit of its list.
    [[nodiscard]] FieldInfo const& limits(FieldInfo const& info) const {
        return listInfo_ == nullptr ? info : *listInfo_;
    }
    [[nodiscard]] Json inFile(FieldInfo const& info, double value) const {
        double const shown = isAngle(limits(info).unit) ? degrees(value) : value;
        bool const whole = std::abs(shown) < 1e15 && shown == std::floor(shown);
        return whole ? Json(static_cast<std::int64_t>(shown)) : Json(shown);
    }
    [[nodiscard]] Json const* statedFor(FieldInfo const& info) const {
        if (bare_ || stated_ == nullptr) {
            return stated_;
        }
        auto const found = stated_->is_object() ? stated_->find(std::string(info.key)) : stated_->end();
        return stated_->is_object() && found != stated_->end() ? &*found : nullptr;
    }
    InspectedField& add(FieldInfo const& stated, FieldType type, Json value) {
        FieldInfo const& info = limits(stated);
        InspectedField field{bare_ ? around_ : around_ + "/" + std::string(stated.key),
                             nameForPeople(stated.key), unitForPeople(info.unit), std::string(info.meaning)};
        bool const turned = isAngle(info.unit);
        field.type = type;
        field.minimum = turned ? degrees(info.minimum) : info.minimum;
        field.maximum = turned ? degrees(info.maximum) : info.maximum;
        field.minimumExcluded = info.minimumExcluded;
        field.required = stated.required;
        field.stated = statedFor(stated) != nullptr;
        field.value = std::move(value);
        fields.push_back(std::move(field));
        return fields.back();
    }

    NamesToChoose const& choices_;
    NameTable const& names_;
    Json const* stated_;
    std::string around_;
    bool bare_;
    FieldInfo const* listInfo_ = nullptr;
};

/// Fills in the values that the fields have if they are not stated. Entries of lists are matched by their
/// place.
void addInitials(std::vector<InspectedField>& fields, std::vector<InspectedField> const& initial) {
    for (InspectedField& field : fields) {
        for (InspectedField const& other : initial) {
            if (other.place == field.place && !field.required) {
                field.initial = other.value;
            }
        }
    }
}

} // namespace

std::optional<std::vector<InspectedField>> fieldsOf(GameData const& data, Json const& level,
                                                    PropertyInfo const& info, Json const& value) {
    NameTable names;
    auto read = value.is_null() ? info.makeValue() : readValue(info, value, names);
    if (!read) {
        return std::nullopt;
    }
    NamesToChoose const choices{data, level};
    auto initialValue = info.makeValue();
    bool const bare = isBare(outlineOf(*initialValue));
    FieldLister lister(choices, names, value.is_null() ? nullptr : &value, "", bare);
    read->visit(lister);
    FieldLister initial(choices, names, nullptr, "", bare);
    initialValue->visit(initial);
    addInitials(lister.fields, initial.fields);
    if (bare && !lister.fields.empty()) {
        lister.fields.front().name = std::string(info.text.name);
    }
    return std::move(lister.fields);
}

bool isMarker(PropertyInfo const& info) {
    auto const value = info.makeValue();
    return outlineOf(*value).empty();
}

} // namespace trembler::edit
