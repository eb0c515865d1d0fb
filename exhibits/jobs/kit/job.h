#pragma once

#include "exhibits/framework/files/picture_record.h"
#include "exhibits/framework/scene/frame_request.h"
#include "exhibits/framework/table/parameters.h"
#include "exhibits/museum/museum.h"
#include "exhibits/museum/picture.h"
#include "render/files/strict_json.h"
#include "render/plan/render_backend.h"

#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace vitrine::study {
class StudyParts;
}

namespace vitrine::jobs {

/// A parameter of a subject, by its index in the table.
struct PinnedParameter {
    std::size_t subject = 0, row = 0;

    bool operator==(const PinnedParameter&) const = default;
};

/// Values of a picture's parameters that are left to the scene.
struct UsualPicture {
    int samples = 0;      ///< Samples per pixel of the picture whose settings were taken; 0: unknown.
    glm::ivec2 size{0};   ///< Pixels of that picture, or of the view in the window; 0: unknown.
    Channels channels{};  ///< Further channels of that picture.
    bool depth = false, position = false, objects = false;  ///< Whether it had these channels.
    std::optional<FrameBefore> before = {};  ///< Frame before that picture, if it had the channel motion.
    /// Whether the field of view grows for a narrow picture, as in the window (`widened`).
    bool widens = false;
    double secondsPerSample = 0;  ///< Time in which the window drew a sample of a pixel; 0: unknown.
};

/// Settings that a job compares with those of its scene.
struct OtherSettings {
    SceneState state;
    std::string name = {};  ///< For people: "soft.json".
};

/// Scene that a job works on: the museum and everything that is set in it.
struct JobScene {
    const Museum* museum = nullptr;  ///< Null for a job without a scene. Must outlive what is made of it.
    SceneState state = {};
    std::size_t subject = 0;  ///< In `Museum::subjects`.
    FrameRequest frame = {};
    UsualPicture usual = {};
    /// Parameters that were set one by one, which a job with `JobNeeds::anySettings` does not change.
    std::vector<PinnedParameter> pinned = {};
    std::string name = {};  ///< Name of its settings, for people. Only for a job with `JobNeeds::twoSettings`.
    std::optional<OtherSettings> other = {};
};

/// Form in which a preview shows the result of a run.
enum class PreviewForm : std::uint8_t { none, picture, text, sprites };

/// Inputs of a job besides its parameters, and the formats that it writes.
struct JobNeeds {
    /// Exhibit whose settings the job takes (`--preset`, `--set`); empty: none.
    std::string_view subject = {};
    /// True if the job shows any exhibit or the hall, with all options of a scene.
    bool anyScene = false;
    /// Whether the job takes the settings of any exhibit or of the hall, and has views of its own.
    bool anySettings = false;
    /// Whether it compares two settings, A and B, seen by one camera: those of the scene, and `JobScene::other`.
    bool twoSettings = false;
    /// Exhibit, and its file parameter, that a path in place of an exhibit's name sets. Empty: only names are allowed.
    std::pair<std::string_view, std::string_view> fileOf = {};
    /// Extensions of the output, the usual one first: "png". Empty: the output is a folder.
    std::vector<std::string_view> extensions = {};
    /// Whether the exhibit is an option (`--exhibit`) that may be left out, because the job also works without a scene.
    bool sceneByOption = false;
    bool inWindow = false;  ///< Whether the window offers it.
    bool inParts = false;   ///< Whether several processes can share it.
    /// Help of the option for a further file with a report (`JobOrder::reportFile`); empty: there is none.
    std::string_view report = {};
    /// Whether the output itself carries the settings, so that no document lies beside it.
    bool carriesSettings = false;
    bool answers = false;      ///< Whether the service answers what was made (`JobRun::answer`) in place of writing it.
    bool timesPasses = false;  ///< Whether its backend must time each pass, which makes it slower.
    PreviewForm preview = PreviewForm::none;

    [[nodiscard]] bool hasScene() const { return anyScene || anySettings || twoSettings || !subject.empty(); }
    /// Whether it works on an exhibit that people choose.
    [[nodiscard]] bool choosesSubject() const { return anyScene || anySettings; }
};

/// A measured or computed property of a job's output: "Frames 12", "Volume 0.523 m³".
struct Fact {
    std::string label;  ///< With a capital, as the window shows it.
    std::variant<double, std::string> value;
    std::string unit = {};

    bool operator==(const Fact&) const = default;
};
/// Formats the value: "12", "0.523 m³". Numbers that are not whole have three digits.
[[nodiscard]] std::string valueText(const Fact&);

struct PlannedFile {
    std::filesystem::path path;
    std::string content;  ///< "normals": what is in it.

    bool operator==(const PlannedFile&) const = default;
};

/// Outcome of a job as far as it is known before the start.
struct JobPlan {
    std::string refusal = {};                ///< Sentence on why the job cannot start; empty: it can.
    std::vector<std::string> warnings = {};  ///< Sentences on what may disappoint.
    std::vector<PlannedFile> files = {};     ///< All that will be written, the output first.
    std::vector<Fact> facts = {};
    std::string ifStopped = {};  ///< Sentence on what is left when the job is stopped; empty: nothing.
    bool makesFolders = false;   ///< Whether folders above a file are made, as they are above an output folder.
    /// Values offered for text parameters, by the parameter's name: the animations of a file.
    std::map<std::string, std::vector<std::string>, std::less<>> offers = {};

    bool operator==(const JobPlan&) const = default;
};

/// Outcome of a finished job.
struct JobReport {
    std::vector<std::filesystem::path> files = {};
    std::vector<Fact> facts = {};
    std::vector<std::string> warnings = {};
};

/// Expected outcome of a job, judged by a draft.
struct JobForecast {
    std::vector<Fact> facts = {};  ///< In addition to those of the plan.
    double seconds = 0;            ///< Duration of the run; 0: unknown.
};

/// Called repeatedly with the fraction that is done, 0 to 1. Returns false if the job must stop.
using Watch = std::function<bool(double part)>;

/// Exception of a step that stopped because its `Watch` returned false.
class Stopped final : public std::exception {
public:
    [[nodiscard]] const char* what() const noexcept override { return "The job was stopped."; }
};

/// A job in progress. Destroying it before `publish` cancels it. Then no file remains, except as `JobPlan::ifStopped`
/// states.
class JobRun {
public:
    enum class Next : std::uint8_t {
        draw,  ///< `step` draws for part of a second; always on the same thread, which has the graphics.
        work,  ///< `step` computes on any thread and asks `Watch` often.
        done   ///< `publish` comes next.
    };

    virtual ~JobRun() = default;

    [[nodiscard]] virtual Next next() const = 0;
    /// Runs the next step. Throws Stopped, or Failure naming what was being done.
    virtual void step(const Watch&) = 0;
    /// Returns the fraction that is done, 0 to 1.
    [[nodiscard]] virtual double progress() const = 0;
    /// Returns what the next step does, such as "drawing". Messages show it after the program's name.
    [[nodiscard]] virtual std::string_view doing() const = 0;
    /// Returns the report of the work so far. It is complete when `next` returns `done`.
    [[nodiscard]] virtual const JobReport& report() const = 0;
    /// Moves all files to their destinations at once. On failure throws Failure and leaves all old files unchanged. Any
    /// thread.
    virtual void publish() = 0;
    /// Returns a picture of the finished result, linear with opacity. For `PreviewForm::picture`.
    [[nodiscard]] virtual render::Image previewPicture() const { return {}; }
    /// Returns the first lines of the finished result. For `PreviewForm::text`.
    [[nodiscard]] virtual std::string previewText() const { return {}; }
    /// Returns what the finished job made, for the service.
    [[nodiscard]] virtual render::Json answer() const { return {}; }
};

/// Finished draft of a job, by which the whole is judged.
struct FinishedDraft {
    const ParameterValues& values;  ///< Values of the draft (`Job::draft`).
    const JobRun& run;
    double seconds = 0;  ///< Duration of the run.
};

/// Files and other inputs that the values name, as read. Immutable.
class JobInputs {
public:
    virtual ~JobInputs() = default;
};

/// Creates the backend on the thread that draws, when the job first needs it.
using BackendMaker = std::function<std::unique_ptr<render::RenderBackend>()>;

/// Share of a job's items (such as frames) that this process makes if several processes share the job.
struct JobShare {
    std::function<bool(int)> makes = {};  ///< Whether it makes item k (from 0). Empty: all.
    /// Pattern of the items that the parts made ("folder/%06d.png"). If set, they are read and not made.
    std::filesystem::path from = {};
    /// The same for items that are measures. Null: there are none.
    study::StudyParts* measures = nullptr;
    /// Writes a picture exactly, under this name. Empty for a job in one piece.
    std::function<void(const std::string& name, const render::Image&)> keep = {};
    /// Reads what a part kept. If set, pictures are read and not made. Throws Failure (ErrorKind::check).
    std::function<render::Image(const std::string& name)> kept = {};
};

/// Everything that a job needs in order to start.
struct JobOrder {
    ParameterValues values;
    JobScene scene = {};
    std::shared_ptr<const JobInputs> inputs = {};
    std::filesystem::path out = {};  ///< Empty: nothing will be published, as for a preview.
    BackendMaker backend = {};
    JobShare share = {};
    int largestTile = 2048;  ///< Largest side of what is drawn in one step, in pixels.
    /// Describes the machine that draws. Called after the backend was made.
    std::function<render::Json()> machine = {};
    /// Measures the report of a picture's frame. `first`: report of its first sample. Empty: none is written.
    std::function<render::Json(const JobScene&, const PictureRequest&, const render::FrameReport& first)> frameReport =
        {};
    std::filesystem::path reportFile = {};
    /// Writes the folder of a study, whose pages and charts are made by the program. Empty: the job writes all files.
    std::function<void(const JobRun&)> writeFolder = {};
};

/// Arguments of a job, from which values follow that are not given.
struct GivenArguments {
    ParameterValues values;
    std::function<bool(std::size_t parameter)> has;  ///< Whether the parameter was typed.
    std::string subject = {};                        ///< Exhibit that is named; empty: none.
    std::filesystem::path out = {};
};

/// A job: turns a scene or files into files. The command line, the dialog, the settings document and the schema are
/// derived from its parameter table.
class Job {
public:
    virtual ~Job() = default;

    /// Returns the name of its command, also used in documents: "sprite".
    [[nodiscard]] virtual std::string_view name() const = 0;
    /// Returns the words of its command: those of a group of commands and one of it, or the name.
    [[nodiscard]] virtual std::string_view command() const { return name(); }
    /// Returns the title of its dialog: "Export sprites".
    [[nodiscard]] virtual std::string_view title() const = 0;
    /// Returns what it makes, as an entry of a list: "Sprites".
    [[nodiscard]] virtual std::string_view product() const { return title(); }
    /// Returns one sentence without a full stop, for the help of the command.
    [[nodiscard]] virtual std::string_view summary() const = 0;
    [[nodiscard]] virtual const Parameters& parameters() const = 0;
    [[nodiscard]] virtual JobNeeds needs() const = 0;
    /// Reads the files that the values name. Any thread. Throws Failure.
    [[nodiscard]] virtual std::shared_ptr<const JobInputs> read(const ParameterValues&) const = 0;
    /// Returns what the job would write. Reads no file, needs no graphics and throws nothing: an impossible request is
    /// reported as `JobPlan::refusal`. `inputs` are the result of `read` for these values. Without `out`, no file is
    /// planned.
    [[nodiscard]] virtual JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                                       const std::filesystem::path& out) const = 0;
    /// Starts the job. Cheap: opens no file.
    [[nodiscard]] virtual std::unique_ptr<JobRun> start(JobOrder) const = 0;
    /// Returns whether the camera of the scene has an effect. For jobs with `JobNeeds::anyScene`.
    [[nodiscard]] virtual bool usesCamera(const ParameterValues&, const JobScene&) const { return true; }
    /// Returns the values with everything that follows from the given ones. Throws Failure (ErrorKind::usage) for
    /// arguments that exclude each other or have no effect together.
    [[nodiscard]] virtual ParameterValues completed(const GivenArguments& given) const { return given.values; }
    /// Returns whether the job needs an output. Without, these values name other files to write.
    [[nodiscard]] virtual bool needsOutput(const ParameterValues&) const { return true; }
    /// Returns why the job cannot be split into parts with these values: "charts are made at once". Empty: it can.
    [[nodiscard]] virtual std::string refusedInParts(const ParameterValues&) const { return {}; }
    /// Returns options that have no effect here, each with what it has none on: {"--points", "a study of --values"}.
    /// They are refused where they are typed.
    [[nodiscard]] virtual std::vector<std::pair<const char*, const char*>> idleOptions(const ParameterValues&,
                                                                                       const JobScene&) const
    {
        return {};
    }
    /// Returns the pattern of the files that a part makes instead of `out`: "%06d.png". Empty: a part makes its items
    /// of `out` itself, and there is nothing to merge.
    [[nodiscard]] virtual std::string partItems(const std::filesystem::path&) const { return {}; }
    /// Returns the scene as the job shows it with these values. Command lines and runs use this scene.
    [[nodiscard]] virtual JobScene sceneFor(const ParameterValues&, JobScene scene) const { return scene; }
    /// Returns the values with those that the window's scene gives where none are set, such as the file that an exhibit
    /// shows. The dialog reads, runs and writes them; a plan does the same by itself.
    [[nodiscard]] virtual ParameterValues withScene(const ParameterValues& values, const JobScene&) const
    {
        return values;
    }
    /// Returns a sentence on how a draft differs from the whole.
    [[nodiscard]] virtual std::string_view draftNote() const { return "The preview shows a part of it."; }
    /// Returns the effort of a run: the number of samples of pixels that it draws. 0: unknown.
    [[nodiscard]] virtual double effort(const ParameterValues&, const JobScene&) const { return 0; }
    /// Returns the values of a smaller run that previews the whole one.
    [[nodiscard]] virtual ParameterValues draft(const ParameterValues& values, const JobInputs&) const
    {
        return values;
    }
    /// Returns what a run with these values will make, judged by its draft. The extension of `out` decides the format.
    /// Any thread.
    [[nodiscard]] virtual JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                               const std::filesystem::path&) const
    {
        return {};
    }
};

/// Returns the reason why the job cannot write a file with this extension: "a.gif: give a name that ends in .png or
/// .tif." Empty if it can, and for a job that writes a folder.
[[nodiscard]] std::string refusedExtension(const Job&, const std::filesystem::path& out);

/// Makes the folders that the job makes for its output, and checks that all its files can be written. To be called
/// before the work begins. Throws Failure (ErrorKind::file).
void requireWritable(const Job&, const JobOrder&);

}  // namespace vitrine::jobs
