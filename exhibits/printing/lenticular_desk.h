#pragma once

#include "exhibits/printing/desk_table.h"
#include "exhibits/printing/own_sheets.h"
#include "exhibits/printing/view_rig.h"
#include "exhibits/printing/view_set.h"

namespace vitrine::printing {

/// The views of a desk: in full for the print, and small ones for looking at it.
class DeskViews final : public PrintViews {
public:
    [[nodiscard]] int count() const override { return full_.count(); }
    void add(const render::Image&) override;

    void setLook(std::string look) override { look_ = std::move(look); }
    [[nodiscard]] const std::string& look() const { return look_; }

    [[nodiscard]] const ViewSet& full() const { return full_; }
    [[nodiscard]] const ViewSet& small() const { return small_; }
    [[nodiscard]] const std::string& profile() const { return profile_; }
    void setProfile(std::string profile) { profile_ = std::move(profile); }

private:
    ViewSet full_, small_;
    std::string profile_, look_;
};

/// The desk over the interlacer, the charts and the sheets of this folder.
class LenticularDesk final : public PrintDesk {
public:
    /// The user's sheets are in "vitrine/sheets.json" of the configuration folder.
    LenticularDesk();
    explicit LenticularDesk(std::filesystem::path ownSheets) : own_(std::move(ownSheets)) {}

    [[nodiscard]] const DeskTable& table() const { return table_; }

    [[nodiscard]] const Parameters& parameters() const override { return table_; }
    [[nodiscard]] ViewOrigin origin(const ParameterValues&) const override;
    [[nodiscard]] ParameterValues withOrigin(const ParameterValues&, ViewOrigin) const override;
    [[nodiscard]] bool matters(const ParameterInfo&, const ParameterValues&, bool chart) const override;
    [[nodiscard]] bool sameViews(const ParameterValues&, const ParameterValues&) const override;
    [[nodiscard]] double viewingDistance(const ParameterValues&) const override;

    [[nodiscard]] std::vector<SheetEntry> sheets(std::string& problem) const override;
    [[nodiscard]] ParameterValues withSheet(const ParameterValues&, const std::string& name) const override;
    [[nodiscard]] std::string sheetName(const ParameterValues&, const std::string& preferred = {}) const override;
    void saveSheet(const ParameterValues&, const std::string& name) override;
    void removeSheet(const std::string& name) override;

    [[nodiscard]] std::shared_ptr<PrintViews> newViews() const override;
    [[nodiscard]] std::shared_ptr<const PrintViews> readViews(const ParameterValues&, const std::vector<std::string>& files,
                                                              const PrintProgress&) const override;

    [[nodiscard]] std::vector<PrintShot> shots(const ParameterValues&, const Look&, const FrameRequest&, bool draft) const override;
    [[nodiscard]] ParameterValues withBaselineScale(const ParameterValues&, double) const override;
    [[nodiscard]] SceneDepth sceneDepth(const ParameterValues&, const Look&, const render::Image&) const override;

    [[nodiscard]] PrintSummary summary(const ParameterValues&, const PrintViews*, bool chart, const std::filesystem::path&) const override;
    [[nodiscard]] std::shared_ptr<const PrintPreview> preview(const ParameterValues&, std::shared_ptr<const PrintViews>) const override;
    std::vector<std::filesystem::path> write(const ParameterValues&, std::shared_ptr<const PrintViews>, const std::vector<std::string>& sources,
                                             const std::filesystem::path&, const PrintProgress&) const override;

    [[nodiscard]] std::string settingsText(const ParameterValues&, const std::vector<std::string>& sources) const override;
    [[nodiscard]] Settings settingsFrom(const std::string& text, const std::string& fileName) const override;
    [[nodiscard]] std::string settingsIn(const std::filesystem::path&) const override;

private:
    [[nodiscard]] std::vector<Sheet> allSheets(std::string& problem) const;
    [[nodiscard]] PrintLayout chartLayout(const ParameterValues&) const;
    [[nodiscard]] double tileWidth(const ParameterValues&) const;  ///< In millimeters.
    [[nodiscard]] ViewRig rigOf(const ParameterValues&, const Look&) const;
    /// For a chart, of as many views as it is to try.
    [[nodiscard]] PrintLayout layoutOf(const ParameterValues&, const PrintViews*) const;

    DeskTable table_;
    OwnSheets own_;
};

}  // namespace vitrine::printing
