// A world like the thesis's Experiment I (Figure 6-3), built in code: drawn by the scene tests.
#pragma once

#include "audio/effect/register.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/register_physics.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"
#include "tests/render/stage.hpp"

#include <map>

namespace trembler::render::test {

inline Registry const& everything() {
    static Registry const* const registry = [] {
        auto* const made = new Registry;
        registerEverything(*made);
        registerSound(*made);
        return made;
    }();
    return *registry;
}

/// An object with a body, at rest.
inline ObjectId body(World& world, std::string const& name, std::vector<ShapePiece> pieces, Vec2 at,
                     double angle = 0) {
    Store& store = world.store();
    ObjectId const id = store.create(name);
    store.column<Position>().set(id, {at});
    store.column<Rotation>().set(id, {angle});
    store.column<Shape>().set(id, {std::move(pieces)});
    return id;
}

/// Floor, ceiling, two contacts, a falling bar above them, an electromagnet under the ceiling and an iron
/// ball.
struct ExperimentStage {
    Callers callers;
    CallerId touch = callers.add("Electricity <- Dynamics");
    World world{everything()};
    std::map<std::string, ObjectId> id;

    ExperimentStage() {
        Store& store = world.store();
        auto const add = [&](std::string const& name, std::vector<ShapePiece> pieces, Vec2 at, bool fixed,
                             bool conductor, double angle = 0) {
            ObjectId const made = body(world, name, std::move(pieces), at, angle);
            if (fixed) {
                store.column<Fixed>().set(made, {});
            }
            if (conductor) {
                store.column<Conductor>().set(made, {});
            }
            id[name] = made;
        };
        add("floor", {boxPiece(11, 0.5)}, {0, -2.75}, true, false);
        add("ceiling", {boxPiece(11, 0.4)}, {0, 2.8}, true, false);
        add("object 1", {boxPiece(0.7, 0.24)}, {-3.6, -0.8}, true, true);
        add("object 2", {boxPiece(0.7, 0.24)}, {-1.8, -0.8}, true, true);
        add("object 3", {boxPiece(0.24, 0.5)}, {1.2, 2.1}, true, true);
        add("object 4", {boxPiece(0.24, 0.5)}, {3.6, 2.1}, true, true);
        add("electromagnet", {boxPiece(0.7, 1.1)}, {2.4, 2.05}, true, true);
        add("switch", {boxPiece(2.3, 0.2)}, {-2.7, 0.6}, false, true, 0.12);
        add("metal object", {circlePiece(0.28)}, {2.4, -2.22}, false, false);
        for (auto const& [name, x, y] : {std::tuple{"source", -4.6, 0.6}, std::tuple{"earth", 4.6, 1.0}}) {
            ObjectId const made = store.create(name);
            store.column<Position>().set(made, {{x, y}});
            store.column<Conductor>().set(made, {});
            id[name] = made;
        }
        store.column<ElectricalSource>().set(id["source"], {});
        store.column<ElectricalReturn>().set(id["earth"], {});
        ObjectId const magnet = id["electromagnet"];
        store.column<ElectricalDevice>().set(magnet, {});
        store.column<Electromagnet>().set(magnet, {});
        store.column<Magnet>().set(magnet, {false, 0});
        store.column<MagneticPoles>().set(magnet, {PoleSet::north, {0, -0.55}, {}});
        store.column<MagneticStrength>().set(magnet, {1e4, 0});
        store.column<MagneticStrength>().set(id["metal object"], {0, 1e4});
        auto& graph = store.column<ElectricityGraph>();
        std::vector<ObjectId> vertices(store.column<Conductor>().owners().begin(),
                                       store.column<Conductor>().owners().end());
        addVertices(graph, vertices);
        for (auto const& [a, b] : {std::pair{"source", "object 1"},
                                   {"object 2", "object 3"},
                                   {"object 3", "electromagnet"},
                                   {"electromagnet", "object 4"},
                                   {"object 4", "earth"}}) {
            wire(a, b);
        }
    }

    void wire(std::string const& a, std::string const& b, CallerId by = CallerId::level()) {
        auto& graph = world.store().column<ElectricityGraph>();
        CallerCounts counts = connectionBetween(graph, id[a], id[b]);
        counts.add(by, 1);
        setConnection(graph, id[a], id[b], counts);
    }

    /// Sets the state in which the switch lies on both contacts, with all its consequences.
    void closeSwitch() {
        Store& store = world.store();
        store.column<Position>().set(id["switch"], {{-2.7, -0.58}});
        store.column<Rotation>().set(id["switch"], {0});
        wire("object 1", "switch", touch);
        wire("object 2", "switch", touch);
        auto& state = store.slot<ElectricalState>().value();
        for (auto const& name :
             {"source", "object 1", "switch", "object 2", "object 3", "electromagnet", "object 4", "earth"}) {
            ObjectId const object = id[name];
            state.byIndex.resize(std::max<std::size_t>(state.byIndex.size(), object.index + std::size_t{1}));
            state.byIndex[object.index] = {object, true, {}};
        }
        store.column<Magnet>().set(id["electromagnet"], {true, 1});
        store.column<Position>().set(id["metal object"], {{2.4, 1.22}});
    }
};

/// The camera with which the stage fills a picture.
inline Camera stageCamera(Size size = {1280, 720}) {
    Camera camera;
    camera.viewport = size;
    camera.fit({-5.4, -3.05}, {5.4, 3.05}, 0);
    return camera;
}

} // namespace trembler::render::test
