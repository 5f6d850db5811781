// The properties that Electricity adds to new objects.
#pragma once

#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/material.hpp"
#include "runtime/component/completion.hpp"
#include "runtime/object/without.hpp"

namespace trembler {

/// Whether an object conducts because of its material.
[[nodiscard]] inline bool conductsByMaterial(MadeOf const* of, Without const* without) {
    return of != nullptr && materialFacts(of->material).conducts && !isWithout<Conductor>(without);
}

struct ConductorCompletion final : Completion<ConductorCompletion, Reads<MadeOf, Without>, Adds<Conductor>> {
    static constexpr CompletionText text{
        .name = "Conductor",
        .work = "Makes an object of metal a conductor, unless it is stated not to be one."};
    using Activation = NeedsAll<MadeOf>;
    static void complete(Access& access) {
        if (conductsByMaterial(access.find<MadeOf>(), access.find<Without>())) {
            access.add(Conductor{});
        }
    }
};

struct VertexCompletion final : Completion<VertexCompletion, Reads<>, Adds<ElectricityGraph>> {
    static constexpr CompletionText text{
        .name = "Vertex",
        .work = "Makes every conductor a vertex of the electricity graph, at first without connections."};
    using Activation = NeedsAll<Conductor>;
    static void complete(Access& access) { access.add(ElectricityGraph{}); }
};

} // namespace trembler
