// Wires that the player lays: they count, last through other edits, are undone, recorded and loaded.
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace session_wires_test {
namespace {

class Wires : public Experiment {
protected:
    [[nodiscard]] static LevelFile level() {
        return loadLevel(gameData().registry,
                         std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/game/ui/data/wires.json");
    }
    Wires() : session(gameData().registry, gameData().parts, level()) {}

    [[nodiscard]] ObjectId find(char const* name) const { return session.world().store().find(name); }
    [[nodiscard]] std::string refusal(char const* a, char const* b) const {
        return session.checkWire(find(a), find(b)).why;
    }
    bool lights() {
        for (int i = 0; i < 10; ++i) {
            session.step();
        }
        bool const solved = session.solved();
        session.stop();
        return solved;
    }

    Session session;
};

TEST_F(Wires, CloseACircuitAndAreUndone) {
    EXPECT_FALSE(lights());
    EXPECT_EQ(session.wiresLeft(), 2);
    ASSERT_TRUE(session.layWire(find("plus"), find("lamp")));
    EXPECT_EQ(session.wiresLeft(), 1);
    EXPECT_TRUE(lights());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.wiresLeft(), 2);
    EXPECT_FALSE(lights());
    ASSERT_TRUE(session.redo());
    EXPECT_TRUE(lights());
    EXPECT_TRUE(session.takeWire(find("lamp"), find("plus")));
    EXPECT_FALSE(session.takeWire(find("lamp"), find("minus"))) << "the level's own";
    EXPECT_FALSE(lights());
}

TEST_F(Wires, WithoutALimitStayUnlimited) {
    LevelFile free = level();
    free.wires = unlimitedCount;
    free.toolbox[0].count = unlimitedCount;
    Session many(gameData().registry, gameData().parts, free);
    std::vector<int> bars;
    for (int i = 0; i < 6; ++i) {
        auto const bar = many.place({"steel bar", {-2.5, 0.8 + 0.4 * i}, 0, ""});
        ASSERT_TRUE(bar) << i;
        bars.push_back(*bar);
    }
    EXPECT_EQ(many.toolbox()[0].left, unlimitedCount);
    std::size_t laid = 0;
    for (std::size_t a = 0; a < bars.size(); ++a) {
        for (std::size_t b = a + 1; b < bars.size(); ++b) {
            ASSERT_TRUE(many.layWire(many.objectOf(bars[a]), many.objectOf(bars[b])));
            EXPECT_EQ(many.wires().size(), ++laid);
            EXPECT_EQ(many.wiresLeft(), unlimitedCount);
        }
    }
    EXPECT_EQ(laid, 15U);
    ASSERT_TRUE(many.undo());
    EXPECT_EQ(many.wires().size(), 14U);
    ASSERT_TRUE(many.redo());
    EXPECT_EQ(many.wires().size(), 15U);
    // A recording has them all, also after it was written and read; and it plays as the session does.
    Solution const recorded = many.record("many");
    LevelFile copy = free;
    copy.solutions = {recorded};
    auto const document = JsonDocument::parse(levelText(copy), "copy.json");
    LevelFile const read = readLevel(gameData().registry, document);
    EXPECT_EQ(read.wires, unlimitedCount);
    Session again(gameData().registry, gameData().parts, read);
    again.load(read.solutions.at(0));
    EXPECT_EQ(again.wires().size(), 15U);
    EXPECT_EQ(again.wiresLeft(), unlimitedCount);
    for (int i = 0; i < 30; ++i) {
        many.step();
        again.step();
    }
    EXPECT_EQ(many.world().stateHash(), again.world().stateHash());
    again.stop();
    EXPECT_TRUE(
        again.takeWire(again.objectOf(again.placed()[0].number), again.objectOf(again.placed()[1].number)));
    EXPECT_EQ(again.wires().size(), 14U);
}

TEST_F(Wires, AreRefusedInWords) {
    EXPECT_EQ(refusal("plus", "lamp"), "");
    EXPECT_NE(refusal("plus", "floor"), "");
    EXPECT_NE(refusal("plus", "plus"), "");
    EXPECT_EQ(refusal("minus", "lamp"), "There is a wire between them already.");
    ASSERT_TRUE(session.layWire(find("plus"), find("lamp")));
    EXPECT_EQ(refusal("lamp", "plus"), "There is a wire between them already.");
    ASSERT_TRUE(session.layWire(find("plus"), find("minus")));
    auto const bar = session.place({"steel bar", {-1.5, 2.5}, 0, ""});
    ASSERT_TRUE(bar);
    EXPECT_EQ(refusal("plus", "steel bar 1"), "There is no wire left in the toolbox.");
}

TEST_F(Wires, GoWithThePartsAtTheirEnds) {
    auto const bar = session.place({"steel bar", {-1.5, 2.5}, 0, ""});
    ASSERT_TRUE(bar);
    ASSERT_TRUE(session.layWire(find("plus"), session.objectOf(*bar)));
    ASSERT_TRUE(session.layWire(find("lamp"), session.objectOf(*bar)));
    EXPECT_TRUE(lights());
    ASSERT_TRUE(session.move(*bar, {-1.5, 2.8}, 0));
    EXPECT_EQ(session.wires().size(), 2U);
    ASSERT_TRUE(session.putBack(*bar));
    EXPECT_TRUE(session.wires().empty());
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(session.wires().size(), 2U);
    EXPECT_TRUE(lights());
    ASSERT_TRUE(session.putAllBack());
    EXPECT_TRUE(session.wires().empty());
    EXPECT_EQ(session.wiresLeft(), 2);
}

TEST_F(Wires, AreRecordedWrittenAndLoaded) {
    LevelFile const file = level();
    ASSERT_EQ(file.wires, 2);
    for (Solution const& solution : file.solutions) {
        session.load(solution);
        EXPECT_EQ(session.wires().size(), solution.wires.size());
        EXPECT_TRUE(lights()) << solution.name;
    }
    Solution const again = session.record("again");
    ASSERT_EQ(again.wires.size(), 2U);
    EXPECT_EQ(again.wires[0].a, "lamp");
    EXPECT_EQ(again.wires[0].b, "steel bar 1");
    // The written level states the same.
    LevelFile const copy = readLevel(gameData().registry, JsonDocument::parse(levelText(file), "copy.json"));
    EXPECT_EQ(copy.wires, 2);
    ASSERT_EQ(copy.solutions.size(), 2U);
    EXPECT_EQ(copy.solutions[1].wires.size(), 2U);
    EXPECT_EQ(levelText(copy), levelText(file));
}

TEST_F(Wires, OfASolutionAreChecked) {
    auto const refused = [&](char const* solution) -> std::string {
        std::string const text = std::string(R"({"version": 2, "title": "w", "objects": [
            {"name": "plus", "part": "battery +"}, {"name": "lamp", "part": "lamp", "at": [1, 1]}],
            "toolbox": [{"wire": 1}], "solutions": [)") +
                                 solution + "]}";
        try {
            (void)readLevel(gameData().registry, JsonDocument::parse(text, "w.json"));
        } catch (InputError const& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refused(R"({"name": "a", "wires": [["plus", "lamp"]]})"), "");
    EXPECT_NE(refused(R"({"name": "a", "wires": [["plus", "lamb"]]})").find("lamb"), std::string::npos);
    EXPECT_NE(refused(R"({"name": "a", "wires": [["plus", "plus"]]})").find("itself"), std::string::npos);
    EXPECT_NE(refused(R"({"name": "a", "wires": ["plus"]})").find("two objects"), std::string::npos);
    EXPECT_NE(refused(R"({"name": "a", "wires": [["plus", "lamp"], ["lamp", "plus"]]})").find("only one"),
              std::string::npos);
}

} // namespace
} // namespace session_wires_test
} // namespace trembler
