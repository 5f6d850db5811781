// The account of frames in the thesis's form (6.7), compared with the thesis's own for Experiment I (6.8.3).
#include "puzzle/run/frame_account.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>
#include <sstream>

namespace trembler {
namespace {

// The text under one frame's heading; empty if the account leaves the frame out.
std::string frameOf(std::string const& account, std::uint64_t frame) {
    std::string const heading = "### Frame " + std::to_string(frame) + " - ";
    std::size_t const begin = account.find(heading);
    if (begin == std::string::npos) {
        return {};
    }
    return account.substr(begin, account.find("\n### ", begin + 1) - begin);
}

bool has(std::string const& text, std::string const& words) {
    return text.find(words) != std::string::npos;
}

// Whether a section of a frame contains `words`.
bool under(std::string const& frame, std::string const& section, std::string const& words) {
    std::size_t const begin = frame.find("**" + section + "**");
    if (begin == std::string::npos) {
        return false;
    }
    return has(frame.substr(begin, frame.find("**", begin + section.size() + 4) - begin), words);
}

constexpr char const* resolvers = "Work for Resolvers";
constexpr char const* dps = "Work for Derived Property Sets";
constexpr char const* interactions = "Work for Interactions";

class FrameAccount : public Experiment {
protected:
    std::string account(std::string const& file, std::uint64_t frames, bool trace = true) {
        open(file, "", trace);
        runTo(frames);
        return frameAccount(session());
    }
};

TEST_F(FrameAccount, OfExperimentOneHasTheFramesOfTheThesis) {
    std::string const text = account("1-switched-electromagnet.json", 120);
    // Frame 1: the metal object touches the floor, gravity is passed on. Frame 2: it is resolved.
    EXPECT_TRUE(under(frameOf(text, 1), resolvers, "contact begun: floor and metal object")) << text;
    EXPECT_TRUE(
        under(frameOf(text, 1), interactions,
              "(Dynamics <- Gravity) Interaction: calls addForce: metal object, switch; and from now on"));
    EXPECT_TRUE(under(frameOf(text, 2), resolvers,
                      "Dynamics Resolver: carries out addForce: metal object, "
                      "switch"));
    // f: the switch closes the contact.
    std::uint64_t const f = std::max(first("contact begun", {"object 1", "switch"}).frame,
                                     first("contact begun", {"object 2", "switch"}).frame);
    EXPECT_TRUE(under(frameOf(text, f), resolvers, "Dynamics Resolver: contact begun: object"));
    EXPECT_TRUE(
        under(frameOf(text, f), interactions, "(Electricity <- Dynamics) Interaction: calls addConnection"));
    EXPECT_FALSE(has(frameOf(text, f), "from now on")) << "a connection is added once";
    // f + 1: the electromagnet almost activates.
    EXPECT_TRUE(under(frameOf(text, f + 1), resolvers, "Electricity Resolver: connected: object"));
    EXPECT_FALSE(has(frameOf(text, f + 1), "carries out addConnection"))
        << "the event \"connected\" stands for it";
    EXPECT_TRUE(under(frameOf(text, f + 1), dps, "electromagnet"));
    EXPECT_TRUE(
        under(frameOf(text, f + 1), interactions, "calls enableMagnet: electromagnet; and from now on"));
    // f + 2: it activates.
    EXPECT_TRUE(under(frameOf(text, f + 2), resolvers, "Magnetics Resolver: magnet on: electromagnet"));
    EXPECT_TRUE(under(frameOf(text, f + 2), interactions,
                      "(Dynamics <- Magnetic Forces) Interaction: calls addForceToPoint: metal object"));
    // f + 3: the metal object is lifted.
    EXPECT_TRUE(under(frameOf(text, f + 3), resolvers,
                      "Dynamics Resolver: carries out addForceToPoint: metal object"));
    // After that, the account mentions gravity no more.
    EXPECT_FALSE(has(frameOf(text, f + 3), "addForce:"));
}

TEST_F(FrameAccount, ListsTheObjectsAndTheUsedComponents) {
    std::string const text = account("1-switched-electromagnet.json", 120);
    EXPECT_TRUE(has(text, "| switch | "));
    EXPECT_TRUE(has(text, "| electromagnet | "));
    EXPECT_TRUE(has(text, "- Resolvers: "));
    EXPECT_TRUE(has(text, "Magnetics"));
    EXPECT_FALSE(has(text.substr(0, text.find("### ")), "Buoyancy")) << "absent components are not used";
    EXPECT_LT(text.find("### Frame 0 - Setup"), text.find("### Frame 1 - "));
}

TEST_F(FrameAccount, LeavesOutRepeats) {
    std::string const text = account("2-doorbell.json", 600);
    // No line is repeated, however long the bell rings, except for lines that name no object.
    std::set<std::string> lines;
    std::istringstream in(text.substr(text.find("### Frame 0")));
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("- (")) { // an interaction's calls
            EXPECT_TRUE(lines.insert(line).second) << line;
        }
    }
    EXPECT_TRUE(has(text, "more of the same")) << text;
    std::size_t const events = world().tracer()->events().size();
    std::size_t const described = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    EXPECT_LT(described, events / 2) << "the trace has all events, the account only new ones";
}

// Consecutive frames are distinguished from gaps.
TEST_F(FrameAccount, EveryFrameIsDescribedOrSkippedByName) {
    std::string const text = account("1-switched-electromagnet.json", 120);
    std::set<std::uint64_t> listed;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::uint64_t from = 0;
        std::uint64_t to = 0;
        if (std::sscanf(line.c_str(), "### Frame %lu - ", &from) == 1) {
            EXPECT_TRUE(listed.insert(from).second);
        } else if (std::sscanf(line.c_str(), "*Frames %lu to %lu:", &from, &to) == 2) {
            for (std::uint64_t frame = from; frame <= to; ++frame) {
                EXPECT_TRUE(listed.insert(frame).second);
            }
        } else if (std::sscanf(line.c_str(), "*Frame %lu:", &from) == 1) {
            EXPECT_TRUE(listed.insert(from).second);
        }
    }
    EXPECT_EQ(listed.size(), 121U);
    EXPECT_EQ(*listed.rbegin(), 120U);
}

TEST_F(FrameAccount, OfAWorldThatDoesNotTraceIsTheSetup) {
    std::string const text = account("1-switched-electromagnet.json", 10, false);
    EXPECT_TRUE(has(text, "### Frame 0 - Setup"));
    EXPECT_TRUE(has(text, "*Frames 1 to 10: more of the same.*"));
}

} // namespace
} // namespace trembler
