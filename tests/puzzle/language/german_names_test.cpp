// Names of objects in German: gender, case, adjectives, numbers and pieces.
#include "puzzle/language/german_names.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trembler {
namespace {

GermanNames names() {
    return GermanNames(nlohmann::json{{"nouns",
                                       {{"lamp", "die Lampe|Lampen"},
                                        {"bucket", "der Eimer|Eimer"},
                                        {"plank", "das Brett|Bretter"},
                                        {"doorbell", "die Türklingel"},
                                        {"striker", "der Klöppel"},
                                        {"magnet", "der Magnet|Magnete|Magneten"},
                                        {"crane magnet", "der Kranmagnet||Kranmagneten"}}},
                                      {"adjectives", {{"left", "link"}, {"second", "zweit"}}},
                                      {"behind", {{"left", "links"}}}});
}

TEST(GermanNames, TakeTheArticleOfTheirGenderAndCase) {
    auto const all = names();
    EXPECT_EQ(all.definite("lamp", GermanCase::nominative), "die Lampe");
    EXPECT_EQ(all.definite("lamp", GermanCase::accusative), "die Lampe");
    EXPECT_EQ(all.definite("lamp", GermanCase::dative), "der Lampe");
    EXPECT_EQ(all.definite("bucket", GermanCase::nominative), "der Eimer");
    EXPECT_EQ(all.definite("bucket", GermanCase::accusative), "den Eimer");
    EXPECT_EQ(all.definite("bucket", GermanCase::dative), "dem Eimer");
    EXPECT_EQ(all.definite("plank", GermanCase::dative), "dem Brett");
    EXPECT_EQ(all.indefinite("bucket", GermanCase::accusative), "einen Eimer");
    EXPECT_EQ(all.indefinite("lamp", GermanCase::dative), "einer Lampe");
    EXPECT_EQ(all.plural("plank", GermanCase::accusative), "Bretter");
    EXPECT_EQ(all.plural("plank", GermanCase::dative), "Brettern");
    EXPECT_EQ(all.plural("lamp", GermanCase::dative), "Lampen");
}

TEST(GermanNames, InflectAdjectives) {
    auto const all = names();
    EXPECT_EQ(all.bare("left lamp"), "linke Lampe");
    EXPECT_EQ(all.bare("left bucket"), "linker Eimer");
    EXPECT_EQ(all.bare("second left plank"), "zweites linkes Brett");
    EXPECT_EQ(all.definite("left bucket", GermanCase::accusative), "den linken Eimer");
    EXPECT_EQ(all.definite("left lamp", GermanCase::accusative), "die linke Lampe");
    EXPECT_EQ(all.definite("left lamp", GermanCase::dative), "der linken Lampe");
    EXPECT_EQ(all.indefinite("left plank", GermanCase::accusative), "ein linkes Brett");
    EXPECT_EQ(all.indefinite("left plank", GermanCase::dative), "einem linken Brett");
}

TEST(GermanNames, KeepNumbersPlacesAndPieces) {
    auto const all = names();
    EXPECT_EQ(all.bare("lamp 2"), "Lampe 2");
    EXPECT_EQ(all.definite("lamp 2", GermanCase::dative), "Lampe 2") << "a number needs no article";
    EXPECT_EQ(all.bare("lamp a"), "Lampe a");
    EXPECT_EQ(all.definite("plank left", GermanCase::accusative), "das Brett links");
    EXPECT_EQ(all.definite("doorbell striker", GermanCase::accusative), "den Klöppel (Türklingel)");
    EXPECT_EQ(all.bare("doorbell 1 striker"), "Klöppel (Türklingel 1)");
    EXPECT_EQ(all.definite("second doorbell 1 left striker", GermanCase::accusative),
              "den linken Klöppel (zweite Türklingel 1)");
}

TEST(GermanNames, HaveAnotherFormInTheObliqueCases) {
    auto const all = names();
    EXPECT_EQ(all.definite("magnet", GermanCase::nominative), "der Magnet");
    EXPECT_EQ(all.definite("magnet", GermanCase::accusative), "den Magneten");
    EXPECT_EQ(all.definite("magnet", GermanCase::dative), "dem Magneten");
    EXPECT_EQ(all.definite("left magnet", GermanCase::accusative), "den linken Magneten");
    EXPECT_EQ(all.indefinite("magnet", GermanCase::accusative), "einen Magneten");
    EXPECT_EQ(all.indefinite("second magnet", GermanCase::dative), "einem zweiten Magneten");
    EXPECT_EQ(all.bare("magnet"), "Magnet");
    EXPECT_EQ(all.plural("magnet", GermanCase::dative), "Magneten");
    EXPECT_EQ(all.definite("crane magnet", GermanCase::dative), "dem Kranmagneten");
    EXPECT_EQ(all.plural("crane magnet", GermanCase::dative), "Kranmagnet") << "no plural is known";
    EXPECT_EQ(all.definite("magnet 2", GermanCase::accusative), "Magnet 2") << "nothing shows the case";
    EXPECT_EQ(all.definite("left magnet 2", GermanCase::dative), "linkem Magneten 2");
    EXPECT_EQ(all.definite("left lamp 2", GermanCase::dative), "linker Lampe 2");
}

TEST(GermanNames, LeaveWhatTheyDoNotKnow) {
    auto const all = names();
    EXPECT_EQ(all.bare("flux capacitor"), "flux capacitor");
    EXPECT_EQ(all.definite("Bob", GermanCase::dative), "Bob");
    EXPECT_FALSE(all.understands("left"));
    EXPECT_FALSE(all.understands(""));
    EXPECT_EQ(GermanNames(nlohmann::json("damaged")).bare("lamp"), "lamp");
    EXPECT_EQ(GermanNames(nlohmann::json{{"nouns", {{"lamp", 3}, {"bell", "Glocke"}}}}).bare("bell"), "bell");
}

} // namespace
} // namespace trembler
