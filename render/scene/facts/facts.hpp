// The properties of an object that drawing reads, whether it is in a world or still a part in the toolbox.
#pragma once

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/drawing.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/look_form.hpp"
#include "physics/magnetism/properties.hpp"
#include "render/scene/facts/appearance.hpp"
#include "runtime/level/property/property_set.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <tuple>
#include <utility>
#include <vector>

namespace trembler::render {

/// Pointers are null, and flags false, where the object lacks the property. Pointers are valid until the
/// world changes.
struct Facts {
    ObjectId id; ///< invalid for a part that is in no world
    Position const* position = nullptr;
    Rotation const* rotation = nullptr;
    Shape const* shape = nullptr;
    bool fixed = false;
    bool liquid = false;
    bool conductor = false;
    bool source = false;
    bool earth = false; ///< the return of a network
    bool device = false;
    bool on = false; ///< it is part of a working circuit
    MagneticPoles const* poles = nullptr;
    Magnet const* magnet = nullptr;
    MagneticStrength const* strength = nullptr;
    Electromagnet const* coil = nullptr;
    MadeOf const* madeOf = nullptr;
    Look const* look = nullptr;
    Drawing const* drawing = nullptr;
    Vec2 const* axle = nullptr;    ///< of the body that this is welded to, if it turns about the world; m
    LookForm form = LookForm::own; ///< as stated
    Substance substance = Substance::plastic; ///< as stated, else guessed

    /// It is shown by a symbol alone: it conducts but has no body.
    [[nodiscard]] bool symbolOnly() const {
        return shape == nullptr && (source || earth || conductor || device);
    }
    /// Something of it can be seen at a place.
    [[nodiscard]] bool visible() const {
        return position != nullptr && (shape != nullptr || drawing != nullptr || symbolOnly());
    }
    /// Share of a magnet's strength that acts, 0 to 1.
    [[nodiscard]] double magnetLevel() const {
        return magnet != nullptr ? magnet->level : (coil != nullptr ? 0.0 : 1.0);
    }
};

/// Finds the columns once, so that asking for many objects is cheap. Valid until the world gains a new kind
/// of property; make one per picture.
class FactsReader {
public:
    explicit FactsReader(World const& world);
    [[nodiscard]] Facts of(ObjectId id) const;
    /// Every visible object, from bottom to top: by the layers of drawings (0 without one); within a layer
    /// liquids, then fixed objects, then moving ones, then symbols; in the order of ids within each.
    [[nodiscard]] std::vector<Facts> drawOrder() const;

private:
    /// Of a world, the columns of these properties; nullptr where it has none.
    template <class... P>
    struct ColumnsOf {
        explicit ColumnsOf(Store const& store) : all(store.findColumn<P>()...) {}
        template <class Q>
        [[nodiscard]] Q const* find(ObjectId id) const {
            auto const* const column = std::get<Column<Q> const*>(all);
            return column == nullptr ? nullptr : column->find(id);
        }
        std::tuple<Column<P> const*...> all;
    };
    ColumnsOf<Position, Rotation, Shape, Fixed, Liquid, Conductor, ElectricalSource, ElectricalReturn,
              ElectricalDevice, MagneticPoles, Magnet, MagneticStrength, Electromagnet, MadeOf, Look, DrawnAs,
              Drawing>
        columns_;
    ElectricalState const* state_;
    std::vector<std::pair<ObjectId, Vec2 const*>> axles_; // of connected conductors; by object
};

/// The same for a part that is not in any world; it lies at the origin unless its values say otherwise.
[[nodiscard]] Facts factsOf(Prototype const& prototype);
[[nodiscard]] Facts factsOf(PropertySet const& properties);
/// In the order of FactsReader::drawOrder(), stable.
void putInDrawOrder(std::vector<Facts>& all);

} // namespace trembler::render
