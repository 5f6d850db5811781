#include "runtime/level/build/build_world.hpp"

#include "runtime/level/build/effective_properties.hpp"
#include "runtime/level/build/joint_names.hpp"
#include "runtime/level/build/lay_connections.hpp"
#include "runtime/level/build/references.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/object/without.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace trembler {
namespace {

/// An object that will be created, with the source of its properties.
struct Made {
    std::string name;
    PartDefinition const* part = nullptr;
    PropertySet properties;           ///< effective
    std::vector<std::string> without; ///< keys that it is stated not to have, ascending
    PropertySet const* own = nullptr;
    std::string path; ///< in the level's file
    Origin::Kind kind = Origin::Kind::object;
    std::size_t index = 0; ///< in the level's list of objects or joints, or among the placements
    ObjectId id;

    /// Its properties are members of its entry, not of "properties" in it.
    [[nodiscard]] bool inEntry() const { return kind == Origin::Kind::world || kind == Origin::Kind::joint; }
};

std::optional<std::string> faultOf(ObjectId id, std::span<ObjectFault const> ascending) {
    auto const found =
        std::lower_bound(ascending.begin(), ascending.end(), id,
                         [](ObjectFault const& fault, ObjectId wanted) { return fault.object < wanted; });
    return found != ascending.end() && found->object == id ? std::optional(found->text) : std::nullopt;
}

/// The indices 0 to count - 1, sorted.
template <class Less>
std::vector<std::size_t> sortedIndices(std::size_t count, Less less) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), less);
    return order;
}

class Builder {
public:
    Builder(Registry const& registry, LevelFile const& level, PartLibrary const& library, Problems& problems)
        : registry_(registry), level_(level), library_(library), problems_(problems) {}

    void addWorld() {
        Made made; // always created, so that ids do not depend on whether the level states it
        made.name = "world";
        made.properties = effectiveProperties({}, level_.world);
        made.own = &level_.world;
        made.path = "/world";
        made.kind = Origin::Kind::world;
        made_.push_back(std::move(made));
    }

    void addObjects() {
        for (std::size_t const i : sortedIndices(level_.objects.size(), [&](std::size_t a, std::size_t b) {
                 return level_.objects[a].name < level_.objects[b].name;
             })) {
            LevelObject const& object = level_.objects[i];
            Made made;
            made.name = object.name;
            made.own = &object.properties;
            made.path = object.path;
            made.index = i;
            if (!object.part.empty()) {
                made.part = library_.find(object.part);
                if (made.part == nullptr) {
                    problem(object.path.empty() ? "" : object.path + "/part",
                            fmt::format("there is no part '{}'{}", object.part,
                                        didYouMean(object.part, library_.names())),
                            listed(library_.names()));
                    continue;
                }
            }
            PropertySet const part = made.part == nullptr ? PropertySet() : made.part->properties;
            made.properties = effectiveProperties(part, object.properties);
            made.without = statedAbsent(part, object.properties);
            made_.push_back(std::move(made));
        }
    }

    void addJoints() {
        std::vector<std::string> const names = jointNames(level_);
        for (std::size_t const i :
             sortedIndices(names.size(), [&](std::size_t a, std::size_t b) { return names[a] < names[b]; })) {
            Made made;
            made.name = names[i];
            made.own = &level_.joints[i].properties;
            made.properties = level_.joints[i].properties;
            made.path = level_.joints[i].path;
            made.kind = Origin::Kind::joint;
            made.index = i;
            made_.push_back(std::move(made));
        }
    }

    void addPlacements(std::span<Placement const> placements) {
        std::vector<Placement> const sorted = inCanonicalOrder(placements);
        std::vector<std::size_t> const order = canonicalOrder(placements);
        std::vector<std::string> const names = placementNames(level_, placements);
        PlacementCount count(level_, library_);
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            Placement const& placement = sorted[i];
            if (auto const refusal = count.add(placement)) {
                problem(placement.path, *refusal, "a placement that the level allows");
                continue;
            }
            Made made;
            made.name = names[i];
            made.part = library_.find(placement.part);
            made.properties = effectiveProperties(made.part->properties, {});
            made.without = statedAbsent(made.part->properties, {});
            made.properties.set(Position{placement.at});
            made.properties.set(Rotation{placement.angle});
            made.path = placement.path;
            made.kind = Origin::Kind::placement;
            made.index = order[i];
            made_.push_back(std::move(made));
        }
    }

    void checkToolbox() {
        for (ToolboxEntry const& entry : level_.toolbox) {
            if (library_.find(entry.part) == nullptr) {
                problem(entry.path.empty() ? "" : entry.path + "/part",
                        fmt::format("there is no part '{}'{}", entry.part,
                                    didYouMean(entry.part, library_.names())),
                        listed(library_.names()));
            }
        }
    }

    void create(Store& store) {
        for (PartDefinition const* part : library_.all()) {
            numbers_.emplace(part, store.prototypes().add(part->prototype()));
        }
        for (Made& made : made_) {
            if (store.find(made.name).valid()) {
                problem(made.path, fmt::format("the name '{}' is taken", made.name), "a unique name");
                continue;
            }
            made.id = store.create(made.name, originOf(made));
        }
        for (Made& made : made_) {
            if (made.id.valid()) {
                furnish(store, made);
            }
        }
    }

    void checkRules(Store const& store) {
        std::span<ObjectRule const> const rules = registry_.rules();
        std::vector<std::vector<ObjectFault>> atOnce(rules.size());
        for (std::size_t i = 0; i < rules.size(); ++i) {
            if (rules[i].checkAll != nullptr && store.findColumn(*rules[i].property) != nullptr) {
                atOnce[i] = rules[i].checkAll(store);
            }
        }
        for (Made const& made : made_) {
            if (!made.id.valid()) {
                continue;
            }
            for (std::size_t i = 0; i < rules.size(); ++i) {
                PropertyInfo const& property = *rules[i].property;
                ColumnBase const* const column = store.findColumn(property);
                if (column == nullptr || !column->has(made.id)) {
                    continue;
                }
                std::optional<std::string> const broken = rules[i].checkAll != nullptr
                                                              ? faultOf(made.id, atOnce[i])
                                                              : rules[i].check(store, made.id);
                if (broken) {
                    addProblem(problems_, [&] {
                        return propertyProblem(made, property, "", fmt::format("{}: {}", made.name, *broken),
                                               "");
                    });
                }
            }
        }
    }

    /// The objects of one kind that create() made, by index in their list of `count` entries.
    [[nodiscard]] std::vector<ObjectId> created(Origin::Kind kind, std::size_t count) const {
        std::vector<ObjectId> ids(count);
        for (Made const& made : made_) {
            if (made.kind == kind) {
                ids[made.index] = made.id;
            }
        }
        return ids;
    }

private:
    [[nodiscard]] Origin originOf(Made const& made) const {
        Origin origin{.kind = made.kind, .prototype = {}, .number = made.index, .maker = {}};
        if (made.part != nullptr) {
            origin.prototype = numbers_.at(made.part);
        }
        return origin;
    }

    void problem(std::string path, std::string message, std::string expected) {
        addProblem(problems_, [&] {
            return level_.diagnostic(std::move(path), std::move(message), std::move(expected));
        });
    }

    /// A problem with an object's property, where that is stated: in the object's entry or in its part's
    /// file.
    [[nodiscard]] Diagnostic propertyProblem(Made const& made, PropertyInfo const& info,
                                             std::string const& inside, std::string message,
                                             std::string expected) const {
        std::string const key(info.text.key);
        bool const own = made.own != nullptr && made.own->states(info);
        if (!own && made.part != nullptr && made.part->document && made.part->properties.states(info)) {
            JsonDocument const& document = *made.part->document;
            bool const beside = document.root().contains(key);
            return document.diagnostic(pointerTo(beside ? "" : "/properties", key) + inside,
                                       std::move(message), std::move(expected));
        }
        std::string path = made.path;
        if (!path.empty() && made.kind != Origin::Kind::placement && key != "joint") {
            bool const direct = made.inEntry() || info.text.place != PropertyPlace::properties;
            path = pointerTo(direct ? path : path + "/properties", key);
        }
        return level_.diagnostic(path + inside, std::move(message), std::move(expected));
    }

    void furnish(Store& store, Made& made) {
        for (PropertySet::Entry const& entry : made.properties.entries()) {
            auto const value = entry.value->clone();
            for (DanglingReference const& dangling : resolveReferences(*value, level_.names, store)) {
                addProblem(problems_, [&] {
                    return propertyProblem(made, *entry.info, dangling.path,
                                           fmt::format("there is no object '{}'{}", dangling.name,
                                                       didYouMean(dangling.name, objectNames())),
                                           "the name of an object of this level");
                });
            }
            value->assignTo(store.column(*entry.info), made.id);
        }
        if (!made.without.empty()) {
            store.column<Without>().set(made.id, {made.without});
        }
    }

    [[nodiscard]] std::vector<std::string> objectNames() const {
        std::vector<std::string> names;
        for (Made const& made : made_) {
            names.push_back(made.name);
        }
        return names;
    }

    Registry const& registry_;
    LevelFile const& level_;
    PartLibrary const& library_;
    Problems& problems_;
    std::vector<Made> made_;                                 ///< in the order in which they are created
    std::map<PartDefinition const*, std::uint32_t> numbers_; ///< of prototypes; looked up, never walked
};

} // namespace

BuiltLevel buildLevel(Registry const& registry, LevelFile const& level, PartLibrary const& library,
                      std::span<Placement const> placements, WorldOptions options,
                      std::span<LevelConnection const> wires) {
    Problems problems;
    Builder builder(registry, level, library, problems);
    builder.addWorld();
    builder.addObjects();
    builder.addJoints();
    builder.addPlacements(placements);
    builder.checkToolbox();
    for (auto const& [effect, detail] : level.detail) {
        options.detail.try_emplace(effect, detail);
    }
    BuiltLevel built;
    built.world = std::make_unique<World>(registry, std::move(options));
    Store& store = built.world->store();
    builder.create(store);
    problems.throwIfAny(); // rules may assume that references are valid
    builder.checkRules(store);
    layConnections(registry, level, wires, store, problems);
    problems.throwIfAny(); // and completions may assume that all rules hold
    built.world->start();
    built.objects = builder.created(Origin::Kind::object, level.objects.size());
    built.joints = builder.created(Origin::Kind::joint, level.joints.size());
    built.placements = builder.created(Origin::Kind::placement, placements.size());
    return built;
}

std::unique_ptr<World> buildWorld(Registry const& registry, LevelFile const& level,
                                  PartLibrary const& library, std::span<Placement const> placements,
                                  WorldOptions options) {
    return buildLevel(registry, level, library, placements, std::move(options)).world;
}

} // namespace trembler
