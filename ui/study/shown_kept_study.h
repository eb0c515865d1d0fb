#pragma once

#include "exhibits/study/contact_sheet.h"
#include "exhibits/study/kept_parameters.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace vitrine::ui {

/// Kept study that is shown: its file, its pictures once they have been read, and the parameters that it varied, as far
/// as they exist now.
class ShownKeptStudy {
public:
    /// `json`: text of its file; `title`: name for people.
    ShownKeptStudy(study::KeptStudy, std::string json, QString title);

    [[nodiscard]] const study::KeptStudy& study() const { return study_; }
    [[nodiscard]] const std::string& json() const { return json_; }
    [[nodiscard]] const QString& title() const { return title_; }
    [[nodiscard]] bool isTimed() const;
    /// Sets the pictures. Returns false if they belong to another study.
    bool setPictures(const study::ContactSheet&);
    [[nodiscard]] const study::ContactSheet& pictures() const { return pictures_; }
    /// Finds the parameters in the present tables. Call after tables changed.
    void findParameters(Subjects, const SceneState&);
    /// Returns the reason why no point can be applied; empty if one can.
    [[nodiscard]] QString whyNotApplied() const;
    /// Returns the point whose values are the present ones.
    [[nodiscard]] std::optional<std::size_t> presentPoint(const SceneState&) const;
    /// Sets the values of a point. If a parameter does not accept its value, changes nothing and returns the
    /// parameter's label.
    [[nodiscard]] std::optional<std::string> apply(std::size_t point, SceneState&) const;
    [[nodiscard]] QString captionOf(std::size_t point) const;

private:
    study::KeptStudy study_;
    std::string json_;
    QString title_;
    study::KeptParameters parameters_;
    study::ContactSheet pictures_;
};

}  // namespace vitrine::ui
