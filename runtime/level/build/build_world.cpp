#include "runtime/level/build/build_world.hpp"

#include "runtime/level/build/check_toolbox.hpp"
#include "runtime/level/build/joint_names.hpp"
#include "runtime/level/build/lay_connections.hpp"
#include "runtime/level/build/object_rules.hpp"
#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/level/build/property_bytes.hpp"
#include "runtime/level/build/references.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/object/without.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <numeric>

namespace trembler {
namespace {

/// An object that will be created.
struct Made {
    MadeObject object;
    std::string path; ///< of the entry that it comes from, in the level's file
    Origin origin;    ///< without the prototype
    ObjectId id{};
};

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
        : registry_(registry), level_(level), library_(library), problems_(problems),
          expander_(library, [this](StatementScope const& scope, std::string path, std::string message,
                                    std::string expected) {
              addProblem(problems_, [&] {
                  return diagnostic(scope, std::move(path), std::move(message), std::move(expected));
              });
          }) {
        for (LevelConnection const& connection : level.connections) {
            connections_.push_back({connection, nullptr});
        }
    }

    void addWorld() { // always created, so that ids do not depend on whether the level states it
        addMembers("world", level_.world, "/world", Origin::Kind::world, 0);
    }

    void addObjects() {
        for (std::size_t const i : sortedIndices(level_.objects.size(), [&](std::size_t a, std::size_t b) {
                 return level_.objects[a].name < level_.objects[b].name;
             })) {
            add(expander_.expand(level_.objects[i], scope_), level_.objects[i].path, Origin::Kind::object, i);
        }
    }

    void addJoints() {
        std::vector<std::string> const names = jointNames(level_);
        for (std::size_t const i :
             sortedIndices(names.size(), [&](std::size_t a, std::size_t b) { return names[a] < names[b]; })) {
            addMembers(names[i], level_.joints[i].properties, level_.joints[i].path, Origin::Kind::joint, i);
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
            placed_.push_back(entryOf(placement, names[i]));
            add(expander_.expand(placed_.back(), scope_, StatedProperties::Form::placement), placement.path,
                Origin::Kind::placement, order[i]);
        }
    }

    void create(Store& store) {
        for (PartDefinition const* part : library_.all()) {
            numbers_.emplace(part, store.prototypes().add(part->prototype()));
        }
        for (Made& made : made_) {
            std::string const& name = made.object.name;
            if (store.find(name).valid()) {
                problem(made.path, fmt::format("the name '{}' is taken", name), "a unique name");
            } else if (name.size() > limits::name && made.object.stated.front().scope != &scope_) {
                problem(made.path, fmt::format("the name '{}' of a piece is too long", name),
                        fmt::format("at most {} bytes", limits::name));
            } else {
                made.id = store.create(name, originOf(made));
            }
        }
        for (auto const& [name, piece] : aliases_) {
            if (ObjectId const id = store.find(piece); id.valid() && !store.alias(name, id)) {
                problem("", fmt::format("the name '{}' is taken", name), "a unique name");
            }
        }
        for (Made& made : made_) {
            if (made.id.valid() && !furnish(store, made)) {
                problem(made.path,
                        fmt::format(
                            "the texts and lists in the properties of all objects take more than {} bytes",
                            allowance_.most()),
                        "fewer or simpler objects");
                return;
            }
        }
    }

    void checkRules(Store const& store) {
        ObjectRules const rules(registry_, store);
        for (Made const& made : made_) {
            for (BrokenRule const& broken : rules.brokenBy(made.id)) {
                addProblem(problems_, [&] {
                    return propertyProblem(made, *broken.property, "",
                                           fmt::format("{}: {}", made.object.name, broken.fault), "");
                });
            }
        }
    }

    void addWires(std::span<LevelConnection const> wires) {
        for (LevelConnection const& wire : wires) {
            connections_.push_back({wire, nullptr});
        }
    }

    [[nodiscard]] std::span<MadeConnection const> connections() const { return connections_; }

    /// The objects of one kind that create() made, by index in their list of `count` entries, and those of
    /// composites among them.
    [[nodiscard]] std::vector<ObjectId> created(Origin::Kind kind, std::size_t count,
                                                std::map<std::size_t, std::vector<ObjectId>>* pieces) const {
        std::vector<ObjectId> ids(count);
        for (Made const& made : made_) {
            if (made.origin.kind != kind) {
                continue;
            }
            std::size_t const entry = made.origin.number;
            auto const main = mains_.find({kind, entry});
            if (main == mains_.end() || main->second == made.origin.piece) {
                ids[entry] = made.id;
            }
            if (main != mains_.end() && pieces != nullptr) {
                (*pieces)[entry].push_back(made.id);
            }
        }
        return ids;
    }

private:
    void add(ExpandedEntry expanded, std::string const& path, Origin::Kind kind, std::size_t index) {
        if (made_.size() + expanded.objects.size() > limits::made) {
            problem(path, "there are too many objects, the pieces of parts included",
                    fmt::format("at most {}", limits::made));
            return;
        }
        if (!expanded.aliases.empty()) {
            mains_[{kind, index}] = static_cast<std::uint32_t>(expanded.main);
        }
        for (std::size_t i = 0; i < expanded.objects.size(); ++i) {
            made_.push_back({std::move(expanded.objects[i]),
                             path,
                             {.kind = kind,
                              .prototype = {},
                              .number = index,
                              .maker = {},
                              .piece = static_cast<std::uint32_t>(i)}});
        }
        std::move(expanded.aliases.begin(), expanded.aliases.end(), std::back_inserter(aliases_));
        std::move(expanded.connections.begin(), expanded.connections.end(), std::back_inserter(connections_));
    }

    void addMembers(std::string name, PropertySet const& properties, std::string const& path,
                    Origin::Kind kind, std::size_t index) {
        MadeObject object;
        object.name = std::move(name);
        object.stated.push_back({&properties, &scope_, path, StatedProperties::Form::members});
        made_.push_back(
            {std::move(object), path, {.kind = kind, .prototype = {}, .number = index, .maker = {}}});
    }

    [[nodiscard]] Origin originOf(Made const& made) const {
        Origin origin = made.origin;
        if (made.object.part != nullptr) {
            origin.prototype = numbers_.at(made.object.part);
        }
        return origin;
    }

    /// A problem at a path in the file of a scope.
    [[nodiscard]] Diagnostic diagnostic(StatementScope const& scope, std::string path, std::string message,
                                        std::string expected) const {
        return scope.document != nullptr
                   ? scope.document->diagnostic(std::move(path), std::move(message), std::move(expected))
                   : level_.diagnostic(std::move(path), std::move(message), std::move(expected));
    }

    void problem(std::string path, std::string message, std::string expected) {
        addProblem(problems_, [&] {
            return level_.diagnostic(std::move(path), std::move(message), std::move(expected));
        });
    }

    /// A problem with an object's property, where that is stated.
    [[nodiscard]] Diagnostic propertyProblem(Made const& made, PropertyInfo const& info,
                                             std::string const& inside, std::string message,
                                             std::string expected) const {
        auto const [scope, path] = made.object.placeOf(info);
        return diagnostic(*scope, path + inside, std::move(message), std::move(expected));
    }

    /// Returns false if all objects so far hold too much.
    [[nodiscard]] bool furnish(Store& store, Made& made) {
        PropertySet properties = made.object.properties();
        if (!allowance_.take(properties)) {
            return false;
        }
        for (PropertySet::Entry const& entry : properties.entries()) {
            StatementScope const& scope = *made.object.determining(*entry.info)->scope;
            for (DanglingReference const& dangling :
                 resolveReferences(*entry.value, *scope.names, store, scope.prefix)) {
                addProblem(problems_, [&] {
                    return propertyProblem(made, *entry.info, dangling.path,
                                           fmt::format("there is no object '{}'{}", dangling.name,
                                                       didYouMean(dangling.name, objectNames())),
                                           scope.document != nullptr ? "the name of a piece of this part"
                                                                     : "the name of an object of this level");
                });
            }
            entry.value->assignTo(store.column(*entry.info), made.id);
        }
        if (std::vector<std::string> without = made.object.without(); !without.empty()) {
            store.column<Without>().set(made.id, {std::move(without)});
        }
        return true;
    }

    [[nodiscard]] std::vector<std::string> objectNames() const {
        std::vector<std::string> names;
        for (Made const& made : made_) {
            names.push_back(made.object.name);
        }
        return names;
    }

    Registry const& registry_;
    LevelFile const& level_;
    PartLibrary const& library_;
    Problems& problems_;
    StatementScope const scope_{&level_.names, "", nullptr}; ///< of the level
    PartExpander expander_;
    PropertyAllowance allowance_;
    std::deque<LevelObject> placed_; ///< entries of the placements
    std::vector<Made> made_;         ///< in the order in which they are created
    std::vector<std::pair<std::string, std::string>> aliases_;
    std::vector<MadeConnection> connections_;
    /// For each entry or placement made from a composite, the number of its main piece among its objects.
    std::map<std::pair<Origin::Kind, std::size_t>, std::uint32_t> mains_;
    std::map<PartDefinition const*, std::uint32_t> numbers_; ///< of prototypes; never iterated over
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
    builder.addWires(wires);
    checkToolbox(level, library, problems);
    for (auto const& [effect, detail] : level.detail) {
        options.detail.try_emplace(effect, detail);
    }
    BuiltLevel built;
    built.world = std::make_unique<World>(registry, std::move(options));
    Store& store = built.world->store();
    builder.create(store);
    problems.throwIfAny(); // rules may assume that references are valid
    builder.checkRules(store);
    layConnections(registry, level, builder.connections(), store, problems);
    for (auto const& [connection, document] : builder.connections()) {
        built.connections.push_back(std::minmax(store.find(connection.a), store.find(connection.b)));
    }
    std::sort(built.connections.begin(), built.connections.end());
    problems.throwIfAny(); // and completions may assume that all rules hold
    built.world->start();
    built.objects = builder.created(Origin::Kind::object, level.objects.size(), &built.objectPieces);
    built.joints = builder.created(Origin::Kind::joint, level.joints.size(), nullptr);
    built.placements = builder.created(Origin::Kind::placement, placements.size(), &built.placementPieces);
    return built;
}

std::unique_ptr<World> buildWorld(Registry const& registry, LevelFile const& level,
                                  PartLibrary const& library, std::span<Placement const> placements,
                                  WorldOptions options) {
    return buildLevel(registry, level, library, placements, std::move(options)).world;
}

} // namespace trembler
