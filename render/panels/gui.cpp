#include "render/panels/gui.hpp"

#include "render/gl/error.hpp"

#include <imgui_internal.h>

// Debian 12's ImGui 1.86 and Debian 13's 1.90 name the header differently.
#if __has_include(<backends/imgui_impl_sdl2.h>)
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif
#include <algorithm>
#include <array>
#include <backends/imgui_impl_opengl3.h>
#include <cfloat>
#include <cmath>
#include <utility>
#include <vector>

namespace trembler::render {

Gui::Context::Context() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
}

Gui::Context::~Context() {
    ImGui::DestroyContext();
}

Gui::Backends::Backends(Window& window) {
    if (!ImGui_ImplSDL2_InitForOpenGL(window.handle(), window.context())) {
        throw RenderError("The panels could not be connected to the window.");
    }
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
        ImGui_ImplSDL2_Shutdown();
        throw RenderError("The graphics driver cannot draw the panels.");
    }
}

Gui::Backends::~Backends() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
}

Gui::Gui(Window& window, GuiOptions const& options) : window_(window) {
    auto& io = ImGui::GetIO();
    io.UserData = &theme_;
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigInputTextCursorBlink = !options.steady;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.ConfigDragClickToInputText = true; // one click on a number begins to type
    backends_ = std::make_unique<Backends>(window);
    theme_.scale = 0; // so that the first frame loads style and letters
    followScale();
}

Gui::~Gui() = default;

void Gui::followScale() {
    float const scale = window_.uiScale();
    // Dragging a window's edge must not build new letters in every frame.
    if (theme_.scale > 0.F && std::abs(scale / theme_.scale - 1.F) < 0.03F) {
        if (std::exchange(theme_.colours, palette::inUse()) != palette::inUse()) {
            applyStyle(theme_.scale);
        }
        return;
    }
    theme_.colours = palette::inUse();
    theme_.scale = scale;
    applyStyle(scale);
    theme_.fonts = loadFonts(scale);
    ImGui::GetIO().FontDefault = theme_.fonts.body;
    if (lettersLoaded_) { // before the first frame the backend does not have the texture of the letters yet
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
}

void Gui::feedMouse(InputEvents const& input) {
    auto& io = ImGui::GetIO();
    // ImGui's SDL backend asks SDL for the real mouse and so misses pushed events (1.86), or mixes the two
    // (1.90 under X11). Its result is replaced by that of the events.
#if IMGUI_VERSION_NUM >= 18700
    auto& queue = ImGui::GetCurrentContext()->InputEventsQueue;
    for (int i = queue.Size - 1; i >= 0; --i) {
        if (queue[i].Type == ImGuiInputEventType_MousePos ||
            queue[i].Type == ImGuiInputEventType_MouseButton) {
            queue.erase(queue.begin() + i);
        }
    }
#else
    auto const modifiers = input.modifiers();
    io.KeyCtrl = (modifiers & KMOD_CTRL) != 0;
    io.KeyShift = (modifiers & KMOD_SHIFT) != 0;
    io.KeyAlt = (modifiers & KMOD_ALT) != 0;
    io.KeySuper = (modifiers & KMOD_GUI) != 0;
#endif
    io.MousePos = input.mouseInside()
                      ? ImVec2(static_cast<float>(input.mouse().x), static_cast<float>(input.mouse().y))
                      : ImVec2(-FLT_MAX, -FLT_MAX);
    for (auto const button : {MouseButton::Left, MouseButton::Right, MouseButton::Middle}) {
        // A click that is over within one frame must be seen as held once.
        io.MouseDown[static_cast<int>(button)] = input.held(button) || input.pressed(button);
    }
}

namespace {

/// The key of ImGui's that has the meaning of a gamepad's button: the directional pad moves among widgets,
/// its lower button presses, the right one leaves, the left one starts text input, also into a number that
/// can be dragged. Other events are returned as they are.
SDL_Event asKeyOfWidgets(SDL_Event event) {
    struct Stands {
        SDL_Keycode pad;
        SDL_Keycode key;
        SDL_Scancode code;
    };
    static constexpr std::array<Stands, 7> all{
        {{padKey(SDL_CONTROLLER_BUTTON_DPAD_UP), SDLK_UP, SDL_SCANCODE_UP},
         {padKey(SDL_CONTROLLER_BUTTON_DPAD_DOWN), SDLK_DOWN, SDL_SCANCODE_DOWN},
         {padKey(SDL_CONTROLLER_BUTTON_DPAD_LEFT), SDLK_LEFT, SDL_SCANCODE_LEFT},
         {padKey(SDL_CONTROLLER_BUTTON_DPAD_RIGHT), SDLK_RIGHT, SDL_SCANCODE_RIGHT},
         {padKey(SDL_CONTROLLER_BUTTON_A), SDLK_SPACE, SDL_SCANCODE_SPACE},
         {padKey(SDL_CONTROLLER_BUTTON_X), SDLK_RETURN, SDL_SCANCODE_RETURN},
         {padKey(SDL_CONTROLLER_BUTTON_B), SDLK_ESCAPE, SDL_SCANCODE_ESCAPE}}};
    if (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP) {
        for (Stands const& one : all) {
            if (event.key.keysym.sym == one.pad) {
                event.key.keysym.sym = one.key;
                event.key.keysym.scancode = one.code;
                break;
            }
        }
    }
    return event;
}

} // namespace

void Gui::beginFrame(InputEvents const& input, double seconds,
                     std::function<SDL_Event(SDL_Event const&)> const& asWidgets) {
    followScale();
    for (SDL_Event const& event : input.events()) {
        SDL_Event const shown = asWidgets ? asWidgets(event) : asKeyOfWidgets(event);
        ImGui_ImplSDL2_ProcessEvent(&shown);
    }
    for (SDL_Event const& event : input.typed()) {
        // The keys of the keyboard on the screen are those of widgets already.
        bool const pad = isPadKey(event.key.keysym.sym);
        SDL_Event const shown = asWidgets && pad ? asWidgets(event) : asKeyOfWidgets(event);
        ImGui_ImplSDL2_ProcessEvent(&shown);
    }
    ImGui_ImplOpenGL3_NewFrame();
    lettersLoaded_ = true;
    ImGui_ImplSDL2_NewFrame();
    auto& io = ImGui::GetIO();
    auto const [width, height] = window_.size();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DisplayFramebufferScale = {1, 1};
    io.DeltaTime = static_cast<float>(std::isfinite(seconds) ? std::clamp(seconds, 0.001, 1.0) : 0.016);
    feedMouse(input);
    ImGui::NewFrame();
}

namespace {

/// Draws only the words beneath all panels, or only everything else. Those words are the commands of the
/// lowest list from a reset of the render state on; before it are the shadows of cards.
void renderLists(ImDrawData& all, bool beneath) {
    ImDrawList const* const lowest = ImGui::GetBackgroundDrawList();
    // Copies of an empty ImVector pass a null pointer to memcpy, so all of them are made here and never
    // copied.
    std::vector<ImVector<ImDrawCmd>> whole(static_cast<std::size_t>(all.CmdListsCount));
    for (int i = 0; i < all.CmdListsCount; ++i) {
        ImDrawList* const list = all.CmdLists[i];
        ImVector<ImDrawCmd> seen;
        bool words = false;
        for (ImDrawCmd const& command : list->CmdBuffer) {
            words = words || (list == lowest && command.UserCallback == ImDrawCallback_ResetRenderState);
            if (words == beneath) {
                seen.push_back(command);
            }
        }
        list->CmdBuffer.swap(seen);
        whole[static_cast<std::size_t>(i)].swap(seen);
    }
    ImGui_ImplOpenGL3_RenderDrawData(&all);
    for (int i = 0; i < all.CmdListsCount; ++i) {
        all.CmdLists[i]->CmdBuffer.swap(whole[static_cast<std::size_t>(i)]);
    }
}

/// Enter begins to type where the ring of the keyboard is on a field; anything else it presses, as Space does
/// and as a key of menus does. Since 1.89 ImGui does so itself. Call at the end of a frame.
void pressByEnter() {
#if IMGUI_VERSION_NUM < 18900
    ImGuiContext const& context = *ImGui::GetCurrentContext();
    // A field that Enter opened is active now; one that it closed was active before.
    if (context.NavActivateInputId != 0 && context.ActiveId == 0 && context.ActiveIdPreviousFrame == 0) {
        ImGui::ActivateItem(context.NavActivateInputId);
    }
#endif
}

} // namespace

void Gui::endFrame(std::function<void()> const& beneath) {
    pressByEnter();
    ImGui::Render();
    window_.bind();
    ImDrawData& all = *ImGui::GetDrawData();
    if (!beneath) {
        ImGui_ImplOpenGL3_RenderDrawData(&all);
        return;
    }
    renderLists(all, true);
    beneath();
    window_.bind();
    renderLists(all, false);
}

void Gui::dropFrame() {
    pressByEnter();
    ImGui::EndFrame();
}

bool Gui::wantsMouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}

bool Gui::wantsKeyboard() const {
    return ImGui::GetIO().WantTextInput;
}

} // namespace trembler::render
