#include "game/ui/shared/words.hpp"

#include "runtime/file/visible_text.hpp"
#include "runtime/math/vec2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace trembler::ui::words {

std::string toolboxHint(std::string const& turnLeft, std::string const& turnRight) {
    std::string keys = turnLeft;
    if (!turnRight.empty()) {
        keys += (keys.empty() ? "" : " and ") + turnRight;
    }
    return "Drag a part into the world. " +
           (keys.empty()
                ? "The wheel turns it."
                : "Wheel or " + keys + (turnLeft.empty() || turnRight.empty() ? " turns it." : " turn it."));
}
std::string wiresLeft(int count) {
    return fmt::format("Wire ({} left)", count);
}
std::string conductsNot(std::string const& object) {
    return fmt::format("No current flows through the {}", object);
}
std::string putThisBack(std::string const& a, std::string const& b) {
    return fmt::format("Take the wire from {} to {} back", a, b);
}
std::string timesReal(double speed) {
    if (speed == 0.25) {
        return "¼×";
    }
    return speed == 0.5 ? "½×" : fmt::format("{:g}×", speed);
}
std::string tooSlow(double asked, double reached) {
    return fmt::format(
        "This computer is too slow for {}: the world goes at {:.2g}×. What happens in it stays the "
        "same.",
        timesReal(asked), reached);
}
std::string hold(std::string const& key) {
    return "hold " + key;
}
std::string keyIsTaken(std::string const& key, std::string const& command) {
    return fmt::format("{} is the key of \"{}\"", key, command);
}
std::string keepsItsKey(std::string const& command) {
    return fmt::format("\"{}\" keeps its key", command);
}
std::string noSuchCommand(std::string const& id) {
    return fmt::format("Keys in your profile: there is no command \"{}\".", visible(id));
}
std::string notAKey(std::string const& id, std::string const& text) {
    return fmt::format("Keys in your profile: \"{}\" has \"{}\", which is no key; the default key applies.",
                       visible(id), visible(text));
}
std::string keysNotTaken(std::string const& id, std::string const& why) {
    return fmt::format("Keys in your profile: {}, so the default key of \"{}\" applies.", why, visible(id));
}
std::string keysNotRead(std::string const& what) {
    return fmt::format("Keys in your profile: expected {}.", visible(what));
}

std::string cannotWrite(std::string const& path, std::string const& why) {
    return fmt::format("Nothing can be written to {}: {}.", path, why);
}
std::string pictureTaken(std::string const& path) {
    return "Picture written to " + path;
}
std::string solutionSaved(std::string const& path) {
    return "Saved as " + path + ". \"trembler run\" plays it with --solution.";
}

std::string modLine(std::string const& name, std::string const& version, std::string const& author,
                    std::string const& licence) {
    return fmt::format("{} {}, by {}, {}", name, version, author, licence);
}

std::string levelsOfMod(std::string const& title) {
    return title + " (mod)";
}

std::string modFrom(std::string const& folder) {
    return "From " + folder + ".";
}

namespace {

/// With a thin space between groups of three digits.
std::string inGroups(std::uint64_t number) {
    std::string const digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) {
            text += "\u2009";
        }
        text += digits[i];
    }
    return text;
}

std::string inBytes(std::size_t bytes) {
    double const kilo = static_cast<double>(bytes) / 1000;
    return kilo < 1000 ? fmt::format("{:.0f} kB", kilo) : fmt::format("{:.1f} MB", kilo / 1000);
}

} // namespace

std::string ofMost(std::uint64_t count, std::uint64_t most) {
    return inGroups(count) + " of " + inGroups(most);
}

std::string bytesOf(std::size_t bytes, std::size_t most) {
    return inBytes(bytes) + " of " + inBytes(most);
}

std::string inFrame(std::uint64_t frame, std::string const& text) {
    return fmt::format("in frame {}: {}", frame, text);
}

std::string worksButAltered(std::string const& why) {
    return "It works! " + why;
}

std::string andMore(std::size_t count) {
    return fmt::format("and {} more", count);
}
std::string sceneNeeds(std::string const& why) {
    return "The scene needs " + why + ".";
}

std::string nothingHas(std::string_view property) {
    return fmt::format("nothing has \"{}\"", property);
}
std::string duration(double microseconds) {
    return microseconds < 9.95    ? fmt::format("{:.1f} µs", microseconds)
           : microseconds < 999.5 ? fmt::format("{:.0f} µs", microseconds)
                                  : fmt::format("{:.3g} ms", microseconds / 1000);
}
std::string howFarOff(double metres) {
    if (!(metres > 0)) {
        return "not at all";
    }
    return metres < 1e-4      ? "< 0.1 mm"
           : metres < 9.95e-3 ? fmt::format("{:.1f} mm", 1000 * metres)
           : metres < 0.995   ? fmt::format("{:.2g} cm", 100 * metres)
           : metres < 9.95    ? fmt::format("{:.1f} m", metres)
                              : fmt::format("{:.0f} m", std::min(metres, 1e6));
}
std::string errorTip(double metres, double share, std::string const& of, std::string const& source) {
    return fmt::format("{:.2g} % {}: a body that nothing holds would be off by {} after a second. {}",
                       100 * share, of, metres > 0 ? howFarOff(metres) : "nothing", source);
}
std::string budgetIs(double microseconds) {
    return fmt::format("Time budget: {:.2f} ms per frame", microseconds / 1000);
}
std::string ofBudget(double microseconds) {
    return fmt::format("of a budget of {:.2f} ms", microseconds / 1000);
}

std::string ofRated(double share) {
    return fmt::format(" ({:.0f} % of its rating)", 100 * share);
}

std::string idleNow(std::string const& chosen, std::string const& working) {
    return chosen + " (used: " + working + ")";
}

std::string automaticNow(std::string const& level) {
    return fmt::format("{}: {}", automatic, level);
}
std::string hintOf(std::size_t shown, std::size_t total) {
    return total > 1 ? fmt::format("{} {} of {}", hint, shown, total) : std::string(hint);
}
std::string seconds(double time) {
    return fmt::format("{:.1f} s", time);
}
std::string solvedWith(double time, int parts) {
    return parts == 0 ? fmt::format("Solved after {}", seconds(time))
                      : fmt::format("Solved after {} with {}", seconds(time), count(parts, "part", "parts"));
}
std::string count(int number, char const* one, char const* many) {
    return fmt::format("{} {}", number, number == 1 ? one : many);
}
std::string cutThis(std::string const& a, std::string const& b) {
    return fmt::format("cut {} – {}", a, b);
}

std::string direction(double angle) {
    static constexpr std::array arrows{"→", "↗", "↑", "↖", "←", "↙", "↓", "↘"};
    auto const eighth = static_cast<int>(std::lround(angle / (pi / 4)));
    return arrows[static_cast<std::size_t>(((eighth % 8) + 8) % 8)];
}

std::string capital(std::string text) {
    if (!text.empty()) {
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    }
    return text;
}

std::string wrapped(std::string const& text, std::size_t width) {
    std::string lines;
    std::size_t column = 0;
    std::size_t start = 0;
    while (start < text.size()) {
        std::size_t const end = std::min(text.find(' ', start), text.size());
        std::size_t const length = end - start;
        if (column > 0 && column + 1 + length > width) {
            lines += '\n';
            column = 0;
        } else if (column > 0) {
            lines += ' ';
            ++column;
        }
        lines += text.substr(start, length);
        column += length;
        start = end + 1;
    }
    return lines;
}

} // namespace trembler::ui::words
