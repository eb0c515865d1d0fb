#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace vitrine::ui {

/// Row with the parameter to measure, the button that starts and stops, and the progress.
class MeasuringBar final : public QWidget {
    Q_OBJECT

public:
    explicit MeasuringBar(QWidget* parent = nullptr);

    /// Offers parameters, each with its label and its name, and all of them together.
    void setParameters(const std::vector<std::pair<QString, QString>>&);
    /// Selects the parameter of this name; an empty name stands for all together. Selects nothing for any other text.
    void select(const QString& name);
    [[nodiscard]] bool hasSelection() const;
    /// Puts a widget behind the button.
    void insert(QWidget*);

    void showStart();
    void showProgress(double part, const QString& doing);
    /// Ends the display of progress unless a study is `running`.
    void showIdle(bool running);

signals:
    void parameterChosen(const QString& name);
    void goAsked();  ///< Emitted when a study is to be started, or the running one stopped.

private:
    QComboBox* parameter_;
    QPushButton* go_;
    QProgressBar* progress_;
    QLabel* doing_;
    QElapsedTimer elapsed_;
};

}  // namespace vitrine::ui
