#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine {

class Parameters;

/// Settings with which an accuracy study shows the effect of a parameter, if its condition (`when`) is not sufficient.
/// Texts must be literals; names are those of parameters of the same object, unless said otherwise.
struct StudiedParameter {
    /// Value of another parameter.
    struct Setting {
        std::string_view row;
        double value = 0;
    };

    std::string_view name;
    /// Values of other parameters that make the effect visible: a matt body for shadows.
    std::vector<Setting> with = {};
    /// Values of the hall's parameters that make the effect visible: a sun that shines on the exhibit.
    std::vector<Setting> hall = {};
    /// Parameters that would limit or override this one. Each is studied at its own most exact value.
    std::vector<std::string_view> lifted = {};
    /// Parameters that take their most exact value only in the reference. The error then measures the drawn picture
    /// against the picture that the parameter helps to approximate.
    std::vector<std::string_view> exactInReference = {};
    /// Names of study views (`SceneObject::studyViews`) in which the effect is visible. Empty: all in which it acts.
    std::vector<std::string_view> views = {};
    /// Reason why every value gives the same picture: a sentence. Empty: the pictures differ.
    std::string_view same = {};
    /// Reason why the second most exact value may give the same picture as the most exact one: a sentence. Empty: they
    /// differ.
    std::string_view settles = {};
};

/// Declaration of studied parameters, as a member of the class with the parameters:
///
///     StudiedParameters studied{*this, {{.name = "shellCount", .lifted = {"levelOfDetail"}}}};
///
/// A class may have several, each beside its parameters. They are looked up by the address of the Parameters object.
/// Constructor, destructor and functions are thread-safe.
class StudiedParameters {
public:
    StudiedParameters(const Parameters&, std::initializer_list<StudiedParameter>);
    ~StudiedParameters();
    StudiedParameters(const StudiedParameters&) = delete;
    StudiedParameters& operator=(const StudiedParameters&) = delete;

    /// Returns the declaration for the parameter of that name; a StudiedParameter with only the name if there is none.
    [[nodiscard]] static StudiedParameter of(const Parameters&, std::string_view row);
    /// Returns all declarations for this object.
    [[nodiscard]] static std::vector<StudiedParameter> allOf(const Parameters&);

private:
    const Parameters& table_;
};

}  // namespace vitrine
