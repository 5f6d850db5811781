// Numbers found by a part of their names, compared with what watch::find() accepts.
#include "insight/probe/named_numbers.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>

namespace trembler {
namespace {

class NamedNumbersTest : public Experiment {
protected:
    [[nodiscard]] watch::NamedNumbers named(std::string const& object, std::string const& word,
                                            std::size_t most = 1000) const {
        return watch::namedNumbers(world(), fields_, object, word, most);
    }
    static bool has(std::vector<std::string> const& names, std::string const& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    }
    std::vector<watch::WatchedField> const fields_ = watch::watchedFields(gameData().registry);
};

TEST_F(NamedNumbersTest, FindsNumbersOfTheWorldOfListsAndThoseWithoutAValue) {
    open("1-switched-electromagnet.json");
    EXPECT_TRUE(has(named("", "gravity").found, "world.gravity"));
    EXPECT_EQ(named("", "world.gravity.y").found.front(), "world.gravity.y")
        << "a component, by its exact name";
    EXPECT_EQ(named("", "contacts.current.count").found.front(), "world.contacts.current.count");
    EXPECT_TRUE(has(named("switch", "WIDTH").found, "switch.shape.0.width"));
    EXPECT_EQ(named("switch", "shape.3.width").found.front(), "switch.shape.3.width");
    EXPECT_EQ(named("", "switch.mass").found.front(), "switch.mass") << "of an object that is not selected";
    auto const cells =
        watch::find(world(), fields_, "electromagnet.electrical_quantities.current").read(world());
    ASSERT_TRUE(std::holds_alternative<std::monostate>(cells.front())) << "the level computes no amperes";
    EXPECT_TRUE(has(named("electromagnet", "quantities.current").found,
                    "electromagnet.electrical_quantities.current"));
}

TEST_F(NamedNumbersTest, EveryNameItFindsCanBePlotted) {
    open("1-switched-electromagnet.json");
    for (std::string const& name : named("switch", ".").found) {
        try {
            (void)watch::find(world(), fields_, name);
        } catch (std::invalid_argument const& error) {
            ADD_FAILURE() << name << ": " << error.what();
        }
    }
    EXPECT_GT(named("switch", ".").found.size(), 50U);
    EXPECT_FALSE(has(named("switch", "material").found, "switch.material")) << "a text";
}

TEST_F(NamedNumbersTest, CountsWhatItLeavesOut) {
    open("1-switched-electromagnet.json");
    auto const all = named("switch", "o");
    auto const few = named("switch", "o", 5);
    EXPECT_EQ(few.found.size(), 5U);
    EXPECT_EQ(few.more, all.found.size() - 5);
    EXPECT_TRUE(std::equal(few.found.begin(), few.found.end(), all.found.begin()));
}

TEST_F(NamedNumbersTest, NamesWhatMayBeMeant) {
    open("1-switched-electromagnet.json");
    EXPECT_TRUE(has(named("", "world.gravty").similar, "world.gravity"));
    EXPECT_TRUE(has(named("switch", "positoin").similar, "switch.position"));
    EXPECT_TRUE(has(named("", "swicth.position").similar, "switch.position"));
    EXPECT_TRUE(named("", "qqqqqqqqqqqq").similar.empty());
}

} // namespace
} // namespace trembler
