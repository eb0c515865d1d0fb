#pragma once

#define SDL_MAIN_HANDLED
#include <SDL.h>

#include <cmath>

namespace vitrine::test {

/// Virtual gamepad of SDL, connected while the object exists. SDL's joystick subsystem must be initialized.
class VirtualPad {
public:
    VirtualPad()
        : index_(SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                           SDL_CONTROLLER_BUTTON_MAX, 0)),
          id_(SDL_JoystickGetDeviceInstanceID(index_)), joystick_(SDL_JoystickOpen(index_))
    {
        // A released trigger is at the end of its axis, and not in the middle.
        trigger(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 0);
        trigger(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 0);
    }
    ~VirtualPad()
    {
        SDL_JoystickClose(joystick_);
        for (int i = 0; i < SDL_NumJoysticks(); ++i)
            if (SDL_JoystickGetDeviceInstanceID(i) == id_) SDL_JoystickDetachVirtual(i);
    }
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    [[nodiscard]] bool works() const { return index_ >= 0 && joystick_; }
    /// Moves a stick to -1 to 1.
    void stick(SDL_GameControllerAxis axis, double way)
    {
        SDL_JoystickSetVirtualAxis(joystick_, axis, static_cast<Sint16>(std::lround(way * 32767)));
    }
    /// Moves a trigger to 0 to 1.
    void trigger(SDL_GameControllerAxis axis, double way)
    {
        SDL_JoystickSetVirtualAxis(joystick_, axis, static_cast<Sint16>(std::lround(way * 65535 - 32768)));
    }
    void button(SDL_GameControllerButton button, bool down)
    {
        SDL_JoystickSetVirtualButton(joystick_, button, down ? 1 : 0);
    }

private:
    int index_;
    SDL_JoystickID id_;
    SDL_Joystick* joystick_;
};

}  // namespace vitrine::test
