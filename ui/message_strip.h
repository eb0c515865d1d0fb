#pragma once

#include <QWidget>

class QVBoxLayout;
class QScrollArea;

namespace vitrine::ui {

/// What happened, to which file and line, what to do: listed above the viewport until dismissed. Never a
/// pop-up. Text is plain and can be selected.
class MessageStrip final : public QWidget {
    Q_OBJECT

public:
    enum class Mood { notice, problem };

    explicit MessageStrip(QWidget* parent = nullptr);

    /// A text that is already listed is not listed twice.
    void say(Mood, const QString& text);
    [[nodiscard]] QStringList texts() const;
    void dismissAll();

signals:
    void said(const QString& text);

private:
    void fit();

    QScrollArea* scroll_;
    QWidget* content_;
    QVBoxLayout* list_;
};

}  // namespace vitrine::ui
