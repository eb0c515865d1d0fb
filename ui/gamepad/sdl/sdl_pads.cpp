// Gamepad module: all code that uses SDL.
#define SDL_MAIN_HANDLED
#include "render/failure.h"
#include "ui/gamepad/pads.h"

#include <SDL.h>

#include <string>

namespace vitrine::ui {
namespace {

constexpr std::array<SDL_GameControllerButton, padButtons> sdlButtons{SDL_CONTROLLER_BUTTON_A,
                                                                      SDL_CONTROLLER_BUTTON_B,
                                                                      SDL_CONTROLLER_BUTTON_X,
                                                                      SDL_CONTROLLER_BUTTON_Y,
                                                                      SDL_CONTROLLER_BUTTON_LEFTSHOULDER,
                                                                      SDL_CONTROLLER_BUTTON_RIGHTSHOULDER,
                                                                      SDL_CONTROLLER_BUTTON_LEFTSTICK,
                                                                      SDL_CONTROLLER_BUTTON_RIGHTSTICK,
                                                                      SDL_CONTROLLER_BUTTON_START,
                                                                      SDL_CONTROLLER_BUTTON_DPAD_UP,
                                                                      SDL_CONTROLLER_BUTTON_DPAD_DOWN,
                                                                      SDL_CONTROLLER_BUTTON_DPAD_LEFT,
                                                                      SDL_CONTROLLER_BUTTON_DPAD_RIGHT};

class SdlPads final : public Pads {
public:
    SdlPads()
    {
        // SDL must read gamepads although none of its windows has the focus, and must leave signals alone.
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");  // The drivers of the kernel suffice; HIDAPI would also search USB.
        if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0)
            throw Failure(ErrorKind::file, std::string("Gamepads cannot be read: ") + SDL_GetError() + ".");
        SDL_JoystickEventState(SDL_IGNORE);
        SDL_GameControllerEventState(SDL_IGNORE);
    }
    ~SdlPads() override
    {
        if (pad_) SDL_GameControllerClose(pad_);
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
    SdlPads(const SdlPads&) = delete;
    SdlPads& operator=(const SdlPads&) = delete;

    PadState read() override
    {
        SDL_GameControllerUpdate();
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // Nobody waits for them.
        if (pad_ && !SDL_GameControllerGetAttached(pad_)) {
            SDL_GameControllerClose(pad_);
            pad_ = nullptr;
        }
        for (int i = 0; !pad_ && i < SDL_NumJoysticks(); ++i)
            if (SDL_IsGameController(i)) pad_ = SDL_GameControllerOpen(i);
        PadState state;
        if (!pad_) return state;
        state.connected = true;
        state.leftX = axis(SDL_CONTROLLER_AXIS_LEFTX);
        state.leftY = axis(SDL_CONTROLLER_AXIS_LEFTY);
        state.rightX = axis(SDL_CONTROLLER_AXIS_RIGHTX);
        state.rightY = axis(SDL_CONTROLLER_AXIS_RIGHTY);
        state.leftTrigger = axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT);
        state.rightTrigger = axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
        for (std::size_t i = 0; i < padButtons; ++i)
            state.buttons[i] = SDL_GameControllerGetButton(pad_, sdlButtons[i]) != 0;
        return state;
    }

private:
    [[nodiscard]] double axis(SDL_GameControllerAxis which) const
    {
        const int raw = SDL_GameControllerGetAxis(pad_, which);
        return raw < 0 ? raw / 32768.0 : raw / 32767.0;
    }

    SDL_GameController* pad_ = nullptr;
};

}  // namespace
}  // namespace vitrine::ui

extern "C" __attribute__((visibility("default"))) vitrine::ui::Pads* vitrinePads(int version)
{
    return version == vitrine::ui::vitrinePadsVersion ? new vitrine::ui::SdlPads : nullptr;
}
