// A library that is loaded into the real program before SDL (LD_PRELOAD), for tests of the program as a
// process: it feeds events from a pipe and calls SDL's offscreen pictures a screen, so that the window opens
// without one.
//
// The pipe TREMBLER_FED_EVENTS holds lines, of which the program gets one for each of its pictures, so that
// no time is involved:
//     down KEY MODIFIERS    a key of SDL's, as numbers
//     up KEY
//     text WORDS            as typed, to the end of the line
//     quit
#include <SDL_events.h>
#include <SDL_keyboard.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <sstream>
#include <string>
#include <unistd.h>

namespace {

/// The next complete line of the pipe; nothing if there is none yet.
bool nextLine(std::string& line) {
    static int const pipe = [] {
        char const* const name = std::getenv("TREMBLER_FED_EVENTS");
        return name == nullptr ? -1 : ::open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    }();
    static std::string waiting;
    std::array<char, 4096> buffer{};
    for (ssize_t got = 0; pipe >= 0 && (got = ::read(pipe, buffer.data(), buffer.size())) > 0;) {
        waiting.append(buffer.data(), static_cast<std::size_t>(got));
    }
    std::size_t const end = waiting.find('\n');
    if (end == std::string::npos) {
        return false;
    }
    line = waiting.substr(0, end);
    waiting.erase(0, end + 1);
    return true;
}

void push(std::string const& line) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    SDL_Event event{};
    event.key.windowID = 1;
    if (what == "down" || what == "up") {
        int modifiers = 0;
        words >> event.key.keysym.sym >> modifiers;
        event.type = what == "down" ? SDL_KEYDOWN : SDL_KEYUP;
        event.key.state = what == "down" ? SDL_PRESSED : SDL_RELEASED;
        event.key.keysym.scancode = SDL_GetScancodeFromKey(event.key.keysym.sym);
        event.key.keysym.mod = static_cast<Uint16>(modifiers);
    } else if (what == "text") {
        std::string text;
        std::getline(words >> std::ws, text);
        event.type = SDL_TEXTINPUT;
        std::copy_n(text.begin(), std::min(text.size(), sizeof(event.text.text) - 1), event.text.text);
    } else {
        event.type = SDL_QUIT;
    }
    SDL_PushEvent(&event);
}

} // namespace

// In place of SDL's own functions, in the whole program.
extern "C" {

int SDL_PollEvent(SDL_Event* event) {
    static auto const real = reinterpret_cast<int (*)(SDL_Event*)>(::dlsym(RTLD_NEXT, "SDL_PollEvent"));
    static bool newPicture = true;
    std::string line;
    if (newPicture && nextLine(line)) {
        push(line);
    }
    int const any = real(event);
    newPicture = any == 0;
    return any;
}

char const* SDL_GetCurrentVideoDriver() {
    return "a screen of a test";
}
}
