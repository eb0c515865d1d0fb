#include "exhibits/study/kept_study.h"

#include "exhibits/study/csv_field.h"
#include "render/files/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace vitrine::study {
namespace {

using render::Json;
using render::JsonDocument;

constexpr int version = 1;
constexpr const char* severalFormat = "vitrine-studies";
constexpr std::size_t mostStudies = 256;
constexpr std::size_t mostPoints = 20'000;
constexpr std::size_t mostParameters = 64;
constexpr std::size_t mostViews = 256;
constexpr std::size_t mostCounters = 256;
constexpr std::size_t mostSentences = 256;
constexpr std::size_t mostNameBytes = 200;
constexpr double largestNumber = 1e15;

/// A value of the file, and its path for messages.
class Place {
public:
    Place(const JsonDocument& document, const Json& json, std::string path)
        : document_(document), json_(json), path_(std::move(path))
    {
    }

    [[nodiscard]] Failure failure(const std::string& problem) const { return document_.failure(path_, problem); }
    [[nodiscard]] bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
    [[nodiscard]] Place at(const char* key) const
    {
        if (!json_.is_object()) throw failure("this must be an object; it is not a study that Vitrine wrote.");
        if (!json_.contains(key))
            throw failure("the key \"" + std::string(key) + "\" is missing; it is not a study that Vitrine wrote.");
        return {document_, json_[key], inside(key)};
    }
    [[nodiscard]] std::vector<Place> elements(std::size_t most) const
    {
        if (!json_.is_array()) throw failure("this must be an array; correct it there.");
        if (json_.size() > most) throw failure("these are more than " + std::to_string(most) + "; take some away.");
        std::vector<Place> all;
        for (std::size_t i = 0; i < json_.size(); ++i)
            all.emplace_back(document_, json_[i], path_ + '[' + std::to_string(i) + ']');
        return all;
    }
    [[nodiscard]] std::string text(std::size_t mostBytes = 4096) const
    {
        if (!json_.is_string()) throw failure("this must be text; correct it there.");
        if (json_.get_ref<const std::string&>().size() > mostBytes)
            throw failure("this text is longer than " + std::to_string(mostBytes) + " bytes; shorten it.");
        return json_.get<std::string>();
    }
    [[nodiscard]] bool boolean() const
    {
        if (!json_.is_boolean()) throw failure("this must be true or false; correct it there.");
        return json_.get<bool>();
    }
    /// Returns a number of at least 0.
    [[nodiscard]] double number() const
    {
        if (!json_.is_number()) throw failure("this must be a number; correct it there.");
        const double x = json_.get<double>();
        if (!(x >= 0) || x > largestNumber) throw failure("this must be from 0 to 1e15; correct it there.");
        return x;
    }
    /// Returns a number of at least 0, or infinity for null, since JSON cannot express it.
    [[nodiscard]] double numberOrNone() const
    {
        return json_.is_null() ? std::numeric_limits<double>::infinity() : number();
    }
    [[nodiscard]] std::size_t whole(std::size_t low, std::size_t high) const
    {
        const double x = number();
        if (x != std::floor(x) || x < static_cast<double>(low) || x > static_cast<double>(high))
            throw failure("this must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                          "; correct it there.");
        return static_cast<std::size_t>(x);
    }
    [[nodiscard]] const Json& json() const { return json_; }
    [[nodiscard]] std::string inside(const std::string& key) const { return path_.empty() ? key : path_ + '.' + key; }

private:
    const JsonDocument& document_;
    const Json& json_;
    std::string path_;
};

std::string textIn(const Place& place, const char* key)
{
    return place.has(key) ? place.at(key).text() : std::string();
}

KeptPoint::Time timeAt(const Place& place)
{
    KeptPoint::Time time;
    time.median = place.at("median").number();
    time.spread = place.at("spread").number();
    const std::vector<Place> ends = place.at("interval").elements(2);
    if (ends.size() != 2) throw place.at("interval").failure("this must be two numbers; correct it there.");
    time.interval = {ends[0].number(), ends[1].number(), place.at("confidence").number()};
    if (time.interval.low > time.median || time.interval.high < time.median)
        throw place.at("interval").failure("the median is not in this interval; correct it there.");
    if (time.interval.confidence > 1) throw place.at("confidence").failure("this must be at most 1; correct it there.");
    time.runs = place.at("runs").whole(1, 1'000'000);
    return time;
}

KeptPoint pointAt(const Place& place, const std::vector<KeptStudy::Parameter>& parameters)
{
    KeptPoint point;
    const Place values = place.at("values");
    for (const KeptStudy::Parameter& parameter : parameters) {
        const Place value = values.at(parameter.name.c_str());
        if (!value.json().is_number() && !value.json().is_boolean()) (void)value.text(200);
        point.values.push_back(value.json());
    }
    point.error = place.at("error").numberOrNone();
    const std::vector<Place> over = place.at("errorOverViews").elements(2);
    if (over.size() != 2) throw place.at("errorOverViews").failure("this must be two numbers; correct it there.");
    point.lowestError = over[0].numberOrNone();
    point.worstError = over[1].numberOrNone();
    if (place.has("modelError") && !place.at("modelError").json().is_null())
        point.modelError = place.at("modelError").number();
    point.cost = place.at("cost").numberOrNone();
    if (!std::isfinite(point.cost)) point.cost = 0;
    point.uncertain = place.at("uncertain").boolean();
    const Place counters = place.at("counters");
    if (!counters.json().is_object()) throw counters.failure("this must be an object; correct it there.");
    if (counters.json().size() > mostCounters) throw counters.failure("these are too many; take some away.");
    for (const auto& [name, count] : counters.json().items()) point.counters[name] = counters.at(name.c_str()).number();
    if (place.has("ms")) point.time = timeAt(place.at("ms"));
    return point;
}

void readMachine(const Place& root, KeptStudy& study)
{
    const Place clock = root.at("clock");
    study.clock = clock.at("method").text();
    study.clockTrusted = clock.at("trusted").boolean();
    const Place machine = root.at("machine");
    if (!machine.json().is_object()) throw machine.failure("this must be an object; correct it there.");
    study.renderer = textIn(machine, "renderer");
    if (machine.has("processors")) study.processors = static_cast<int>(machine.at("processors").whole(0, 1'000'000));
}

/// Returns whether a text is a local time to the second, as in `KeptStudy::measured`.
bool isMoment(const std::string& text)
{
    const std::string form = "dddd-dd-ddTdd:dd:dd";
    if (text.size() != form.size()) return false;
    for (std::size_t i = 0; i < form.size(); ++i)
        if (form[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != form[i]) return false;
    return true;
}

void readHead(const Place& root, KeptStudy& study)
{
    if (root.at("format").text() != "vitrine-study")
        throw root.at("format").failure("this is not a study; choose a file that `vitrine study` wrote.");
    if (root.at("version").whole(1, 1'000'000) > version)
        throw root.at("version").failure("this was written by a newer Vitrine; open it there.");
    if (root.has("name")) study.name = root.at("name").text(mostNameBytes);
    study.measured = textIn(root, "measured");
    if (!study.measured.empty() && !isMoment(study.measured))
        throw root.at("measured").failure("this must be like 2026-11-25T01:43:23; correct it there.");
    if (root.has("complete")) study.complete = root.at("complete").boolean();
    study.exhibit = root.at("exhibit").text(200);
    study.alone = root.at("alone").boolean();
    const std::vector<Place> size = root.at("size").elements(2);
    if (size.size() != 2) throw root.at("size").failure("this must be width and height; correct it there.");
    study.size = {static_cast<int>(size[0].whole(1, 65536)), static_cast<int>(size[1].whole(1, 65536))};
    for (const Place& view : root.at("views").elements(mostViews)) study.views.push_back(view.text());
    if (study.views.empty()) throw root.at("views").failure("there is no view; it is not a study that Vitrine wrote.");
    for (const Place& each : root.at("parameters").elements(mostParameters))
        study.parameters.push_back({each.at("name").text(200), textIn(each, "label"), textIn(each, "unit")});
    if (study.parameters.empty())
        throw root.at("parameters").failure("there is no parameter; it is not a study that Vitrine wrote.");
    const std::string metric = root.at("metric").text();
    const std::optional<render::Metric> known = render::metricNamed(metric);
    if (!known) throw root.at("metric").failure("\"" + metric + "\" is not a metric; correct it there.");
    study.metric = *known;
    study.cost = root.at("cost").text(200);
}

void readSentences(const Place& root, KeptStudy& study)
{
    if (root.has("law")) (void)root.at("law").at("sentence").text();  // Checked only; it follows from the points.
    if (root.has("choice")) study.sentences.push_back(root.at("choice").at("sentence").text());
    study.sentences.push_back(root.at("reference").at("why").text());
    if (root.has("situation"))
        for (const Place& each : root.at("situation").at("sentences").elements(mostSentences))
            study.sentences.push_back(each.text());
    std::erase(study.sentences, std::string());
}

std::string numberField(double x)
{
    return std::isfinite(x) ? render::shortestNumber(x) : std::string();
}

const std::string& labelOf(const KeptStudy::Parameter& parameter)
{
    return parameter.label.empty() ? parameter.name : parameter.label;
}

std::string valueText(const Json& value)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
    const double x = value.get<double>();
    // Four digits distinguish the values of a sweep.
    return x == std::floor(x) && std::abs(x) < 1e9 ? std::to_string(static_cast<long long>(x)) : render::shortNumber(x);
}

KeptStudy studyAt(const Place& root)
{
    KeptStudy study;
    readHead(root, study);
    readMachine(root, study);
    const std::vector<Place> points = root.at("points").elements(mostPoints);
    for (std::size_t i = 0; i < points.size(); ++i) {
        study.points.push_back(pointAt(points[i], study.parameters));
        if (points[i].has("knee") && points[i].at("knee").boolean()) study.knee = i;
    }
    if (study.points.empty()) throw root.at("points").failure("there is no point; nothing was measured.");
    for (const Place& each : root.at("front").elements(study.points.size()))
        study.front.push_back(each.whole(0, study.points.size() - 1));
    readSentences(root, study);
    return study;
}

}  // namespace

bool KeptPoint::measured() const
{
    return cost > 0 && std::isfinite(error);
}

std::vector<SettingPart> KeptStudy::settingParts(std::size_t point) const
{
    std::vector<SettingPart> parts;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Json& value = points[point].values[i];
        const bool hasUnit = value.is_number() && !parameters[i].unit.empty();
        parts.push_back({labelOf(parameters[i]), valueText(value) + (hasUnit ? ' ' + parameters[i].unit : "")});
    }
    return parts;
}

std::string KeptStudy::pointText(std::size_t point) const
{
    std::string text;
    const std::vector<SettingPart> parts = settingParts(point);
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (text.empty() ? "" : ", ") + parameters[i].name + ' ' + parts[i].value;
    return text;
}

std::string KeptStudy::parameterNames() const
{
    if (parameters.size() > 2) return "all parameters";
    return parameters.size() == 1 ? labelOf(parameters[0]) : labelOf(parameters[0]) + " and " + labelOf(parameters[1]);
}

std::size_t KeptStudy::measuredPoints() const
{
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [](const KeptPoint& point) { return point.measured(); }));
}

KeptStudy parseStudy(const JsonDocument& document)
{
    return studyAt({document, document.root(), {}});
}

std::vector<StudyAndJson> parseStudies(const JsonDocument& document)
{
    const Place root(document, document.root(), {});
    if (root.at("format").text() != severalFormat) return {{studyAt(root), document.root()}};
    if (root.at("version").whole(1, 1'000'000) > version)
        throw root.at("version").failure("this was written by a newer Vitrine; open it there.");
    std::vector<StudyAndJson> studies;
    for (const Place& each : root.at("studies").elements(mostStudies)) studies.push_back({studyAt(each), each.json()});
    if (studies.empty()) throw root.at("studies").failure("there is no study; choose another file.");
    return studies;
}

Json studiesJson(const std::vector<Json>& studies)
{
    Json all = Json::array();
    for (const Json& study : studies) all.push_back(study);
    return Json{{"format", severalFormat}, {"version", version}, {"studies", all}};
}

KeptStudy readStudy(const std::filesystem::path& path)
{
    return parseStudy(render::readJson(path, studyLimits));
}

Json named(Json study, const std::string& name)
{
    std::string kept = name.substr(0, mostNameBytes);
    // Does not cut within a character.
    while (kept.size() < name.size() && (static_cast<unsigned char>(name[kept.size()]) & 0xC0) == 0x80) kept.pop_back();
    study.erase("name");
    if (!kept.empty()) study["name"] = kept;
    return study;
}

std::string keptCsv(const std::vector<KeptStudy>& studies)
{
    std::set<std::string> counters;
    for (const KeptStudy& study : studies)
        for (const KeptPoint& point : study.points)
            for (const auto& [name, count] : point.counters) counters.insert(name);
    std::string text = "study,measured,exhibit,renderer,width,height,views,setting,metric,error,error_lowest_view,"
                       "error_worst_view,uncertain,front";
    for (const std::string& name : counters) text += ',' + csvField(name);
    text += ",ms_median,ms_spread,ms_low,ms_high,confidence,runs,clock\n";
    for (const KeptStudy& study : studies) {
        std::string head;
        for (const std::string& each : {study.name, study.measured, study.exhibit, study.renderer})
            head += csvField(each) + ',';
        for (const std::size_t n :
             {static_cast<std::size_t>(study.size.x), static_cast<std::size_t>(study.size.y), study.views.size()})
            head += std::to_string(n) + ',';
        for (std::size_t i = 0; i < study.points.size(); ++i) {
            const KeptPoint& point = study.points[i];
            text += head + csvField(study.pointText(i)) + ',' + std::string(toString(study.metric));
            for (const double x : {point.error, point.lowestError, point.worstError}) text += ',' + numberField(x);
            const bool onFront = std::find(study.front.begin(), study.front.end(), i) != study.front.end();
            for (const bool is : {point.uncertain, onFront}) text += is ? ",1" : ",0";
            for (const std::string& name : counters)
                text += ',' + (point.counters.contains(name) ? numberField(point.counters.at(name)) : std::string());
            if (point.time)
                for (const double x :
                     {point.time->median, point.time->spread, point.time->interval.low, point.time->interval.high,
                      point.time->interval.confidence, static_cast<double>(point.time->runs)})
                    text += ',' + numberField(x);
            else
                text += ",,,,,,";
            text += ',' + csvField(study.clock) + '\n';
        }
    }
    return text;
}

}  // namespace vitrine::study
