#pragma once

#include "exhibits/jobs/kit/job.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <functional>
#include <optional>

class QLabel;
class QListWidget;
class QPushButton;

namespace vitrine::ui {

/// Settings of an export page, which presets store and set.
struct ExportSettings {
    const jobs::Job* job = nullptr;
    std::function<ParameterValues()> values = {};
    /// Sets the values in one undo step with this name.
    std::function<void(const QString& undoText, const ParameterValues&)> change = {};
};

/// The presets of the shown export page: chooses, saves, deletes and resets.
class ExportPresetList final : public QWidget {
    Q_OBJECT

public:
    explicit ExportPresetList(QWidget* parent);

    /// Shows the presets of this page. Call `clear` before the page is destroyed.
    void show(ExportSettings);
    void clear();
    [[nodiscard]] QStringList names() const;

signals:
    /// Emitted when a preset cannot be read, written or deleted; empty: the last action succeeded.
    void failed(const QString& why);
    /// Emitted for a value that was corrected.
    void noted(const QString& note);

private:
    void refresh(const QString& selected);
    /// Does something with the presets, and reports whether it failed.
    bool attempt(const std::function<void()>& work);
    /// Asks a question whose answer is this button; then calls `work`.
    void ask(const QString& question, const QString& button, std::function<void()> work);
    [[nodiscard]] QString selected() const;
    void choose();
    void askName();
    void save(const QString& name);
    void askDelete();
    void reset();

    std::optional<ExportSettings> settings_;
    QLabel* heading_;
    QListWidget* list_;
    QPushButton *save_, *delete_, *reset_;
};

}  // namespace vitrine::ui
