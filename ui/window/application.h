#pragma once

#include <QApplication>

namespace vitrine::ui {

/// An application that goes on when the handler of an event or a timer throws: what was thrown is told, and the event
/// counts as handled. Everything that runs in the window's event loop passes here.
class Application final : public QApplication {
    Q_OBJECT

public:
    Application(int& argc, char** argv) : QApplication(argc, argv) {}

    bool notify(QObject*, QEvent*) override;

signals:
    /// One or two full sentences.
    void caught(const QString& message);

private:
    void tell(const QString& message);

    bool telling_ = false;
};

}  // namespace vitrine::ui
