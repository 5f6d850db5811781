#include "render/scene/facts/look_form.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/render/scene/scene_stage.hpp"

namespace trembler::render::test {
namespace {

Shape const plateOfForm{{boxPiece(1, 0.4)}};

Facts conductorWithBody() {
    Facts facts;
    facts.shape = &plateOfForm;
    facts.conductor = true;
    facts.substance = Substance::steel;
    return facts;
}

TEST(LookForm, FollowsFromThePropertiesUnlessStated) {
    Facts facts = conductorWithBody();
    EXPECT_EQ(formOf(facts), LookForm::plain);
    facts.device = true;
    EXPECT_EQ(formOf(facts), LookForm::flash);
    facts.substance = Substance::glass;
    EXPECT_EQ(formOf(facts), LookForm::bulb);
    facts.shape = nullptr;
    EXPECT_EQ(formOf(facts), LookForm::flash) << "without a body nothing is made of glass";

    Facts pole = conductorWithBody();
    pole.source = true;
    EXPECT_EQ(formOf(pole), LookForm::plus);
    pole.earth = true;
    EXPECT_EQ(formOf(pole), LookForm::battery);
    pole.source = false;
    EXPECT_EQ(formOf(pole), LookForm::earth);
    Look const minus{LookPattern::own, "", "−"};
    pole.look = &minus;
    EXPECT_EQ(formOf(pole), LookForm::minus);
}

TEST(LookForm, OfACoilIsItsWinding) {
    Facts facts = conductorWithBody();
    Electromagnet const coil{};
    facts.coil = &coil;
    facts.device = true;
    EXPECT_EQ(formOf(facts), LookForm::plain);
    EXPECT_EQ(signOf(facts), Sign::flash) << "in a circuit diagram it has the sign of a device";
}

TEST(LookForm, IsTheStatedOne) {
    for (LookForm const form : {LookForm::plain, LookForm::bulb, LookForm::plus, LookForm::minus,
                                LookForm::battery, LookForm::earth, LookForm::flash}) {
        Facts facts = conductorWithBody();
        facts.form = form;
        EXPECT_EQ(formOf(facts), form);
        facts.device = true;
        facts.substance = Substance::glass;
        EXPECT_EQ(formOf(facts), form);
    }
    Facts symbol = conductorWithBody();
    symbol.form = LookForm::bulb;
    symbol.shape = nullptr;
    symbol.earth = true;
    EXPECT_EQ(formOf(symbol), LookForm::earth) << "a bulb needs a body";
}

TEST(LookForm, DecidesBetweenTheTwoSignsOfAReturn) {
    Facts facts = conductorWithBody();
    facts.earth = true;
    facts.form = LookForm::minus;
    EXPECT_EQ(signOf(facts), Sign::minus);
    Look const minus{LookPattern::own, "", "-"};
    facts.look = &minus;
    facts.form = LookForm::earth;
    EXPECT_EQ(signOf(facts), Sign::earth);
}

TEST(LookForm, IsStatedInALevelByAWordAndChangesNoHashOfLevelsWithoutIt) {
    auto const worldOf = [](std::string const& more) {
        std::string const text = R"({"version": 2, "title": "t", "objects": [{"name": "a", "at": [0, 0],
            "properties": {"shape": [{"form": "box", "width": 1, "height": 1}])" +
                                 more + "}}]}";
        LevelFile const level = readLevel(everything(), JsonDocument::parse(text, "level.json"));
        return buildWorld(everything(), level, {});
    };
    auto const stated = worldOf(R"(, "look_form": "bulb")");
    EXPECT_EQ(FactsReader(*stated).of(stated->store().find("a")).form, LookForm::bulb);
    auto const unstated = worldOf("");
    EXPECT_EQ(FactsReader(*unstated).of(unstated->store().find("a")).form, LookForm::own);
    auto const* const column = unstated->store().findColumn<DrawnAs>();
    EXPECT_TRUE(column == nullptr || column->empty()) << "an empty column is not hashed";
    EXPECT_NE(stated->stateHash(), unstated->stateHash()) << "like all stated properties";
    EXPECT_THROW((void)worldOf(R"(, "look_form": "lantern")"), InputError);
}

} // namespace
} // namespace trembler::render::test
