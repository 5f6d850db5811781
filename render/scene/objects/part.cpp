#include "render/scene/objects/part.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "render/draw/path.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/objects/joint_parts.hpp"
#include "render/scene/objects/wires.hpp"
#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/build/placed_pieces.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace trembler::render {
namespace {

/// A cable between two pieces, each by its place in ExpandedPart::properties_.
struct PartCable {
    std::size_t a = 0;
    std::size_t b = 0;
    double length = 0; ///< m, if a rope between the two bounds it; else 0
};

constexpr double leastWidthOnTile = 0.05; // of a cable, as a share of the part's width

// The objects that a placement becomes, with the names of pieces and joints.
class ExpandedPart {
public:
    ExpandedPart(PartLibrary const& library, Placement const& placement)
        : expander_(library, [this](auto const&...) { whole_ = false; }),
          entry_(entryOf(placement, placement.part)),
          expanded_(expander_.expand(entry_, nowhere_, StatedProperties::Form::placement)) {
        for (std::size_t i = 0; whole_ && i < expanded_.objects.size(); ++i) {
            MadeObject const& made = expanded_.objects[i];
            byName_[made.name] = i;
            properties_.push_back(made.properties());
        }
        for (auto const& [alias, name] : expanded_.aliases) {
            if (auto const found = byName_.find(name); found != byName_.end()) {
                byName_.try_emplace(alias, found->second);
            }
        }
    }
    ExpandedPart(ExpandedPart const&) = delete;
    ExpandedPart& operator=(ExpandedPart const&) = delete;

    /// Pointers into this.
    [[nodiscard]] std::vector<Facts> pieces() const {
        std::vector<Facts> all;
        for (PropertySet const& properties : properties_) {
            Facts const facts = factsOf(properties);
            if (facts.visible()) {
                all.push_back(facts);
            }
        }
        putInDrawOrder(all);
        return all;
    }
    /// The cables between pieces that are seen.
    [[nodiscard]] std::vector<PartCable> cables() const {
        std::set<std::pair<std::size_t, std::size_t>> inside;            // both orders
        std::map<std::pair<std::size_t, std::size_t>, double> lengthsOf; // both orders, m
        for (std::size_t i = 0; i < properties_.size(); ++i) {
            Joint const* const joint = properties_[i].find<Joint>();
            if (joint == nullptr) {
                continue;
            }
            auto const a = place(i, joint->a);
            auto const b = place(i, joint->b);
            if (a && b && hidesWires(*joint)) {
                inside.insert({*a, *b});
                inside.insert({*b, *a});
            } else if (a && b && joint->form == JointForm::rope) {
                lengthsOf[{*a, *b}] = lengthsOf[{*b, *a}] = joint->length;
            }
        }
        std::vector<PartCable> all;
        for (MadeConnection const& made : expanded_.connections) {
            auto const a = byName_.find(made.connection.a);
            auto const b = byName_.find(made.connection.b);
            if (a != byName_.end() && b != byName_.end() && !inside.contains({a->second, b->second}) &&
                facts(a->second).visible() && facts(b->second).visible()) {
                auto const bound = lengthsOf.find({a->second, b->second});
                all.push_back({a->second, b->second, bound == lengthsOf.end() ? 0 : bound->second});
            }
        }
        return all;
    }
    [[nodiscard]] Facts facts(std::size_t place) const { return factsOf(properties_[place]); }
    void drawJoints(Canvas& canvas) const {
        for (std::size_t i = 0; i < properties_.size(); ++i) {
            Joint const* const joint = properties_[i].find<Joint>();
            if (joint == nullptr) {
                continue;
            }
            if (joint->form != JointForm::gear) {
                drawJoint(canvas, *joint, statedPlaces(*joint));
                continue;
            }
            PropertySet const* const a = named(i, joint->a);
            PropertySet const* const b = named(i, joint->b);
            PropertySet const* const pinA = named(i, joint->jointA);
            PropertySet const* const pinB = named(i, joint->jointB);
            if (a != nullptr && b != nullptr && pinA != nullptr && pinB != nullptr &&
                pinA->find<Joint>() != nullptr && pinB->find<Joint>() != nullptr) {
                drawGear(canvas, *joint, factsOf(*a), factsOf(*b), statedPlaces(*pinA->find<Joint>()),
                         statedPlaces(*pinB->find<Joint>()));
            }
        }
    }

private:
    /// The place in properties_ of the object to which a joint refers; nullopt if it is not among the part's
    /// objects.
    [[nodiscard]] std::optional<std::size_t> place(std::size_t joint, ObjectId reference) const {
        StatementScope const* const scope = expanded_.objects[joint].stated.front().scope;
        if (scope == nullptr || scope->names == nullptr || !reference.valid()) {
            return std::nullopt;
        }
        auto const found = byName_.find(scope->prefix + scope->names->nameOf(reference));
        return found == byName_.end() ? std::nullopt : std::optional(found->second);
    }
    [[nodiscard]] PropertySet const* named(std::size_t joint, ObjectId reference) const {
        auto const found = place(joint, reference);
        return found ? &properties_[*found] : nullptr;
    }

    bool whole_ = true;
    StatementScope nowhere_;
    PartExpander expander_;
    LevelObject entry_;
    ExpandedEntry expanded_;
    std::vector<PropertySet> properties_; // by index in expanded_.objects
    std::map<std::string, std::size_t> byName_;
};

/// Everything but the cables.
void drawPieces(Canvas& canvas, ExpandedPart const& part, Marks const& marks) {
    for (Facts const& facts : part.pieces()) {
        drawObject(canvas, facts, poseOf(facts), marks);
    }
    part.drawJoints(canvas);
}

std::vector<Point> pathOf(ExpandedPart const& part, PartCable const& cable, bool onTile) {
    Facts const a = part.facts(cable.a);
    Facts const b = part.facts(cable.b);
    std::vector<Point> const path = cablePath(a, poseOf(a), b, poseOf(b));
    return onTile && cable.length > pathLength(path) ? loopedCable(path.front(), path.back(), cable.length)
                                                     : path;
}

Extent extentWith(ExpandedPart const& part, bool onTile) {
    Extent around;
    for (Facts const& facts : part.pieces()) {
        around.add(pictureExtentOf(facts, poseOf(facts)));
    }
    for (PartCable const& cable : part.cables()) {
        for (Point const point : pathOf(part, cable, onTile)) {
            around.add(point);
        }
    }
    return around;
}

} // namespace

void drawPart(Canvas& canvas, PartLibrary const& library, Placement const& placement, Marks const& marks) {
    if (library.find(placement.part) == nullptr) {
        return;
    }
    ExpandedPart const part(library, placement);
    drawPieces(canvas, part, marks);
    for (PartCable const& cable : part.cables()) {
        Facts const a = part.facts(cable.a);
        Facts const b = part.facts(cable.b);
        drawCable(canvas, a, poseOf(a), b, poseOf(b));
    }
}

Extent extentOfPart(PartLibrary const& library, Placement const& placement) {
    return library.find(placement.part) == nullptr ? Extent{}
                                                   : extentWith(ExpandedPart(library, placement), false);
}

void drawPartOnTile(Canvas& canvas, PartLibrary const& library, Placement const& placement) {
    if (library.find(placement.part) == nullptr) {
        return;
    }
    ExpandedPart const part(library, placement);
    double const least = leastWidthOnTile * 2 * extentWith(part, true).half().x;
    for (PartCable const& cable : part.cables()) { // the ends lie on the cable
        drawCableAlong(canvas, pathOf(part, cable, true), part.facts(cable.a), part.facts(cable.b),
                       std::max(cableWidth, cable.length > 0 ? least : 0));
    }
    drawPieces(canvas, part, {});
}

Placement placementOnTile(PartLibrary const& library, std::string const& part) {
    constexpr double slim = 2.2;   // times as long as high
    constexpr double slope = 0.52; // rad
    Placement placement{part, {}, 0, ""};
    PartDefinition const* const definition = library.find(part);
    Extent const flat = extentOnTile(library, placement);
    if (definition != nullptr && !definition->composite() &&
        definition->properties.find<Fixed>() == nullptr && !flat.empty() &&
        flat.half().x > slim * flat.half().y) {
        placement.angle = slope;
    }
    return placement;
}

Extent extentOnTile(PartLibrary const& library, Placement const& placement) {
    return library.find(placement.part) == nullptr ? Extent{}
                                                   : extentWith(ExpandedPart(library, placement), true);
}

} // namespace trembler::render
