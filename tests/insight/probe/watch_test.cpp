// Watched numbers compared with formulas, and the messages for unknown names.
#include "insight/probe/watch_table.hpp"
#include "tests/support/experiment.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <set>
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

/// Collects every value of a visited property, with the address by which it is watched. Written without the
/// list of watched fields, which it tests.
class Walk final : public FieldVisitor {
public:
    Walk(World const& world, std::string address) : world_(world), address_(std::move(address)) {}
    /// For a default value: gives each list one element, and each choice the value of that number.
    Walk(World const& world, std::string address, std::size_t option) : Walk(world, std::move(address)) {
        option_ = option;
    }

    std::map<std::string, watch::Cell> found;

    void boolean(FieldInfo const& info, bool& value) override { found[at(info)] = value ? 1.0 : 0.0; }
    void integer(FieldInfo const& info, std::int32_t& value) override {
        found[at(info)] = static_cast<double>(value);
    }
    void number(FieldInfo const& info, double& value) override {
        found[at(info)] = isAngle(info.unit) ? value * (180 / pi) : value;
    }
    void vector(FieldInfo const& info, Vec2& value) override {
        found[at(info) + ".x"] = value.x;
        found[at(info) + ".y"] = value.y;
    }
    void text(FieldInfo const& info, std::string& value) override { found[at(info)] = value; }
    void object(FieldInfo const& info, ObjectId& value) override {
        found[at(info)] = value.valid() ? watch::Cell(world_.store().nameOf(value)) : watch::Cell();
    }
    void choice(FieldInfo const& info, ChoiceField field) override {
        if (option_) {
            field.index = static_cast<int>(*option_ % field.names.size());
        }
        found[at(info)] = std::string(field.names[static_cast<std::size_t>(field.index)]);
    }
    void list(FieldInfo const& info, ListField& list) override {
        if (option_) {
            list.resize(1);
        }
        std::string const outer = address_;
        std::string const here = at(info);
        found[here + ".count"] = static_cast<double>(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            address_ = here + "." + std::to_string(i);
            list.visitElement(i, *this);
        }
        address_ = outer;
    }

private:
    [[nodiscard]] std::string at(FieldInfo const& info) const {
        return info.key == "value" ? address_ : address_ + "." + std::string(info.key);
    }

    World const& world_;
    std::string address_;
    std::optional<std::size_t> option_;
};

bool areEqual(watch::Cell const& a, watch::Cell const& b) {
    auto const* const x = std::get_if<double>(&a);
    auto const* const y = std::get_if<double>(&b);
    return a == b || (x != nullptr && y != nullptr && std::isnan(*x) && std::isnan(*y));
}

/// Every property of the program, by its key.
std::map<std::string, PropertyInfo const*> everyProperty(Registry const& registry) {
    std::map<std::string, PropertyInfo const*> all;
    for (PropertyInfo const* info : registry.objectProperties()) {
        all.emplace(info->text.key, info);
    }
    for (Registration const& registration : registry.components()) {
        for (PropertyInfo const* info : registration.info->offers) {
            all.emplace(info->text.key, info);
        }
    }
    return all;
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

// An electromagnet has no field "voltage"; the volts are the potential.
TEST_F(WatchTest, EverydayWordsLeadToTheirFields) {
    open("1-switched-electromagnet.json");
    for (auto const& [word, field] : {std::pair("voltage", "'electrical_quantities.potential'"),
                                      {"amperes", "'electrical_quantities.current'"},
                                      {"watts", "'electrical_quantities.power'"}}) {
        std::string const said = refusalOf(std::string("electromagnet.") + word);
        EXPECT_NE(said.find("see "), std::string::npos) << said;
        EXPECT_NE(said.substr(0, said.find("; it has")).find(field), std::string::npos) << said;
    }
}

TEST_F(WatchTest, ElementsAndComponentsHaveColumnsOfTheirOwn) {
    open(level(R"("world": {"gravity": [0, -9.81]}, )",
               R"({"name": "floor", "at": [1, -0.5], "properties": {"fixed": true,
                    "shape": [{"form": "box", "width": 4, "height": 1}]}},
                  {"name": "ball", "at": [1, 0.1], "properties": {"mass": 2,
                    "shape": [{"form": "circle", "radius": 0.1}]}})"));
    Table const table = parsed(
        watched({"ball.shape.0.radius", "ball.shape.count", "ball.shape.0.at", "ball.shape.1.radius",
                 "ball.shape.0.width", "world.gravity.y", "ball.position.x", "ball.gravity_force.force.y",
                 "world.gravity_force.forces.count", "world.contacts.current.count",
                 "world.contacts.current.0.a", "world.contacts.current.0.b"},
                60));
    auto const last = [&](std::string const& header) { return table.at(header).back(); };
    EXPECT_EQ(last("ball.shape.0.radius [m]"), "0.1");
    EXPECT_EQ(last("ball.shape.count"), "1");
    EXPECT_EQ(last("ball.shape.0.at.x [m]"), "0");
    EXPECT_EQ(last("ball.shape.0.at.y [m]"), "0");
    EXPECT_EQ(last("ball.shape.1.radius [m]"), "") << "it has one piece";
    EXPECT_EQ(last("ball.shape.0.width [m]"), "") << "a circle has none";
    EXPECT_EQ(last("world.gravity.y [m/s²]"), "-9.81");
    EXPECT_NEAR(number(last("ball.position.x [m]")), 1, 1e-6);
    EXPECT_NEAR(number(last("ball.gravity_force.force.y [N]")), -2 * 9.81, 1e-9);
    EXPECT_EQ(last("world.gravity_force.forces.count"), "2");
    EXPECT_EQ(last("world.contacts.current.count"), "1");
    EXPECT_EQ((std::set{last("world.contacts.current.0.a"), last("world.contacts.current.0.b")}),
              (std::set<std::string>{"ball", "floor"}));
}

TEST_F(WatchTest, AListIsReportedWithTheNamesOfItsFields) {
    open("1-switched-electromagnet.json");
    auto const says = [&](std::string const& what, std::string const& part) {
        std::string const said = refusalOf(what);
        EXPECT_NE(said.find(part), std::string::npos) << what << ": " << said;
    };
    says("metal object.shape", "'shape.count'");
    says("metal object.shape", "'shape.0.width'");
    says("metal object.radius", "'shape.0.radius'");
    says("metal object.shape.width", "'shape.0.width'");
    says("metal object.shape[0].width", "'shape.0.width'");
    says("world.contacts", "'contacts.current.count'");
    says("world.gravity.z", "nothing called 'gravity.z'");
    says("metal object.mass.x", "nothing called 'mass.x'");
    says("metal object.shape.-1.width", "nothing called");
    EXPECT_EQ(refusalOf("metal object.shape.0.width"), "");
    EXPECT_EQ(refusalOf("metal object.shape.12.corners.3.y"), "");
    EXPECT_EQ(refusalOf("world.gravity.y"), "");
}

// By the outlines of all properties: of each list one element, with each of its choices.
TEST_F(WatchTest, EveryFieldThatAPropertyDescribesHasAName) {
    auto const fields = watch::watchedFields(gameData().registry);
    open("3d-motor-and-generator.json");
    constexpr std::size_t options = 16; // more than any choice has
    std::set<std::string> without;
    for (auto const& [key, info] : everyProperty(gameData().registry)) {
        std::set<std::string> addresses;
        for (std::size_t option = 0; option < options; ++option) {
            Walk walk(world(), key, option);
            if (info->kind == PropertyKind::object) {
                info->makeValue()->visit(walk);
            } else {
                info->makeSlot()->visitCopy(walk);
            }
            for (auto const& [address, cell] : walk.found) {
                addresses.insert(address);
            }
        }
        for (std::string const& address : addresses) {
            EXPECT_NO_THROW(static_cast<void>(watch::find(world(), fields, "world." + address))) << address;
        }
        if (addresses.empty() && info->kind != PropertyKind::object) {
            without.insert(key);
        }
    }
    // Properties of objects without fields are markers, or no file states them: see MayLackFields. The others
    // describe no fields for these reasons.
    std::map<std::string, std::string> const reasons{
        {"graph_changes", "a journal for components"},
        {"magnet_switching", "ids of events only"},
        {"motion_causes", "ids of events only"},
        {"population_changes", "ids, some of objects that are gone"},
        {"sounds", "data for the loudspeaker; loudness has the levels"},
    };
    for (std::string const& key : without) {
        EXPECT_TRUE(reasons.contains(key)) << key << " describes no fields";
    }
    for (auto const& [key, why] : reasons) {
        EXPECT_TRUE(without.contains(key)) << key << " is listed, but describes fields";
    }
}

// Every value of a running world, compared with the value under its name.
TEST_F(WatchTest, EveryNameReadsTheValueOfItsField) {
    auto const fields = watch::watchedFields(gameData().registry);
    open("3d-motor-and-generator.json");
    runTo(30);
    std::map<std::string, watch::WatchedField> resolved;
    std::size_t compared = 0;
    auto const compare = [&](std::string const& object, Walk const& walk) {
        for (auto const& [address, value] : walk.found) {
            if (!resolved.contains(address)) {
                resolved.emplace(address, watch::find(world(), fields, object + "." + address).field());
            }
            auto const cells = watch::Watch(address, object, resolved.at(address)).read(world());
            ASSERT_EQ(cells.size(), 1U) << address;
            EXPECT_TRUE(areEqual(cells.front(), value)) << object << "." << address;
            ++compared;
        }
    };
    Store const& store = world().store();
    for (auto const& [key, info] : everyProperty(gameData().registry)) {
        if (info->kind != PropertyKind::object) {
            if (SlotBase const* const slot = store.findSlot(*info)) {
                Walk walk(world(), key);
                slot->visitCopy(walk);
                compare("world", walk);
            }
            continue;
        }
        ColumnBase const* const column = store.findColumn(*info);
        for (std::uint32_t index = 0; column != nullptr && index < store.objects().indexBound(); ++index) {
            ObjectId const id = store.objects().at(index);
            if (id.valid() && column->has(id)) {
                Walk walk(world(), key);
                column->visitCopy(id, walk);
                compare(store.nameOf(id), walk);
            }
        }
    }
    EXPECT_GT(compared, 500U);
}

// For each object, whether it has the field or not.
TEST_F(WatchTest, EveryFieldCanBeReadForEveryObject) {
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
