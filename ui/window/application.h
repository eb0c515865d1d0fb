#pragma once

#include <QApplication>

namespace vitrine::ui {

/// Application that survives exceptions in handlers of events and timers. The exception is reported, and the event
/// counts as handled. All code in the window's event loop runs below `notify`.
class Application final : public QApplication {
    Q_OBJECT

public:
    Application(int& argc, char** argv) : QApplication(argc, argv) {}

    bool notify(QObject*, QEvent*) override;

signals:
    /// Emitted with one or two full sentences on the exception.
    void caught(const QString& message);

private:
    void showError(const QString& message);

    bool telling_ = false;
};

}  // namespace vitrine::ui
