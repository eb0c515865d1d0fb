#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine {

class Parameters;

/// How an accuracy study shows what a parameter does, where its condition (`when`) does not say enough. Texts must be
/// literals; names are those of rows of the same table.
struct StudiedRow {
    /// The value of another row.
    struct Setting {
        std::string_view row;
        double value = 0;
    };

    std::string_view name;
    /// Values of other rows, in which the parameter shows: a matt body for shadows.
    std::vector<Setting> with = {};
    /// Rows that would cap or override the parameter. Each is studied at its own most exact value.
    std::vector<std::string_view> lifted = {};
    /// Rows that take their most exact value in the reference only: errors are those of the picture as it is drawn
    /// against the picture that the parameter helps to approximate.
    std::vector<std::string_view> exactInReference = {};
    /// Names of study views (`Subject::studyViews`) in which the parameter shows. Empty: all in which it acts.
    std::vector<std::string_view> views = {};
    /// Why every value gives the same picture: a sentence. Empty: the pictures differ.
    std::string_view same = {};
    /// Why the second most exact value may already give the picture of the most exact one: a sentence. Empty: they
    /// differ.
    std::string_view settles = {};
};

/// The studied rows of a table, as a member of it:
///
///     StudiedRows studied{*this, {{.name = "shellCount", .lifted = {"levelOfDetail"}}}};
///
/// A table may have several, each beside its parameters. They are looked up by the table's address. Any thread may
/// make, ask and destroy.
class StudiedRows {
public:
    StudiedRows(const Parameters&, std::initializer_list<StudiedRow>);
    ~StudiedRows();
    StudiedRows(const StudiedRows&) = delete;
    StudiedRows& operator=(const StudiedRows&) = delete;

    /// Returns what the table declares of the row of that name; a StudiedRow with nothing but the name where it says
    /// nothing.
    [[nodiscard]] static StudiedRow of(const Parameters&, std::string_view row);
    /// Everything that the table declares.
    [[nodiscard]] static std::vector<StudiedRow> allOf(const Parameters&);

private:
    const Parameters& table_;
};

}  // namespace vitrine
