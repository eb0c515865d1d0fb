#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;

namespace vitrine::ui {

/// Bar that finds words in a text.
class FindBar final : public QWidget {
    Q_OBJECT

public:
    explicit FindBar(QWidget* parent = nullptr);

    /// Shows the bar with these words, if there are any.
    void open(const QString& words);
    [[nodiscard]] QLineEdit& words() const { return *words_; }
    /// Says whether the words were found.
    void setFound(bool);

signals:
    void asked(const QString& words, bool forward);
    void closed();

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void close();

    QLineEdit* words_;
    QLabel* result_;
};

}  // namespace vitrine::ui
