#include "game/watch/watch.hpp"

#include "runtime/level/json/suggestion.hpp"
#include "runtime/population/birth_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace trembler::watch {
namespace {

/// Reads one field of the visited value; for a list, from the entries of one object.
class Reader final : public FieldVisitor {
public:
    Reader(WatchedField const& field, World const& world, ObjectId object, std::vector<Cell>& cells)
        : field_(field), world_(world), object_(object), cells_(cells) {}

    void boolean(FieldInfo const& info, bool& value) override {
        if (isIt(info)) {
            put(0, value ? 1.0 : 0.0);
        }
    }
    void integer(FieldInfo const& info, std::int32_t& value) override {
        if (isIt(info)) {
            put(0, value);
        }
    }
    void number(FieldInfo const& info, double& value) override {
        if (isIt(info)) {
            put(0, isAngle(info.unit) ? value * (180 / pi) : value);
        }
    }
    void vector(FieldInfo const& info, Vec2& value) override {
        if (isIt(info)) {
            put(0, value.x);
            put(1, value.y);
        }
    }
    void text(FieldInfo const& info, std::string& value) override {
        if (isIt(info)) {
            cells_[0] = value;
        }
    }
    void object(FieldInfo const& info, ObjectId& value) override {
        if (inEntry_ && !ownerSeen_) {
            ownerSeen_ = true;
            mine_ = value == object_;
        } else if (isIt(info) && value.valid()) {
            cells_[0] = world_.store().nameOf(value);
        }
    }
    void choice(FieldInfo const& info, ChoiceField choice) override {
        if (isIt(info)) {
            cells_[0] = std::string(choice.names[static_cast<std::size_t>(choice.index)]);
        }
    }
    void list(FieldInfo const& info, ListField& list) override {
        if (inEntry_ || info.key != field_.list) {
            return;
        }
        inEntry_ = true;
        for (std::size_t i = 0; i < list.size() && !done_; ++i) {
            ownerSeen_ = mine_ = false;
            list.visitElement(i, *this);
            done_ = mine_ && !field_.adds;
        }
        inEntry_ = false;
    }

private:
    [[nodiscard]] bool isIt(FieldInfo const& info) const {
        return field_.list.empty() ? !inEntry_ && info.key == field_.key
                                   : inEntry_ && mine_ && info.key == field_.key;
    }
    void put(std::size_t column, double value) {
        double const* const before = field_.adds ? std::get_if<double>(&cells_[column]) : nullptr;
        cells_[column] = before == nullptr ? value : *before + value;
    }

    WatchedField const& field_;
    World const& world_;
    ObjectId object_;
    std::vector<Cell>& cells_;
    bool inEntry_ = false;
    bool ownerSeen_ = false;
    bool mine_ = false;
    bool done_ = false;
};

/// Whether an object of this name can have the field, as far as is known at the start of the run.
bool concerns(World const& world, WatchedField const& field, std::string const& object) {
    if (field.property->kind != PropertyKind::object) {
        return field.ofWorld() == (object == "world");
    }
    ColumnBase const* const column = world.store().findColumn(*field.property);
    return column != nullptr && column->has(world.store().find(object));
}

std::vector<std::string> objectNames(World const& world) {
    std::vector<std::string> names;
    ObjectTable const& objects = world.store().objects();
    for (std::uint32_t index = 0; index < objects.indexBound(); ++index) {
        if (ObjectId const id = objects.at(index); id.valid()) {
            names.push_back(world.store().nameOf(id));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// The object's name in "OBJECT.FIELD". Names may contain dots, so the longest existing name is taken. An
/// object that does not exist yet may be created while the level runs if its name has the form of generated
/// names.
std::string objectIn(World const& world, std::string_view what) {
    for (std::size_t at = what.rfind('.'); at != std::string_view::npos && at > 0;
         at = what.rfind('.', at - 1)) {
        std::string name(what.substr(0, at));
        if (world.store().find(name).valid()) {
            return name;
        }
    }
    std::size_t const first = what.find('.');
    if (first == std::string_view::npos || first == 0 || first + 1 == what.size()) {
        throw std::invalid_argument(
            fmt::format("'{}' does not say what of which object; expected OBJECT.FIELD, "
                        "for example lamp.current or world.gravity",
                        what));
    }
    std::string name(what.substr(0, first));
    if (isBirthName(name)) {
        return name;
    }
    auto const names = objectNames(world);
    throw std::invalid_argument(fmt::format("there is no object '{}'{}; there are: {}", name,
                                            didYouMean(name, names), listed(names)));
}

std::vector<std::string> namesOf(std::vector<WatchedField const*> const& fields) {
    std::vector<std::string> names;
    for (WatchedField const* field : fields) {
        names.push_back(field->name());
    }
    return names;
}

} // namespace

std::vector<std::string> Watch::headers() const {
    std::string const unit = field_.unit.empty() ? "" : fmt::format(" [{}]", field_.unit);
    return field_.type == FieldType::vector ? std::vector{asked_ + ".x" + unit, asked_ + ".y" + unit}
                                            : std::vector{asked_ + unit};
}

std::vector<Cell> Watch::read(World const& world) const {
    std::vector<Cell> cells(field_.type == FieldType::vector ? 2 : 1);
    ObjectId const id = world.store().find(object_);
    Reader reader(field_, world, id, cells);
    if (field_.property->kind == PropertyKind::object) {
        ColumnBase const* const column = world.store().findColumn(*field_.property);
        if (column != nullptr && id.valid() && column->has(id)) {
            column->visitCopy(id, reader);
        }
    } else if (SlotBase const* const slot = world.store().findSlot(*field_.property);
               slot != nullptr && (id.valid() || field_.ofWorld())) {
        slot->visitCopy(reader);
    }
    return cells;
}

Watch find(World const& world, std::vector<WatchedField> const& fields, std::string_view what) {
    std::string const object = objectIn(world, what);
    std::string_view const word = what.substr(std::min(object.size() + 1, what.size()));
    bool const isThere = world.store().find(object).valid();
    std::vector<WatchedField const*> named;
    std::vector<WatchedField const*> known;
    std::vector<std::string> names;
    std::vector<std::string> words;
    for (WatchedField const& field : fields) {
        bool const concerned = concerns(world, field, object);
        bool const mayConcern =
            field.property->kind == PropertyKind::object || field.ofWorld() == (object == "world");
        if (field.isNamed(word) && mayConcern) {
            named.push_back(&field);
        } else if (field.isKnownAs(word) && (concerned || (!isThere && mayConcern))) {
            known.push_back(&field);
        }
        if (concerned) {
            names.push_back(field.name());
            words.insert(words.end(), {field.name(), field.spokenName(), field.key});
        }
    }
    auto const& found = named.empty() ? known : named;
    if (found.size() == 1) {
        return {std::string(what), object, *found.front()};
    }
    if (!found.empty()) {
        auto const all = namesOf(found);
        throw std::invalid_argument(
            fmt::format("'{}' of '{}' may mean any of these: {}", word, object, listed(all)));
    }
    throw std::invalid_argument(fmt::format("'{}' has nothing called '{}'{}; it has: {}", object, word,
                                            didYouMean(word, words), listed(names)));
}

} // namespace trembler::watch
