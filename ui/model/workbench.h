#pragma once

#include "ui/kit/message_strip.h"

#include <cstddef>

namespace vitrine {
class Museum;
}

namespace vitrine::ui {

class History;
class Renderers;
class Viewport;

/// Returns the cause under which problems of opening this file are listed. Opening the file again takes them back.
[[nodiscard]] inline QString openingOf(const QString& path)
{
    return QStringLiteral("opening ") + path;
}

/// Interface of the window for controllers, exports and dialogs.
class Workbench {
public:
    virtual ~Workbench() = default;

    [[nodiscard]] virtual const Museum& museum() const = 0;
    /// Renderers of the render thread: call them only from its tasks.
    [[nodiscard]] virtual Renderers& renderers() const = 0;
    [[nodiscard]] virtual History& history() = 0;
    [[nodiscard]] virtual Viewport& viewport() const = 0;
    /// Index of the subject that is visited: an exhibit, or the hall.
    [[nodiscard]] virtual std::size_t chosen() const = 0;
    /// Index of the subject whose parameters the panel shows: the chosen exhibit, or the hall.
    [[nodiscard]] virtual std::size_t shown() const = 0;
    /// Shows this exhibit's parameters and presets.
    virtual void choose(std::size_t exhibit) = 0;
    /// As `MessageStrip::say`.
    virtual void say(MessageStrip::Mood, const QString& text, const QString& several = {}, const QString& what = {},
                     const QString& file = {}) = 0;
    /// As `MessageStrip::setProblems`.
    virtual void setProblems(const QString& cause, const QStringList& texts) = 0;
};

}  // namespace vitrine::ui
