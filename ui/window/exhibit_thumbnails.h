#pragma once

#include <QObject>

namespace vitrine::ui {

class ExhibitList;
class Workbench;

/// Thumbnails in the list of exhibits: the shipped ones, and pictures kept from the screen for exhibits that ship none.
class ExhibitThumbnails final : public QObject {
    Q_OBJECT

public:
    /// Shows the thumbnails that are there. Both must outlive this object.
    ExhibitThumbnails(Workbench&, ExhibitList&, QObject* parent);

private:
    void showKept();
    /// Keeps the converged picture for the chosen exhibit if it has no thumbnail and the visitor stands before it.
    void keep();

    Workbench& workbench_;
    ExhibitList& list_;
};

}  // namespace vitrine::ui
