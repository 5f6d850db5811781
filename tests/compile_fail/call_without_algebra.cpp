// A call that does not declare an algebra, which makes the order of calls irrelevant.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Cool {
    static constexpr CallText text{"cool", "(object)", "Cools the object."};
#ifdef TREMBLER_CONTROL
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
#endif
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const {
        return {object};
    }
};
struct CoolRole {
    static constexpr std::string_view name = "Cool";
    using Calls = CallList<Cool>;
};
struct Fridge final : Resolver<Fridge, CoolRole, Reads<>, Writes<Heat>> {
    static constexpr ComponentText text{.name = "Fridge", .effect = "heat", .level = "", .work = "Cools."};
    using Activation = NeedsAny<Heat>;
    void advance(Access& access) {
        access.forCalls<Cool>([](Cool const&, CallOrigin) {});
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Fridge>();

} // namespace trembler
