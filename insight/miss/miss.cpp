#include "insight/miss/miss.hpp"

#include <array>
#include <utility>

namespace trembler::insight {
namespace {

struct LackText {
    std::string_view name;
    std::string_view unit;
};
constexpr std::array<LackText, 23> lackTexts{
    {{"nothing", ""}, {"distance", "m"}, {"gap", "m"},  {"source", ""},    {"power", "W"},
     {"shorted", ""}, {"force", "N"},    {"lift", "N"}, {"torque", "N m"}, {"count", ""},
     {"time", "s"},   {"steps", ""},     {"ways", ""},  {"touches", ""},   {"held", ""},
     {"blocked", ""}, {"unpushed", "N"}, {"push", "N"}, {"grab", ""},      {"cut", ""},
     {"removal", ""}, {"absent", ""},    {"change", ""}}};

} // namespace

std::string_view nameOf(Lack lack) {
    return lackTexts.at(static_cast<std::size_t>(lack)).name;
}

Miss missOfBlocked(std::string by, std::string blocked) {
    Miss miss;
    miss.lack = Lack::blocked;
    miss.by = 1;
    miss.names = {std::move(by), std::move(blocked)};
    return miss;
}

std::string_view unitOf(Lack lack) {
    return lackTexts.at(static_cast<std::size_t>(lack)).unit;
}

void nameObjects(Miss& miss, Store const& store) {
    miss.names.clear();
    for (ObjectId const id : miss.objects) {
        miss.names.push_back(store.nameOf(id));
    }
    for (CircuitGap& gap : miss.gaps) {
        gap.nameA = store.nameOf(gap.a);
        gap.nameB = store.nameOf(gap.b);
        gap.nameBy = gap.by.valid() ? store.nameOf(gap.by) : std::string();
    }
    for (CurrentWay& way : miss.ways) {
        way.nameA = store.nameOf(way.a);
        way.nameB = store.nameOf(way.b);
    }
    for (Miss& other : miss.besides) {
        nameObjects(other, store);
    }
}

} // namespace trembler::insight
