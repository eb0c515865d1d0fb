#pragma once

#include <QPlainTextEdit>

namespace vitrine::ui {

/// Everything that was said, with the time; warnings of Qt and the driver too.
class LogView final : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit LogView(QWidget* parent = nullptr);
    ~LogView() override;
    void add(const QString& text);
};

}  // namespace vitrine::ui
