#include "insight/probe/watch.hpp"

#include "runtime/level/json/suggestion.hpp"
#include "runtime/population/birth_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace trembler::watch {
namespace {

/// Reads one field of the visited value; in a list, of one element or of the entries of one object.
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
        if (isIt(info) && field_.component == lengthComponent) {
            lengthSum_ += value; // of the sum, where several entries add up
            cells_[0] = length(field_.adds ? lengthSum_ : value);
        } else if (isIt(info) && field_.component >= 0) {
            put(0, field_.component == 0 ? value.x : value.y);
        } else if (isIt(info)) {
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
        if (owner_ == Owner::sought) {
            owner_ = value == object_ ? Owner::asked : Owner::other;
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
        if (isIt(info)) {
            put(0, static_cast<double>(list.size()));
        } else if (depth_ < field_.lists.size() && info.key == field_.lists[depth_].key && isOwn()) {
            ListStep const& step = field_.lists[depth_];
            ++depth_;
            if (step.ofObject) {
                visitEntries(list);
            } else if (step.element < list.size()) {
                list.visitElement(step.element, *this);
            }
            --depth_;
        }
    }

private:
    enum class Owner {
        none,   ///< not in an entry
        sought, ///< at the beginning of an entry
        asked,  ///< in an entry of the object
        other,  ///< in another object's entry
    };

    void visitEntries(ListField& list) {
        bool done = false;
        for (std::size_t i = 0; i < list.size() && !done; ++i) {
            owner_ = Owner::sought;
            list.visitElement(i, *this);
            done = owner_ == Owner::asked && !field_.adds;
        }
        owner_ = Owner::none;
    }
    [[nodiscard]] bool isOwn() const { return owner_ == Owner::none || owner_ == Owner::asked; }
    [[nodiscard]] bool isIt(FieldInfo const& info) const {
        return depth_ == field_.lists.size() && info.key == field_.key && isOwn();
    }
    void put(std::size_t column, double value) {
        double const* const before = field_.adds ? std::get_if<double>(&cells_[column]) : nullptr;
        cells_[column] = before == nullptr ? value : *before + value;
    }

    WatchedField const& field_;
    World const& world_;
    ObjectId object_;
    std::vector<Cell>& cells_;
    std::size_t depth_ = 0; // of field_.lists that have been entered
    Owner owner_ = Owner::none;
    Vec2 lengthSum_; // of the entries so far
};

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
        throw std::invalid_argument(fmt::format("'{}' does not name a field of an object; expected "
                                                "OBJECT.FIELD, for example lamp.current or world.gravity",
                                                what));
    }
    std::string name(what.substr(0, first));
    if (isBirthName(name)) {
        return name;
    }
    auto const names = objectNames(world);
    throw std::invalid_argument(fmt::format("there is no object '{}'{}; the objects are: {}", name,
                                            didYouMean(name, names), listed(names)));
}

std::vector<std::string> namesOf(std::vector<WatchedField const*> const& fields) {
    std::vector<std::string> names;
    for (WatchedField const* field : fields) {
        names.push_back(field->name());
    }
    return names;
}

/// The name of a field without its numbers, as WatchedField::name() has it: "shape.2.width" is
/// "shape.0.width" and the element 2.
struct Address {
    std::string name;
    std::vector<std::size_t> elements;
};

Address addressOf(std::string_view word) {
    Address address;
    for (std::size_t begin = 0; begin <= word.size();) {
        std::size_t const end = std::min(word.find('.', begin), word.size());
        std::string_view const step = word.substr(begin, end - begin);
        std::size_t element = 0;
        auto const [stop, error] = std::from_chars(step.data(), step.data() + step.size(), element);
        bool const isNumber = error == std::errc{} && stop == step.data() + step.size();
        if (isNumber) {
            address.elements.push_back(element);
        }
        address.name += begin == 0 ? "" : ".";
        address.name += isNumber ? "0" : step;
        begin = end + 1;
    }
    return address;
}

/// The component that a word names in its last step: 0 for ".x", 1 for ".y", that of ".length", else -1.
int componentOf(std::string_view word) {
    return word.ends_with(".x")        ? 0
           : word.ends_with(".y")      ? 1
           : word.ends_with(".length") ? lengthComponent
                                       : -1;
}

/// The fields that a word names, among the fields that the object may have.
std::vector<WatchedField const*> fieldsOf(World const& world, std::vector<WatchedField> const& fields,
                                          std::string const& object, std::string const& word) {
    bool const isThere = world.store().find(object).valid();
    std::vector<WatchedField const*> named;
    std::vector<WatchedField const*> known;
    for (WatchedField const& field : fields) {
        bool const mayConcern =
            field.property->kind == PropertyKind::object || field.ofWorld() == (object == "world");
        if (mayConcern && field.isNamed(word)) {
            named.push_back(&field);
        } else if (field.isKnownAs(word) && (isThere ? concerns(world, field, object) : mayConcern)) {
            known.push_back(&field);
        }
    }
    return named.empty() ? known : named;
}

/// Everyday words, and the keys of fields that are called otherwise.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> everydayWords{
    {{"voltage", "potential"}, {"volts", "potential"}, {"amperes", "current"}, {"watts", "power"}}};

std::string_view keyFor(std::string_view word) {
    auto const known = std::find_if(everydayWords.begin(), everydayWords.end(),
                                    [word](auto const& each) { return each.first == word; });
    return known == everydayWords.end() ? word : known->second;
}

/// Refuses a word that names no field, with the names of fields that may be meant.
[[noreturn]] void refuse(World const& world, std::vector<WatchedField> const& fields,
                         std::string const& object, std::string_view word) {
    std::string_view const last = word.substr(word.rfind('.') + 1); // all of it if there is no dot
    std::vector<std::string> names;
    std::vector<std::string> numbered;
    std::vector<std::string> near;
    std::vector<std::string> words;
    for (WatchedField const& field : fields) {
        if (!concerns(world, field, object)) {
            continue;
        }
        std::string const name = field.name();
        (field.numbered() ? numbered : names).push_back(name);
        words.insert(words.end(), {name, field.spokenName()});
        if (!field.numbered()) {
            words.push_back(field.key);
        }
        if (name.starts_with(fmt::format("{}.", word)) || field.key == last || field.key == keyFor(last)) {
            near.push_back(name);
        }
    }
    names.insert(names.end(), numbered.begin(), numbered.end());
    std::string const hint = near.empty() ? didYouMean(word, words) : fmt::format("; see {}", listed(near));
    throw std::invalid_argument(
        fmt::format("'{}' has nothing called '{}'{}; it has: {}", object, word, hint, listed(names)));
}

} // namespace

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

std::size_t Watch::columns() const {
    return field_.type == FieldType::vector && field_.component < 0 ? 2 : 1;
}

std::vector<std::string> Watch::headers() const {
    std::string const unit = field_.unit.empty() ? "" : fmt::format(" [{}]", field_.unit);
    return columns() == 2 ? std::vector{asked_ + ".x" + unit, asked_ + ".y" + unit}
                          : std::vector{asked_ + unit};
}

std::vector<Cell> Watch::read(World const& world) const {
    std::vector<Cell> cells(columns());
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
    Address address = addressOf(word);
    std::vector<WatchedField const*> found = fieldsOf(world, fields, object, address.name);
    int component = -1;
    if (found.empty() && componentOf(word) >= 0) {
        component = componentOf(word);
        found = fieldsOf(world, fields, object, address.name.substr(0, address.name.rfind('.')));
        std::erase_if(found, [](WatchedField const* field) { return field->type != FieldType::vector; });
    }
    if (found.empty()) {
        refuse(world, fields, object, word);
    }
    if (found.size() > 1) {
        throw std::invalid_argument(
            fmt::format("'{}' of '{}' may mean any of these: {}", word, object, listed(namesOf(found))));
    }
    WatchedField field = *found.front();
    field.component = component;
    auto element = address.elements.begin();
    for (ListStep& step : field.lists) {
        if (!step.ofObject && element != address.elements.end()) {
            step.element = *element++;
        }
    }
    return {std::string(what), object, std::move(field)};
}

} // namespace trembler::watch
