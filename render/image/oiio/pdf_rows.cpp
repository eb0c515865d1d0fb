#include "render/image/oiio/pdf_rows.h"

#include "render/image/oiio/guarded.h"

#include <qpdf/Pl_Flate.hh>
#include <qpdf/Pl_StdioFile.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

namespace vitrine::render {
namespace {

using Object = QPDFObjectHandle;

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

/// Hands the deflated rows to the writer of the document, which may ask for them more than once.
class KeptRows final : public Object::StreamDataProvider {
public:
    explicit KeptRows(std::FILE* file) : file_(file) {}

    void provideStreamData(const QPDFObjGen& /*object*/, Pipeline* to) override
    {
        std::rewind(file_);
        std::vector<unsigned char> part(1U << 20U);
        while (const std::size_t got = std::fread(part.data(), 1, part.size(), file_)) to->write(part.data(), got);
        if (std::ferror(file_)) throw std::runtime_error("the deflated rows cannot be read back");
        to->finish();
    }

private:
    std::FILE* file_;
};

/// Makes a document of one page with the picture at its exact size.
class PdfRows final : public OiioRows {
public:
    explicit PdfRows(const OiioRowTarget& target) : target_(target)
    {
        const std::string path = target.path + "-rows";
        kept_.reset(std::fopen(path.c_str(), "w+b"));
        if (!kept_) throw std::runtime_error(std::strerror(errno));
        // Nobody else needs its name, so that nothing remains of it.
        std::error_code unnamed;
        std::filesystem::remove(path, unnamed);
        file_ = std::make_unique<Pl_StdioFile>("rows", kept_.get());
        deflater_ = std::make_unique<Pl_Flate>("rows", file_.get(), Pl_Flate::a_deflate);
    }

    std::string write(const void* rows, int /*first*/, int count) noexcept override
    {
        return guarded([&]() -> std::string {
            const std::size_t bytes = static_cast<std::size_t>(target_.width) * static_cast<std::size_t>(count) *
                                      static_cast<std::size_t>(target_.channels * target_.bits / 8);
            const auto* codes = static_cast<const unsigned char*>(rows);
            if (target_.bits == 16) {
                turned_.assign(codes, codes + bytes);  // A PDF has the high byte first.
                for (std::size_t i = 0; i + 1 < bytes; i += 2) std::swap(turned_[i], turned_[i + 1]);
                codes = turned_.data();
            }
            deflater_->write(codes, bytes);
            return {};
        });
    }

    std::string close() noexcept override
    {
        return guarded([&]() -> std::string {
            deflater_->finish();
            if (std::fflush(kept_.get()) != 0) return "writing failed (" + std::string(std::strerror(errno)) + ")";
            writeDocument();
            QPDF written;
            written.processFile(target_.path.c_str());
            if (QPDFPageDocumentHelper(written).getAllPages().size() != 1) return "the written file has no page";
            return {};
        });
    }

private:
    static std::string number(double value)
    {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.6f", value);
        return text.data();
    }

    /// Returns a box of the page. `edges` are pixels from the top left corner: left, top, right, bottom.
    [[nodiscard]] Object box(const std::array<double, 4>& edges) const
    {
        const auto x = [&](double pixels) { return Object::newReal(number(pixels / target_.dpiX * points())); };
        const auto y = [&](double pixels) {
            return Object::newReal(number((target_.height - pixels) / target_.dpiY * points()));
        };
        return Object::newArray(std::vector<Object>{x(edges[0]), y(edges[3]), x(edges[2]), y(edges[1])});
    }

    /// Returns units per inch: 72, or fewer for a page of more than 200 inches, where a larger unit is stored.
    [[nodiscard]] double points() const { return 72.0 / unit(); }
    [[nodiscard]] double unit() const
    {
        const double side = std::max(target_.width / target_.dpiX, target_.height / target_.dpiY);
        return std::max(1.0, std::ceil(side / 200));
    }

    Object profileStream(QPDF& pdf) const
    {
        Object profile = pdf.newStream(target_.profile);
        profile.getDict().replaceKey("/N", Object::newInteger(target_.channels));
        return profile;
    }

    Object picture(QPDF& pdf, const Object& profile) const
    {
        Object image = pdf.newStream();
        Object dict = image.getDict();
        dict.replaceKey("/Type", Object::newName("/XObject"));
        dict.replaceKey("/Subtype", Object::newName("/Image"));
        dict.replaceKey("/Width", Object::newInteger(target_.width));
        dict.replaceKey("/Height", Object::newInteger(target_.height));
        dict.replaceKey("/BitsPerComponent", Object::newInteger(target_.bits));
        dict.replaceKey("/Interpolate", Object::newBool(false));
        dict.replaceKey("/ColorSpace", Object::newArray(std::vector<Object>{Object::newName("/ICCBased"), profile}));
        image.replaceStreamData(std::make_shared<KeptRows>(kept_.get()), Object::newName("/FlateDecode"),
                                Object::newNull());
        return image;
    }

    void addPage(QPDF& pdf, const Object& profile) const
    {
        const std::array<double, 4> all{0, 0, static_cast<double>(target_.width), static_cast<double>(target_.height)};
        const std::string width = number(target_.width / target_.dpiX * points());
        const std::string height = number(target_.height / target_.dpiY * points());
        Object page = Object::newDictionary();
        page.replaceKey("/Type", Object::newName("/Page"));
        page.replaceKey("/MediaBox", box(all));
        page.replaceKey("/BleedBox", box(target_.bleed.value_or(all)));
        page.replaceKey("/TrimBox", box(target_.trim.value_or(all)));
        if (unit() > 1) page.replaceKey("/UserUnit", Object::newReal(number(unit())));
        Object pictures = Object::newDictionary();
        pictures.replaceKey("/Im0", picture(pdf, profile));
        Object resources = Object::newDictionary();
        resources.replaceKey("/XObject", pictures);
        page.replaceKey("/Resources", resources);
        page.replaceKey("/Contents", pdf.newStream("q " + width + " 0 0 " + height + " 0 0 cm /Im0 Do Q\n"));
        QPDFPageDocumentHelper(pdf).addPage(QPDFPageObjectHelper(pdf.makeIndirectObject(page)), false);
    }

    void writeDocument() const
    {
        QPDF pdf;
        pdf.emptyPDF();
        const Object profile = profileStream(pdf);
        addPage(pdf, profile);
        Object intent = Object::newDictionary();
        intent.replaceKey("/Type", Object::newName("/OutputIntent"));
        intent.replaceKey("/S", Object::newName("/GTS_PDFX"));
        intent.replaceKey("/OutputConditionIdentifier", Object::newString("Custom"));
        intent.replaceKey("/Info", Object::newString("ICC profile of the print"));
        intent.replaceKey("/DestOutputProfile", profile);
        pdf.getRoot().replaceKey("/OutputIntents", Object::newArray(std::vector<Object>{intent}));
        Object info = Object::newDictionary();
        info.replaceKey("/Title", Object::newString("Lenticular print"));
        info.replaceKey("/Creator", Object::newString("Vitrine"));
        pdf.getTrailer().replaceKey("/Info", pdf.makeIndirectObject(info));
        if (!target_.description.empty()) attach(pdf);
        QPDFWriter writer(pdf, target_.path.c_str());
        writer.setMinimumPDFVersion("1.6");
        writer.setDeterministicID(true);
        writer.setStreamDataMode(qpdf_s_preserve);
        writer.setObjectStreamMode(qpdf_o_disable);
        writer.write();
    }

    void attach(QPDF& pdf) const
    {
        auto stream = QPDFEFStreamObjectHelper::createEFStream(pdf, target_.description);
        stream.setSubtype("application/json");
        auto file = QPDFFileSpecObjectHelper::createFileSpec(pdf, "vitrine-print.json", stream);
        file.setDescription("Settings of the lenticular print");
        QPDFEmbeddedFileDocumentHelper(pdf).replaceEmbeddedFile("vitrine-print.json", file);
    }

    OiioRowTarget target_;
    File kept_;  ///< Deflated rows.
    std::unique_ptr<Pl_StdioFile> file_;
    std::unique_ptr<Pl_Flate> deflater_;
    std::vector<unsigned char> turned_;
};

}  // namespace

std::string openPdfRowsWithQpdf(const OiioRowTarget& target, std::unique_ptr<OiioRows>& out)
{
    out = std::make_unique<PdfRows>(target);
    return {};
}

}  // namespace vitrine::render
