#include "game/ui/cards/toolbox_view.hpp"

#include <algorithm>
#include <sstream>

namespace trembler::ui {
namespace {

bool hasEveryWord(std::string const& name, std::string const& sought) {
    std::istringstream words(sought);
    for (std::string word; words >> word;) {
        if (name.find(word) == std::string::npos) {
            return false;
        }
    }
    return true;
}

} // namespace

std::string inSmallLetters(std::string text) {
    // In UTF-8 the capitals U+00C0 to U+00DE are C3 80 to C3 9E, each 0x20 below its small letter; D7 is ×.
    unsigned char before = 0;
    for (char& letter : text) {
        auto const byte = static_cast<unsigned char>(letter);
        bool const latin = before == 0xC3 && byte >= 0x80 && byte <= 0x9E && byte != 0x97;
        if ((byte >= 'A' && byte <= 'Z') || latin) {
            letter = static_cast<char>(byte + 0x20);
        }
        before = byte;
    }
    return text;
}

void ToolboxView::choose(std::optional<PartGroup> group) {
    group_ = group;
    sought_.clear();
    offersGroups_ = false;
}

void ToolboxView::seek(std::string text) {
    text.resize(std::min(text.size(), longestText));
    sought_ = std::move(text);
    if (!sought_.empty()) {
        group_.reset();
        offersGroups_ = false;
    }
}

std::vector<ToolboxSlot> ToolboxView::shown(std::vector<ToolboxSlot> slots, PartCatalog& catalog) const {
    if (!large(slots)) {
        return slots;
    }
    std::string const sought = inSmallLetters(sought_);
    struct Named {
        std::string name;
        ToolboxSlot slot;
    };
    std::vector<Named> found;
    for (ToolboxSlot& slot : slots) {
        std::string name = inSmallLetters(catalog.titleOf(slot.part));
        auto const& groups = catalog.groupsOf(slot.part);
        bool const inGroup = !group_ || std::find(groups.begin(), groups.end(), *group_) != groups.end();
        if (inGroup && hasEveryWord(name, sought)) {
            found.push_back({std::move(name), std::move(slot)});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](Named const& a, Named const& b) { return a.name < b.name; });
    std::vector<ToolboxSlot> all;
    all.reserve(found.size());
    for (Named& each : found) {
        all.push_back(std::move(each.slot));
    }
    return all;
}

std::vector<PartGroup> ToolboxView::groupsIn(std::vector<ToolboxSlot> const& slots, PartCatalog& catalog) {
    std::vector<PartGroup> there;
    for (std::size_t i = 0; i < partGroupNames.size(); ++i) {
        auto const group = static_cast<PartGroup>(i);
        if (std::any_of(slots.begin(), slots.end(), [&](ToolboxSlot const& slot) {
                auto const& groups = catalog.groupsOf(slot.part);
                return std::find(groups.begin(), groups.end(), group) != groups.end();
            })) {
            there.push_back(group);
        }
    }
    return there;
}

void ToolboxView::chooseNext(std::vector<PartGroup> const& there, int by) {
    auto const places = static_cast<int>(there.size()) + 1; // all parts are place 0
    int now = 0;
    for (int i = 1; i < places; ++i) {
        now = group_ == there[static_cast<std::size_t>(i - 1)] ? i : now;
    }
    int const next = ((now + by) % places + places) % places;
    choose(next == 0 ? std::nullopt : std::optional(there[static_cast<std::size_t>(next - 1)]));
}

std::optional<std::string> ToolboxView::firstShown(std::vector<ToolboxSlot> const& slots,
                                                   PartCatalog& catalog) const {
    auto const all = shown(slots, catalog);
    auto const first =
        std::find_if(all.begin(), all.end(), [](ToolboxSlot const& slot) { return slot.left > 0; });
    return first == all.end() ? std::nullopt : std::optional(first->part);
}

bool ToolboxView::newInHand(std::string const& part) {
    bool const isNew = !part.empty() && part != inHand_;
    inHand_ = part;
    return isNew;
}

} // namespace trembler::ui
