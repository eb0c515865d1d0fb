#pragma once

#include "exhibits/study/study_result.h"
#include "exhibits/study/study_table.h"

#include <QWidget>

class QLineEdit;

namespace vitrine::ui {

/// Two sentences that find a setting: the cheapest within an error, or the best within a time.
class StudyFinder final : public QWidget {
    Q_OBJECT

public:
    explicit StudyFinder(QWidget* parent = nullptr);

    /// Suggests half of the present time as the limit, unless a limit was typed.
    void suggestTime(const StudyResult&);

signals:
    /// `limit`: error, or milliseconds; above 0.
    void asked(vitrine::StudyFind, double limit);
    void refused(const QString& why);

private:
    void ask(StudyFind);

    QLineEdit* error_;
    QLineEdit* milliseconds_;
};

}  // namespace vitrine::ui
