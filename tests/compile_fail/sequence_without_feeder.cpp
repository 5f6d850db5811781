// A role with calls in sequence that does not declare the code that feeds it.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct Press {
    static constexpr CallText text{"press", "(key)", "Presses a key."};
    static constexpr Algebra algebra = Algebra::sequence;
    int key = 0;
    [[nodiscard]] std::array<ObjectId, 0> objects() const { return {}; }
};
struct KeyRole {
    static constexpr std::string_view name = "Keys";
#ifdef TREMBLER_CONTROL
    static constexpr std::string_view fedBy = "a typist";
#endif
    using Calls = CallList<Press>;
};
struct Keys final : Resolver<Keys, KeyRole, Reads<Heat>, Writes<>> {
    static constexpr ComponentText text{.name = "Keys", .effect = "keys", .level = "", .work = "Types."};
    using Activation = NeedsAll<Heat>;
    void advance(Access& access) {
        access.forCalls<Press>([](Press const&, CallOrigin) {});
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<Keys>();

} // namespace trembler
