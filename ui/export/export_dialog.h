#pragma once

#include "ui/export/export_preset_list.h"

#include <QDialog>
#include <QString>

#include <functional>
#include <map>
#include <vector>

class QListWidget;
class QStackedWidget;

namespace vitrine::ui {

class MessageStrip;

/// Kind of export that the dialog offers.
struct ExportKind {
    QString id;                                             ///< "render".
    QString title;                                          ///< Entry of the list: "Picture".
    std::function<QDialog*(QWidget*)> makePage;             ///< Creates the page. Its `finished` closes the dialog.
    std::function<bool(const QDialog&)> exporting;          ///< Returns whether a page is writing.
    QString unavailable = {};                               ///< Reason why this kind cannot be chosen; empty: it can.
    std::function<ExportSettings(QDialog&)> settings = {};  ///< Returns the settings of a page; empty: no presets.
};

/// The dialog for all exports: a list of kinds with the presets of the shown one, and a page for each, which is created
/// when it is first chosen. An export goes on while another page is shown, or while the dialog is hidden.
class ExportDialog final : public QDialog {
    Q_OBJECT

public:
    ExportDialog(std::vector<ExportKind> kinds, QWidget* parent);

    /// Shows a kind and returns its page.
    QDialog* showKind(const QString& id);
    [[nodiscard]] QString shownKind() const;
    /// Cancels the export of the shown page. Without one, closes the dialog.
    void reject() override;

protected:
    void showEvent(QShowEvent*) override;

private:
    [[nodiscard]] QDialog* page(const ExportKind&);
    [[nodiscard]] bool isExporting(const QString& id) const;
    void endPage(const QString& id);
    [[nodiscard]] QWidget* buildColumn();

    std::vector<ExportKind> kinds_;
    std::map<QString, QDialog*> pages_;
    QListWidget* list_;
    QStackedWidget* stack_;
    ExportPresetList* presets_;
    MessageStrip* messages_;
};

}  // namespace vitrine::ui
