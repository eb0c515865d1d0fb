#pragma once

#include <QHash>
#include <QWidget>

class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace vitrine::ui {

/// List of messages, the newest first. A problem stays until its cause is gone or it is dismissed; a notice disappears
/// after some seconds. The text is plain and can be selected. The list lies over other widgets and moves none of them.
class MessageStrip final : public QWidget {
    Q_OBJECT

public:
    enum class Mood { notice, problem };

    explicit MessageStrip(QWidget* parent = nullptr);

    /// Places the list over the top of this widget.
    void lieOver(QWidget*);
    /// Shows a message. A text that is already listed moves to the front. Notices with the same `several` are merged
    /// into one. `several`: text of merged notices, such as "%1 screenshots saved, the last one to %2.", filled with
    /// their number and the newest one's `what`. `file`: the file that the message is about, with a button that shows
    /// it in its folder; empty: none.
    void say(Mood, const QString& text, const QString& several = {}, const QString& what = {},
             const QString& file = {});
    /// Sets the problems of one cause, such as "the files of the scene". New ones are listed, and earlier ones of this
    /// cause that are not in `texts` are removed. An empty list removes all. A dismissed problem stays hidden for as
    /// long as it is in `texts`.
    void setProblems(const QString& cause, const QStringList& texts);
    [[nodiscard]] QStringList texts() const;
    void dismissAll();
    /// While on, the list is hidden, even for new messages: used for the bare picture.
    void setBanned(bool);
    /// Sets how long a notice stays, in milliseconds. It stays longer while the pointer is on it.
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
    QHash<QString, QStringList> problems_;  // Texts listed for each cause.
    QWidget* under_ = nullptr;
    int noticeTime_ = 8000;
    bool banned_ = false;
};

}  // namespace vitrine::ui
