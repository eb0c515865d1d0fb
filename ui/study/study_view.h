#pragma once

#include "exhibits/study/contact_sheet.h"
#include "exhibits/study/kept_rows.h"
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

/// A study as it is seen: chart, pictures, and what it came to in words. One that was measured here, or one that was
/// kept, perhaps without its pictures. A click on a point applies it.
class StudyView final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive it.
    StudyView(const Museum&, History&, QWidget* parent = nullptr);

    /// The study that runs, or ran: shown from its first point on. `isNew`: another one than is on show.
    void showMeasured(const StudyRequest&, StudyResult, const render::Json& machine, bool isNew);
    /// The study that runs was stopped: no point follows.
    void noteStopped();
    /// `json`: of its file; `title`: for people.
    void showKept(KeptStudy, std::string json, const QString& title);
    /// Of the kept study on show, once they have been read.
    void showKeptPictures(const ContactSheet&);
    /// The look or the tables changed.
    void refresh();
    /// In place of what a study came to.
    void say(const QString&);
    /// Shows this point's values, as one step to undo. Says `refused` where it cannot.
    void apply(std::size_t point);
    /// The same of what was measured here last, whatever is on show.
    void applyMeasured(std::size_t point);

    [[nodiscard]] bool empty() const { return !kept_ && result_.points.empty(); }
    [[nodiscard]] const StudyResult& result() const { return result_; }  ///< Of what was measured here last.
    [[nodiscard]] const StudyRequest& request() const { return request_; }
    [[nodiscard]] bool showsKept() const { return kept_.has_value(); }
    [[nodiscard]] StudyChart& chart() const { return *chart_; }
    /// What the chart has on its axis of costs. Until the user chooses one, it follows from the clock of each study
    /// before its first point is shown; nothing else changes it.
    [[nodiscard]] CostAxis costAxis() const;
    /// The user's choice, which stays for all studies from then on.
    void chooseCostAxis(CostAxis);
    /// The study that was measured here last, as its file has it.
    [[nodiscard]] render::Json json() const;
    /// What is shown, as a file that ends in csv, json, png or svg.
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
    [[nodiscard]] QString whyNotApplied() const;  ///< Of the kept one; empty where it can be.
    [[nodiscard]] QString captionOf(const StudyPoint&) const;
    [[nodiscard]] QString captionOf(const KeptStudy&, std::size_t point) const;
    /// The row of an axis of what is shown, in the table that its exhibit has now: a file may have given it others.
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
    KeptRows keptRows_;
    ContactSheet keptPictures_;
    int shownPoint_ = -1;
    PictureTriple shown_;  ///< In the pictures.
    QString shownScale_;

    bool costChosen_ = false;  ///< By the user.
    bool stopped_ = false;     ///< The measured study ended early.

    QComboBox* cost_;
    QWidget* right_;  ///< Pictures and what they are; hidden while there is nothing to say.
    QComboBox* view_;
    QLabel* words_;
    QLabel* caption_;
    StudyChart* chart_;
    StudyPictures* pictures_;
    LargePictures* large_ = nullptr;  ///< Once it was asked for.
};

}  // namespace vitrine::ui
