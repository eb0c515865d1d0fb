#pragma once

#include <QPlainTextEdit>

namespace vitrine::ui {

/// Log of all messages with their times, including warnings of Qt and the driver.
class LogView final : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit LogView(QWidget* parent = nullptr);
    ~LogView() override;
    void add(const QString& text);
};

}  // namespace vitrine::ui
