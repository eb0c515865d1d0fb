#pragma once

#include "exhibits/study/study_result.h"
#include "exhibits/study/study_table.h"

#include <QObject>

#include <array>

class QLineEdit;
class QWidget;

namespace vitrine::ui {

/// Two sentences that find a setting: the cheapest within an error, or the best within a time. Each is a widget, so
/// that a layout may put them on two lines.
class StudyFinder final : public QObject {
    Q_OBJECT

public:
    /// The parent owns this object and both widgets.
    explicit StudyFinder(QWidget* parent);

    [[nodiscard]] std::array<QWidget*, 2> sentences() const { return {byError_, byTime_}; }

    /// Suggests half of the present time as the limit, unless a limit was typed.
    void suggestTime(const study::StudyResult&);

signals:
    /// `limit`: error, or milliseconds; above 0.
    void asked(vitrine::study::StudyFind, double limit);
    void refused(const QString& why);

private:
    void ask(study::StudyFind);

    QWidget *byError_, *byTime_;
    QLineEdit* error_;
    QLineEdit* milliseconds_;
};

}  // namespace vitrine::ui
