#include "insight/probe/watched_fields.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace trembler::watch {
namespace {

std::string shownUnit(std::string_view unit) {
    return unit == "rad" ? "deg" : unit == "rad/s" ? "deg/s" : std::string(unit);
}

class Gatherer;

/// Gathers the fields that visit(visitor) shows, with all their choices.
template <class Visit>
void gather(PropertyInfo const& property, std::vector<ListStep> const& lists, std::vector<WatchedField>& into,
            Visit&& visit);

/// Collects the fields of a value and those of the elements in its lists. The fields that are present may
/// depend on choices, so it sets each choice to the value number `option`; see gather().
class Gatherer final : public FieldVisitor {
public:
    Gatherer(PropertyInfo const& property, std::vector<ListStep> const& lists, std::size_t option,
             std::vector<WatchedField>& into)
        : property_(property), lists_(lists), option_(option), into_(into) {}

    /// The greatest number of values that a visited choice has, at least 1.
    [[nodiscard]] std::size_t options() const { return options_; }

    void boolean(FieldInfo const& info, bool&) override { add(info, FieldType::boolean); }
    void integer(FieldInfo const& info, std::int32_t&) override { add(info, FieldType::integer); }
    void number(FieldInfo const& info, double&) override { add(info, FieldType::number); }
    void vector(FieldInfo const& info, Vec2&) override { add(info, FieldType::vector); }
    void text(FieldInfo const& info, std::string&) override { add(info, FieldType::text); }
    void object(FieldInfo const& info, ObjectId&) override { add(info, FieldType::object); }
    void choice(FieldInfo const& info, ChoiceField field) override {
        add(info, FieldType::choice);
        options_ = std::max(options_, field.names.size());
        field.index = static_cast<int>(option_ % field.names.size());
    }
    void list(FieldInfo const& info, ListField& field) override {
        add(info, FieldType::list);
        field.resize(1); // of a copy, to visit the fields of one element
        auto const visit = [&field](FieldVisitor& visitor) { field.visitElement(0, visitor); };
        ListStep step{.key = std::string(info.key)};
        if (property_.kind != PropertyKind::object && lists_.empty()) {
            step.ofObject = true;
            std::vector<WatchedField> found;
            gather(property_, {step}, found, visit);
            if (!found.empty() && found.front().type == FieldType::object && found.front().key == "object") {
                into_.insert(into_.end(), found.begin() + 1, found.end());
            }
            step.ofObject = false;
        }
        std::vector<ListStep> deeper = lists_;
        deeper.push_back(step);
        gather(property_, deeper, into_, visit);
    }

private:
    void add(FieldInfo const& info, FieldType type) {
        bool const known = std::any_of(into_.begin(), into_.end(), [&](WatchedField const& field) {
            return field.property == &property_ && field.lists == lists_ && field.key == info.key;
        });
        if (!known) {
            into_.push_back({&property_, lists_, std::string(info.key), type,
                             type == FieldType::list ? std::string() : shownUnit(info.unit), info.adds});
        }
    }

    PropertyInfo const& property_;
    std::vector<ListStep> const& lists_;
    std::size_t option_;
    std::size_t options_ = 1;
    std::vector<WatchedField>& into_;
};

template <class Visit>
void gather(PropertyInfo const& property, std::vector<ListStep> const& lists, std::vector<WatchedField>& into,
            Visit&& visit) {
    std::size_t options = 1;
    for (std::size_t option = 0; option < options; ++option) {
        Gatherer gatherer(property, lists, option, into);
        visit(gatherer);
        options = std::max(options, gatherer.options());
    }
}

/// "Angular velocity" as a key in a file: "angular_velocity".
std::string asWord(std::string_view name) {
    std::string word;
    for (char const c : name) {
        word += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return word;
}

std::string joined(std::string name, WatchedField const& field) {
    auto const append = [&name](std::string const& key) {
        if (key != "value") {
            name += "." + key;
        }
    };
    for (ListStep const& step : field.lists) {
        if (!step.ofObject) {
            append(step.key);
            name += "." + std::to_string(step.element);
        }
    }
    append(field.key);
    return field.type == FieldType::list ? name + ".count" : name;
}

} // namespace

std::string WatchedField::name() const {
    return joined(std::string(property->text.key), *this);
}

std::string WatchedField::spokenName() const {
    return joined(asWord(property->text.name), *this);
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
        gather(*info, {}, all, [info = info](FieldVisitor& visitor) {
            if (info->kind == PropertyKind::object) {
                info->makeValue()->visit(visitor);
            } else {
                info->makeSlot()->visitCopy(visitor);
            }
        });
    }
    return all;
}

} // namespace trembler::watch
