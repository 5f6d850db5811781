// The account of a run, frame by frame, in the form that the thesis gives its experiments (6.7).
#pragma once

#include "puzzle/session/session.hpp"

#include <string>

namespace trembler {

/// The account of what a session's world, which must trace, has gone through so far, as Markdown: the objects
/// and what is set up, the resolvers, derived property sets and interactions that were used, and then every
/// frame in which something new happens, in the thesis's sections, each of which is left out where it has
/// nothing to say. "New" is what has not been described before: what happens again to the same objects is
/// left out, and so are the frames in which nothing else does. An interaction's call is work for its resolver
/// in the frame after it, which is described as that resolver's own event where it has one.
[[nodiscard]] std::string frameAccount(Session const& session);

} // namespace trembler
