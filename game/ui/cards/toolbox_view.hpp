// Which parts of the toolbox are shown: of a large one those of a group, or those that the player seeks.
#pragma once

#include "game/ui/shared/catalog/part_catalog.hpp"
#include "puzzle/session/placements.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trembler::ui {

/// A toolbox of few parts is shown as its level orders it, without groups and search. Window thread only.
class ToolboxView {
public:
    /// A toolbox with more entries is large.
    static constexpr std::size_t mostInSmall = 12;
    /// Bytes of the text that is sought.
    static constexpr std::size_t longestText = 60;

    [[nodiscard]] static bool large(std::vector<ToolboxSlot> const& slots) {
        return slots.size() > mostInSmall;
    }

    /// Shows one group, or all; ends the search.
    void choose(std::optional<PartGroup> group);
    [[nodiscard]] std::optional<PartGroup> group() const { return group_; }
    /// Shows the parts of all groups whose shown names have every word of `text`, in any order and whatever
    /// its capitals. Empty: ends the search.
    void seek(std::string text);
    [[nodiscard]] std::string const& sought() const { return sought_; }

    /// The entries that are shown, in order: of a large toolbox by their shown names.
    [[nodiscard]] std::vector<ToolboxSlot> shown(std::vector<ToolboxSlot> slots, PartCatalog& catalog) const;
    /// The groups of which a toolbox has parts, in their order.
    [[nodiscard]] static std::vector<PartGroup> groupsIn(std::vector<ToolboxSlot> const& slots,
                                                         PartCatalog& catalog);
    /// Where the card has no room for a button of each group they are offered as a list in place of the
    /// tiles, until one is chosen or a part is sought.
    void offerGroups(bool offer) { offersGroups_ = offer; }
    [[nodiscard]] bool offersGroups() const { return offersGroups_; }
    /// The group `by` places on among these; all parts come before the first and after the last.
    void chooseNext(std::vector<PartGroup> const& there, int by);

    /// The field for the search gets the keys in the next picture.
    void askForKeys() { keysAsked_ = true; }
    [[nodiscard]] bool takeKeysAsked() { return std::exchange(keysAsked_, false); }
    /// The first of the parts that are shown is to go into the hand.
    void want() { wanted_ = true; }
    [[nodiscard]] bool takeWanted() { return std::exchange(wanted_, false); }
    /// The first shown part that is left; nothing if there is none.
    [[nodiscard]] std::optional<std::string> firstShown(std::vector<ToolboxSlot> const& slots,
                                                        PartCatalog& catalog) const;
    /// Whether this part has just come into the hand, so that its tile is to be in sight. Once per picture.
    [[nodiscard]] bool newInHand(std::string const& part);

private:
    std::optional<PartGroup> group_;
    std::string sought_;
    bool offersGroups_ = false;
    bool keysAsked_ = false;
    bool wanted_ = false;
    std::string inHand_;
};

/// In small letters, of those of western European languages; other bytes stay.
[[nodiscard]] std::string inSmallLetters(std::string text);

} // namespace trembler::ui
