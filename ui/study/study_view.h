#pragma once

#include "exhibits/study/study_costs.h"
#include "ui/study/shown_kept_study.h"

#include <QWidget>

#include <optional>
#include <string>

class QComboBox;
class QLabel;

namespace vitrine::ui {

class History;
class PointPictures;
class StudyChart;
struct ChartedStudy;

/// View of one study, measured here or kept: chart, pictures, and a summary. A kept study may have no pictures. A click
/// on a point applies it.
class StudyView final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the view.
    StudyView(const Museum&, History&, QWidget* parent = nullptr);

    /// Shows the running or last study, from its first point on. `isNew`: it replaces the study that is shown.
    void showMeasured(const study::StudyRequest&, study::StudyResult, const render::Json& machine, bool isNew);
    /// The running study was stopped: no further point comes.
    void noteStopped();
    /// Shows a kept study. `json`: text of its file; `title`: name for people.
    void showKept(study::KeptStudy, std::string json, const QString& title);
    /// Sets the pictures of the kept study once they have been read.
    void showKeptPictures(const study::ContactSheet&);
    /// Updates the view after values or parameter tables changed.
    void refresh();
    /// Shows a text in place of the summary.
    void say(const QString&);
    /// Applies the values of a point, as one undo step. Emits `refused` if that is impossible.
    void apply(std::size_t point);
    /// Applies a point of the study measured last here, even if another one is shown.
    void applyMeasured(std::size_t point);

    [[nodiscard]] bool empty() const { return !kept_ && result_.points.empty(); }
    [[nodiscard]] const study::StudyResult& result() const
    {
        return result_;
    }  ///< Result of the study measured last here.
    [[nodiscard]] const study::StudyRequest& request() const { return request_; }
    [[nodiscard]] bool showsKept() const { return kept_.has_value(); }
    [[nodiscard]] StudyChart& chart() const { return *chart_; }
    /// Returns the quantity on the cost axis. Until the user chooses one, it depends on how exact each study's clock
    /// is.
    [[nodiscard]] study::CostAxis costAxis() const;
    /// Sets the user's choice, which applies to all later studies.
    void chooseCostAxis(study::CostAxis);
    /// Returns the study measured last here, in the format of its file.
    [[nodiscard]] render::Json json() const;
    /// Returns a name for a file with what is shown, without an ending: "sdf_morph-hitTolerance".
    [[nodiscard]] QString fileName() const;
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
    void showKeptPoint(int point);
    void refreshKept();
    [[nodiscard]] QString sentences(const QString& law) const;
    [[nodiscard]] QWidget* chartWithCosts();
    void decideCostAxis(bool clockTrusted);
    void showChart(ChartedStudy, std::optional<std::size_t> present);
    [[nodiscard]] QString captionOf(const study::StudyPoint&) const;
    /// Returns the index of an axis's parameter in its exhibit's present table, which a file may have changed.
    [[nodiscard]] std::optional<std::size_t> rowNow(const study::StudyAxis&) const;
    [[nodiscard]] std::optional<std::size_t> presentPoint() const;
    void applyKept(std::size_t point);

    const Museum& museum_;
    History& history_;
    study::StudyRequest request_;
    study::StudyResult result_;
    render::Json machine_ = render::Json::object();
    std::optional<ShownKeptStudy> kept_;
    int shownPoint_ = -1;

    bool costChosen_ = false;  ///< The user has chosen the cost axis.
    bool stopped_ = false;     ///< The measured study ended early.

    QComboBox* cost_;
    QLabel* words_;
    StudyChart* chart_;
    PointPictures* pictures_;
};

}  // namespace vitrine::ui
