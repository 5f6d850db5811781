#include "tests/runtime/level/sample_properties.hpp"

#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/read_part.hpp"
#include "runtime/population/population_resolver.hpp"

namespace trembler::sample {
namespace {

std::optional<std::string> checkWeight(Store const& store, ObjectId id) {
    if ((*store.findColumn<Weight>())[id].value == 13) {
        return "the weight is 13; expected a luckier number";
    }
    return std::nullopt;
}

std::optional<std::string> refuseString(Store const& store, ObjectId a, ObjectId b) {
    auto const* const tags = store.findColumn<Tag>();
    if (tags == nullptr || !tags->has(a) || !tags->has(b)) {
        return "only what has a tag can be connected";
    }
    return std::nullopt;
}

void layString(Store& store, ObjectId a, ObjectId b) {
    store.column<Links>().addDefault(a);
    store.column<Links>()[a].to.push_back(b);
}

} // namespace

void fill(Registry& registry) {
    registerRuntime(registry);
    registry.property<Weight>();
    registry.property<Tag>();
    registry.property<Cake>();
    registry.property<Climate>();
    registry.property<Knot>();
    registry.property<Links>();
    registry.rule({&propertyInfo<Weight>(), checkWeight});
    registry.connector({"string", "sample", "a string between two tags", refuseString, layString});
}

LevelFile read(Registry const& registry, std::string text) {
    return readLevel(registry, JsonDocument::parse(std::move(text), "test.json"));
}

PartLibrary parts(Registry const& registry, std::vector<std::string> const& texts) {
    PartLibrary library;
    for (std::string const& text : texts) {
        library.add(readPart(registry, JsonDocument::parse(text, "part.json")));
    }
    return library;
}

std::vector<std::string> problemsOf(Registry const& registry, std::string text) {
    try {
        (void)read(registry, std::move(text));
        return {};
    } catch (InputError const& error) {
        std::vector<std::string> printed;
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            printed.push_back(diagnostic.print());
        }
        return printed;
    }
}

std::string only(std::vector<std::string> const& problems) {
    std::string all = problems.size() == 1 ? "" : "(" + std::to_string(problems.size()) + " problems)";
    for (std::string const& problem : problems) {
        all += (all.empty() ? "" : "\n") + problem;
    }
    return all;
}

} // namespace trembler::sample
