// The account of a run, frame by frame, in the form that the thesis gives its experiments (6.7).
#pragma once

#include "puzzle/session/session.hpp"

#include <string>

namespace trembler {

/// The account of a session's world so far, as Markdown. The world must trace. The account lists the objects
/// and the setup, the resolvers, derived property sets and interactions that were used, and then every frame
/// with a new event, in the thesis's sections; empty sections are left out. An event is new if it has not
/// been described before for the same objects. Repeated events, and frames with no others, are left out. An
/// interaction's call is work for its resolver in the next frame; if the resolver recorded an event of its
/// own for it, that event is described.
[[nodiscard]] std::string frameAccount(Session const& session);

} // namespace trembler
