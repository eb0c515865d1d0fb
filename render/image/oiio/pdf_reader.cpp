#include "render/image/oiio/pdf_reader.h"

#include "render/image/oiio/guarded.h"

#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFExc.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace vitrine::render {
namespace {

using Object = QPDFObjectHandle;

constexpr std::size_t mostAttachedBytes = 16U << 20U;  ///< For the settings and the profile, each.
constexpr long long longestSide = 1 << 20;             ///< Pixels; longer prints are not written.

/// Keeps what a stream of the document decodes to, up to a limit.
class Kept final : public Pipeline {
public:
    Kept() : Pipeline("kept", nullptr) {}
    void write(const unsigned char* data, std::size_t count) override
    {
        if (count > mostAttachedBytes - bytes.size()) throw std::runtime_error("a part of it is too large");
        bytes.append(reinterpret_cast<const char*>(data), count);
    }
    void finish() override {}

    std::string bytes;
};

std::string contentOf(Object stream)
{
    Kept kept;
    if (!stream.isStream() || !stream.pipeStreamData(&kept, 0, qpdf_dl_generalized)) return {};
    return kept.bytes;
}

/// Inflates rows from a place in the file (RFC 1950), as far as they are asked for. Going back starts anew.
class DeflatedRows final : public OiioRowReader {
public:
    DeflatedRows(const std::string& path, long long offset, long long length)
        : file_(path, std::ios::binary), offset_(offset), length_(length), input_(1U << 16U)
    {
        if (!file_) throw std::runtime_error("it cannot be opened");
    }
    ~DeflatedRows() override
    {
        if (isOpen_) inflateEnd(&zip_);
    }
    DeflatedRows(const DeflatedRows&) = delete;
    DeflatedRows& operator=(const DeflatedRows&) = delete;

    std::string read(int first, int count, void* rows) noexcept override
    {
        return guarded([&]() -> std::string {
            if (!isOpen_ || first < next_) begin();
            row_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels * bits / 8));
            auto* out = static_cast<unsigned char*>(rows);
            for (; next_ < first + count; ++next_) {
                if (!inflateRow()) return "its picture is broken";
                if (next_ < first) continue;
                if (bits == 16)  // A PDF has the high byte first.
                    for (std::size_t i = 0; i + 1 < row_.size(); i += 2) std::swap(row_[i], row_[i + 1]);
                out = std::copy(row_.begin(), row_.end(), out);
            }
            return {};
        });
    }

private:
    void begin()
    {
        if (isOpen_) inflateEnd(&zip_);
        zip_ = {};
        isOpen_ = inflateInit(&zip_) == Z_OK;
        if (!isOpen_) throw std::bad_alloc();
        next_ = 0;
        left_ = length_;
        file_.clear();
        if (!file_.seekg(offset_)) throw std::runtime_error("it cannot be read");
    }
    bool inflateRow()
    {
        zip_.next_out = row_.data();
        zip_.avail_out = static_cast<uInt>(row_.size());
        while (zip_.avail_out > 0) {
            if (zip_.avail_in == 0) {
                const auto wanted =
                    static_cast<std::size_t>(std::min<long long>(left_, static_cast<long long>(input_.size())));
                file_.read(reinterpret_cast<char*>(input_.data()), static_cast<std::streamsize>(wanted));
                const auto got = static_cast<std::size_t>(file_.gcount());
                if (got == 0) return false;
                left_ -= static_cast<long long>(got);
                zip_.next_in = input_.data();
                zip_.avail_in = static_cast<uInt>(got);
            }
            const int state = inflate(&zip_, Z_NO_FLUSH);
            if (state != Z_OK && !(state == Z_STREAM_END && zip_.avail_out == 0)) return false;
        }
        return true;
    }

    std::ifstream file_;
    long long offset_, length_, left_ = 0;
    std::vector<unsigned char> input_, row_;
    z_stream zip_{};
    bool isOpen_ = false;
    int next_ = 0;
};

std::string settingsOf(QPDF& pdf)
{
    QPDFEmbeddedFileDocumentHelper files(pdf);
    if (!files.hasEmbeddedFiles()) return {};
    const auto file = files.getEmbeddedFile("vitrine-print.json");
    return file ? contentOf(file->getEmbeddedFileStream()) : std::string();
}

long long wholeAt(Object dict, const char* key)
{
    Object value = dict.getKey(key);
    return value.isInteger() ? value.getIntValue() : 0;
}

/// Returns the picture of a page if it is stored as PdfRows writes it; otherwise null.
Object pictureOf(QPDF& pdf)
{
    const std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(pdf).getAllPages();
    if (pages.size() != 1) return Object::newNull();
    Object page = pages.front().getObjectHandle();
    Object resources = page.getKey("/Resources");
    Object pictures = resources.isDictionary() ? resources.getKey("/XObject") : Object::newNull();
    if (!pictures.isDictionary() || pictures.getKeys().size() != 1) return Object::newNull();
    Object picture = pictures.getKey("/Im0");
    if (!picture.isStream()) return Object::newNull();
    Object dict = picture.getDict();
    const bool isDeflated = dict.getKey("/Filter").isName() && dict.getKey("/Filter").getName() == "/FlateDecode" &&
                            !dict.hasKey("/DecodeParms") && !dict.hasKey("/Decode");
    Object space = dict.getKey("/ColorSpace");
    const bool hasProfile = space.isArray() && space.getArrayNItems() == 2 && space.getArrayItem(0).isName() &&
                            space.getArrayItem(0).getName() == "/ICCBased" && space.getArrayItem(1).isStream();
    return isDeflated && hasProfile ? picture : Object::newNull();
}

/// Returns where the data of a stream begins in the file: after the line "stream" that follows its dictionary. -1 if it
/// is not there.
long long dataOffset(const std::string& path, Object stream)
{
    const long long at = stream.getDict().getParsedOffset();
    std::ifstream file(path, std::ios::binary);
    if (at < 0 || !file.seekg(at)) return -1;
    std::string head(4096, '\0');
    file.read(&head[0], static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    const std::string mark = "\nstream\n";
    const std::size_t found = head.find(mark);
    return found == std::string::npos ? -1 : at + static_cast<long long>(found + mark.size());
}

}  // namespace

std::string openPdfReaderWithQpdf(const std::string& path, std::unique_ptr<OiioRowReader>& out)
{
    const std::string other = "it is not a PDF that vitrine print wrote, and pictures of others are not read; print it "
                              "anew, or as a TIFF or PNG";
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.setAttemptRecovery(false);
    try {
        pdf.processFile(path.c_str());
        const std::string settings = settingsOf(pdf);
        Object picture = pictureOf(pdf);
        if (settings.empty() || picture.isNull()) return other;
        Object dict = picture.getDict();
        const long long width = wholeAt(dict, "/Width"), height = wholeAt(dict, "/Height");
        const long long bits = wholeAt(dict, "/BitsPerComponent"), offset = dataOffset(path, picture);
        Object profile = dict.getKey("/ColorSpace").getArrayItem(1);
        const long long channels = wholeAt(profile.getDict(), "/N");
        if (width < 1 || height < 1 || width > longestSide || height > longestSide || (bits != 8 && bits != 16) ||
            (channels != 3 && channels != 4) || offset < 0)
            return other;
        auto reader = std::make_unique<DeflatedRows>(path, offset, wholeAt(dict, "/Length"));
        reader->width = static_cast<int>(width);
        reader->height = static_cast<int>(height);
        reader->bits = static_cast<int>(bits);
        reader->channels = static_cast<int>(channels);
        reader->isInks = channels == 4;
        reader->description = settings;
        reader->profile = contentOf(profile);
        out = std::move(reader);
    } catch (const QPDFExc&) {
        return "it is a broken PDF; print it anew";
    }
    return {};
}

}  // namespace vitrine::render
