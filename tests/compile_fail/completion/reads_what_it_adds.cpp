// A completion reads what it adds: of other objects that would depend on who is completed first.
#include "tests/compile_fail/kit.hpp"

namespace trembler {

#ifdef TREMBLER_CONTROL
using Seen = Reads<Colour>;
#else
using Seen = Reads<Colour, Heat>;
#endif
template void Registry::completion<WarmthAfter<Seen>>();

} // namespace trembler
