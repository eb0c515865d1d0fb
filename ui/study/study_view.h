#pragma once

#include "exhibits/study/contact_sheet.h"
#include "exhibits/study/kept_parameters.h"
#include "exhibits/study/study_costs.h"
#include "ui/study/picture_panes.h"

#include <QWidget>

#include <optional>
#include <string>

class QComboBox;
class QLabel;

namespace vitrine::ui {

class History;
class LargePictures;
class StudyChart;
class StudyPictures;
struct ChartedStudy;

/// View of one study, measured here or kept: chart, pictures, and a summary. A kept study may have no pictures. A click
/// on a point applies it.
class StudyView final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the view.
    StudyView(const Museum&, History&, QWidget* parent = nullptr);

    /// Shows the running or last study, from its first point on. `isNew`: it replaces the study that is shown.
    void showMeasured(const StudyRequest&, StudyResult, const render::Json& machine, bool isNew);
    /// The running study was stopped: no further point comes.
    void noteStopped();
    /// Shows a kept study. `json`: text of its file; `title`: name for people.
    void showKept(KeptStudy, std::string json, const QString& title);
    /// Sets the pictures of the kept study once they have been read.
    void showKeptPictures(const ContactSheet&);
    /// Updates the view after values or parameter tables changed.
    void refresh();
    /// Shows a text in place of the summary.
    void say(const QString&);
    /// Applies the values of a point, as one undo step. Emits `refused` if that is impossible.
    void apply(std::size_t point);
    /// Applies a point of the study measured last here, even if another one is shown.
    void applyMeasured(std::size_t point);

    [[nodiscard]] bool empty() const { return !kept_ && result_.points.empty(); }
    [[nodiscard]] const StudyResult& result() const { return result_; }  ///< Result of the study measured last here.
    [[nodiscard]] const StudyRequest& request() const { return request_; }
    [[nodiscard]] bool showsKept() const { return kept_.has_value(); }
    [[nodiscard]] StudyChart& chart() const { return *chart_; }
    /// Returns the quantity on the cost axis. Until the user chooses one, it depends on how exact each study's clock
    /// is.
    [[nodiscard]] CostAxis costAxis() const;
    /// Sets the user's choice, which applies to all later studies.
    void chooseCostAxis(CostAxis);
    /// Returns the study measured last here, in the format of its file.
    [[nodiscard]] render::Json json() const;
    /// Returns the content of a file with all that is shown; `suffix` is csv, json, png or svg.
    [[nodiscard]] QByteArray exported(const QString& suffix) const;

signals:
    void refused(const QString& why);

protected:
    void showEvent(QShowEvent*) override;

private:
    void layOut();
    void connectParts();
    void showPoint(int point);
    void showPictures(render::Image picture, render::Image reference, render::Metric);
    void showKeptPoint(int point);
    void showCaption(const QString&);
    void refreshKept();
    void enlarge();
    void fillLarge();
    [[nodiscard]] QString sentences(const QString& law) const;
    [[nodiscard]] QWidget* chartWithCosts();
    void decideCostAxis(bool clockTrusted);
    void showChart(ChartedStudy, std::optional<std::size_t> present);
    void hidePictures();
    [[nodiscard]] QString whyNotApplied() const;  ///< Reason why the kept study cannot be applied; empty if it can.
    [[nodiscard]] QString captionOf(const StudyPoint&) const;
    [[nodiscard]] QString captionOf(const KeptStudy&, std::size_t point) const;
    /// Returns the index of an axis's parameter in its exhibit's present table, which a file may have changed.
    [[nodiscard]] std::optional<std::size_t> rowNow(const StudyAxis&) const;
    [[nodiscard]] std::optional<std::size_t> presentPoint() const;
    [[nodiscard]] std::optional<std::size_t> presentKeptPoint() const;
    void applyKept(std::size_t point);

    const Museum& museum_;
    History& history_;
    StudyRequest request_;
    StudyResult result_;
    render::Json machine_ = render::Json::object();
    std::optional<KeptStudy> kept_;
    std::string keptJson_;
    QString keptTitle_;
    KeptParameters keptParameters_;
    ContactSheet keptPictures_;
    int shownPoint_ = -1;
    PictureTriple shown_;  ///< Content of `pictures_`.
    QString shownScale_;

    bool costChosen_ = false;  ///< The user has chosen the cost axis.
    bool stopped_ = false;     ///< The measured study ended early.

    QComboBox* cost_;
    QWidget* right_;  ///< Pictures and their caption; hidden while there are none.
    QComboBox* view_;
    QLabel* words_;
    QLabel* caption_;
    StudyChart* chart_;
    StudyPictures* pictures_;
    LargePictures* large_ = nullptr;  ///< Null until it is opened.
};

}  // namespace vitrine::ui
