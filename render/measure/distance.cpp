#include "render/measure/distance.h"

#include "render/measure/color_at.h"
#include "render/measure/hdr_flip.h"
#include "render/measure/structure.h"

#include <algorithm>
#include <cmath>

namespace vitrine::render {
namespace {

/// Copies the channels of one pixel into a picture of one pixel.
Image pixelOf(const Image& image, int x, int y, int first, int count)
{
    Image pixel(1, 1, count);
    for (int c = 0; c < count; ++c) pixel.at(0, 0, c) = image.at(x, y, first + c);
    return pixel;
}

/// Returns the index of a channel that both pictures have at the same index; -1 otherwise.
int sharedChannel(const Image& a, const Image& b, std::string_view name)
{
    const int channel = channelNamed(a, name);
    return channel == channelNamed(b, name) ? channel : -1;
}

using Pictures = ComparedPictures;

template <double (*Of)(const ColorDifference&)> std::optional<double> ofColor(const Pictures& p)
{
    return Of(p.color());
}
double rmse(const ColorDifference& d)
{
    return d.rmse;
}
double psnr(const ColorDifference& d)
{
    return d.psnr();
}
double largest(const ColorDifference& d)
{
    return d.max;
}
double shareBeyond(const ColorDifference& d)
{
    return d.beyond;
}
std::optional<Image> mapOfColor(const Pictures& p)
{
    return differenceMap(p.reference(), p.test());
}

double relative(const ColorDifference& d)
{
    return d.mape;
}
double relativeSquare(const ColorDifference& d)
{
    return d.relativeMse;
}
std::optional<Image> mapOfRelative(const Pictures& p)
{
    return relativeDifferenceMap(p.reference(), p.test());
}

std::optional<double> dissimilarityOf(const Pictures& p)
{
    return dissimilarity(p.reference(), p.test());
}
std::optional<Image> mapOfDissimilarity(const Pictures& p)
{
    return dissimilarityMap(p.reference(), p.test());
}

std::optional<double> flipOf(const Pictures& p)
{
    return flip(p.reference(), p.test(), p.pixelsPerDegree());
}
std::optional<Image> mapOfFlip(const Pictures& p)
{
    return flipMap(p.reference(), p.test(), p.pixelsPerDegree());
}

std::optional<double> hdrFlipOf(const Pictures& p)
{
    return hdrFlip(p.reference(), p.test(), p.pixelsPerDegree());
}
std::optional<Image> mapOfHdrFlip(const Pictures& p)
{
    return hdrFlipMap(p.reference(), p.test(), p.pixelsPerDegree());
}

bool hasHighRange(const Image& image)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::dvec3 color = colorAt(image, x, y);
            if (std::max({color.x, color.y, color.z}) > 1) return true;
        }
    return false;
}

/// Applies `errorOf` to each pixel of `count` channels from the one of that name.
template <typename Of>
std::optional<Image> mapOfChannels(const Pictures& p, std::string_view name, int count, const Of& errorOf)
{
    const int channel = sharedChannel(p.reference(), p.test(), name);
    if (channel < 0) return std::nullopt;
    Image map(p.reference().width, p.reference().height, 1);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            map.at(x, y) =
                errorOf(pixelOf(p.reference(), x, y, channel, count), pixelOf(p.test(), x, y, channel, count));
    return map;
}

constexpr std::string_view firstNormal = "normal.X", depthChannel = "depth.Z";

std::optional<double> normalsApart(const Pictures& p)
{
    const int first = sharedChannel(p.reference(), p.test(), firstNormal);
    return first < 0 ? std::nullopt : std::optional(normalDifference(p.reference(), p.test(), first).mean);
}
std::optional<Image> mapOfNormals(const Pictures& p)
{
    return mapOfChannels(p, firstNormal, 3, [](const Image& a, const Image& b) {
        const NormalDifference d = normalDifference(a, b, 0);
        return d.missing > 0 ? INFINITY : static_cast<float>(d.mean);
    });
}

std::optional<double> depthsApart(const Pictures& p)
{
    const int channel = sharedChannel(p.reference(), p.test(), depthChannel);
    return channel < 0 ? std::nullopt : std::optional(depthDifference(p.reference(), p.test(), channel).rms);
}
std::optional<Image> mapOfDepths(const Pictures& p)
{
    return mapOfChannels(p, depthChannel, 1, [](const Image& a, const Image& b) {
        const DepthDifference d = depthDifference(a, b, 0);
        return d.missing > 0 ? INFINITY : static_cast<float>(d.rms);
    });
}

}  // namespace

const ColorDifference& ComparedPictures::color() const
{
    if (!color_) color_ = colorDifference(reference_, test_);
    return *color_;
}

const std::vector<MetricInfo>& allMetrics()
{
    using P = ViewPooling;
    static const std::vector<MetricInfo> metrics{
        {Metric::rmse, "rmse", "RMS error of linear light", ofColor<rmse>, mapOfColor, P::rootMeanSquare},
        {.metric = Metric::psnr,
         .name = "psnr",
         .title = "peak signal to noise ratio, dB",
         .distance = ofColor<psnr>,
         .map = mapOfColor,
         .falls = true},
        {Metric::max, "max", "largest error of linear light", ofColor<largest>, mapOfColor, P::largest},
        {Metric::beyond, "beyond", "share of pixels off by more than 1/255", ofColor<shareBeyond>, mapOfColor},
        {Metric::mape, "mape", "mean relative error", ofColor<relative>, mapOfRelative},
        {Metric::relmse, "relmse", "mean squared relative error", ofColor<relativeSquare>, mapOfRelative},
        {Metric::dssim, "dssim", "structural dissimilarity, (1 − SSIM) / 2", dissimilarityOf, mapOfDissimilarity,
         P::mean, 1.0},
        {Metric::flip, "flip", "mean FLIP", flipOf, mapOfFlip, P::mean, 1.0},
        {.metric = Metric::hdrflip,
         .name = "hdrflip",
         .title = "mean HDR-FLIP",
         .distance = hdrFlipOf,
         .map = mapOfHdrFlip,
         .fullScale = 1.0,
         .ofHighRange = true},
        {.metric = Metric::normal,
         .name = "normal",
         .title = "mean angle between normals, degrees",
         .distance = normalsApart,
         .map = mapOfNormals,
         .ofColor = false},
        {.metric = Metric::depth,
         .name = "depth",
         .title = "RMS distance of surfaces, meters",
         .distance = depthsApart,
         .map = mapOfDepths,
         .ofColor = false},
    };
    return metrics;
}

const MetricInfo& metricInfo(Metric metric)
{
    return allMetrics().at(static_cast<std::size_t>(metric));
}

std::string_view toString(Metric metric)
{
    return metricInfo(metric).name;
}

std::string_view title(Metric metric)
{
    return metricInfo(metric).title;
}

std::optional<Metric> metricNamed(std::string_view name)
{
    for (const MetricInfo& metric : allMetrics())
        if (metric.name == name) return metric.metric;
    return std::nullopt;
}

int channelNamed(const Image& image, std::string_view name)
{
    const auto found = std::find(image.channelNames.begin(), image.channelNames.end(), name);
    return found == image.channelNames.end() ? -1 : static_cast<int>(found - image.channelNames.begin());
}

std::optional<double> distance(Metric metric, const Image& reference, const Image& test, double pixelsPerDegree)
{
    return metricInfo(metric).distance({reference, test, pixelsPerDegree});
}

std::map<Metric, double> distances(const ComparedPictures& pictures)
{
    std::map<Metric, double> found;
    const bool high = hasHighRange(pictures.reference()) || hasHighRange(pictures.test());
    for (const MetricInfo& metric : allMetrics()) {
        if (metric.ofHighRange && !high) continue;
        if (const std::optional<double> distance = metric.distance(pictures)) found[metric.metric] = *distance;
    }
    return found;
}

std::optional<Image> errorMap(Metric metric, const Image& reference, const Image& test, double pixelsPerDegree)
{
    return metricInfo(metric).map({reference, test, pixelsPerDegree});
}

double fullScale(Metric metric, const Image& errors)
{
    if (const std::optional<double> full = metricInfo(metric).fullScale) return *full;
    double largest = 0;
    for (const float e : errors.pixels)
        if (std::isfinite(e)) largest = std::max(largest, static_cast<double>(e));
    return largest > 0 ? largest : 1;
}

bool isBeyond(Metric metric, double value, double limit)
{
    return metricInfo(metric).falls ? value < limit : value > limit;
}

double pooledError(Metric metric, const std::vector<double>& errors)
{
    if (errors.empty()) return 0;
    const ViewPooling pooling = metricInfo(metric).pooling;
    if (pooling == ViewPooling::largest) return std::max(0.0, *std::max_element(errors.begin(), errors.end()));
    const bool squared = pooling == ViewPooling::rootMeanSquare;
    double sum = 0;
    for (const double e : errors) sum += squared ? e * e : e;
    const double mean = sum / static_cast<double>(errors.size());
    return squared ? std::sqrt(mean) : mean;
}

}  // namespace vitrine::render
