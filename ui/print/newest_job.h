#pragma once

#include <QObject>
#include <QThreadPool>

#include <functional>

namespace vitrine::ui {

/// Works beside the window, on one thread of its own. Of everything asked for while it is busy, only the
/// newest is done: a dragged slider sends whole requests and none of them piles up.
class NewestJob final : public QObject {
    Q_OBJECT

public:
    using Outcome = std::function<void()>;

    explicit NewestJob(QObject* parent);
    /// Waits for what is being done; its outcome is dropped.
    ~NewestJob() override;

    /// `work` runs on the other thread and must own what it uses; what it returns, if anything, runs on this one.
    void ask(std::function<Outcome()> work);
    /// Drops what waits, and the outcome of what is being done.
    void forget();
    [[nodiscard]] bool busy() const { return running_; }

signals:
    /// The work threw; `why` is for people.
    void failed(const QString& why);

private:
    void start(std::function<Outcome()> work);
    void take(int turn, const Outcome&, const QString& why);

    QThreadPool pool_;
    std::function<Outcome()> next_;
    bool running_ = false;
    int turn_ = 0;  ///< Grows when outcomes are forgotten.
};

}  // namespace vitrine::ui
