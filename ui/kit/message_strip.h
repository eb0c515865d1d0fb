#pragma once

#include <QHash>
#include <QWidget>

class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace vitrine::ui {

/// List of messages, the newest first: what happened, to which file and line, what to do. Problems stay until their
/// cause is gone or they are dismissed; notices go by themselves after some seconds. Never a pop-up. Text is plain and
/// can be selected. The list lies over other widgets and moves none of them.
class MessageStrip final : public QWidget {
    Q_OBJECT

public:
    enum class Mood { notice, problem };

    explicit MessageStrip(QWidget* parent = nullptr);

    /// Lies over the top of this widget instead of pushing it down.
    void lieOver(QWidget*);
    /// A text that is already listed is not listed twice, and comes first again. Notices of one kind, told by the same
    /// `several`, become one:
    /// "%1 screenshots saved, the last one to %2.", with their number and the newest's `what`.
    /// `file`: the one it is about, which a button shows in its folder; empty: none.
    void say(Mood, const QString& text, const QString& several = {}, const QString& what = {},
             const QString& file = {});
    /// Problems of one cause ("the files of the scene"): lists those that are new and takes back those that it listed
    /// for this cause before and that are not among `texts`. An empty list: the cause is gone. One that was dismissed
    /// stays away for as long as it is among them.
    void setProblems(const QString& cause, const QStringList& texts);
    [[nodiscard]] QStringList texts() const;
    void dismissAll();
    /// Out of sight, whatever is said meanwhile: in the bare picture.
    void setBanned(bool);
    /// How long a notice stays, milliseconds; while the pointer is on it, longer.
    void setNoticeTime(int milliseconds) { noticeTime_ = milliseconds; }

signals:
    void said(const QString& text);

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void fit();
    void takeBack(const QString& text);

    QScrollArea* scroll_;
    QWidget* content_;
    QVBoxLayout* list_;
    QToolButton* closeAll_;
    QHash<QString, QStringList> problems_;  // By cause.
    QWidget* under_ = nullptr;
    int noticeTime_ = 8000;
    bool banned_ = false;
};

}  // namespace vitrine::ui
