#include "runtime/level/property/property_writer.hpp"

#include "runtime/level/property/field_outline.hpp"
#include "runtime/property/idle_visitor.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

/// Writes every field that it visits.
class FieldWriter final : public FieldVisitor {
public:
    /// `names` are the names of the objects that fields refer to.
    explicit FieldWriter(NameTable const& names) : names_(names) {}

    Json out = Json::object();

    void boolean(FieldInfo const& info, bool& value) override { put(info, value); }
    void integer(FieldInfo const& info, std::int32_t& value) override { put(info, value); }
    void number(FieldInfo const& info, double& value) override { put(info, stated(info, value)); }
    void vector(FieldInfo const& info, Vec2& value) override {
        put(info, Json::array({stated(info, value.x), stated(info, value.y)}));
    }
    void text(FieldInfo const& info, std::string& value) override { put(info, value); }
    void object(FieldInfo const& info, ObjectId& value) override {
        std::string const name = names_.nameOf(value);
        put(info, name.empty() ? Json(nullptr) : Json(name));
    }
    void choice(FieldInfo const& info, ChoiceField field) override {
        put(info, field.names[static_cast<std::size_t>(field.index)]);
    }
    void list(FieldInfo const& info, ListField& field) override {
        Json all = Json::array();
        for (std::size_t i = 0; i < field.size(); ++i) {
            FieldWriter writer(names_);
            writer.listInfo_ = field.elementsHaveFields() ? nullptr : &info;
            field.visitElement(i, writer);
            all.push_back(field.elementsHaveFields() ? std::move(writer.out)
                                                     : std::move(writer.out["value"]));
        }
        put(info, std::move(all));
    }

private:
    [[nodiscard]] Json stated(FieldInfo const& info, double value) const {
        double const inFile =
            isAngle(listInfo_ == nullptr ? info.unit : listInfo_->unit) ? degrees(value) : value;
        // Whole numbers without ".0"; -0.0 is not whole, as its sign would get lost.
        constexpr double small = 1e15;
        if (std::abs(inFile) < small && inFile == std::floor(inFile) &&
            !(inFile == 0 && std::signbit(inFile))) {
            return static_cast<std::int64_t>(inFile);
        }
        return inFile;
    }
    void put(FieldInfo const& info, Json value) { out[std::string(info.key)] = std::move(value); }

    NameTable const& names_;
    FieldInfo const* listInfo_ = nullptr;
};

/// Records, in order, the choices and the lengths of lists, on which a value's fields depend.
class StructureRecorder final : public IdleVisitor {
public:
    std::vector<std::size_t> structure;

    void choice(FieldInfo const&, ChoiceField field) override {
        structure.push_back(static_cast<std::size_t>(field.index));
    }
    void list(FieldInfo const&, ListField& field) override {
        structure.push_back(field.size());
        for (std::size_t i = 0; i < field.size(); ++i) {
            field.visitElement(i, *this);
        }
    }
};

/// Gives an initial value the recorded structure, so that it has the same fields.
class StructureCopier final : public IdleVisitor {
public:
    explicit StructureCopier(std::vector<std::size_t> const& structure) : structure_(structure) {}

    void choice(FieldInfo const&, ChoiceField field) override {
        field.index = static_cast<int>(structure_[next_++]);
    }
    void list(FieldInfo const&, ListField& field) override {
        field.resize(structure_[next_++]);
        for (std::size_t i = 0; i < field.size(); ++i) {
            field.visitElement(i, *this);
        }
    }

private:
    std::vector<std::size_t> const& structure_;
    std::size_t next_ = 0;
};

/// Removes the members that equal those of an initial value, walking through both at once.
class Pruner final : public FieldVisitor {
public:
    Pruner(Json& written, Json const& structured, Json const& initial)
        : written_(written), structured_(structured), initial_(initial) {}

    void boolean(FieldInfo const& info, bool&) override { prune(info); }
    void integer(FieldInfo const& info, std::int32_t&) override { prune(info); }
    void number(FieldInfo const& info, double&) override { prune(info); }
    void vector(FieldInfo const& info, Vec2&) override { prune(info); }
    void text(FieldInfo const& info, std::string&) override { prune(info); }
    void object(FieldInfo const& info, ObjectId&) override {
        std::string const key(info.key);
        if (written_.contains(key) && written_[key].is_null()) {
            written_.erase(key);
        }
    }
    void choice(FieldInfo const& info, ChoiceField) override {
        std::string const key(info.key);
        if (!info.required && initial_.contains(key) && same(written_[key], initial_[key])) {
            written_.erase(key);
        }
    }
    void list(FieldInfo const& info, ListField& field) override {
        std::string const key(info.key);
        if (field.size() == 0) {
            if (!info.required && initial_.contains(key) && initial_[key].empty()) {
                written_.erase(key);
            }
            return;
        }
        if (!field.elementsHaveFields()) {
            if (!info.required && initial_.contains(key) && same(written_[key], initial_[key])) {
                written_.erase(key);
            }
            return;
        }
        // A new element, with initial values of all its choices.
        std::size_t const size = field.size();
        field.resize(size + 1);
        NameTable const unnamed;
        FieldWriter fresh(unnamed);
        field.visitElement(size, fresh);
        field.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            bool const there = initial_.contains(key) && i < initial_[key].size();
            Pruner pruner(written_[key][i], structured_[key][i], there ? initial_[key][i] : fresh.out);
            field.visitElement(i, pruner);
        }
    }

private:
    /// Whether both are written alike. 0 and -0 are equal numbers, but written differently.
    static bool same(Json const& a, Json const& b) {
        if (a.type() != b.type()) {
            return false;
        }
        if (a.is_number_float()) {
            return std::bit_cast<std::uint64_t>(a.get<double>()) ==
                   std::bit_cast<std::uint64_t>(b.get<double>());
        }
        if (a.is_array()) {
            return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
        }
        return a.is_object() ? a.dump() == b.dump() : a == b;
    }

    void prune(FieldInfo const& info) {
        std::string const key(info.key);
        if (!info.required && same(written_[key], structured_[key])) {
            written_.erase(key);
        }
    }

    Json& written_;
    Json const& structured_; ///< an initial value with the same structure
    Json const& initial_;    ///< an unchanged initial value
};

} // namespace

Json writeProperty(PropertyValue const& value, NameTable const& names) {
    auto const copy = value.clone();
    auto const fields = outlineOf(*copy);
    if (fields.empty()) {
        return true;
    }
    FieldWriter writer(names);
    copy->visit(writer);

    auto const initial = value.info().makeValue();
    FieldWriter initialWriter(names);
    initial->visit(initialWriter);
    StructureRecorder recorder;
    copy->visit(recorder);
    StructureCopier copier(recorder.structure);
    initial->visit(copier);
    FieldWriter structuredWriter(names);
    initial->visit(structuredWriter);

    if (isBare(fields)) {
        Json const whole = writer.out;
        Pruner pruner(writer.out, structuredWriter.out, initialWriter.out);
        copy->visit(pruner);
        return writer.out.contains("value") ? writer.out["value"]
                                            : whole["value"]; // a bare value is always written
    }
    Pruner pruner(writer.out, structuredWriter.out, initialWriter.out);
    copy->visit(pruner);
    return writer.out.empty() ? Json(true) : writer.out;
}

Json writeProperties(PropertySet const& set, PropertyPlace place, NameTable const& names) {
    Json out = Json::object();
    for (PropertySet::Entry const& entry : set.entries()) {
        if (entry.info->text.place == place) {
            out[std::string(entry.info->text.key)] =
                entry.value ? writeProperty(*entry.value, names) : Json(false);
        }
    }
    return out;
}

} // namespace trembler
