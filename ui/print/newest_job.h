#pragma once

#include <QObject>
#include <QThreadPool>

#include <functional>

namespace vitrine::ui {

/// Background job with a thread of its own. While it is busy, only the newest request is kept, so that requests of a
/// dragged slider do not pile up.
class NewestJob final : public QObject {
    Q_OBJECT

public:
    using Outcome = std::function<void()>;

    explicit NewestJob(QObject* parent);
    /// Waits for the present work and drops its outcome.
    ~NewestJob() override;

    /// Runs `work` on the other thread; it must own everything it uses. Its result, if any, is called on this thread.
    void ask(std::function<Outcome()> work);
    /// Drops the waiting request and the outcome of the present work.
    void forget();
    [[nodiscard]] bool busy() const { return running_; }

signals:
    /// Emitted when the work threw; `why` is a sentence for people.
    void failed(const QString& why);

private:
    void start(std::function<Outcome()> work);
    void take(int turn, const Outcome&, const QString& why);

    QThreadPool pool_;
    std::function<Outcome()> next_;
    bool running_ = false;
    int turn_ = 0;  ///< Grows when outcomes are dropped.
};

}  // namespace vitrine::ui
