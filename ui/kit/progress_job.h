#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <functional>
#include <memory>

namespace vitrine::ui {

/// Background job that reports its progress and can be stopped. Starting another one stops the one before.
class ProgressJob final : public QObject {
    Q_OBJECT

public:
    using Outcome = std::function<void()>;
    /// Called with the part that is done, 0 to 1. Returns false if the work is to stop, which it does by throwing.
    using Progress = std::function<bool(double)>;
    using Work = std::function<Outcome(const Progress&)>;

    explicit ProgressJob(QObject* parent);
    /// Stops the work and waits for its end.
    ~ProgressJob() override;

    /// Runs `work` on another thread; it must own everything it uses. Its result is called on this thread.
    void start(Work work);
    void stop();
    [[nodiscard]] bool running() const { return running_; }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    void failed(const QString& why);
    void stopped();

private:
    void run(Work work);
    void end(int turn, const Outcome&, const QString& why, bool stopped);

    QThreadPool pool_;
    QElapsedTimer elapsed_;
    std::shared_ptr<std::atomic<bool>> stopping_;
    Work next_;
    bool running_ = false;
    int turn_ = 0;
};

}  // namespace vitrine::ui
