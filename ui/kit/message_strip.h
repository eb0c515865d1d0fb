#pragma once

#include <QWidget>

class QScrollArea;
class QVBoxLayout;

namespace vitrine::ui {

/// What happened, to which file and line, what to do. Problems are listed until dismissed; notices go by themselves
/// after some seconds. Never a pop-up. Text is plain and can be selected.
class MessageStrip final : public QWidget {
    Q_OBJECT

public:
    enum class Mood { notice, problem };

    explicit MessageStrip(QWidget* parent = nullptr);

    /// Lies over the top of this widget instead of pushing it down.
    void lieOver(QWidget*);
    /// A text that is already listed is not listed twice. Notices of one kind, told by the same `several`, become one:
    /// "%1 screenshots saved, the last one to %2.", with their number and the newest's `what`.
    /// `file`: the one it is about, which a button shows in its folder; empty: none.
    void say(Mood, const QString& text, const QString& several = {}, const QString& what = {},
             const QString& file = {});
    /// What was said is no longer so: takes it out of the list.
    void takeBack(const QString& text);
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

    QScrollArea* scroll_;
    QWidget* content_;
    QVBoxLayout* list_;
    QWidget* under_ = nullptr;
    int noticeTime_ = 8000;
    bool banned_ = false;
};

}  // namespace vitrine::ui
