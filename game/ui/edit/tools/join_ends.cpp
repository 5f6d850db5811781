#include "game/ui/edit/tools/join_ends.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/view/edit_geometry.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "physics/dynamics/properties/joint_check.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/session/wire_rules.hpp"
#include "render/scene/facts/facts.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/facts/poses.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using edit::Json;

Store const* storeOf(EditParts const& parts) {
    World const* const world = parts.world.world();
    return world == nullptr ? nullptr : &world->store();
}

JoinEnd endOf(EditParts const& parts, ObjectId object) {
    Store const* const store = storeOf(parts);
    if (store == nullptr || !store->alive(object)) {
        return {};
    }
    std::string const& entry = parts.world.entryOf(object);
    if (entry.empty()) {
        return {};
    }
    // A name without a piece stays right when the entry gets another part.
    bool const main = store->find(entry) == object;
    return {object, main ? entry : std::string(store->nameOf(object))};
}

bool conductsThere(Store const& store, ObjectId object) {
    auto const* const conductors = store.findColumn<Conductor>();
    return conductors != nullptr && conductors->has(object);
}

/// The objects that the level connects with one.
std::vector<ObjectId> connectedWith(EditParts const& parts, Store const& store, ObjectId object) {
    std::vector<ObjectId> others;
    for (edit::ConnectionEntry const& wire : edit::connectionsOf(parts.tree())) {
        ObjectId const a = store.find(wire.a);
        ObjectId const b = store.find(wire.b);
        if (a == object || b == object) {
            others.push_back(a == object ? b : a);
        }
    }
    return others;
}

std::string whyNoWire(EditParts const& parts, Store const& store, ObjectId from, ObjectId to,
                      std::vector<ObjectId> const& connected) {
    for (ObjectId const end : {from, to}) {
        if (!conductsThere(store, end)) {
            return words::conductsNot(store.nameOf(end));
        }
    }
    bool const already = std::find(connected.begin(), connected.end(), to) != connected.end();
    Verdict const verdict = wireVerdict(parts.data->registry, store, from, to, already);
    return verdict.ok ? std::string() : translated(verdict.why);
}

/// Without the questions that only the command answers.
std::string whyNoJoint(EditParts const& parts, Store const& store, Join const& join) {
    auto const* const form =
        std::find(choiceNames<JointForm>.begin(), choiceNames<JointForm>.end(), parts.jointForm);
    if (form == choiceNames<JointForm>.end()) {
        return {};
    }
    Joint joint;
    joint.form = static_cast<JointForm>(form - choiceNames<JointForm>.begin());
    joint.a = join.from.object;
    joint.b = join.to.object;
    joint.at = join.at;
    joint.atB = join.atB;
    joint.stiffness = 1; // the command states one, and where a pulley's wheels are
    joint.groundA = join.at + Vec2{0, 1};
    joint.groundB = join.atB + Vec2{0, 1};
    if (joint.form == JointForm::gear) { // the command looks for the joints that it couples
        joint.form = JointForm::hinge;
    }
    auto const why = refuseJoint(store, joint);
    return why ? translated(*why) : std::string();
}

/// Whether the level has a joint of the chosen form between the same ends, from the same place to the same.
bool isThere(EditParts const& parts, Join const& join) {
    constexpr double same = 1e-6; // m
    auto const near = [](Vec2 a, Vec2 b) { return length(a - b) < same; };
    std::vector<edit::JointEntry> const joints = edit::jointsOf(parts.tree());
    return std::any_of(joints.begin(), joints.end(), [&](edit::JointEntry const& one) {
        bool const twoEnds = !near(one.at, one.atB);
        Vec2 const atB = twoEnds ? join.atB : join.at;
        bool const alike =
            one.a == join.from.name && one.b == join.to.name && near(one.at, join.at) && near(one.atB, atB);
        bool const reversed =
            one.a == join.to.name && one.b == join.from.name && near(one.at, atB) && near(one.atB, join.at);
        return one.form == parts.jointForm && (alike || reversed);
    });
}

std::vector<ObjectId> joinable(EditParts const& parts, Tool tool, JoinEnd const& from,
                               render::Extent const& view) {
    std::vector<ObjectId> all;
    World const* const world = parts.world.world();
    if (world == nullptr) {
        return all;
    }
    Store const& store = world->store();
    std::vector<ObjectId> const connected = tool == Tool::wire && from.valid()
                                                ? connectedWith(parts, store, from.object)
                                                : std::vector<ObjectId>();
    auto const whyNot = [&](ObjectId object) {
        if (!from.valid()) {
            return whyNoBeginning(parts, tool, {object, {}});
        }
        if (tool == Tool::wire) {
            return whyNoWire(parts, store, from.object, object, connected);
        }
        // Between two places, as a rope needs them: these are where the mouse leads.
        return whyNoJoint(parts, store, {tool, from, {object, {}}, {0, 0}, {1, 0}});
    };
    for (render::Facts const& facts : render::FactsReader(*world).drawOrder()) {
        bool const seen =
            facts.visible() && render::pictureExtentOf(facts, render::poseOf(facts)).overlaps(view);
        bool const there = seen && !parts.world.entryOf(facts.id).empty();
        if (there && facts.id != from.object && whyNot(facts.id).empty()) {
            all.push_back(facts.id);
        }
    }
    return all;
}

} // namespace

JoinEnd endAt(EditParts const& parts, Vec2 at) {
    return endOf(parts, pickTopmost(parts, at));
}

JoinEnd endNamed(EditParts const& parts, std::string const& name) {
    Store const* const store = storeOf(parts);
    return store == nullptr || name.empty() ? JoinEnd{} : endOf(parts, store->find(name));
}

std::vector<JoinEnd> selectedEnds(EditParts const& parts, Tool tool) {
    std::vector<JoinEnd> ends;
    Store const* const store = storeOf(parts);
    for (std::string const& name : parts.selected()) {
        std::string const& piece = parts.selection.piece();
        JoinEnd end = endNamed(parts, piece.empty() ? name : name + " " + piece);
        if (tool == Tool::wire && piece.empty() && end.valid() && !conductsThere(*store, end.object)) {
            std::vector<ObjectId> conducting;
            for (ObjectId const one : parts.world.objectsOf(name)) {
                if (conductsThere(*store, one)) {
                    conducting.push_back(one);
                }
            }
            end = conducting.size() == 1 ? endOf(parts, conducting.front()) : end;
        }
        ends.push_back(std::move(end));
    }
    return ends;
}

std::string whyNoBeginning(EditParts const& parts, Tool tool, JoinEnd const& from) {
    Store const* const store = storeOf(parts);
    if (store == nullptr || !from.valid()) {
        return {};
    }
    if (tool == Tool::wire) {
        return conductsThere(*store, from.object) ? std::string()
                                                  : words::conductsNot(store->nameOf(from.object));
    }
    if (canBeJoined(*store, from.object)) { // also a fixed one, to something that moves
        return {};
    }
    Joint probe;
    probe.a = from.object;
    return translated(refuseJoint(*store, probe).value_or(""));
}

std::string whyNoJoin(EditParts const& parts, Join const& join) {
    Store const* const store = storeOf(parts);
    if (store == nullptr || !join.from.valid()) {
        return {};
    }
    if (join.tool == Tool::wire) {
        return join.to.valid() ? whyNoWire(parts, *store, join.from.object, join.to.object,
                                           connectedWith(parts, *store, join.from.object))
                               : std::string();
    }
    if (std::string why = whyNoJoint(parts, *store, join); !why.empty()) {
        return why;
    }
    if (isThere(parts, join)) {
        return words::jointThere;
    }
    try {
        static_cast<void>(edit::addJoint(*parts.data, parts.tree(), parts.jointForm, join.from.name,
                                         join.to.name, join.at, join.atB));
    } catch (edit::CommandError const& error) {
        return shownError(error);
    }
    return {};
}

std::vector<ObjectId> const& joinableInView(EditParts const& parts, JoinEnd const& from) {
    render::Extent const view = render::viewOf(parts.camera());
    JoinablesOf const of{parts.world.builds(),
                         parts.document.revision(),
                         parts.tool,
                         parts.jointForm,
                         from.object,
                         view.lower,
                         view.upper};
    if (!parts.joinables.of || *parts.joinables.of != of) {
        parts.joinables = {of, joinable(parts, parts.tool, from, view)};
    }
    return parts.joinables.objects;
}

} // namespace trembler::ui
