// Events as if the player had made them, for tests and replays: they go the whole way through SDL's queue.
#pragma once

#include "render/draw/geometry.hpp"
#include "render/window/input_events.hpp"

#include <filesystem>
#include <string_view>

namespace trembler::render {

// Positions are in the window's pixels, from the top left; each call queues events that the next
// InputEvents::poll takes. Thread of the window only. They throw RenderError if SDL's queue is full.

void pushMouseMove(Window const& window, Point at);
void pushMouseButton(Window const& window, MouseButton button, bool down, Point at, int clicks = 1);
/// Move, press and release, all in one frame.
void pushClick(Window const& window, Point at, MouseButton button = MouseButton::Left);
/// Notches, away from the player positive.
void pushWheel(Window const& window, int notches);
void pushKey(Window const& window, SDL_Keycode key, bool down, unsigned modifiers = KMOD_NONE);
/// UTF-8, as typed into a text field.
void pushText(Window const& window, std::string_view text);
/// A file that is dropped onto the window.
void pushDrop(Window const& window, std::filesystem::path const& file);
void pushQuit();

} // namespace trembler::render
