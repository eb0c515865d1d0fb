#pragma once

#include <QString>

namespace vitrine::ui {

struct ParameterNote {
    QString text;         ///< Label below the parameter; empty: none.
    QString explanation;  ///< Sentences for its tooltip.
    bool operator==(const ParameterNote&) const = default;
};

/// Controllers (OSC, MIDI) that move parameters, as the parameter panel shows and changes them. Keys are
/// "exhibit/parameter".
class ControlledParameters {
public:
    virtual ~ControlledParameters() = default;
    /// Returns the label of the parameter's control, and where the control stands while it does not move the parameter.
    [[nodiscard]] virtual ParameterNote note(const QString& key) const = 0;
    /// Returns whether a control can move the parameter at all.
    [[nodiscard]] virtual bool mayLearn(const QString& key) const = 0;
    /// Returns whether the next control that moves is given to the parameter.
    [[nodiscard]] virtual bool isLearning(const QString& key) const = 0;
    [[nodiscard]] virtual bool isControlled(const QString& key) const = 0;
    /// Gives the next control that moves to the parameter. An empty key ends that.
    virtual void learn(const QString& key) = 0;
    virtual void forget(const QString& key) = 0;
};

}  // namespace vitrine::ui
