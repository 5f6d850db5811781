// Watched numbers compared with formulas, and the messages for unknown names.
#include "game/watch/watch_table.hpp"
#include "tests/support/experiment.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

namespace trembler {
namespace {

using Table = std::map<std::string, std::vector<std::string>>; // columns by their headers

Table parsed(std::string const& text) {
    Table table;
    std::vector<std::string> headers;
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
        std::vector<std::string> cells(1);
        for (char const c : line) { // no cell is quoted here
            if (c == ',') {
                cells.emplace_back();
            } else {
                cells.back() += c;
            }
        }
        if (headers.empty()) {
            headers = cells;
        } else {
            EXPECT_EQ(cells.size(), headers.size()) << line;
            for (std::size_t i = 0; i < cells.size(); ++i) {
                table[headers[i]].push_back(cells[i]);
            }
        }
    }
    return table;
}

double number(std::string const& cell) {
    double value = std::nan("");
    std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return value;
}

class WatchTest : public Experiment {
protected:
    static LevelFile level(std::string const& more, std::string const& objects) {
        return readLevel(gameData().registry, JsonDocument::parse(R"({"version": 2, "title": "t", )" + more +
                                                                      R"("objects": [)" + objects + "]}",
                                                                  "watch.json"));
    }
    /// Runs the open level and returns the table as text.
    std::string watched(std::vector<std::string> const& what, int frames, std::uint64_t every = 1) {
        std::ostringstream out;
        watch::WatchTable table(gameData().registry, world(), what, every, out);
        table.look(world());
        for (int i = 0; i < frames; ++i) {
            step();
            table.look(world());
        }
        return out.str();
    }
    std::string refusalOf(std::string const& what) {
        try {
            static_cast<void>(watch::find(world(), watch::watchedFields(gameData().registry), what));
        } catch (std::invalid_argument const& error) {
            return error.what();
        }
        return "";
    }
};

std::string const ball =
    R"({"name": "ball", "at": [1, 40], "properties": {"shape": [{"form": "circle", "radius": 0.1}],
        "mass": 2, "velocity": [3, 0], "angular_velocity_deg": 90}})";

TEST_F(WatchTest, AFallingBallGainsTheSpeedThatGravityCauses) {
    open(level(R"("world": {"gravity": [0, -9.81]}, )", ball));
    Table const table = parsed(watched(
        {"ball.position", "ball.velocity", "ball.angle_deg", "ball.gravity_force.force", "world.gravity"},
        120, 6));
    auto const& time = table.at("time [s]");
    auto const& x = table.at("ball.position.x [m]");
    auto const& fall = table.at("ball.velocity.y [m/s]");
    auto const& turned = table.at("ball.angle_deg [deg]");
    ASSERT_EQ(time.size(), 21U) << "the start and every sixth of 120 frames";
    for (std::size_t i = 1; i + 1 < time.size(); ++i) {
        double const t = number(time[i]);
        EXPECT_DOUBLE_EQ(t, 0.1 * static_cast<double>(i));
        EXPECT_NEAR(number(x[i]), 1 + 3 * t, 1e-4);
        EXPECT_NEAR(number(turned[i]), 90 * t, 1e-2);
        EXPECT_NEAR(number(fall[i + 1]) - number(fall[i]), -9.81 * 0.1, 1e-4);
        EXPECT_NEAR(number(table.at("ball.gravity_force.force.y [N]")[i]), -2 * 9.81, 1e-9);
        EXPECT_EQ(table.at("world.gravity.y [m/s²]")[i], "-9.81");
    }
}

TEST_F(WatchTest, ADividerHasTheVoltsOfItsResistances) {
    LevelFile circuit = level("", R"(
        {"name": "plus", "at": [0, 0], "properties": {"conductor": true, "electrical_source": true, "emf": {"voltage": 9}}},
        {"name": "upper", "at": [1, 0], "properties": {"conductor": true, "resistance": 2}},
        {"name": "lower", "at": [2, 0], "properties": {"conductor": true, "resistance": 1}},
        {"name": "minus", "at": [3, 0], "properties": {"conductor": true, "electrical_return": true}})");
    circuit.connections = {{"plus", "upper", ""}, {"upper", "lower", ""}, {"lower", "minus", ""}};
    open(circuit);
    Table const table = parsed(watched({"upper.current", "lower.current", "upper.power",
                                        "lower.electrical_quantities.potential", "upper.on"},
                                       5));
    for (auto const& [header, volts] : std::map<std::string, double>{
             {"upper.current [A]", 3},
             {"lower.current [A]", 3},
             {"upper.power [W]", 18},
             {"lower.electrical_quantities.potential [V]", 1.5}, // at the middle of the divider
             {"upper.on", 1}}) {
        EXPECT_NEAR(number(table.at(header).back()), volts, 1e-9) << header;
        EXPECT_EQ(table.at(header).front(), "") << "unknown before the first frame";
    }
}

// No component reads the force of a joint, so it is computed only because it is watched.
TEST_F(WatchTest, AJointBearsTheWeightThatHangsOnIt) {
    LevelFile hanging = level(R"("world": {"gravity": [0, -9.81]}, "joints": [
        {"name": "pin", "form": "hinge", "a": "ball", "at": [1, 40.5]}], )",
                              R"({"name": "ball", "at": [1, 40],
        "properties": {"shape": [{"form": "circle", "radius": 0.1}], "mass": 2}})");
    open(hanging);
    Table const table = parsed(watched({"pin.joint_forces.force"}, 30));
    double const bears = number(table.at("pin.joint_forces.force.y [N]")[20]);
    EXPECT_NEAR(std::abs(bears), 2 * 9.81, 0.02);
}

TEST_F(WatchTest, ChangesNothingAndDependsOnNoOrderAndNoThreads) {
    std::vector<std::string> const what{"raft body.position", "flotation device A.buoyancy_force.force",
                                        "world.solver_choice.substeps", "raft body.angle_deg"};
    open("4-raft.json");
    runTo(120);
    std::uint64_t const alone = world().stateHash();
    std::vector<Table> tables;
    for (int const threads : {1, 4}) {
        WorldOptions options;
        options.threads = threads;
        options.rowsWorthThreads = 0;
        Session session(gameData().registry, gameData().parts, load("4-raft.json"), options);
        std::ostringstream out;
        std::vector<std::string> order = what;
        if (threads > 1) {
            std::reverse(order.begin(), order.end());
        }
        watch::WatchTable table(gameData().registry, session.world(), order, 1, out);
        for (int i = 0; i < 120; ++i) {
            session.step();
            table.look(session.world());
        }
        EXPECT_EQ(session.world().stateHash(), alone);
        tables.push_back(parsed(out.str()));
    }
    EXPECT_EQ(tables[0], tables[1]) << "every digit of every cell";
    EXPECT_FALSE(tables[0].at("flotation device A.buoyancy_force.force.y [N]").back().empty());
}

TEST_F(WatchTest, ARemovedObjectHasEmptyCells) {
    open("1-switched-electromagnet.json");
    std::ostringstream out;
    watch::WatchTable table(gameData().registry, world(), {"switch.position", "switch.mass"}, 1, out);
    table.look(world());
    session().start();
    session().feed({PlayerInput::Kind::remove, id("switch"), {}, {}});
    for (int i = 0; i < 5; ++i) {
        step();
        table.look(world());
    }
    EXPECT_FALSE(world().store().find("switch").valid());
    Table const table2 = parsed(out.str());
    for (char const* const header : {"switch.position.x [m]", "switch.position.y [m]", "switch.mass [kg]"}) {
        EXPECT_NE(table2.at(header).front(), "") << header;
        EXPECT_EQ(table2.at(header).back(), "") << header;
    }
}

TEST_F(WatchTest, UnknownNamesAreReportedWithSimilarOnes) {
    open("4-raft.json");
    step();
    auto const says = [&](std::string const& what, std::string const& part) {
        std::string const said = refusalOf(what);
        EXPECT_NE(said.find(part), std::string::npos) << what << ": " << said;
    };
    says("raft bdoy.position", "did you mean 'raft body'?");
    says("raft body.positon", "did you mean 'position'?");
    says("raft body.force", "'buoyancy_force.force'");
    says("raft body", "OBJECT.FIELD");
    says("world.substep", "did you mean 'substeps'?");
    says("raft body.solver_choice.substeps", "nothing called");
    EXPECT_EQ(refusalOf("raft body.position"), "");
    EXPECT_EQ(refusalOf("raft body.at"), "");
    EXPECT_EQ(refusalOf("raft body.electrical_quantities.current"), "") << "an empty column";
    EXPECT_EQ(refusalOf("bullet of cannon 3.position"), "") << "may be created while it runs";
    says("king of hearts.position", "there is no object 'king of hearts'");
}

// Every described field can be read in a world with objects of all kinds.
TEST_F(WatchTest, EveryFieldOfTheProgramCanBeRead) {
    auto const fields = watch::watchedFields(gameData().registry);
    EXPECT_GT(fields.size(), 80U);
    open("3d-motor-and-generator.json");
    runTo(30);
    std::size_t filled = 0;
    for (watch::WatchedField const& field : fields) {
        for (std::uint32_t index = 0; index < world().store().objects().indexBound(); ++index) {
            ObjectId const id = world().store().objects().at(index);
            std::string const name = id.valid() ? world().store().nameOf(id) : "nobody";
            watch::Watch const watch("w", name, field);
            auto const cells = watch.read(world());
            EXPECT_EQ(cells.size(), watch.headers().size());
            filled += std::holds_alternative<std::monostate>(cells.front()) ? 0 : 1;
        }
    }
    EXPECT_GT(filled, 500U);
}

} // namespace
} // namespace trembler
