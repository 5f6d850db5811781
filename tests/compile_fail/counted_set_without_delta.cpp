// A call on a counted set that does not declare whether it adds or removes.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Weld {
    static constexpr CallText text{"weld", "(object)", "Welds the object on, or cuts it off."};
    static constexpr Algebra algebra = Algebra::countedSet;
    ObjectId object;
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
#ifdef TREMBLER_CONTROL
    [[nodiscard]] int delta() const {
        return 1;
    }
#endif
};
struct WeldRole {
    static constexpr std::string_view name = "Weld";
    using Calls = CallList<Weld>;
};
struct Welder final : Interaction<Welder, WeldRole, Reads<Heat>> {
    static constexpr ComponentText text{
        .name = "Weld <- Heat", .effect = "heat", .level = "", .work = "Welds."};
    using Activation = NeedsAll<Heat>;
    void apply(Access& access) { access.call(Weld{ObjectId{0, 0}}); }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Welder>();

} // namespace trembler
