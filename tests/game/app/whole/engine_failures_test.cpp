// The program continues after the failure of an engine, and reports the failure once.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

namespace trembler::test {
namespace {

using nlohmann::json;

class EngineFailures : public InAFolder {
protected:
    /// Runs the program on a level on every engine.
    void run(std::string const& name, json const& level, std::function<void(Ran const&)> const& look = {}) {
        write(at(name), level.dump());
        for (std::string const engine : {"native", "box2d", "chipmunk", "ode"}) {
            SCOPED_TRACE(name + " on " + engine);
            Ran const ran =
                runProgram({"run", at(name), "--frames", "60", "--json", "--detail", "dynamics=" + engine});
            EXPECT_NE(ran.status, -1) << ran.err;
            // Debian's Chipmunk is a debug build, which prints a message for each space.
            EXPECT_EQ((ran.out + ran.err).find("Initializing"), std::string::npos) << ran.out << ran.err;
            json const report = json::parse(ran.out, nullptr, false);
            if (!report.is_discarded() && report.contains("warnings")) {
                EXPECT_TRUE(report["warnings"].is_array());
            }
            if (look) {
                look(ran);
            }
        }
    }
};

json object(std::string const& name, double x, double y, json const& piece,
            json properties = json::object()) {
    properties["shape"] = json::array({piece});
    return {{"name", name}, {"at", {x, y}}, {"properties", properties}};
}

json levelOf(json const& objects, json const& joints) {
    return {{"version", 2},       {"title", "Extremes"},
            {"text", "Extremes"}, {"world", {{"gravity", {0, -9.81}}, {"bounds", {-5, -5, 10, 10}}}},
            {"objects", objects}, {"joints", joints}};
}

json const box = {{"form", "box"}, {"width", 1}, {"height", 1}};

TEST_F(EngineFailures, OfASliderWithExchangedLimitsAreReported) {
    run("slider.json",
        levelOf(json::array({object("a", 0, 0, box)}),
                json::array({{{"form", "slider"}, {"a", "a"}, {"upper", -1}}})),
        [](Ran const& ran) {
            EXPECT_EQ(ran.status, 2);
            EXPECT_NE(ran.err.find("above its upper"), std::string::npos) << ran.err;
        });
}

TEST_F(EngineFailures, OfAStiffSpringDoNotEndTheProgram) {
    json const polygon = {{"form", "polygon"}, {"corners", {{-1, -1}, {1, -1}, {0, 1}}}};
    run("spring.json", levelOf(json::array({object("a", 0, 3, polygon),
                                            object("b", 3, 0, {{"form", "circle"}, {"radius", 30}})}),
                               json::array({{{"form", "slider"}, {"a", "b"}, {"at", {3, 0}}},
                                            {{"form", "spring"},
                                             {"a", "a"},
                                             {"b", "b"},
                                             {"at", {0, 3}},
                                             {"at_b", {3, 0}},
                                             {"length", 1},
                                             {"stiffness", 1e9}}})));
}

TEST_F(EngineFailures, OfAFeatherOnARopeDoNotEndTheProgram) {
    run("rope.json",
        levelOf(json::array({object("a", 0, 2, box),
                             object("b", 1.2, 2, {{"form", "box"}, {"width", 1}, {"height", 0.05}},
                                    {{"density", 0.001}})}),
                json::array({{{"form", "rope"}, {"a", "a"}, {"b", "b"}, {"at", {0, 2}}, {"at_b", {1.2, 2}}},
                             {{"form", "weld"}, {"a", "b"}, {"b", "a"}, {"at", {0.6, 2}}}})));
}

TEST_F(EngineFailures, OfAHundredBoxesInOnePlaceDoNotEndTheProgram) {
    json boxes = json::array();
    for (int i = 0; i < 100; ++i) {
        boxes.push_back(
            object("box " + std::to_string(i), 0, 1, {{"form", "box"}, {"width", 0.2}, {"height", 0.2}}));
    }
    run("boxes.json", levelOf(boxes, json::array()));
}

} // namespace
} // namespace trembler::test
