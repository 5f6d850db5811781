#include "audio/effect/properties/acoustics.hpp"
#include "audio/effect/properties/decibel.hpp"
#include "audio/effect/properties/loudness.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "game/ui/panels/inspector.hpp"
#include "game/ui/panels/script_rows.hpp"
#include "game/ui/shared/readable_number.hpp"
#include "game/ui/shared/words.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace trembler::ui {
namespace {

/// Replaces the underscores of a file's key: "cool_down" becomes "cool down".
std::string spoken(std::string_view key) {
    std::string text(key);
    constexpr std::string_view degrees = "_deg";
    if (text.size() > degrees.size() && text.ends_with(degrees)) {
        text.resize(text.size() - degrees.size());
    }
    std::replace(text.begin(), text.end(), '_', ' ');
    return text == "value" ? std::string() : translated(text);
}

std::string pointText(Vec2 v) {
    bool const comma = localNumber(".") == ","; // then a comma is no separator
    return readable(v.x) + (comma ? "; " : ", ") + readable(v.y);
}

/// Writes each field into a row.
class RowWriter final : public FieldVisitor {
public:
    RowWriter(Store const& store, std::vector<InspectorRow>& rows, std::string prefix = {})
        : store_(store), rows_(rows), prefix_(std::move(prefix)) {}

    void boolean(FieldInfo const& info, bool& value) override {
        add(info, std::string(value ? words::yes : words::no), {});
    }
    void integer(FieldInfo const& info, std::int32_t& value) override {
        add(info, std::to_string(value), info.unit);
    }
    void number(FieldInfo const& info, double& value) override {
        constexpr std::string_view radians = "rad";
        if (info.unit.starts_with(radians)) {
            std::string const rest(info.unit.substr(radians.size()));
            add(info, readable(value * 180 / pi), "°" + rest);
        } else {
            add(info, readable(value), info.unit);
        }
    }
    void vector(FieldInfo const& info, Vec2& value) override { add(info, pointText(value), info.unit); }
    void text(FieldInfo const& info, std::string& value) override {
        add(info, value.empty() ? std::string(words::nothingStated) : value, info.unit);
    }
    void object(FieldInfo const& info, ObjectId& value) override {
        add(info, value.valid() ? shownName(store_.nameOf(value)) : std::string(words::nothingStated), {});
    }
    void choice(FieldInfo const& info, ChoiceField field) override {
        auto const index = static_cast<std::size_t>(field.index);
        add(info,
            index < field.names.size() ? translated(std::string(field.names[index]))
                                       : std::to_string(field.index),
            {});
    }
    void list(FieldInfo const& info, ListField& field) override {
        constexpr std::size_t most = 12;
        if (field.size() == 0) {
            add(info, std::string(words::nothingStated), {});
            return;
        }
        std::string const name = nameOf(info);
        for (std::size_t i = 0; i < std::min(field.size(), most); ++i) {
            std::string const prefix = field.size() == 1 ? name : fmt::format("{} {}", name, i + 1);
            RowWriter inner(store_, rows_, prefix);
            field.visitElement(i, inner);
        }
        if (field.size() > most) {
            rows_.push_back(
                {name, words::andMore(field.size() - most), {}, translated(std::string(info.meaning))});
        }
    }

private:
    [[nodiscard]] std::string nameOf(FieldInfo const& info) const {
        std::string const own = spoken(info.key);
        return prefix_.empty() ? own : (own.empty() ? prefix_ : prefix_ + " " + own);
    }
    void add(FieldInfo const& info, std::string value, std::string_view unit) {
        rows_.push_back(
            {nameOf(info), std::move(value), std::string(unit), translated(std::string(info.meaning))});
    }

    Store const& store_;
    std::vector<InspectorRow>& rows_;
    std::string prefix_;
};

/// The names of up to four objects, and the number of the others.
std::string namesOf(Store const& store, std::vector<ObjectId> const& objects) {
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(objects.size(), most); ++i) {
        text += (text.empty() ? "" : ", ") + shownName(store.nameOf(objects[i]));
    }
    return objects.size() > most ? text + " " + words::andMore(objects.size() - most) : text;
}

std::vector<ObjectId> touching(Contacts const& contacts, ObjectId object) {
    std::vector<ObjectId> others;
    for (TouchingPair const& pair : contacts.current) {
        if (pair.a == object || pair.b == object) {
            others.push_back(pair.a == object ? pair.b : pair.a);
        }
    }
    return others;
}

template <class Forces>
Vec2 sumOf(Forces const& forces, ObjectId object) {
    Vec2 sum;
    for (auto const& entry : forces.forces) {
        if (entry.object == object) {
            sum += entry.force;
        }
    }
    return sum;
}

std::string forceText(Vec2 force) {
    return fmt::format("{} N {}", readable(length(force)), words::direction(std::atan2(force.y, force.x)));
}

/// Text for a `level` in dB(A). Levels below 0 are inaudible.
std::string levelText(double level) {
    return level >= 0 ? fmt::format(numberLocale(), "{:.1Lf} dB(A)", level) : std::string(words::silence);
}

/// A-weighted square of the sound pressure at 1 m, Pa², of all current sounds of the object.
double soundOf(Sounds const& sounds, ObjectId object) {
    double sum = 0;
    for (Sounds::Body const& body : sounds.bodies) {
        sum += body.object == object ? body.loudness : 0;
    }
    for (Sounds::Recording const& recording : sounds.recordings) {
        sum += recording.object == object ? recording.loudness : 0;
    }
    return sum;
}

/// Adds rows for the object's own sound level and, if it listens, the level at its place.
void saySound(World const& world, ObjectId object, std::vector<InspectorRow>& rows) {
    if (auto const* sounds = world.find<Sounds>(); sounds != nullptr) {
        if (double const own = levelOf(soundOf(*sounds, object)); own >= 0) {
            rows.push_back({words::sounds, levelText(own), {}, words::soundsMeaning});
        }
    }
    bool const listens = world.find<Ear>(object) != nullptr || world.find<SoundSensor>(object) != nullptr;
    if (auto const* loudness = world.find<Loudness>(); listens && loudness != nullptr) {
        rows.push_back({words::hears, levelText(loudness->at(object)), {}, words::hearsMeaning});
    }
}

InspectorSection situation(World const& world, ObjectId object) {
    InspectorSection section{std::string(words::rightNow), {}, {}};
    auto& rows = section.rows;
    auto const say = [&](std::string_view name, std::string value, std::string_view meaning) {
        rows.push_back({std::string(name), std::move(value), {}, std::string(meaning)});
    };
    Store const& store = world.store();
    auto const* const hand = world.find<Hand>();
    auto const* const second = world.find<SecondHand>();
    if ((hand != nullptr && hand->object == object) || (second != nullptr && second->grip.object == object)) {
        say(words::inHand, std::string(words::yes), words::inHandMeaning);
    }
    if (auto const* velocity = world.find<Velocity>(object);
        velocity != nullptr && world.find<Fixed>(object) == nullptr) {
        say(words::speed, readable(length(velocity->value)) + " m/s", words::speedMeaning);
    }
    if (auto const* state = world.find<ElectricalState>();
        state != nullptr && world.find<Conductor>(object) != nullptr) {
        say(words::electricity,
            std::string(state->isOn(object) ? words::electricityOn : words::electricityOff),
            words::electricityMeaning);
    }
    if (auto const* quantities = world.find<ElectricalQuantities>(); quantities != nullptr) {
        auto const* const entry = quantities->find(object);
        auto const* const circuit = quantities->circuitOf(object);
        if (entry != nullptr && circuit != nullptr && circuit->level == ElectricalLevel::nodal) {
            say(words::potential,
                entry->floating ? std::string(words::floating) : readable(entry->potential) + " V",
                words::potentialMeaning);
            say(words::current, readable(entry->current) + " A", words::currentMeaning);
            bool const rated = world.find<RatedPower>(object) != nullptr;
            say(words::power,
                readable(entry->power) + " W" + (rated ? words::ofRated(entry->brightness) : std::string()),
                words::powerMeaning);
            if (std::find(circuit->shorted.begin(), circuit->shorted.end(), object) !=
                circuit->shorted.end()) {
                say(words::shortCircuit, std::string(words::yes), words::shortMeaning);
            }
        }
    }
    if (auto const* graph = world.find<ElectricityGraph>(object);
        graph != nullptr && !graph->connections.empty()) {
        std::vector<ObjectId> others;
        std::map<std::string, std::vector<ObjectId>> byWhom;
        for (auto const& connection : graph->connections) {
            others.push_back(connection.to);
            byWhom[connection.counts.names()].push_back(connection.to);
        }
        std::string reasons;
        for (auto const& [callers, connected] : byWhom) {
            reasons += (reasons.empty() ? "" : "; ") + words::connectedBy(callers, namesOf(store, connected));
        }
        say(words::connectedTo, namesOf(store, others), reasons);
    }
    if (auto const* contacts = world.find<Contacts>(); contacts != nullptr) {
        auto const others = touching(*contacts, object);
        if (!others.empty()) {
            say(words::touches, namesOf(store, others), words::touchesMeaning);
        }
    }
    if (world.find<Fixed>(object) == nullptr) {
        if (auto const* weight = world.find<GravityForce>(); weight != nullptr) {
            Vec2 const force = sumOf(*weight, object);
            if (lengthSquared(force) > 0) {
                say(words::weight, forceText(force), words::weightMeaning);
            }
        }
    }
    if (auto const* magnetic = world.find<MagneticForce>(); magnetic != nullptr) {
        Vec2 const force = sumOf(*magnetic, object);
        if (lengthSquared(force) > 0) {
            say(words::magneticPull, forceText(force), words::magneticMeaning);
        }
    }
    saySound(world, object, rows);
    return section;
}

} // namespace

std::vector<InspectorSection> inspect(World const& world, ObjectId object, lua::LiveScripts const* scripts) {
    std::vector<InspectorSection> sections;
    if (!world.store().alive(object)) {
        return sections;
    }
    if (InspectorSection now = situation(world, object); !now.rows.empty()) {
        sections.push_back(std::move(now));
    }
    for (ColumnBase const* column : world.store().columns()) {
        if (!column->has(object)) {
            continue;
        }
        PropertyText const& text = column->info().text;
        InspectorSection section{
            translated(std::string(text.name)), translated(std::string(text.meaning)), {}};
        if (column->info().type == typeid(lua::Scripts)) {
            section.rows = scriptRows(*world.find<lua::Scripts>(object), scripts);
        } else {
            RowWriter writer(world.store(), section.rows);
            column->visitCopy(object, writer);
        }
        sections.push_back(std::move(section));
    }
    return sections;
}

} // namespace trembler::ui
