#pragma once

#include <QDialog>

class QPushButton;
class QTextBrowser;

namespace vitrine::ui {

/// A page about each exhibit: how its technique works, with figures, formulas and sources. assets/pages/NAME.html, in
/// the rich text that Qt knows; links lead to other pages, to the web, and to lessons ("lesson:noise").
class PageDialog final : public QDialog {
    Q_OBJECT

public:
    explicit PageDialog(QWidget* window);

    /// The page of the subject of this name.
    void showPage(const QString& name);
    [[nodiscard]] QTextBrowser& browser() const { return *browser_; }

signals:
    /// Somebody wants to walk through this exhibit's lesson.
    void lessonAsked(const QString& exhibit);

private:
    void follow(const QUrl&);
    void noteSource();

    QTextBrowser* browser_;
    QPushButton* lesson_;
    QPushButton* back_;
};

}  // namespace vitrine::ui
